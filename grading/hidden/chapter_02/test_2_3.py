"""Hidden tests of exercise 2.3, an interface."""

import json

import pytest

from helpers.checks.chapter_02 import builds
from helpers.runner import expect

pytestmark = pytest.mark.exercise('2.3')


def test_constant_and_default(learner):
    """Charge has the constant FULL with the value 100; the speed of a Dock request is 0.2 if nobody sets it.

    A constant is written with capital letters and `=`, a default value after a space.
    """
    found = builds.interface(learner)
    expect(found['FULL'] == 100, f'Charge.FULL is {found["FULL"]}, expected 100. A constant needs `=`.')
    expect(abs((found['speed'] or 0) - 0.2) < 1e-6,
           f'A new request has the speed {found["speed"]}, expected 0.2: write the default value after the name.')


def test_declared(learner):
    """package.xml declares everything that the package needs to be built and to be used.

    std_msgs is needed for both; the generators to build, the runtime to run.
    """
    declared = builds.dependencies(learner, 'DOCK_XML')
    for name in ('ament_cmake', 'rosidl_default_generators', 'std_msgs'):
        expect(name in builds.to_build(declared), f'{name} is needed for the build; package.xml does not say so.')
    expect('std_msgs' in builds.to_run(declared),
           'std_msgs is declared for the build only. Who uses your message needs it, too: depend, or exec_depend.')
    expect('rosidl_interface_packages' in declared.get('member_of_group', ()),
           'package.xml does not say that it is a member of the group rosidl_interface_packages.')
    expect('rosidl_default_runtime' in builds.to_run(declared),
           'rosidl_default_runtime is not declared: on a machine without compilers the types cannot be used.')


@pytest.mark.weight(2)
def test_on_the_wire(learner):
    """A node offers Dock and publishes Charge; the call is answered and the message arrives.

    This uses the types as chapter 3 and 4 do.
    """
    station, percent = f'dock{learner.random.randint(10, 99)}', learner.random.randint(1, 99)
    done = builds.dock_interfaces(learner).run('python3', 'try_it.py', station, str(percent))
    expect(done.status == 0, f'A program that uses your types ended with: {done.last_line}')
    wanted = [True, station, station, percent]
    expect(json.loads(done.lines[-1]) == wanted, f'What came over the wire is {done.lines[-1]}.')
