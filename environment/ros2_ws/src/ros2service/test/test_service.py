"""`ros2 service` beside real nodes."""

import pytest

from environment.tests.running import PATIENCE

pytestmark = pytest.mark.usefixtures('several_nodes')

SWITCH = ('service', 'call', '/switch', 'std_srvs/srv/SetBool')


def test_service_list_type_find_info(ros2):
    assert '/switch' in ros2.lines('service', 'list')
    assert '/switch [std_srvs/srv/SetBool]' in ros2.lines('service', 'list', '-t')
    assert not [name for name in ros2.lines('service', 'list') if '_action' in name]
    assert '/fibonacci/_action/send_goal' in ros2.lines('service', 'list', '--include-hidden-services')
    assert ros2.output('service', 'type', '/switch') == 'std_srvs/srv/SetBool\n'
    assert ros2.error('service', 'type', '/nothing') == ''
    assert ros2.lines('service', 'find', 'std_srvs/srv/SetBool') == ['/switch']
    assert ros2.lines('service', 'find', 'std_srvs/srv/SetBool', '-c') == ['1']
    assert ros2.output('service', 'info', '/switch') == (
        'Type: std_srvs/srv/SetBool\nClients count: 0\nServices count: 1\n'
    )


def test_service_call_of_the_article(ros2):
    text = ros2.output('service', 'call', '/add_two_ints', 'example_interfaces/srv/AddTwoInts', '{a: 10, b: 20}')
    assert text.removeprefix('waiting for service to become available...\n') == (
        'requester: making request: example_interfaces.srv.AddTwoInts_Request(a=10, b=20)\n\n'
        'response:\nexample_interfaces.srv.AddTwoInts_Response(sum=30)\n\n'
    )


def test_service_call_waits_for_the_server_and_repeats(ros2):
    with ros2.start(*SWITCH[:2], '/nobody', SWITCH[3]) as call:
        call.wait_for_output('waiting for service to become available...', timeout=PATIENCE)
        call.stop(PATIENCE)
        assert call.lines == ['waiting for service to become available...']
        assert call.returncode == 2
    with ros2.start(*SWITCH, '{data: true}', '-r', '20') as call:
        for _ in range(2):
            call.wait_for_output("message='switched'", timeout=PATIENCE)


def test_service_call_refuses_bad_input(ros2):
    assert ros2.error(*SWITCH[:3], 'std_srvs/srv/Nothing') == 'The passed service type is invalid'
    assert ros2.error(*SWITCH[:3], 'SetBool') == 'The passed service type is invalid'
    assert ros2.error(*SWITCH[:3], 'std_msgs/msg/String') == 'The passed type is not a service'
    assert ros2.error(*SWITCH, '{date: 1}') == (
        "Failed to populate field: 'SetBool_Request' object has no attribute 'date'"
    )
    assert ros2.error(*SWITCH, '{data: [').startswith('The passed value is not valid YAML: ')
    assert ros2.error(*SWITCH, 'yes') == 'The passed value needs to be a dictionary in YAML format'
    assert ros2.error(*SWITCH, '-r', '0') == 'rate must be greater than zero'
    assert 'service name' in ros2.error(*SWITCH[:2], '/no way', SWITCH[3])


def test_hidden_services_are_those_of_others(ros2):
    assert not [name for name in ros2.lines('service', 'list', '--include-hidden-services') if '_ros2cli' in name]


def test_echo_prints_the_events_of_a_service(ros2, node):
    node('introspected')
    with ros2.start('service', 'echo', '--flow-style', '/watched', 'std_srvs/srv/SetBool') as echo:
        with ros2.start('service', 'call', '-r', '5', '/watched', 'std_srvs/srv/SetBool', '{data: true}'):
            echo.wait_for_output('event_type: REQUEST_RECEIVED', PATIENCE)
            echo.wait_for_output('event_type: RESPONSE_SENT', PATIENCE)
            echo.wait_for_output('response: [{success: true, message: done}]', PATIENCE)
        echo.stop(PATIENCE)
    first = echo.lines.index('---')
    names = [line.partition(':')[0].strip() for line in echo.lines[:first]]
    assert names == [
        'info',
        'event_type',
        'stamp',
        'sec',
        'nanosec',
        'client_gid',
        'sequence_number',
        'request',
        'response',
    ]
    assert ros2.error('service', 'echo', '/no_such') == 'Could not load the type for the passed service'


def test_echo_takes_a_quality_of_service(ros2, node):
    options = ['--no-arr', '--qos-profile', 'services_default', '--qos-depth', '5']
    with ros2.start('service', 'echo', '/watched', 'std_srvs/srv/SetBool', *options) as echo:
        with ros2.start('service', 'call', '-r', '5', '/watched', 'std_srvs/srv/SetBool', '{data: true}'):
            echo.wait_for_output("client_gid: '<array type: uint8[16]>'", PATIENCE)
            echo.wait_for_output("request: '<sequence type: std_srvs/srv/SetBool_Request[1], length: 1>'", PATIENCE)
    assert 'invalid choice' in ros2.error('service', 'echo', '/watched', '--qos-reliability', 'maybe', status=2)
