"""Loading launch files that are no programs."""

from launch.frontend import Parser
from launch.launch_description import LaunchDescription


def get_launch_description_from_frontend_launch_file(
    frontend_launch_file_path: str, *, parser: type[Parser] = Parser
) -> LaunchDescription:
    """
    Load a launch file in XML, YAML or any other format that a parser is installed for.

    :raises InvalidFrontendLaunchFileError: if it can be read as none of them
    :raises Exception: what the parser or an action finds wrong in it
    """
    entity, found = parser.load(frontend_launch_file_path)
    return found.parse_description(entity)
