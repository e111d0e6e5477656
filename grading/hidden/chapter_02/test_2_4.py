"""Hidden tests of exercise 2.4, a library and its user."""

import math
import re

import pytest

from helpers.checks.chapter_02 import builds
from helpers.runner import expect

pytestmark = pytest.mark.exercise('2.4')


def test_order(learner):
    """colcon builds wheel_math before odometry.

    Who needs the other one declares it.
    """
    done = builds.odometry(learner).build('--packages-up-to', 'odometry')
    order = re.findall(r'Finished <<< (\w+)', done.output)
    expect(order == ['wheel_math', 'odometry'],
           f'The build finished {", then ".join(order)}; expected wheel_math, then odometry.')


def test_needed_at_run_time(learner):
    """odometry says that wheel_math must be there when it runs.

    exec_depend, or depend.
    """
    declared = builds.dependencies(learner, 'ODOMETRY_XML')
    mine = {tag for tag, names in declared.items() if 'wheel_math' in names}
    module = [name for names in declared.values() for name in names if name.startswith('wheel_math.')]
    expect(not module, f'`{module and module[0]}` names a Python module. A dependency is a ROS package: wheel_math.')
    expect('wheel_math' in builds.to_run(declared),
           f'wheel_math is declared as {", ".join(sorted(mine)) or "nothing"}. It is imported when the program runs, '
           'so it must be an exec_depend or a depend.')


def test_library_stands_alone(learner):
    """wheel_math needs nobody: it can be built and used without odometry.

    A dependency goes in one direction.
    """
    declared = builds.dependencies(learner, 'WHEEL_MATH_XML')
    needed = set().union(*(names for tag, names in declared.items() if tag.endswith('depend')))
    expect(not needed, f'wheel_math declares {", ".join(sorted(needed))}, and needs nothing of it.')


@pytest.mark.weight(2)
def test_other_numbers(learner):
    """The report is right for other numbers of ticks, and comes from wheel_math.

    The program gets the ticks in sys.argv, and asks the library.
    """
    workspace = builds.odometry(learner)
    ticks = learner.random.randint(1000, 9000)
    wanted = f'{2 * math.pi * 0.033 * ticks / 360:.3f} m'
    done = workspace.run('ros2', 'run', 'odometry', 'report', str(ticks))
    expect(done.last_line == wanted, f'`ros2 run odometry report {ticks}` ended with: {done.last_line}; expected '
                                     f'{wanted}.')
    # With another library below it, the same program says something else.
    done = workspace.run('python3', '-c', 'import sys, wheel_math.geometry as g\n'
                         'g.distance = lambda *a, **k: 7.25\n'
                         f'sys.argv[1:] = ["{ticks}"]\nfrom odometry.report import main\nmain()')
    expect(done.last_line == '7.250 m', 'The report does not come from the library: call distance of '
                                        'wheel_math.geometry, and do not compute the distance again.')
