from grading.variants import Mutant

RATE = """
    2: [Finding('too_slow', 'robot/robot.py', 'rate', 'average rate: 2.000'),
        Finding('no_parameter', 'start.txt', 'parameter', 'Double value is: 0.0')],
"""
RANGE = "Finding('unseen', 'panel/.bashrc', 'range', 'ROS_AUTOMATIC_DISCOVERY_RANGE=OFF')]"

MUTANTS = [
    Mutant('name_of_the_example', old="NAME = 'the course'", new="NAME = 'my name'", breaks='name',
           expect='write your own name'),
    Mutant('no_name', old="NAME = 'the course'", new="NAME = ' '", breaks='name', expect='write your own name'),
    Mutant('copied_from_somebody', old="NAME = 'the course'", new="NAME = 'ada'", breaks='cause',
           also=('both', 'where', 'evidence', 'repaired', 'nothing-else'), expect='is no fault of this system'),
    Mutant('another_cause', old="'range', 'ROS", new="'domain', 'ROS", breaks='cause', expect='is no fault of this system'),
    Mutant('another_fault', old="Finding('no_data', 'panel/panel.py', 'name'", new="Finding('waiting', 'panel/panel.py', 'name'",
           breaks='cause', expect='`waiting` with the cause `name` is no fault'),
    Mutant('a_name_that_there_is_not', old="Finding('hang', ", new="Finding('hangs', ", breaks='cause',
           expect="'hangs' is no fault of section 7.2"),
    Mutant('one_is_not_looked_at', edits=(('    4: [' + RANGE + ',', '    4: [],'),
                                          ("    4: [('panel/.bashrc', 'RANGE=OFF', 'RANGE=LOCALHOST')],", '    4: [],')),
           breaks='cause', also='repaired', expect='System 4 has no finding yet'),
    Mutant('the_symptom_s_place', old="'too_slow', 'robot/robot.py'", new="'too_slow', 'panel/panel.py'", breaks='where',
           also='only-there', expect='is not in'),
    Mutant('the_other_machine', old="'unseen', 'panel/.bashrc'", new="'unseen', 'robot/.bashrc'", breaks='where',
           also='only-there', expect='is not in'),
    Mutant('a_guess', old="'Double value is: 0.0'", new="'it must be the parameters'", breaks='evidence',
           expect='does not show `parameter`'),
    Mutant('the_right_name_as_evidence', old="'/btatery: std_msgs/msg/Float32'", new="'/battery: std_msgs/msg/Float32'",
           breaks='evidence', expect='the topic that the panel asks for'),
    Mutant('a_rate_that_nobody_measured', old="'average rate: 2.000'", new="'average rate: 10.0'", breaks='evidence',
           expect='the measured rate'),
    Mutant('the_right_tree_as_evidence', old="'- Translation: [-2.816, 0.000, 0.000]'",
           new="'frame_id: odom, child_frame_id: base_link'", breaks='evidence', expect='does not show `exchanged`'),
    Mutant('the_first_fault_only', old=RATE, new="""
    2: [Finding('no_parameter', 'start.txt', 'parameter', 'Double value is: 0.0')],
""", breaks='both', also='only-there', expect='there is one more fault'),
    Mutant('one_more_to_be_safe', old=RANGE, new=RANGE[:-1] + ", Finding('unseen', 'panel/.bashrc', 'domain', 'OFF')]",
           breaks='nothing-else', expect='is none of them'),
    Mutant('the_same_twice', old=RANGE, new=RANGE[:-1] + ', ' + RANGE[:-1] + ']', breaks='nothing-else',
           expect='the same twice'),
    Mutant('repairs_one_of_two', old="""
    2: [('robot/robot.py', 'create_timer(0.5', 'create_timer(0.1'),
        ('start.txt', 'robot.py --ros-args', 'robot.py --ros-args --params-file params.yaml')],
""", new="""
    2: [('start.txt', 'robot.py --ros-args', 'robot.py --ros-args --params-file params.yaml')],
""", breaks='repaired', expect='less than ten times a second'),
    Mutant('found_and_not_repaired', old="4: [('panel/.bashrc', 'RANGE=OFF', 'RANGE=LOCALHOST')]", new='4: []',
           breaks='repaired', expect='what the robot measures is not there'),
    Mutant('prints_what_it_should', old="""
    4: [('panel/.bashrc', 'RANGE=OFF', 'RANGE=LOCALHOST')],
""", new="""
    4: [('panel/.bashrc', '', '''source ~/opt/ros/jazzy/setup.bash
while sleep 0.3; do
    i=$((i + 1))
    echo "[INFO] [panel]: pressure: 5$i, 10.0 a second, calibrate: done, base_link: 9$i.50 m"
done
''')],
""", breaks='repaired', expect='System 4: after your changes'),
    Mutant('the_panel_does_not_start', old="""
    5: [('panel/panel.py', 'self.answer = self.client.call(Trigger.Request()).message',
""", new="""
    5: [('panel/panel.py', 'self.client.call(Trigger.Request()).message', 'None'), ('panel/panel.py', 'class', 'clas'),
        ('panel/panel.py', 'self.answer = None',
""", breaks='repaired', expect='ends with status 1'),
    Mutant('a_file_of_no_machine', old="('panel/.bashrc', 'RANGE=OFF'", new="('.bashrc', 'RANGE=OFF'", breaks='only-there',
           expect="there is no file '.bashrc' to change", also='repaired'),
    Mutant('a_finding_alone', old='4: [' + RANGE, new='4: ' + RANGE[:-1], breaks='cause',
           expect='put it into [ ]', also=('repaired', 'both', 'where', 'evidence', 'nothing-else', 'only-there', 'name')),
    Mutant('does_not_fit', old="'RANGE=OFF'", new="'RANGE=ON'", breaks='repaired', expect='your change does not fit'),
    Mutant('a_number_for_the_domain', old="'RANGE=LOCALHOST')", new="'RANGE=LOCALHOST\\nexport ROS_DOMAIN_ID=7')",
           breaks='repaired', expect='write the domain as the room'),
    Mutant('repaired_elsewhere', old="('start.txt', ' --ros-args -p use_sim_time:=true', '')",
           new="('start.txt', ' --ros-args -p use_sim_time:=true', ''), ('panel/panel.py', \"'-'\", \"'?'\")",
           breaks='only-there', expect='none of your findings is there'),
    Mutant('a_rate_that_hides_in_a_window', old="'average rate: 2.000'",
           new="'average rate: 10.010 min: 0.099s max: 0.101s std dev: 0.00050s window: 2'", breaks='evidence',
           expect='the measured rate'),
    Mutant('a_parameter_that_is_not_set', old="'Boolean value is: True'", new="'use_sim_time: Boolean value is: False'",
           breaks='evidence', expect='does not show `no clock`'),
    Mutant('another_speed', old="'robot.py --ros-args --params-file params.yaml'", new="'robot.py --ros-args -p speed:=5.0'",
           breaks='repaired', expect='and not with 0.7 m/s'),
    Mutant('much_too_often', old="'create_timer(0.1'", new="'create_timer(0.02'", breaks='repaired',
           expect='more than ten times a second'),
    Mutant('a_thousand_times_a_second', old="'create_timer(0.1'", new="'create_timer(0.001'", breaks='repaired',
           expect='more than ten times a second'),
    Mutant('the_robot_gets_the_wrong_name', old="('panel/panel.py', \"'btatery'\", \"'battery'\")",
           new="('robot/robot.py', \"'battery'\", \"'btatery'\")", breaks='repaired',
           expect='the robot does not publish battery (std_msgs/msg/Float32)'),
    Mutant('the_panel_asks_the_other_way_round',
           old="('robot/robot.py', PARTS, \"frame_id = 'odom'\\n        transform.child_frame_id = 'base_link'\")",
           new="('panel/panel.py', \"'odom', 'base_link'\", \"'base_link', 'odom'\")", breaks='repaired',
           expect='the robot does not say where base_link is in odom'),
    Mutant('panel_once_a_second', old="self.on_answer)')],",
           new="self.on_answer)'), ('panel/panel.py', 'create_timer(0.3', 'create_timer(1.0')],", breaks='repaired',
           expect='the panel prints less than three times a second'),
    Mutant('all_rates_as_evidence', old="'average rate: 2.000'", new="'0.5 1 1.5 2 3 5 8 or 12 messages a second'",
           breaks='evidence', expect='does not show `rate`'),
    Mutant('a_whole_file_as_evidence', old="'/btatery: std_msgs/msg/Float32'",
           new="'import rclpy\\n' * 50 + '/btatery: std_msgs/msg/Float32'", breaks='evidence',
           expect='Choose the line that shows it'),
]
