from grading.variants import Alternative

ALTERNATIVES = [
    Alternative('files_in_a_variable',
                edits=(('rosidl_generate_interfaces(${PROJECT_NAME} "msg/Charge.msg" "srv/Dock.srv" DEPENDENCIES std_msgs)', '''
            set(files msg/Charge.msg srv/Dock.srv)
            rosidl_generate_interfaces(${PROJECT_NAME} ${files} DEPENDENCIES std_msgs)
            '''),
            ('depend>std_msgs<', "depend>rosidl_default_generators</depend>', '<depend>std_msgs<"))),
    Alternative('separate_depends', edits=(('''
            uint8 FULL=100
            std_msgs/Header header
            ''', 'std_msgs/Header header  # when and where'),
            ('bool charging', '''
            bool charging
            uint8 FULL = 100
            '''),
            ("'<depend>std_msgs</depend>',", '''
            '<build_depend>std_msgs</build_depend>',
            '<exec_depend>std_msgs</exec_depend>',
            '''))),
]
