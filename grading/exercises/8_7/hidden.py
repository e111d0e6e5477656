"""Hidden tests of exercise 8.7, parameters, status and stations."""

import pytest

from helpers.checks.chapter_08 import stations
from helpers.checks.chapter_08.node_options import check_options
from helpers.checks.chapter_08.parameter_services import Parameters
from helpers.checks.chapter_08.test_8_7 import test_values_at_the_start  # noqa: F401 - they draw other inputs here
from helpers.runner import about, expect

pytestmark = [pytest.mark.exercise('8.7'), pytest.mark.wiring(type='names', qos='latched', namespace='names')]


@pytest.mark.rules('parameters', 'bounds', 'description')
@pytest.mark.weight(3)
def test_parameters(learner):
    """Each of the five parameters has its default, its bounds and a description.

    declare_parameter(name, default, bounded(description, low, high)).
    """
    with about('parameters'):
        stations.Keeper(learner, strict=False)
    stations.judge_table(learner, '', Parameters(learner, '/delivery_robot'))


@pytest.mark.rules('status', 'status-period', 'latched')
@pytest.mark.weight(2)
def test_status(learner):
    """The status comes every status_period seconds, and who comes late gets the newest one at once.

    The period of the timer is the parameter's value; DurabilityPolicy.TRANSIENT_LOCAL, depth 1.
    """
    period = learner.random.choice([0.175, 0.325, 0.875, 1.125])
    with about('status'):
        keeper = stations.Keeper(learner, status_period=period)
    stations.judge_status(keeper, period)


@pytest.mark.rules('names', 'status-period')
def test_relative_names(learner):
    """In a namespace, status and set_station are in it, and the status has its period.

    Names without a slash at their beginning. The period of the timer is the parameter's value.
    """
    keeper = stations.Keeper(learner, f'/robot{learner.random.randint(2, 99)}')
    response = keeper.set('a', 1.0, 2.0, 'names')
    learner.run(0.6)
    expect(
        response.success and keeper.heard.data,
        f'In the namespace {keeper.namespace}, nothing came on status.',
        'station' if not response.success else 'status',
    )
    stations.judge_periods(learner)
    check_options(learner, 'StationKeeper', 'names')


@pytest.mark.rules('station', 'new-place', 'unknown', 'bad-station', 'message', 'unchanged')
@pytest.mark.weight(4)
def test_stations(learner):
    """Several stations are kept; a known name gets its new place; an unknown one is None; bad ones are refused.

    A dictionary: name → (x, y).
    """
    with about('station'):
        keeper = stations.Keeper(learner, strict=False)
    stations.judge_stations(keeper)
