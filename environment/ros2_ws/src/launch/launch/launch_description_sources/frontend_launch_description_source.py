"""A launch file that is no program."""

from launch.frontend import Parser
from launch.launch_description import LaunchDescription
from launch.launch_description_source import LaunchDescriptionSource
from launch.launch_description_sources.frontend_launch_file_utilities import (
    get_launch_description_from_frontend_launch_file,
)
from launch.some_substitutions_type import SomeSubstitutionsType


class FrontendLaunchDescriptionSource(LaunchDescriptionSource):
    """
    A launch file that is no program.

    :param launch_file_path: its path
    :param method: how the description came to be, for messages
    :param parser: reads the file; the base class finds the one that fits the file
    """

    def __init__(
        self,
        launch_file_path: SomeSubstitutionsType,
        *,
        method: str = 'interpreted frontend launch file',
        parser: type[Parser] = Parser,
    ):
        super().__init__(location=launch_file_path, method=method)
        self._parser = parser

    def _load(self, path: str) -> LaunchDescription:
        return get_launch_description_from_frontend_launch_file(path, parser=self._parser)
