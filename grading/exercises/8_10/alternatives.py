from grading.variants import Alternative

ALTERNATIVES = [
    Alternative('share_directory', source="""
DELIVERY_YAML = '''
/**:
  ros__parameters: {max_linear: 0.4, tolerance: 0.08, timeout: 30.0, use_sim_time: true}
'''
DELIVERY_LAUNCH = '''
from pathlib import Path

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, IncludeLaunchDescription
from launch.launch_description_sources import PythonLaunchDescriptionSource
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node


def generate_launch_description():
    share = Path(get_package_share_directory('delivery_robot'))
    world = Path(get_package_share_directory('mujoco_world')) / 'launch' / 'world.launch.py'
    scene, factor = LaunchConfiguration('scene'), LaunchConfiguration('real_time_factor')
    robot = Node(package='delivery_robot', executable='robot', parameters=[str(share / 'config' / 'delivery.yaml')])
    return LaunchDescription([
        DeclareLaunchArgument('scene', default_value='rooms'),
        DeclareLaunchArgument('real_time_factor', default_value='1.0'),
        robot,
        IncludeLaunchDescription(PythonLaunchDescriptionSource(str(world)),
                                 launch_arguments={'scene': scene, 'real_time_factor': factor}.items()),
    ])
'''
""", alone=True),
    Alternative('parameter_file_and_set_parameter', source="""
DELIVERY_YAML = '''
delivery_robot:
  ros__parameters:
    max_linear: 0.4
    tolerance: 0.08
    timeout: 30.0
'''
DELIVERY_LAUNCH = '''
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, GroupAction, IncludeLaunchDescription
from launch.substitutions import LaunchConfiguration, PathJoinSubstitution
from launch_ros.actions import Node, SetParameter
from launch_ros.parameter_descriptions import ParameterFile
from launch_ros.substitutions import FindPackageShare


def generate_launch_description():
    values = PathJoinSubstitution([FindPackageShare('delivery_robot'), 'config', 'delivery.yaml'])
    world = PathJoinSubstitution([FindPackageShare('mujoco_world'), 'launch', 'world.launch.py'])
    names = {'scene': 'rooms', 'real_time_factor': '1.0'}
    return LaunchDescription([
        *[DeclareLaunchArgument(name, default_value=value) for name, value in names.items()],
        IncludeLaunchDescription(world, launch_arguments=[(name, LaunchConfiguration(name)) for name in names]),
        GroupAction([
            SetParameter('use_sim_time', True),
            Node(package='delivery_robot', executable='robot', parameters=[ParameterFile(values, allow_substs=True)]),
        ]),
    ])
'''
""", alone=True),
    Alternative('default_in_two_parts', old="default_value='1.0'", new="default_value=['1', '.0']", alone=True),
]
