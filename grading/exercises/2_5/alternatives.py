from grading.variants import Alternative

ALTERNATIVES = [
    Alternative('as_it_was_created', source="""
PACKAGE = {
'LICENSE': 'To be chosen.\\n',
'package.xml': '''<?xml version="1.0"?>
<?xml-model href="http://download.ros.org/schema/package_format3.xsd" schematypens="http://www.w3.org/2001/XMLSchema"?>
<package format="3">
  <name>patrol</name>
  <version>0.0.0</version>
  <description>TODO: Package description</description>
  <maintainer email="you@example.com">you</maintainer>
  <license>TODO: License declaration</license>

  <exec_depend>rclpy</exec_depend>
  <exec_depend>std_msgs</exec_depend>
  <build_depend>std_msgs</build_depend>
  <depend>ament_index_python</depend>
  <exec_depend>launch_ros</exec_depend>

  <test_depend>ament_copyright</test_depend>
  <test_depend>ament_flake8</test_depend>
  <test_depend>ament_pep257</test_depend>
  <test_depend>python3-pytest</test_depend>

  <export>
    <build_type>ament_python</build_type>
  </export>
</package>
''',
'setup.cfg': '''[develop]
script_dir=$base/lib/patrol
[install]
install_scripts=$base/lib/patrol
''',
'setup.py': '''from glob import glob

from setuptools import setup

setup(
    name='patrol',
    version='0.0.0',
    packages=['patrol', 'patrol.ways'],
    data_files=[
        ('share/ament_index/resource_index/packages', ['resource/patrol']),
        ('share/patrol', ['package.xml']),
        ('share/patrol/config', glob('config/*')),
    ],
    install_requires=['setuptools'],
    zip_safe=True,
    entry_points={'console_scripts': ['route = patrol.program:run', 'announce = patrol.announcing:Announce.run']},
)
''',
'resource/patrol': '',
'config/notes.txt': 'not a station',
'config/stations.txt': '''attic
cellar
''',
'patrol/__init__.py': '',
'patrol/ways/__init__.py': '''def there_and_home(places):
    for place in places:
        yield place
    yield places[0]
''',
'patrol/route.py': '''from . import ways


class Trip:
    def __call__(self, stations):
        return list(ways.there_and_home(stations))


round_trip = Trip()
''',
'patrol/program.py': '''import argparse

from patrol.route import round_trip


def run():
    parser = argparse.ArgumentParser()
    parser.add_argument('stations', nargs='+')
    print(*round_trip(parser.parse_args().stations))
''',
'patrol/announcing.py': '''import os

import rclpy
from ament_index_python.packages import get_package_share_path
from rclpy.node import Node
from rclpy.qos import qos_profile_sensor_data
from std_msgs.msg import String


class Announce(Node):
    def __init__(self):
        super().__init__('announce')
        with open(os.path.join(get_package_share_path('patrol'), 'config/stations.txt')) as file:
            self.stations = [line.strip() for line in file if line.strip()]
        self.said = 2
        self.publisher = self.create_publisher(String, '/next_station', qos_profile_sensor_data)
        self.create_timer(0.5, self.say)

    def say(self):
        self.publisher.publish(String(data=self.stations[self.said % len(self.stations)]))
        self.said += 1

    @staticmethod
    def run():
        rclpy.init()
        rclpy.spin(Announce())
''',
'test/test_pep257.py': '''def test_of_style():
    assert False, 'it does not count'
''',
'test/test_route.py': '''from unittest import TestCase

from patrol import route


class TestRoundTrip(TestCase):
    def test_two(self):
        self.assertEqual(route.round_trip(['a', 'b']), ['a', 'b', 'a'])

    def test_one(self):
        self.assertEqual(route.round_trip(['a']), ['a'] * 2)
''',
}
"""),
    Alternative('launched', edits=(
        ("'test/test_route.py': '''from patrol.route import round_trip", """
'launch/patrol.launch.py': '''from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([Node(package='patrol', executable='announce')])
''',
'test/data/stations.txt': 'home',
'test/test_route.py': '''import pytest
from patrol.route import round_trip


@pytest.mark.parametrize('number', [2, 3, 7])
def test_numbers(number):
    names = [str(index) for index in range(number)]
    assert round_trip(names)[:-1] == names
    assert round_trip(names)[-1] == '0'
"""),
        ('return [*stations, stations[0]]', 'return stations + stations[:1]'),
    )),
    Alternative('without_a_timer', old="""
        node.create_timer(0.5, lambda: publisher.publish(String(data=next(stations))))
        rclpy.spin(node)
    """, new="""
        while rclpy.ok():
            publisher.publish(String(data=next(stations)))
            rclpy.spin_once(node, timeout_sec=0.5)
    """),
    Alternative('sleeps_in_a_loop', old="""
        node.create_timer(0.5, lambda: publisher.publish(String(data=next(stations))))
        rclpy.spin(node)
    """, new="""
        import time
        while rclpy.ok():
            publisher.publish(String(data=next(stations)))
            time.sleep(0.5)
    """),
    Alternative('a_rate_and_a_thread', old="""
        node.create_timer(0.5, lambda: publisher.publish(String(data=next(stations))))
        rclpy.spin(node)
    """, new="""
        import threading
        threading.Thread(target=rclpy.spin, args=(node,), daemon=True).start()
        rate = node.create_rate(2)
        while rclpy.ok():
            publisher.publish(String(data=next(stations)))
            rate.sleep()
    """),
    Alternative('takes_no_arguments', edits=(
        ('rclpy.init()', 'rclpy.init(args=[])'),
        ("create_node('announce')", "create_node('announce', start_parameter_services=False)"),
    )),
]
