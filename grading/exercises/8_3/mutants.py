from grading.variants import Mutant

MUTANTS = [
    Mutant('path_in_the_workspace', old="PathJoinSubstitution([FindPackageShare('fleet'), 'config', 'fleet.yaml'])",
           new="'install/fleet/share/fleet/config/fleet.yaml'", expect='find it by the name of the package',
           breaks='installed-file'),
    Mutant('a_value_before_the_file', old="Node(namespace='robot1', parameters=[config]",
           new="Node(namespace='robot1', parameters=[{'rate': 15.0}, config]",
           expect='gives a governor a value itself, besides the file: rate = 15.0', breaks='installed-file'),
    Mutant('absolute_remapping', old="=[('cmd_vel', 'base/cmd_vel')], *", new="=[('cmd_vel', '/base/cmd_vel')], *",
           expect='Names in remappings are relative', breaks='remapped'),
    Mutant('blocks_for_two_only', source="""
FLEET_YAML = '''
/robot1/governor:
  ros__parameters:
    rate: 20.0
    max_linear: 1.0
/robot2/governor:
  ros__parameters:
    mode: slow
    rate: 20.0
    max_linear: 0.6
'''
FLEET_LAUNCH = '''
from launch import LaunchDescription
from launch.substitutions import PathJoinSubstitution
from launch_ros.actions import Node
from launch_ros.substitutions import FindPackageShare


def generate_launch_description():
    config = PathJoinSubstitution([FindPackageShare('fleet'), 'config', 'fleet.yaml'])
    governor = {'package': 'fleet', 'executable': 'governor', 'output': 'screen'}
    return LaunchDescription([
        Node(namespace='robot1', parameters=[config], **governor),
        Node(namespace='robot2', parameters=[config], remappings=[('cmd_vel', 'base/cmd_vel')], **governor),
    ])
'''
""", expect='with your file has', breaks='rate', also='max-linear'),
    Mutant('general_block_last', edits=(('''
            /**:
              ros__parameters:
                rate: 20.0
                max_linear: 0.6
            ''', ''),
            ("""
            /robot2/governor:
              ros__parameters:
                mode: slow

            %%answer FLEET_LAUNCH delivery_ws/src/fleet/launch/fleet.launch.py
            """, """
            /robot2/governor:
              ros__parameters:
                mode: slow
            /**:
              ros__parameters:
                rate: 20.0
                max_linear: 0.6

            %%answer FLEET_LAUNCH delivery_ws/src/fleet/launch/fleet.launch.py
            """)), expect='does a later block override it', breaks='robot1'),
    Mutant('integer', old='rate: 20.0', new='rate: 20', expect='has the wrong type', breaks='types',
           also=('nodes', 'rate')),
    Mutant('no_namespace_in_the_block', old='/robot1/governor:', new='governor:',
           expect='does the name of the block fit', breaks='robot1', also='max-linear'),
    Mutant('one_underscore', edits=(('''
            /**:
              ros__parameters:
            ''', '''
            /**:
              ros_parameters:
            '''),
            ('''
            /robot1/governor:
              ros__parameters:
            ''', '''
            /robot1/governor:
              ros_parameters:
            '''),
            ('''
            /robot2/governor:
              ros__parameters:
            ''', '''
            /robot2/governor:
              ros_parameters:
            ''')), expect='cannot read FLEET_YAML', breaks='types', also=('nodes', 'rate')),
    Mutant('path_of_the_sources',
           old="config = PathJoinSubstitution([FindPackageShare('fleet'), 'config', 'fleet.yaml'])",
           new="config = 'src/fleet/config/fleet.yaml'", expect='so name the installed file', breaks='installed-file',
           also='nodes'),
    Mutant('beside_the_launch_file', breaks='installed-file', expect='find it by the name of the package',
           old="config = PathJoinSubstitution([FindPackageShare('fleet'), 'config', 'fleet.yaml'])",
           new="config = str(__import__('pathlib').Path(__file__).parents[1] / 'config/fleet.yaml')"),
    Mutant('beside_the_launch_file_if_it_is_there', breaks='installed-file', expect='find it by the name of the package',
           old="config = PathJoinSubstitution([FindPackageShare('fleet'), 'config', 'fleet.yaml'])",
           new="beside = __import__('pathlib').Path(__file__).parents[1] / 'config/fleet.yaml'\n"
           "config = str(beside) if beside.exists() else PathJoinSubstitution([FindPackageShare('fleet'), 'config', 'fleet.yaml'])"),
    Mutant('values_in_the_launch_file', edits=(('parameters=[config], *', "parameters=[config, {'rate': 20.0}], *"),
            ('parameters=[config], remappings', "parameters=[config, {'rate': 20.0}], remappings")),
           expect='must use the installed file', breaks='installed-file'),
    Mutant('everyone_is_slow', edits=(("""
            /robot2/governor:
              ros__parameters:
                mode: slow
            """, ''), ('    max_linear: 0.6', '    max_linear: 0.6\n    mode: slow\n')),
           expect="has mode = 'slow', expected 'normal'", breaks='robot2'),
    Mutant('slow_in_every_robot2', old='/robot2/governor:', new='/**/robot2/governor:', breaks='robot2',
           expect="has mode = 'slow', expected 'normal'"),
    Mutant('slow_below_robot2', old='/robot2/governor:', new='/robot2/**:', breaks='robot2',
           expect="has mode = 'slow', expected 'normal'"),
    Mutant('one_value_in_both_files', old='parameters=[config], remappings',
           new="parameters=[config, {'max_linear': 0.6}], remappings", breaks='installed-file',
           expect='has max_linear = 0.6. The launch file must use the installed file'),
    Mutant('default_max_linear', old='    max_linear: 0.6', new='', expect='has max_linear = 0.5', breaks='max-linear'),
    Mutant('half_the_rate', old='rate: 20.0', new='rate: 2.0', expect='has rate = 2.0', breaks='rate'),
    Mutant('both_are_remapped', old="Node(namespace='robot1', parameters=[config], **governor),",
           new="Node(namespace='robot1', parameters=[config], remappings=[('cmd_vel', 'base/cmd_vel')], **governor),",
           expect='expected /robot1/cmd_vel', breaks='others-stay'),
    Mutant('one_robot', old="Node(namespace='robot1', parameters=[config], **governor),", new='',
           expect='These nodes were started', breaks='nodes'),
    Mutant('another_name', old="Node(namespace='robot1', parameters",
           new="Node(namespace='robot1', name='g', parameters", expect='These nodes were started', breaks='nodes'),
    Mutant('a_program_of_its_own', edits=(("""
            def generate_launch_description():
            """, '''
            import sys

            PROGRAM = """
            import rclpy
            from geometry_msgs.msg import Twist

            rclpy.init()
            node = rclpy.create_node('governor')
            for name, value in (('max_linear', 0.5), ('slow_linear', 0.2), ('rate', 10.0), ('mode', 'normal')):
                node.declare_parameter(name, value)
            node.create_publisher(Twist, 'cmd_vel', 10)
            node.create_subscription(Twist, 'cmd_vel_in', lambda message: None, 10)
            rclpy.spin(node)
            """


            def generate_launch_description():
            '''),
            ("{'package': 'fleet', 'executable': 'governor', ",
             "{'executable': sys.executable, 'arguments': ['-c', PROGRAM], ")),
           expect='is not the executable governor of the package fleet', breaks='nodes'),
    Mutant('robot1_in_the_launch_file', edits=(("""
            /robot1/governor:
              ros__parameters:
                max_linear: 1.0
            """, ''), ("namespace='robot1', parameters=[config]", "namespace='robot1', parameters=[config, {'max_linear': 1.0}]")),
           expect='/robot1/governor has max_linear = 1.0. The launch file must', breaks='installed-file'),
    Mutant('a_default_in_the_launch_file', old="namespace='robot1', parameters=[config]",
           new="namespace='robot1', parameters=[config, {'mode': 'normal'}]", breaks='installed-file',
           expect='/robot1/governor has mode = normal. The launch file must'),
    Mutant('by_the_folder_of_colcon', breaks='installed-file', expect='find it by the name of the package',
           old="config = PathJoinSubstitution([FindPackageShare('fleet'), 'config', 'fleet.yaml'])",
           new="import os\nconfig = os.environ['COLCON_PREFIX_PATH'].split(':')[0] + '/fleet/share/fleet/config/fleet.yaml'"),
    Mutant('one_value_more', old='    max_linear: 0.6', new='    max_linear: 0.6\n    slow_linear: 0.3\n', breaks='rest',
           expect='has slow_linear = 0.3'),
    Mutant('events_are_remapped', old="('cmd_vel', 'base/cmd_vel')]",
           new="('cmd_vel', 'base/cmd_vel'), ('/parameter_events', 'parameter_events')]", breaks='others-stay',
           expect='/robot2/governor has the topic /robot2/parameter_events'),
    Mutant('log_below_base', old="('cmd_vel', 'base/cmd_vel')]",
           new="('cmd_vel', 'base/cmd_vel'), ('/rosout', 'base/rosout')]", breaks='others-stay',
           expect='has the topic /robot2/base/rosout'),
    Mutant('no_simulated_time_by_the_launch_file', old="parameters=[config], remappings=[('cmd_vel', 'base/cmd_vel')]",
           new="parameters=[config, {'use_sim_time': False}], remappings=[('cmd_vel', 'base/cmd_vel')]",
           expect='gives a governor a value itself', breaks='installed-file'),
    Mutant('simulated_time', old='rate: 20.0', new="""
           rate: 20.0
           use_sim_time: true
           """, expect='has set use_sim_time to true', breaks='others-stay', also='remapped'),
    Mutant('another_file', old="'config', 'fleet.yaml'", new="'config', 'fleet.yml'", breaks='installed-file', also='nodes',
           expect='there is config/fleet.yaml: is that meant'),
    Mutant('no_space_behind_a_colon', old='rate: 20.0', new='rate:20.0', breaks='types', also=('nodes', 'rate'),
           edits=(('    max_linear: 0.6', '    max_linear:0.6'),), expect='a space is missing behind the colon'),
    Mutant('a_mode_that_is_no_text', old='mode: slow', new='mode: off', breaks='types', also='nodes',
           expect='in quotes they are texts'),
    Mutant('a_third_one_later', edits=(('import LaunchDescription', 'import LaunchDescription, actions'),
           ("Node(namespace='robot1', parameters=[config], **governor),", """
           Node(namespace='robot1', parameters=[config], **governor),
           actions.TimerAction(period=60.0, actions=[Node(namespace='robot3', parameters=[config], **governor)]),
           """)), expect='These nodes were started: /robot1/governor, /robot2/governor, /robot3/governor', breaks='nodes'),
    Mutant('a_third_one_in_a_process_that_sleeps', edits=(('import LaunchDescription', 'import LaunchDescription, actions'),
           ("Node(namespace='robot1', parameters=[config], **governor),", """
           Node(namespace='robot1', parameters=[config], **governor),
           actions.ExecuteProcess(cmd=['bash', '-c', 'sleep 60; exec ros2 run fleet governor']),
           """)), expect='Not each of them has a node', breaks='nodes'),
    Mutant('by_the_first_folder_of_ros', breaks='installed-file', expect='find it by the name of the package',
           old="config = PathJoinSubstitution([FindPackageShare('fleet'), 'config', 'fleet.yaml'])",
           new="import os\nconfig = os.environ['AMENT_PREFIX_PATH'].split(':')[0] + '/share/fleet/config/fleet.yaml'"),
    Mutant('star_in_a_word', old='/robot2/governor:', new='/robot2*/governor:', breaks='types',
           also=('nodes', 'rate', 'max-linear', 'robot1', 'robot2', 'rest', 'installed-file', 'remapped', 'others-stay'),
           expect='is no name of a node, because of `robot2*`'),
    Mutant('private_remapping', old="=[('cmd_vel', 'base/cmd_vel')], *", new="=[('cmd_vel', '~/base/cmd_vel')], *",
           expect='`~` stands for the name of the node', breaks='remapped'),
    Mutant('remapped_the_other_way', old="('cmd_vel', 'base/cmd_vel')]", new="('base/cmd_vel', 'cmd_vel')]",
           expect='what the program says first', breaks='remapped'),
]
