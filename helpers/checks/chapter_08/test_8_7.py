"""Visible tests of exercise 8.7, parameters, status and stations."""

import pytest

from helpers.checks.chapter_08 import stations
from helpers.checks.chapter_08.node_options import check_options
from helpers.checks.chapter_08.parameter_services import Parameters
from helpers.runner import about

pytestmark = [pytest.mark.exercise('8.7'), pytest.mark.wiring(type='names', qos='latched', namespace='names')]


@pytest.mark.rules(
    'parameters', 'bounds', 'description', 'station', 'new-place', 'unknown', 'bad-station', 'message', 'unchanged'
)
def test_parameters_and_stations(learner):
    """The five parameters are declared; stations are noted, and bad ones are refused.

    declare_parameter(name, default, bounded(description, low, high)). First look at a request, then note it.
    """
    with about('parameters'):
        keeper = stations.Keeper(learner, strict=False)
    stations.judge_table(learner, '', Parameters(learner, '/delivery_robot'))
    stations.judge_stations(keeper)


@pytest.mark.rules('parameters')
def test_values_at_the_start(learner):
    """Values that are given at the start take the place of the defaults.

    declare_parameter looks for them, if it is not told to ignore them.
    """
    stations.judge_start(learner)


@pytest.mark.rules('names', 'status', 'status-period', 'latched')
def test_status(learner):
    """The status comes every status_period seconds, in the namespace of the robot, and who comes late gets the newest.

    A timer with the period status_period publishes self.state; durability TRANSIENT_LOCAL, depth 1.
    """
    with about('names'):
        period = learner.random.choice([0.125, 0.375, 0.625, 1.375])
        keeper = stations.Keeper(learner, f'/robot{learner.random.randint(2, 99)}', status_period=period)
        keeper.set('a', 1.0, 2.0, 'names')
    stations.judge_status(keeper, period)
    stations.judge_periods(learner)
    with about('names'):
        check_options(learner, 'StationKeeper', 'names')
