from grading.variants import Mutant

INSTALLED = "PathJoinSubstitution([FindPackageShare('delivery_robot'), 'config', 'delivery.yaml']),"
ROBOT = "Node(package='delivery_robot', executable='robot', output='screen', parameters=["
HANDED_ON = "for name in ('scene', 'real_time_factor')]"

MUTANTS = [
    Mutant('another_name', old='/delivery_robot:', new='/robot:', expect='Does the name of the block fit',
           breaks='values', alone=True),
    Mutant('no_file', old=f"""
        {INSTALLED}
        {{'use_sim_time': True}}]),
        """, new="{'use_sim_time': True}]),", expect='The launch file must hand this file over', breaks='robot',
           alone=True),
    Mutant('integer', old='timeout: 30.0', new='timeout: 30', expect='A value in DELIVERY_YAML has the wrong type',
           breaks='types', alone=True),
    Mutant('path_of_the_sources', old=INSTALLED, new="'src/delivery_robot/config/delivery.yaml',",
           expect='a parameter file that is not there', breaks='robot', alone=True),
    Mutant('path_in_the_workspace', old=INSTALLED, new="'install/delivery_robot/share/delivery_robot/config/delivery.yaml',",
           expect='a parameter file that is not there', breaks='robot', alone=True),
    Mutant('a_second_publisher_of_frames', old=ROBOT,
           new="Node(package='robot_state_publisher', executable='robot_state_publisher', parameters=[{"
               "'robot_description': '<robot name=\"a\"><link name=\"b\"/></robot>'}]), " + ROBOT,
           expect='nodes with the name /robot_state_publisher', breaks='world', alone=True),
    Mutant('beside_the_launch_file', old=INSTALLED, breaks='robot', alone=True,
           new="str(__import__('pathlib').Path(__file__).parents[1] / 'config/delivery.yaml'),",
           expect='found by the name of the package'),
    Mutant('a_value_before_the_file', old="parameters=[", new="parameters=[{'timeout': 10.0},",
           expect='gives /delivery_robot a value itself, besides the file: timeout = 10.0', breaks='robot', alone=True),
    Mutant('the_same_values_twice', old="{'use_sim_time': True}", breaks='robot', alone=True,
           new="{'use_sim_time': True, 'timeout': 30.0, 'status_period': 0.5}", expect='timeout became'),
    Mutant('values_in_the_launch_file', edits=(("""
            max_linear: 0.4
            tolerance: 0.08
            timeout: 30.0
        """, 'use_sim_time: true'), ("{'use_sim_time': True}", "{'max_linear': 0.4, 'tolerance': 0.08, 'timeout': 30.0}")),
           expect='Values belong into this file', breaks='values', alone=True),
    Mutant('time_of_the_wall', old=f"""
        {INSTALLED}
        {{'use_sim_time': True}}]),
        """, new=f'{INSTALLED[:-1]}]),', expect="does not live in the world's time", breaks='sim-time', also='drives',
           alone=True),
    Mutant('no_argument', old="DeclareLaunchArgument('scene', default_value='rooms'),",
           new="DeclareLaunchArgument('scene', default_value='empty'),", expect='The default of scene is not rooms',
           breaks='arguments', alone=True),
    Mutant('a_scene_of_its_own', old=HANDED_ON, new="for name in ('real_time_factor',)] + [('scene', 'rooms')]",
           expect='the world has', breaks='world', also=('drives', 'arguments'), alone=True),
    Mutant('one_node_more', old=ROBOT, new='''
        Node(package='tf2_ros', executable='static_transform_publisher', arguments=['--child-frame-id', 'dock',
                                                                                    '--frame-id', 'map']),
        ''' + ROBOT, expect='There is one more node, /static_transform_publisher', breaks='world', alone=True),
    Mutant('a_process_that_is_no_node', old=ROBOT, new="ExecuteProcess(cmd=['sleep', '3600']), " + ROBOT,
           edits=(('from launch.actions import DeclareLaunchArgument, IncludeLaunchDescription',
                   'from launch.actions import DeclareLaunchArgument, ExecuteProcess, IncludeLaunchDescription'),),
           expect='what is no ROS node counts, too', breaks='world', alone=True),
    Mutant('nobody_hears', old=ROBOT, new=ROBOT.replace("output='screen'",
                                                        "output='screen', remappings=[('cmd_vel', 'motor')]"),
           expect='This never came', breaks='drives', alone=True),
    Mutant('status_under_another_name', old=ROBOT,
           new=ROBOT.replace("output='screen'", "output='screen', remappings=[('status', 'robot_status')]"),
           expect="on /status", breaks='drives', alone=True),
    Mutant('something_never_ends', old=ROBOT, new="""
        ExecuteProcess(cmd=['bash', '-c', 'trap "" INT TERM; sleep 600 & wait; wait'], sigterm_timeout='60'),
        Node(package='delivery_robot', executable='robot', output='screen', parameters=[
        """, edits=(('from launch.actions import DeclareLaunchArgument, IncludeLaunchDescription',
                     'from launch.actions import DeclareLaunchArgument, ExecuteProcess, IncludeLaunchDescription'),),
           expect='After Ctrl+C', breaks='ends', also='world', alone=True),
    Mutant('one_value_more', old="""
            max_linear: 0.4
        """, new="""
            max_linear: 0.4
            status_period: 1.0
        """, expect='so it keeps its default', breaks='values'),
    Mutant('two_scenes_only', old="default_value='rooms')", new="default_value='rooms', choices=['rooms', 'empty'])",
           expect='Pass the value on', breaks='world'),
    Mutant('the_world_without_its_launch_file', old="""
            IncludeLaunchDescription(
                PathJoinSubstitution([FindPackageShare('mujoco_world'), 'launch', 'world.launch.py']),
                launch_arguments=[(name, LaunchConfiguration(name)) for name in ('scene', 'real_time_factor')]),
        """, new="""
            Node(package='mujoco_world', executable='world', parameters=[
                {name: LaunchConfiguration(name) for name in ('scene', 'real_time_factor')}]),
        """, expect='world.launch.py of the package mujoco_world was not included', breaks='world', alone=True),
    Mutant('default_as_a_number', old="default_value='1.0'", new='default_value=1.0',
           expect='TypeError: expected a text', breaks='robot'),
    Mutant('declared_too_late', edits=(("DeclareLaunchArgument('scene', default_value='rooms'),", ''),
            (ROBOT, "DeclareLaunchArgument('scene', default_value='rooms'),\n" + ROBOT)),
           expect='Declare each argument before', breaks='arguments', alone=True),
    Mutant('a_name_of_its_own', old=ROBOT, new=ROBOT.replace("'robot',", "'robot', name='courier',"),
           expect='but /courier did', breaks='robot', alone=True),
    Mutant('the_word_scene', old="[(name, LaunchConfiguration(name)) for name in ('scene', 'real_time_factor')]",
           new="{'scene': 'scene', 'real_time_factor': LaunchConfiguration('real_time_factor')}.items()",
           expect='Pass the value of the argument on', breaks='world', also='arguments', alone=True),
    Mutant('default_of_its_own', edits=(("DeclareLaunchArgument('scene', default_value='rooms'),", ''),
           ("LaunchConfiguration(name)) for name", "LaunchConfiguration(name, default='empty')) for name")),
           expect='starts a world with scene = empty', breaks='arguments', alone=True),
    Mutant('another_file', old=INSTALLED, new=INSTALLED.replace('delivery.yaml', 'delivery_robot.yaml'),
           expect='there is config/delivery.yaml: is that meant', breaks='robot', alone=True),
    Mutant('one_node_more_later', old=ROBOT, new="""
        TimerAction(period=60.0, actions=[
            Node(package='tf2_ros', executable='static_transform_publisher', arguments=['--child-frame-id', 'dock',
                                                                                        '--frame-id', 'map'])]),
        """ + ROBOT, edits=(('from launch.actions import DeclareLaunchArgument, IncludeLaunchDescription',
                             'from launch.actions import DeclareLaunchArgument, IncludeLaunchDescription, TimerAction'),),
           expect='There is one more node, /static_transform_publisher', breaks='world', alone=True),
]
