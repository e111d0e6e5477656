"""`ros2 topic hz`, `bw` and `delay` beside a real node."""

import re

import pytest

from environment.tests.running import PATIENCE

pytestmark = pytest.mark.usefixtures('robot')


NUMBER = r'-?\d+\.\d'


@pytest.mark.parametrize(
    'argv,lines',
    [
        (
            ['hz', '/chatter'],
            [
                r'average rate: \d+\.\d{3}',
                rf'\tmin: {NUMBER}{{3}}s max: {NUMBER}{{3}}s std dev: {NUMBER}{{5}}s window: \d+',
            ],
        ),
        (
            ['delay', '/twist'],
            [
                rf'average delay: {NUMBER}{{3}}',
                rf'\tmin: {NUMBER}{{3}}s max: {NUMBER}{{3}}s std dev: {NUMBER}{{5}}s window: \d+',
            ],
        ),
        (
            ['bw', '/chatter'],
            [
                r'Subscribed to \[/chatter\]',
                r'\d+ B/s from \d+ messages',
                r'\tMessage size mean: 16 B min: 16 B max: 16 B',
            ],
        ),
    ],
)
def test_measuring(ros2, argv, lines):
    with ros2.start('topic', *argv) as meter:
        meter.wait_for_output(r'min: ', timeout=PATIENCE)
        meter.stop(PATIENCE)
        assert meter.returncode == 2
    for line, pattern in zip(meter.lines, lines, strict=False):
        assert re.fullmatch(pattern, line), meter.lines


def test_measuring_waits_for_the_topic(ros2):
    with ros2.start('topic', 'hz', '/later') as meter:
        meter.wait_for_output('WARNING: topic [/later] does not appear to be published yet', timeout=PATIENCE)
        with ros2.start('topic', 'pub', '/later', 'std_msgs/msg/Empty', '-r', '20'):
            meter.wait_for_output('average rate: ', timeout=PATIENCE)


def test_delay_needs_a_header(ros2):
    assert ros2.error('topic', 'delay', '/chatter') == 'msg does not have header'
