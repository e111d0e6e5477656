"""`ros2 lifecycle` beside real nodes."""

import pytest

pytestmark = pytest.mark.usefixtures('several_nodes')


def test_lifecycle(ros2):
    assert ros2.lines('lifecycle', 'nodes') == ['/managed']
    assert ros2.lines('lifecycle', 'nodes', '-c') == ['1']
    assert ros2.output('lifecycle', 'get') == '/managed: unconfigured [1]\n'
    assert ros2.output('lifecycle', 'list', '/managed') == (
        '- configure [1]\n\tStart: unconfigured\n\tGoal: configuring\n'
        '- shutdown [5]\n\tStart: unconfigured\n\tGoal: shuttingdown\n'
    )
    assert ros2.error('lifecycle', 'set', '/managed', 'fly') == (
        'Unknown transition requested, available ones are:\n- configure [1]\n- shutdown [5]'
    )
    assert ros2.output('lifecycle', 'set', '/managed', 'configure') == 'Transitioning successful\n'
    assert ros2.output('lifecycle', 'get', 'managed') == 'inactive [2]\n'
    assert ros2.output('lifecycle', 'set', '/managed', '3') == 'Transitioning successful\n'
    assert ros2.output('lifecycle', 'get', '/managed') == 'active [3]\n'
    assert '- cleanup [2]' in ros2.lines('lifecycle', 'list', '/managed', '--all')
    for verb in (('get', '/plain'), ('list', '/nobody'), ('set', '/plain', 'configure')):
        assert ros2.error('lifecycle', *verb) == 'Node not found'
