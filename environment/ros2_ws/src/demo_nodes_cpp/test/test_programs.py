"""What the C++ demos of the official documentation print, and the demo of demo_nodes_py that needs one of them."""

import re

import pytest

from environment.tests.running import PATIENCE, ROS2, program

pytestmark = pytest.mark.usefixtures('domain')


def lines(process):
    """Return what a program has logged, without its name and level."""
    return re.findall(r'\]: (.*)', process.output)


@pytest.mark.parametrize('listener', ['listener', 'listener_best_effort'])
def test_a_listener_hears_the_talker(start, listener):
    heard = start(program('demo_nodes_cpp', listener))
    talker = start(program('demo_nodes_cpp', 'talker'))
    # On a busy machine the two find each other late, and the first messages are not heard.
    line = heard.wait_for_output('I heard: ', PATIENCE)
    number = int(re.search(r'\[listener\]: I heard: \[Hello World: (\d+)\]$', line)[1])
    talker.wait_for_output(f"Publishing: 'Hello World: {max(number, 2)}'", PATIENCE)
    assert lines(talker)[:2] == ["Publishing: 'Hello World: 1'", "Publishing: 'Hello World: 2'"]


@pytest.mark.parametrize(
    'name', ['add_two_ints_launch.py', 'add_two_ints_async_launch.xml', 'add_two_ints_launch.yaml']
)
def test_a_client_is_launched_with_its_server(start, name):
    launched = start(ROS2, 'launch', 'demo_nodes_cpp', name)
    launched.wait_for_output('[add_two_ints_client]: Result of add_two_ints: 5', PATIENCE)
    launched.wait_for_output('process has finished cleanly', PATIENCE)
    assert 'Incoming request' in launched.output


def test_calls_are_introspected(start, peer):
    start(program('demo_nodes_cpp', 'introspection_service'))
    client = start(program('demo_nodes_cpp', 'introspection_client'))
    client.wait_for_output('Result of add_two_ints: 5', PATIENCE)
    nodes = {name for name, _ in peer.node.get_node_names_and_namespaces()}
    assert {'introspection_service', 'introspection_client'} <= nodes


@pytest.mark.parametrize('name', ['one_off_timer', 'reuse_timer'])
def test_a_timer_fires_once_in_three_rounds(start, name):
    timers = start(program('demo_nodes_cpp', name))
    timers.wait_for_output(lambda _: timers.output.count('in one_off_timer callback') == 2, PATIENCE)
    begins, once = ['in periodic_timer callback', '  resetting one off timer'], ['in one_off_timer callback']
    goes_on = ['in periodic_timer callback', '  not resetting one off timer']
    assert lines(timers) == begins + once + goes_on + goes_on + begins + once


def test_parameters_on_a_blackboard(start):
    board = start(program('demo_nodes_cpp', 'parameter_blackboard'), '--ros-args', '-p', 'first:=1')
    board.wait_for_output("named '/parameter_blackboard' ready, and serving", PATIENCE)
    client = start(program('demo_nodes_py', 'async_param_client'))
    client.wait_for_output('Deleting parameters: ', PATIENCE)
    with pytest.raises(RuntimeError, match='ended'):
        client.wait_for_output(lambda _: False, PATIENCE)
    assert client.stop(PATIENCE) == 0
    said = lines(client)
    assert said[said.index('Listing Parameters:') :][1:4] == [
        f'    - {name}_parameter' for name in ('int', 'bool', 'string')
    ]
    assert said[said.index('Getting parameters:') :][1:4] == [
        '    - int_parameter: 10',
        '    - bool_parameter: False',
        '    - string_parameter: Fee Fi Fo Fum',
    ]
    assert said[said.index('Loading parameters: ') :][4:7] == [
        '    int_parameter:',
        '        successful: True',
        '        value: 12',
    ]
    assert said.count('        successful: True') == 3 + 5 + 3


def test_no_blackboard_is_an_error(start):
    client = start(program('demo_nodes_py', 'async_param_client'))
    with pytest.raises(RuntimeError, match='ended'):
        client.wait_for_output(lambda _: False, PATIENCE)
    assert client.stop(PATIENCE) == 1
    assert 'ros2 run demo_nodes_cpp parameter_blackboard' in client.output
