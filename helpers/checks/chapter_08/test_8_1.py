"""Visible tests of exercise 8.1, a linter for names."""

import pytest

from helpers.checks.chapter_08.linting import bad_names, compare, package_xml

pytestmark = pytest.mark.exercise('8.1')

TALKER = '''
class Talker(Node):
    def __init__(self):
        super().__init__('Talker')
        self.pub = self.create_publisher(String, 'chatter', 10)
        self.sub = self.create_subscription(String, '/Reset', self.on_reset, 10)
'''


def test_node(learner):
    """The node Talker is reported with its file, its kind and its name.

    Go through `calls(text)`. The name is the first argument of super().__init__ in a class with the base Node.
    """
    compare(bad_names(learner, {'talker.py': TALKER}),
            [('talker.py', 'node', 'Talker'), ('talker.py', 'topic', '/Reset')])


def test_package(learner):
    """The package MyRobot is reported; my_robot is not.

    Read the element <name> of package.xml.
    """
    compare(bad_names(learner, {'package.xml': package_xml('MyRobot')}), [('package.xml', 'package', 'MyRobot')])
    compare(bad_names(learner, {'package.xml': package_xml('my_robot')}), [])


def test_services(learner):
    """Names of services and of nodes made by create_node are judged as well.

    One table of the functions: which kind of name, and which argument.
    """
    text = "n = create_node('arm_2')\nn.create_service(Empty, 'arm/Stop', stop)\nn.create_client(Empty, 'go')\n"
    compare(bad_names(learner, {'arm/arm.py': text}), [('arm/arm.py', 'service', 'arm/Stop')])
