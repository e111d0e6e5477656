"""Packages whose CMakeLists.txt says little: they are built and installed as their package.xml says."""

import subprocess

PACKAGE_XML = """\
<package format="3">
  <name>{name}</name><version>0.1.0</version><description>d</description>
  <maintainer email="a@example.org">a</maintainer><license>Apache-2.0</license>
  <buildtool_depend>ament_cmake_auto</buildtool_depend>
  {depends}
  <export><build_type>ament_cmake</build_type></export>
</package>
"""
CMAKE = """\
cmake_minimum_required(VERSION 3.16)
project({name})
find_package(ament_cmake_auto REQUIRED)
{lines}
"""


def build(folder, **packages):
    """Build packages with colcon: name -> dependencies, lines of CMake, other files. Returns what it printed."""
    for name, (depends, lines, files) in packages.items():
        texts = {
            'package.xml': PACKAGE_XML.format(name=name, depends=depends),
            'CMakeLists.txt': CMAKE.format(name=name, lines=lines),
            **files,
        }
        for path, text in texts.items():
            (folder / 'src' / name / path).parent.mkdir(parents=True, exist_ok=True)
            (folder / 'src' / name / path).write_text(text)
    command = ['colcon', 'build', '--event-handlers', 'console_direct+']
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, timeout=250)
    return done.returncode, done.stdout + done.stderr


def test_folders_libraries_and_programs_are_installed(tmp_path):
    library = (
        '',
        'ament_auto_find_build_dependencies()\nament_auto_add_library(sums SHARED DIRECTORY src)\nament_auto_package()',
        {'include/sums/sums.hpp': 'int sum(int, int);\n', 'src/sums.cpp': '#include "sums/sums.hpp"\n'
         'int sum(int a, int b) {return a + b;}\n'},
    )  # fmt: skip
    program = (
        '<depend>sums</depend>',
        'ament_auto_find_build_dependencies(REQUIRED sums)\nament_auto_add_executable(add main.cpp)\n'
        'ament_auto_package(INSTALL_TO_SHARE launch config)',
        {'main.cpp': '#include <iostream>\n#include "sums/sums.hpp"\nint main() {std::cout << sum(2, 3) << "\\n";}\n',
         'launch/a.launch.py': '', 'config/a.yaml': ''},
    )  # fmt: skip
    status, printed = build(tmp_path, sums=library, adder=program)
    assert status == 0, printed
    share = tmp_path / 'install' / 'adder' / 'share' / 'adder'
    assert (share / 'launch' / 'a.launch.py').exists() and (share / 'config' / 'a.yaml').exists()
    assert (tmp_path / 'install' / 'sums' / 'include' / 'sums' / 'sums.hpp').exists()
    run = 'source install/setup.bash && ros2 run adder add'
    done = subprocess.run(['bash', '-c', run], cwd=tmp_path, capture_output=True, text=True, timeout=100)
    assert done.stdout == '5\n', done


def test_interfaces_are_generated(tmp_path):
    depends = (
        '<buildtool_depend>rosidl_default_generators</buildtool_depend><depend>std_msgs</depend>'
        '<exec_depend>rosidl_default_runtime</exec_depend><member_of_group>rosidl_interface_packages</member_of_group>'
    )
    lines = 'ament_auto_find_build_dependencies()\nament_auto_generate_code()\nament_auto_package()'
    files = {'msg/Bit.msg': 'std_msgs/Header header\nbool set\n', 'srv/Flip.srv': 'Bit bit\n---\nBit bit\n'}
    status, printed = build(tmp_path, bits=(depends, lines, files))
    assert status == 0, printed
    run = 'source install/setup.bash && python3 -c "from bits.srv import Flip; print(Flip.Request().bit.set)"'
    done = subprocess.run(['bash', '-c', run], cwd=tmp_path, capture_output=True, text=True, timeout=100)
    assert done.stdout == 'False\n', done


def test_what_is_required_must_stand_in_package_xml_and_be_there(tmp_path):
    lines = 'ament_auto_find_build_dependencies(REQUIRED {0})\nament_auto_package()'
    status, printed = build(tmp_path, one=('', lines.format('sums'), {}))
    assert status != 0 and "'sums' is required, and package.xml does not name it" in ' '.join(printed.split())
    status, printed = build(tmp_path, one=('<depend>sums</depend>', lines.format('sums'), {}))
    assert status != 0 and "the required package 'sums' was not found" in ' '.join(printed.split())
