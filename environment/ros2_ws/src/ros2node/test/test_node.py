"""`ros2 node` beside a real node."""

import re

import pytest

from environment.tests.running import PATIENCE

pytestmark = pytest.mark.usefixtures('robot')


def test_node_list(ros2):
    assert ros2.lines('node', 'list') == ['/robot']
    assert ros2.output('node', 'list', '-c') == '1\n'
    everything = ros2.lines('node', 'list', '--all')
    assert everything[-1] == '/robot'
    assert re.fullmatch(r'/_ros2cli_\d+', everything[0])


def test_node_info(ros2):
    services = ''.join(
        f'    /robot/{name}: rcl_interfaces/srv/{kind}\n'
        if kind != 'GetTypeDescription'
        else f'    /robot/{name}: type_description_interfaces/srv/{kind}\n'
        for name, kind in (
            ('describe_parameters', 'DescribeParameters'),
            ('get_parameter_types', 'GetParameterTypes'),
            ('get_parameters', 'GetParameters'),
            ('get_type_description', 'GetTypeDescription'),
            ('list_parameters', 'ListParameters'),
            ('set_parameters', 'SetParameters'),
            ('set_parameters_atomically', 'SetParametersAtomically'),
        )
    )
    assert ros2.output('node', 'info', '/robot') == (
        '/robot\n'
        '  Subscribers:\n'
        '    /heard: std_msgs/msg/String\n'
        '  Publishers:\n'
        '    /chatter: std_msgs/msg/String\n'
        '    /joints: sensor_msgs/msg/JointState\n'
        '    /latched: std_msgs/msg/String\n'
        '    /parameter_events: rcl_interfaces/msg/ParameterEvent\n'
        '    /rosout: rcl_interfaces/msg/Log\n'
        '    /sensor: std_msgs/msg/String\n'
        '    /twist: geometry_msgs/msg/TwistStamped\n'
        '  Service Servers:\n'
        f'{services}'
        '    /switch: std_srvs/srv/SetBool\n'
        '  Service Clients:\n'
        '\n'
        '  Action Servers:\n'
        '\n'
        '  Action Clients:\n'
        '\n'
    )
    assert '    /_hidden: std_msgs/msg/String' in ros2.lines('node', 'info', 'robot', '--include-hidden')
    assert ros2.error('node', 'info', '/nobody') == "Unable to find node '/nobody'"


def test_a_hidden_node_is_found_only_if_asked_for(ros2):
    with ros2.start('topic', 'pub', '-n', '_secret', '-r', '1', '/x', 'std_msgs/msg/String') as publisher:
        publisher.wait_for_output('publishing #1', PATIENCE)
        assert ros2.error('node', 'info', '/_secret') == "Unable to find node '/_secret'"
        assert ros2.lines('node', 'info', '/_secret', '--include-hidden')[0] == '/_secret'
