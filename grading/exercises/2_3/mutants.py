from grading.variants import Mutant

DEPEND = '<depend>std_msgs</depend>'
RUNTIME = '<exec_depend>rosidl_default_runtime</exec_depend>'
GENERATORS = '<buildtool_depend>rosidl_default_generators</buildtool_depend>'
SRV = '%%answer SRV ros2_ws/src/dock_interfaces/srv/Dock.srv'

MUTANTS = [
    Mutant('unknown_to_ros', breaks='both', old='ament_package()', new='', expect='makes the package known to ROS'),
    Mutant('two_fields_exchanged', edits=(('uint8 percent', 'bool charging'), ('bool charging', 'uint8 percent')),
           expect='are in the order', breaks='charge'),
    Mutant('percent_as_float', old='uint8 percent', new='float32 percent', expect='float32 percent', breaks='charge'),
    Mutant('path_of_the_type', old='std_msgs/Header', new='std_msgs/msg/Header',
           expect='without /msg/: `std_msgs/Header`', breaks='charge'),
    Mutant('type_without_package', old='std_msgs/Header header', new='Header header',
           expect='There is no type Header in your package', breaks='charge'),
    Mutant('parenthesis_left_open', old='find_package(std_msgs REQUIRED)', new='find_package(std_msgs REQUIRED',
           expect='CMakeLists.txt, line 5: Parse error', breaks='both'),
    Mutant('boolean', old='bool charging', new='boolean charging', expect='The line `boolean charging` of Charge',
           breaks='charge'),
    Mutant('type_of_python', old='float32 speed', new='float speed', expect='ROS has float32 and float64',
           breaks='request'),
    Mutant('field_with_a_capital', old='uint8 percent', new='uint8 Percent', expect='cannot be the name of a field',
           breaks='charge'),
    Mutant('no_project', old='project(dock_interfaces)', new='', expect='has no line project(', breaks='both'),
    Mutant('small_letters', old='uint8 FULL=100', new='uint8 full=100', expect='A constant has capital letters: FULL',
           breaks='full'),
    Mutant('ninety_nine', old='FULL=100', new='FULL=99', expect='Charge.FULL is 99, expected 100', breaks='full'),
    Mutant('no_constant', old='uint8 FULL=100', new='', expect='has no constant FULL', breaks='full'),
    Mutant('constant_of_another_type', old='uint8 FULL', new='int32 FULL', expect='The type of FULL is int32',
           breaks='full'),
    Mutant('default_as_constant', old='float32 speed 0.2', new='float32 speed=0.2',
           expect='A default value follows after a space only', breaks='default'),
    Mutant('no_default', old='speed 0.2', new='speed', expect='A new request has the speed 0, expected 0.2',
           breaks='default'),
    Mutant('double', old='float32 speed', new='float64 speed', expect='float64 speed', breaks='request'),
    Mutant('exchanged', edits=((SRV, f"""
            {SRV}
            bool docked
            string message
            ---
            """),
            ('''
            ---
            bool docked
            string message
            ''', '')), expect='above `---` is the request', breaks='request'),
    Mutant('a_blank_after_the_line', old='---', new='--- ', expect='not even a blank', breaks='response'),
    Mutant('nothing_between', old='---', new='', expect='has no line `---`', breaks='response'),
    Mutant('message_forgotten', old='string message', new='',
           expect='The fields of the response of Dock are bool docked', breaks='response'),
    Mutant('header_not_declared', old='" DEPENDENCIES std_msgs)', new='")', expect='write DEPENDENCIES std_msgs',
           breaks='std-msgs'),
    Mutant('std_msgs_not_found', old='find_package(std_msgs REQUIRED)', new='', expect='no find_package(std_msgs',
           breaks='std-msgs'),
    Mutant('generators_not_found', old='find_package(rosidl_default_generators REQUIRED)', new='',
           expect='CMake does not know rosidl_generate_interfaces', breaks='both'),
    Mutant('files_without_folder', old='"msg/Charge.msg" "srv/Dock.srv"', new='"Charge.msg" "Dock.srv"',
           expect='names the file Charge.msg, and there is none', breaks='both'),
    Mutant('service_not_built', old='msg" "srv/Dock.srv" DEPENDENCIES std_msgs', new='msg" DEPENDENCIES std_msgs',
           expect='Python does not find', breaks='both'),
    Mutant('not_in_the_group', old='<member_of_group>rosidl_interface_packages</member_of_group>', new='',
           expect='a member of the group', breaks='group'),
    Mutant('build_depend_only', old=DEPEND, new='<build_depend>std_msgs</build_depend>',
           expect='Who uses your message needs it, too', breaks='to-run'),
    Mutant('no_runtime', old=RUNTIME, new='', expect='rosidl_default_runtime is not declared', breaks='to-run'),
    Mutant('std_msgs_to_run_only', old=DEPEND, new='<exec_depend>std_msgs</exec_depend>',
           expect='std_msgs is needed for the build', breaks='to-build'),
    Mutant('std_msgs_not_declared', old=DEPEND, new='', expect='std_msgs is needed for the build', breaks='to-build'),
    Mutant('no_generators', old=GENERATORS, new='', expect='rosidl_default_generators is needed for the build',
           breaks='to-build'),
    Mutant('constant_without_a_sign', old='uint8 FULL=100', new='uint8 FULL 100', expect='The line of `FULL` has no `=`',
           breaks='full'),
    Mutant('false_by_default', old='bool docked', new='bool docked false', expect='`docked` of Dock has a default value',
           breaks='default'),
    Mutant('full_from_the_start', old='uint8 percent', new='uint8 percent 100',
           expect='`percent` of Charge has a default value', breaks='charge'),
    Mutant('one_more_constant', old='uint8 FULL=100', new='uint8 FULL=100\nuint8 EMPTY=0',
           expect='another constant, EMPTY', breaks='full'),
    Mutant('constant_of_the_request', old='string station', new='uint8 RETRIES=3\nstring station',
           expect='The request of Dock has a constant, RETRIES', breaks='request'),
    Mutant('constant_of_the_response', old='bool docked', new='bool docked\nuint8 BUSY=1',
           expect='The response of Dock has a constant, BUSY', breaks='response'),
    Mutant('for_python', old='<build_type>ament_cmake', new='<build_type>ament_python', breaks='both',
           expect='The build type in DOCK_XML is ament_python'),
    Mutant('called_otherwise', old='<name>dock_interfaces</name>', new='<name>docking</name>', breaks='both',
           expect='The package is called docking in DOCK_XML'),
]
