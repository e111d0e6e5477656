"""The course's delivery robot: `urdf()` is the text of its description, `FAULTS` are ways to spoil it."""

from collections.abc import Callable
from pathlib import Path
from xml.etree import ElementTree
from xml.etree.ElementTree import Element

from ament_index_python.packages import get_package_share_directory


def path() -> Path:
    """Return the file of the robot's description."""
    return Path(get_package_share_directory('mobile_robot_description'), 'urdf', 'mobile_robot.urdf')


def urdf(fault: str = '') -> str:
    """
    Return the text of the description.

    :param fault: a name in `FAULTS`: the description with that fault.
    :raises KeyError: there is no such fault.
    """
    text = path().read_text()
    if not fault:
        return text
    builder = ElementTree.TreeBuilder(insert_comments=True)
    robot = ElementTree.fromstring(text, ElementTree.XMLParser(target=builder))
    FAULTS[fault](robot)
    return ElementTree.tostring(robot, encoding='unicode')


def _without(part: str) -> Callable[[Element], None]:
    def spoil(robot: Element) -> None:
        for link in robot.iter('link'):
            for element in link.findall(part):
                link.remove(element)

    return spoil


def _top_heavy(robot: Element) -> None:
    """The centre of mass one metre too high, as if the drawing had been in other units."""
    robot.find("link[@name='base_link']/inertial/origin").set('xyz', '-0.03 0 1.02')


FAULTS: dict[str, Callable[[Element], None]] = {
    'no_collision': _without('collision'),
    'no_inertial': _without('inertial'),
    'top_heavy': _top_heavy,
}
