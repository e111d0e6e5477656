"""Visible tests of exercise 2.5, a package from nothing."""

import pytest

from helpers.checks.chapter_02 import patrolling

pytestmark = pytest.mark.exercise('2.5')


@pytest.mark.rules('package')
def test_package(learner):
    """The folder my_ws/src/patrol is a ROS package called patrol, of the build type ament_python.

    `ros2 pkg create patrol --build-type ament_python`, called in my_ws/src.
    """
    patrolling.judge_package(learner)


@pytest.mark.rules('builds')
def test_build(learner):
    """`colcon build --packages-select patrol` builds it without an error or a warning.

    Read the first error that the build prints, and the lines of data_files in setup.py.
    """
    patrolling.judge_build(learner)


@pytest.mark.rules('round-trip')
def test_round_trip(learner):
    """The function round_trip returns the stations, and the first one again at the end.

    Try it in a terminal: python3 -c "from patrol.route import round_trip; print(round_trip(['a', 'b']))".
    """
    drawn = learner.random.sample(patrolling.STATIONS, 5)
    twice = [drawn[4], drawn[0], drawn[4], drawn[1]]  # a station may be passed several times
    home = [*drawn[1:3], drawn[1]]  # the last one may be the first one, too
    many = learner.random.choices(patrolling.STATIONS, k=learner.random.randint(30, 300))
    words = [f'{drawn[0]} {drawn[1]}', f' {drawn[2]} ', drawn[3]]  # what a name is made of does not matter
    cases = sorted(drawn[:4], reverse=True), drawn[4:], twice, home, words, many
    patrolling.judge_round_trip(learner, ['dock', 'door', 'lab'], *cases)


@pytest.mark.rules('route')
def test_route(learner):
    """`ros2 run patrol route dock door lab` prints the round trip in one line.

    The entry point is `route = patrol.route:main`; what main prints is what counts.
    """
    drawn = learner.random.sample(patrolling.STATIONS, 4)
    patrolling.judge_route(learner, ['dock', 'door', 'lab'], sorted(drawn, reverse=True), drawn[:1])


@pytest.mark.rules('stations', 'announce')
def test_announce(learner):
    """The node /announce publishes the names of the installed stations.txt in turn, twice a second.

    The check writes other names into stations.txt, builds the package and listens.
    """
    stations = sorted(learner.random.sample(patrolling.STATIONS, 3), reverse=True)
    patrolling.judge_announce(learner, stations)


@pytest.mark.rules('dependencies')
def test_dependencies(learner):
    """package.xml declares the ROS packages that the code imports.

    Compare the import lines of all files in patrol/patrol with package.xml: depend, or exec_depend.
    """
    patrolling.judge_dependencies(learner)


@pytest.mark.rules('tests')
def test_tests(learner):
    """`colcon test` runs tests in test/test_route.py, and all of them pass.

    Run `colcon test --packages-select patrol`, then `colcon test-result --verbose`.
    """
    patrolling.judge_tests(learner)


@pytest.mark.rules('notices')
def test_notices(learner):
    """The learner's tests fail with a round_trip that is wrong, and pass with one that is right.

    The check puts other functions into patrol/route.py and runs test/test_route.py.
    """
    patrolling.judge_notices(learner, patrolling.WRONG, patrolling.RIGHT, told=True)
