"""Hidden tests of exercise 2.5, a package from nothing."""

import pytest

from helpers.checks.chapter_02 import patrolling
from helpers.checks.chapter_02.test_2_5 import test_tests  # noqa: F401 - they draw other inputs here

pytestmark = pytest.mark.exercise('2.5')

WRONG = {
    'does not come back to the first station': 'back = 0\n    return [one for one in stations[back:]]',
    'comes back to the last station, and not to the first one': 'there = stations[:]\n    return there + there[-1:]',
    'leaves the first station out': 'return stations[1:] + stations[:1]',
    'leaves the second station out': 'there = list(stations)\n    del there[1:2]\n    return there + [stations[0]]',
    'leaves the last station out': 'there = list(stations)\n    return there[: max(1, len(there) - 1)] + there[:1]',
    'gives the stations in reverse order': 'there = list(stations)[::-1]\n    there.append(there[0])\n    return there',
    'gives the stations in reverse order, and then the first one': 'return stations[::-1] + stations[:1]',
}
RIGHT = (
    'from itertools import chain, islice\n    return [*chain(stations, islice(stations, 1))]',
    'there = list(stations)\n    there.append(there[0])\n    return there',
    'return stations + [stations[0]]',  # a list and a list
)


@pytest.mark.rules('package', 'builds')
def test_package(learner):
    """The package patrol is of the build type ament_python, and builds without an error or a warning.

    `ros2 pkg create patrol --build-type ament_python`, called in my_ws/src.
    """
    patrolling.judge_package(learner)
    patrolling.judge_build(learner)


@pytest.mark.rules('round-trip')
def test_round_trip(learner):
    """The function round_trip returns the stations, and the first one again at the end.

    Also for other numbers of stations, and whatever their order is.
    """
    drawn = learner.random.sample(patrolling.STATIONS, 8)
    many = learner.random.choices(patrolling.STATIONS, k=learner.random.randint(100, 900))
    words = [f'{name}{learner.random.choice(["  ", " east", "/2"])}' for name in drawn[:3]]
    short = sorted(drawn[:5], reverse=True), sorted(drawn[5:7], reverse=True), drawn[7:], [*drawn[:2], drawn[0]]
    cases = [*short, words, many]
    patrolling.judge_round_trip(learner, *cases)


@pytest.mark.rules('route')
def test_route(learner):
    """`ros2 run patrol route` prints the round trip of the stations on its command line.

    The names are sys.argv[1:].
    """
    drawn = learner.random.sample(patrolling.STATIONS, learner.random.randint(4, 6))
    patrolling.judge_route(learner, sorted(drawn, reverse=True), drawn[:1])


@pytest.mark.rules('stations', 'announce')
@pytest.mark.weight(2)
def test_announce(learner):
    """The node /announce publishes the names of the installed stations.txt in turn, twice a second.

    get_package_share_directory('patrol') is the folder; the file is read when the program starts.
    """
    number = learner.random.randint(4, 5)
    patrolling.judge_announce(learner, sorted(learner.random.sample(patrolling.STATIONS, number), reverse=True))


@pytest.mark.rules('dependencies')
def test_dependencies(learner):
    """package.xml declares the ROS packages that the code imports.

    depend, or exec_depend.
    """
    patrolling.judge_dependencies(learner)


@pytest.mark.rules('notices')
def test_notices(learner):
    """The learner's tests fail with a round_trip that is wrong, and pass with one that is right.

    Compare the whole list that comes back with the one that is expected, for at least two stations.
    """
    patrolling.judge_notices(learner, WRONG, RIGHT)
