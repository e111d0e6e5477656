from grading.variants import Alternative

ALTERNATIVES = [
    Alternative('files_in_a_variable',
                edits=(('rosidl_generate_interfaces(${PROJECT_NAME} "msg/Charge.msg" "srv/Dock.srv" DEPENDENCIES std_msgs)', '''
            set(files msg/Charge.msg srv/Dock.srv)
            rosidl_generate_interfaces(${PROJECT_NAME} ${files} DEPENDENCIES std_msgs)
            '''),
            ('depend>std_msgs<', 'depend>rosidl_default_generators</depend> <depend>std_msgs<'))),
    Alternative('separate_depends', edits=(('''
            uint8 FULL=100
            std_msgs/Header header
            ''', 'std_msgs/Header header  # when and where'),
            ('bool charging', '''
            bool charging
            uint8 FULL = 100
            '''),
            ('<depend>std_msgs</depend>', '''
            <build_depend>std_msgs</build_depend>
            <exec_depend>std_msgs</exec_depend>
            '''))),
    Alternative('comments_that_name_the_constant', old='uint8 FULL=100', new="""
        # FULL
        # FULL = the battery takes no more
        uint8 FULL=100  # FULL = 100 %
        """),
    Alternative('in_quotes', source="""
MSG = '''# dock_interfaces/msg/Charge
uint8 FULL=100
std_msgs/Header header
uint8 percent
bool charging
'''
SRV = '''# dock_interfaces/srv/Dock
string station
float32 speed 0.2
---
bool docked
string message
'''
CMAKE = '''cmake_minimum_required(VERSION 3.16)
project(dock_interfaces)
find_package(ament_cmake REQUIRED)
find_package(rosidl_default_generators REQUIRED)
find_package(std_msgs REQUIRED)
rosidl_generate_interfaces(${PROJECT_NAME} "msg/Charge.msg" "srv/Dock.srv" DEPENDENCIES std_msgs)
ament_package()
'''
DOCK_XML = package_xml(
    'dock_interfaces', 'ament_cmake',
    '<buildtool_depend>ament_cmake</buildtool_depend>',
    '<buildtool_depend>rosidl_default_generators</buildtool_depend>',
    '<depend>std_msgs</depend>',
    '<exec_depend>rosidl_default_runtime</exec_depend>',
    '<member_of_group>rosidl_interface_packages</member_of_group>',
)
"""),
    Alternative('service_in_another_order', edits=(("""
            string station
            float32 speed 0.2
            """, """
            float32 speed 2e-1
            string station
            """), ("""
            bool docked
            string message
            """, """
            string message
            bool docked
            """))),
    Alternative('files_that_cmake_finds', edits=(('find_package(std_msgs REQUIRED)', '''
            foreach(name std_msgs)
              find_package(${name} REQUIRED)
            endforeach()
            '''),
            ('rosidl_generate_interfaces(${PROJECT_NAME} "msg/Charge.msg" "srv/Dock.srv" DEPENDENCIES std_msgs)', '''
            file(GLOB files RELATIVE ${CMAKE_CURRENT_SOURCE_DIR} msg/*.msg srv/*.srv)
            rosidl_generate_interfaces(${PROJECT_NAME} ${files} DEPENDENCIES std_msgs)
            ament_export_dependencies(rosidl_default_runtime)
            '''))),
]
