"""Launch files in XML, to be included."""

from launch import SomeSubstitutionsType
from launch.launch_description_sources import FrontendLaunchDescriptionSource

from launch_xml.parser import Parser


class XMLLaunchDescriptionSource(FrontendLaunchDescriptionSource):
    """A launch file that is read as XML, whatever its name."""

    def __init__(self, launch_file_path: SomeSubstitutionsType):
        super().__init__(launch_file_path, method='interpreted XML launch file', parser=Parser)
