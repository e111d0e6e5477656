"""The scene for RViz2, which is not on this machine: YAML of the right form that asks for what our displays show."""

from pathlib import Path

import pytest
import yaml
from ament_index_python.packages import get_package_share_directory

from helpers.show import views

FILE = Path(get_package_share_directory('mobile_robot_description'), 'rviz', 'mobile_robot.rviz')
SAME = {'RobotModel': 'Description Topic', 'LaserScan': 'Topic', 'PointCloud2': 'Topic', 'Odometry': 'Topic'}


@pytest.fixture(scope='module')
def scene() -> dict:
    return yaml.safe_load(FILE.read_text())['Visualization Manager']


@pytest.fixture
def displays(scene) -> dict[str, dict]:
    """By the name of the class, without its plugin library."""
    return {display['Class'].removeprefix('rviz_default_plugins/'): display for display in scene['Displays']}


def test_displays_are_those_of_the_course(scene, displays):
    assert scene['Global Options']['Fixed Frame'] == 'odom'
    assert {'Grid', 'TF', *SAME, 'MarkerArray', 'Image'} == set(displays)
    for name, display in displays.items():
        assert display['Name'] == name and display['Enabled'] is True is display['Value']


@pytest.mark.parametrize('name', SAME)
def test_topic_and_qos_are_those_of_our_display(displays, name):
    ours = getattr(views, name)()
    qos, topic = ours.default_qos(), displays[name][SAME[name]]
    assert topic['Value'] == ours.topic and topic['Depth'] == qos.depth
    for policy in ('Durability', 'Reliability', 'History'):
        assert topic[f'{policy} Policy'].replace(' ', '_').upper() == getattr(qos, policy.lower()).name


def test_the_walls_are_sent_once_and_kept(displays):
    assert displays['MarkerArray']['Topic']['Durability Policy'] == 'Transient Local'
