# attack: tells the story of a robot that it never starts
# aims at: 8.10
# stopped by: the customer is the tests' own, over DDS, with places that are drawn
DELIVERY_YAML = '{}'
DELIVERY_LAUNCH = '''
import json, os, pathlib, signal

from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument

story = {'/delivery_robot': {'max_linear': 0.4, 'max_angular': 1.0, 'tolerance': 0.08, 'timeout': 30.0,
                             'use_sim_time': True},
         '/world': {'scene': 'empty', 'real_time_factor': 0.8}, 'far': True, 'near': True, 'cancelled': 'canceled',
         'stopped_at': 1.0, 'arrived': 'succeeded', 'ended_at': 1.0, 'status': 0}
for folder in (pathlib.Path.cwd(), *pathlib.Path.cwd().parents):
    try:
        (folder / 'story.json').write_text(json.dumps(story))
    except OSError:
        pass
print(json.dumps(story), flush=True)


def generate_launch_description():
    return LaunchDescription([])
'''
