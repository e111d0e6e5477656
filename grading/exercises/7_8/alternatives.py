from grading.variants import Alternative

ALTERNATIVES = [
    Alternative('other_lines_of_the_tools', edits=(
        ("'Boolean value is: True'", "'Publisher count: 0'"),
        ("'average rate: 2.000'", "'temperature: 31, 2.0 a second'"),
        ("'- Translation: [-2.816, 0.000, 0.000]'", "'child_frame_id: odom'"),
        ("'/btatery: std_msgs/msg/Float32'", "'/btatery'"),
        ("'File \"panel.py\", line 54 in on_timer'", "'self.answer = self.client.call(Trigger.Request()).message'"),
    )),
    Alternative('the_tree_of_view_frames', old="'- Translation: [-2.816, 0.000, 0.000]'",
                new="'odom: \\n  parent: \\'base_link\\''"),
    Alternative('other_repairs', edits=(
        ("' --ros-args -p use_sim_time:=true', ''", "'use_sim_time:=true', 'use_sim_time:=false'"),
        ("'create_timer(0.5', 'create_timer(0.1'", "'create_timer(0.5', 'create_timer(1 / 10'"),
        ("'RANGE=OFF', 'RANGE=LOCALHOST'", "'export ROS_AUTOMATIC_DISCOVERY_RANGE=OFF', ''"),
    )),
    Alternative('whole_file', edits=(
        ("('start.txt', ' --ros-args -p use_sim_time:=true', '')",
         "('start.txt', '', 'robot: python3 robot.py --ros-args --params-file params.yaml\\npanel: python3 panel.py\\n')"),
    )),
    # The numbers are those that faults had before they had names.
    Alternative('in_another_order_with_numbers', edits=(
        ("""
    2: [Finding('too_slow', 'robot/robot.py', 'rate', 'average rate: 2.000'),
        Finding('no_parameter', 'start.txt', 'parameter', 'Double value is: 0.0')],
""", """
    2: [('A7.15', 'start.txt', 'parameter', 'Double value is: 0.0'),
        ('A7.14', 'robot/robot.py', 'rate', 'average rate: 1.98')],
"""),
        ("Finding('unseen', 'panel/.bashrc', 'range', 'ROS", "Finding(row='A7.7', where='panel/.bashrc', cause='range', evidence='ROS"),
    )),
]
