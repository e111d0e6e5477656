"""What the learner is told of a parameter file that ROS cannot read (exercises 8.3 and 8.10)."""

import pytest

from helpers.checks.chapter_08.parameter_files import why_unreadable

GOOD = '/**:\n  ros__parameters:\n    rate: 20.0\n    mode: slow\n'


@pytest.mark.parametrize(
    ('text', 'words'),
    [
        (GOOD.replace('    rate', '\trate'), 'Line 3, `rate: 20.0`: found character'),
        (
            GOOD.replace('rate: ', 'rate:'),
            'Line 4, `mode: slow`: mapping values are not allowed here. In the line before',
        ),
        (GOOD.replace('rate: 20.0', 'rate: [20.0'), 'Line 4, `mode: slow`'),
        (GOOD.replace('ros__', 'ros_'), 'Below `/**` there is no block `ros__parameters`'),
        (GOOD + '/robot1/governor:\n  rate: 5.0\n', 'Below `/robot1/governor` there is no block'),
        ('ros__parameters:\n  rate: 20.0\n', '`ros__parameters` stands below the name of a node'),
        ('', 'Look at the indentation'),
        (GOOD, 'Look at the indentation'),
    ],
)
def test_the_reason_is_named(text, words):
    assert words in why_unreadable(text)


@pytest.mark.parametrize(
    'text',
    ['[' * 5000, '- a\n- b\n', '1: 2\n', '? [a, b]\n: c\n', '&a {b: *a}\n', 'a: !!bool maybe\n', '\0', '2026-13-45'],
)
def test_odd_texts_break_nothing(text):
    assert why_unreadable(text)
