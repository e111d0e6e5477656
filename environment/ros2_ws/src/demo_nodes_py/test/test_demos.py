"""What the demos of the official documentation print."""

import os
import re
import signal

import pytest
from example_interfaces.srv import AddTwoInts
from rcl_interfaces.srv import GetParameters, SetParameters
from rclpy.parameter import Parameter
from service_msgs.msg import ServiceEventInfo
from std_msgs.msg import String

from environment.tests.running import PATIENCE, program

pytestmark = pytest.mark.usefixtures('domain')


def lines(process):
    """Return what a program has logged, without its name and level."""
    return re.findall(r'\]: (.*)', process.output)


def status_of(process):
    """Wait until a program has ended by itself, and return its status."""
    with pytest.raises(RuntimeError, match='ended'):
        process.wait_for_output(lambda _: False, PATIENCE)
    return process.stop(PATIENCE)


def test_a_listener_hears_a_talker(start):
    listeners = {
        'listener': '[listener]: I heard: [Hello World: ',
        'listener_serialized': r"""[serialized_subscriber]: I heard: "b'\x00\x01\x00\x00\x0f\x00\x00\x00Hello""",
    }
    started = {name: start(program('demo_nodes_py', name)) for name in listeners}
    talker = start(program('demo_nodes_py', 'talker'))
    talker.wait_for_output('[talker]: Publishing: "Hello World: 0"', PATIENCE)
    for name, said in listeners.items():
        started[name].wait_for_output(said, PATIENCE)


@pytest.mark.parametrize('options, kind', [([], 'Best effort'), (['--reliable'], 'Reliable')])
def test_a_quality_of_service_is_chosen(start, options, kind):
    listener = start(program('demo_nodes_py', 'listener_qos'), '-n', '1', *options)
    listener.wait_for_output(f'[listener_qos]: {kind} listener', PATIENCE)
    talker = start(program('demo_nodes_py', 'talker_qos'), '-n', '1000', *options)
    talker.wait_for_output(f'[talker_qos]: {kind} talker', PATIENCE)
    listener.wait_for_output('I heard: [Hello World: ', PATIENCE)
    assert status_of(listener) == 0  # after one message


def test_a_server_adds_and_its_clients_tell(start):
    server = start(program('demo_nodes_py', 'add_two_ints_server'))
    for name in ('add_two_ints_client', 'add_two_ints_client_async'):
        client = start(program('demo_nodes_py', name))
        client.wait_for_output('[add_two_ints_client]: Result of add_two_ints: 5', PATIENCE)
        assert status_of(client) == 0
    server.wait_for_output('a: 2 b: 3', PATIENCE)
    assert '[add_two_ints_server]: Incoming request\na: 2 b: 3' in server.output


def test_a_client_waits_for_its_server(start):
    client = start(program('demo_nodes_py', 'add_two_ints_client_async'))
    client.wait_for_output('service not available, waiting again...', PATIENCE)
    start(program('demo_nodes_py', 'add_two_ints_server'))
    client.wait_for_output('Result of add_two_ints: 5', PATIENCE)


def test_calls_are_watched_as_the_parameters_say(start, peer):
    start(program('demo_nodes_py', 'introspection'), '--ros-args', '-p', 'service_configure_introspection:=contents')
    events = peer.listen(AddTwoInts.Event, '/add_two_ints/_service_event')
    server = {ServiceEventInfo.REQUEST_RECEIVED, ServiceEventInfo.RESPONSE_SENT}
    peer.until(lambda: {each.info.event_type for each in events} >= server, 'both events of the server')
    assert {each.info.event_type for each in events} == server
    assert {each.response[0].sum for each in events if each.response} == {5}

    def set_it(value):
        parameter = Parameter('client_configure_introspection', value=value).to_parameter_msg()
        return peer.call(SetParameters, '/introspection_client/set_parameters', parameters=[parameter]).results[0]

    assert set_it('metadata').successful
    client = {ServiceEventInfo.REQUEST_SENT, ServiceEventInfo.RESPONSE_RECEIVED}
    peer.until(lambda: {each.info.event_type for each in events} >= client, 'both events of the client')
    assert not [each for each in events if each.info.event_type in client and (each.request or each.response)]
    assert set_it('all').reason == "must be one of 'disabled', 'metadata', 'contents'"
    assert set_it(3).reason


def test_one_parameter_sets_another(start, peer):
    start(program('demo_nodes_py', 'set_parameters_callback'))

    def set_it(name, value):
        parameter = Parameter(name, value=value).to_parameter_msg()
        (result,) = peer.call(SetParameters, '/set_parameters_callback/set_parameters', parameters=[parameter]).results
        answer = peer.call(GetParameters, '/set_parameters_callback/get_parameters', names=['param1', 'param2'])
        return result.successful, [each.double_value for each in answer.values]

    assert set_it('param1', 28.0) == (True, [28.0, 4.0])
    assert set_it('param2', 7.0) == (True, [28.0, 7.0])


def test_matched_events_are_told(start):
    demo = start(program('demo_nodes_py', 'matched_event_detect'))
    assert status_of(demo) == 0
    told = [line for line in lines(demo) if not line.startswith(('Create', 'Destroy'))]
    assert told == [
        line
        for what in ('subscription', 'publisher')
        for line in (
            f'First {what} is connected.',
            f'The changed number of connected {what} is 1 and current number of connected {what} is 2',
            f'The changed number of connected {what} is -1 and current number of connected {what} is 1',
            f'Last {what} is disconnected.',
        )
    ]


def test_levels_of_a_logger_are_set_from_outside(start):
    demo = start(program('demo_nodes_py', 'use_logger_service'))
    assert status_of(demo) == 0
    levels = ['DEBUG', 'INFO', 'WARN', 'ERROR']
    expected = []
    for number, (name, level, logged) in enumerate(
        [('default', 0, levels[1:]), ('debug', 10, levels), ('warn', 30, levels[2:]), ('error', 40, levels[3:])], 1
    ):
        expected.append(f'Output with {name} logger level:')
        expected += [f'Output {number} with {each} logger level.' for each in logged]
        expected.append(f'Current logger level: {level}')
    assert lines(demo) == expected


@pytest.mark.parametrize('number', [signal.SIGINT, signal.SIGTERM])
def test_a_signal_ends_a_program_quietly(start, peer, number):
    talker = start(program('demo_nodes_py', 'talker'))
    waiting = start(program('demo_nodes_py', 'add_two_ints_client'))
    peer.listen(String, '/chatter')
    waiting.wait_for_output('service not available', PATIENCE)
    for process in (talker, waiting):
        os.kill(process.pid, number)
        assert status_of(process) == 0
        assert 'Traceback' not in process.output


def test_ros_arguments_that_cannot_be_read_are_no_success(start):
    process = start(program('demo_nodes_py', 'talker'), '--ros-args', '--no-such-option')
    assert status_of(process) == 1
    assert '--no-such-option' in process.output
