"""A Python launch file."""

from launch.launch_description import LaunchDescription
from launch.launch_description_source import LaunchDescriptionSource
from launch.launch_description_sources.python_launch_file_utilities import (
    get_launch_description_from_python_launch_file,
)
from launch.some_substitutions_type import SomeSubstitutionsType


class PythonLaunchDescriptionSource(LaunchDescriptionSource):
    """A Python launch file."""

    def __init__(self, launch_file_path: SomeSubstitutionsType):
        super().__init__(location=launch_file_path, method='interpreted python launch file')

    def _load(self, path: str) -> LaunchDescription:
        return get_launch_description_from_python_launch_file(path)
