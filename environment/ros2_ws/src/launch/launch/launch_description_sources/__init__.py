"""Sources of launch descriptions: Python files."""

from launch.invalid_launch_file_error import InvalidLaunchFileError
from launch.launch_description_sources.python_launch_description_source import (
    AnyLaunchDescriptionSource,
    PythonLaunchDescriptionSource,
    get_launch_description_from_any_launch_file,
    get_launch_description_from_python_launch_file,
    load_python_launch_file_as_module,
)

__all__ = [
    'AnyLaunchDescriptionSource',
    'InvalidLaunchFileError',
    'PythonLaunchDescriptionSource',
    'get_launch_description_from_any_launch_file',
    'get_launch_description_from_python_launch_file',
    'load_python_launch_file_as_module',
]
