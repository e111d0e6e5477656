"""What the learner is told of a test of theirs that fails with a right program (exercises 8.4, 8.6 and 8.11)."""

import pytest

from helpers.checks.chapter_08.planted import Outcome

NAMED = 'FAILED test/test_limit.py::test_limit[0.6] - {}\n'
PLACED = '/home/ws/test/test_limit.py:21: {}\n'


@pytest.mark.parametrize(
    ('output', 'reason'),
    [
        (
            PLACED.format('assert 0.24999999999999997 == 0.25') + NAMED.format('assert 0.2499999999...'),
            'your test test_limit[0.6], line 21: assert 0.24999999999999997 == 0.25',
        ),
        (
            PLACED.format('Failed: DID NOT RAISE') + NAMED.format('Failed: DID NOT RAISE ValueError'),
            'your test test_limit[0.6], line 21: Failed: DID NOT RAISE ValueError',
        ),
        (
            '/home/ws/test/conftest.py:40: Failed: it took too long\n' + NAMED.format('Failed: it took...'),
            'your test test_limit[0.6]: Failed: it took...',
        ),
        ('Killed\n', ''),
    ],
)
def test_the_reason_says_what_was_compared_where_that_is_known(output, reason):
    assert Outcome(1, output).reason == reason
