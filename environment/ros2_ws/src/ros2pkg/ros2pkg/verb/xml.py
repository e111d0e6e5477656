"""The verb `ros2 pkg xml`."""

from pathlib import Path
from xml.etree import ElementTree

from ros2pkg.api import get_prefix_path, package_name_completer
from ros2pkg.verb import VerbExtension


class XmlVerb(VerbExtension):
    """Output the XML of the package manifest or a specific tag."""

    def add_arguments(self, parser, cli_name):
        """Add the arguments."""
        argument = parser.add_argument('package_name', help='Name of the package')
        argument.completer = package_name_completer
        parser.add_argument('-t', '--tag', help='Print only the text of this tag, for example version')

    def main(self, *, args):
        """Print the manifest or the tag."""
        prefix = get_prefix_path(args.package_name)
        if prefix is None:
            return 'Package not found'
        path = Path(prefix, 'share', args.package_name, 'package.xml')
        if not path.is_file():
            return 'Package xml manifest not found'
        root = ElementTree.parse(path).getroot()
        if args.tag is None:
            print(ElementTree.tostring(root, encoding='unicode'))
            return None
        elements = root.findall(args.tag)
        if not elements:
            return 'XML tag not found'
        for element in elements:
            print(element.text)
        return None
