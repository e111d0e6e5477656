"""`ros2 lifecycle` beside real nodes."""

import subprocess
import sys

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


ASKING = """
from ros2cli.node.direct import DirectNode
from ros2lifecycle import api

with DirectNode(None) as node:
    names = [each.full_name for each in api.get_node_names(node=node)]
    states = api.call_get_states(node=node, node_names=names)
    graph = api.call_get_transition_graph(node=node, states=states)
    print({name: {each.transition.label for each in graph[name]} <= {'deactivate', 'shutdown'} for name in graph})
    (deactivate,) = (each.transition for each in graph['/managed'] if each.transition.label == 'deactivate')
    print(api.call_change_states(node=node, transitions={'/managed': deactivate}))
    available = api.call_get_available_transitions(node=node, states={'/managed': None})['/managed']
    print([each.transition.label for each in available])
"""


def test_a_program_asks_and_changes_several_nodes(ros2):
    if ros2.output('lifecycle', 'get', '/managed') == 'unconfigured [1]\n':
        ros2.output('lifecycle', 'set', '/managed', 'configure')
        ros2.output('lifecycle', 'set', '/managed', 'activate')
    done = subprocess.run([sys.executable, '-c', ASKING], env=ros2.environ, capture_output=True, text=True, timeout=60)
    assert done.stdout.splitlines() == [
        "{'/managed': True}",
        "{'/managed': True}",
        "['cleanup', 'activate', 'shutdown']",
    ], done
