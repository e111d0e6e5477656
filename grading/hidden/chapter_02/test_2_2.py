"""Hidden tests of exercise 2.2, repair a package: each of the six faults by itself."""

import pytest

from helpers.checks.chapter_02 import builds
from helpers.runner import expect

pytestmark = pytest.mark.exercise('2.2')


def test_entry_point(learner):
    """The entry point follow leads to main of follow.py.

    The right side of an entry point is package.module:function.
    """
    done = builds.line_follower(learner).run(
        'python3', '-c', 'from importlib.metadata import distribution as d\n'
        'for e in d("line_follower").entry_points:\n'
        '    if e.group == "console_scripts": print(e.name, e.value)')
    programs = dict(line.split(maxsplit=1) for line in done.lines if ' ' in line)
    value = programs.get('follow', 'nothing')
    expect(value.replace(' ', '') == 'line_follower.follow:main',
           f'The program follow leads to {value}. The function main is in the file line_follower/follow.py.')


def test_python_packages(learner):
    """All Python packages are installed, also the folder filters.

    `packages` in setup.py names each folder that has an __init__.py, with dots; find_packages finds them.
    """
    done = builds.line_follower(learner).run('python3', '-c', 'from line_follower.filters.median import median')
    expect(done.status == 0, f'Python cannot import the filter: {done.last_line}. `packages` in setup.py must name '
                             'the folder inside of line_follower, as line_follower.filters.')


def test_marker(learner):
    """setup.py installs the marker by which ROS finds the package.

    Look at the first line of data_files in a setup.py that `ros2 pkg create` has made, and at the build's warnings.
    """
    done = builds.line_follower(learner).build()
    expect("doesn't explicitly install a marker" not in done.output,
           'setup.py does not install the marker resource/line_follower into '
           'share/ament_index/resource_index/packages. colcon does it for you, with a warning; other tools do not.')


def test_package_xml_is_installed(learner):
    """setup.py installs package.xml, as before.

    Add to data_files; take nothing away.
    """
    done = builds.line_follower(learner).build()
    expect("doesn't explicitly install the 'package.xml'" not in done.output,
           'setup.py no longer installs package.xml into share/line_follower.')


def test_data_file(learner):
    """The data file is installed where the program looks for it.

    The first part of a line of data_files is the folder below the installation, the second one the list of files.
    """
    wanted = 'share/line_follower/config/gains.yaml'
    there = [name.removeprefix('line_follower/') for name in builds.line_follower(learner).installed()]
    elsewhere = [name for name in there if name.endswith('gains.yaml') and name != wanted]
    expect(wanted in there or not elsewhere, f'gains.yaml is installed as {min(elsewhere, default="")}; the program '
                                             f'reads {wanted}.')
    expect(wanted in there, f'{wanted} is not installed: name config/gains.yaml in data_files.')


def test_where_programs_go(learner):
    """Programs go to lib/line_follower, where `ros2 run` looks.

    setup.cfg says it twice: for a plain build, and for --symlink-install.
    """
    there = builds.line_follower(learner).installed()
    expect('line_follower/lib/line_follower/follow' in there,
           'The program is not in lib/line_follower: look at install_scripts in setup.cfg.')
    expect('script_dir=$base/lib/line_follower' in learner.text('FOLLOWER_CFG').replace(' ', ''),
           'script_dir in setup.cfg must stay $base/lib/line_follower: it is used with --symlink-install.')


def test_dependencies(learner):
    """package.xml declares what the code imports from other packages, so that it is there when the program runs.

    Compare the import lines of follow.py with package.xml: exec_depend or depend.
    """
    declared = builds.dependencies(learner, 'FOLLOWER_XML')
    for name in ('geometry_msgs', 'ament_index_python', 'python3-yaml'):
        expect(name not in declared.get('build_depend', set()) - builds.to_run(declared),
               f'{name} is a build_depend only: it would be there when the package is built, but not when it runs.')
        expect(name in builds.to_run(declared),
               f'follow.py needs {name}, and package.xml does not declare it. On a fresh machine it is not installed.')
    expect('ament_python' in ''.join(learner.text('FOLLOWER_XML').split()), 'The build type must stay ament_python.')


def test_finished(learner):
    """The repaired program drives.

    Build, run, read the last line of the error, and go on.
    """
    done = builds.line_follower(learner).run('ros2', 'run', 'line_follower', 'follow')
    expect(done.lines[-1:] == ['forward 0.20 m/s, turn -0.08 rad/s'],
           f'`ros2 run line_follower follow` ended with: {done.last_line}')
