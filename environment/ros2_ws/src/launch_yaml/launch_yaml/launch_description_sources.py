"""Launch files in YAML, to be included."""

from launch import SomeSubstitutionsType
from launch.launch_description_sources import FrontendLaunchDescriptionSource

from launch_yaml.parser import Parser


class YAMLLaunchDescriptionSource(FrontendLaunchDescriptionSource):
    """A launch file that is read as YAML, whatever its name."""

    def __init__(self, launch_file_path: SomeSubstitutionsType):
        super().__init__(launch_file_path, method='interpreted YAML launch file', parser=Parser)
