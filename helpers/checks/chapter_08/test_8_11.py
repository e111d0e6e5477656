"""Visible tests of exercise 8.11, tests for the robot: with the learner's own robot, as it is and spoilt."""

import pytest

from helpers.checks.chapter_08 import deliveries
from helpers.checks.chapter_08.planted import OWN, ROBOT, accepts, rejects

pytestmark = pytest.mark.exercise('8.11')
SILENT = '''

class DeliveryRobot(DeliveryRobot):
    def create_publisher(self, msg_type, topic, *others, **options):
        return super().create_publisher(msg_type, 'nothing' if topic == 'status' else topic, *others, **options)
'''


def robots(learner) -> tuple[dict, dict]:
    """The learner's own robot, and the same without a status."""
    own = deliveries.modules(learner)
    return {OWN: own}, {'whose status never comes': {**own, deliveries.NODE: own[deliveries.NODE] + SILENT}}


def test_own_robot(learner):
    """Your tests pass with your own robot, of exercises 8.5 and 8.7 to 8.9.

    If not: is the robot wrong, or the test? Ask the specification.
    """
    own, silent = robots(learner)
    accepts(learner, own, ROBOT, wrong=silent, among={**own, **silent})


def test_silent_robot(learner):
    """Your tests fail with a robot whose status never comes.

    bench.until(lambda: bench.status) fails if nothing comes.
    """
    own, silent = robots(learner)
    rejects(learner, silent, ROBOT, right=own, among={**own, **silent})
