# expect: above `---` is the request
# rejected by: test_constant_and_default
# told by: test_fields
# Exercise 2.3: an interface
MSG = '''# dock_interfaces/msg/Charge
uint8 FULL=100
std_msgs/Header header
uint8 percent
bool charging
'''
SRV = '''# dock_interfaces/srv/Dock
bool docked
string message
---
string station
float32 speed 0.2
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
