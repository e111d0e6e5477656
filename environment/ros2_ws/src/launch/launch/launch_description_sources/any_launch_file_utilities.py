"""Loading launch files of any format."""

from __future__ import annotations

import os

from launch.frontend import Parser
from launch.invalid_launch_file_error import InvalidLaunchFileError
from launch.launch_description import LaunchDescription
from launch.launch_description_sources.frontend_launch_file_utilities import (
    get_launch_description_from_frontend_launch_file,
)
from launch.launch_description_sources.python_launch_file_utilities import (
    get_launch_description_from_python_launch_file,
)


def get_launch_description_from_any_launch_file(
    launch_file_path: str, *, parser: type[Parser] = Parser
) -> LaunchDescription:
    """
    Load a launch file: first as what its name says, then as the rest.

    :raises InvalidLaunchFileError: if all of that fails; it tells every reason if the format is known
    """
    path = str(launch_file_path)
    extension = os.path.splitext(path)[1][1:]
    loaders = [get_launch_description_from_python_launch_file, get_launch_description_from_frontend_launch_file]
    if extension != 'py':
        loaders.reverse()
        extension = extension if parser.is_filename_valid(os.path.basename(path)) else ''
    errors = []
    for load in loaders:
        try:
            return load(path)
        except Exception as error:  # whatever the file's own code raises
            errors.append(error)
    raise InvalidLaunchFileError(extension, likely_errors=errors)
