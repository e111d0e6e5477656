"""The course's interfaces are wire-compatible with every stock Jazzy: their type hashes are upstream's.

`type_hashes.json` holds upstream's hashes. Another process uses every interface, and this one learns over the wire what
it uses, in two ways:

- the graph. It carries the hash of each topic's type. For a service it carries only the hashes of the request and the
  response, for an action only those of its parts: these are compared with what the build wrote.
- the node's own service `get_type_description`, which answers only for hashes of types that the node uses, services and
  actions among them. Its answer names the type and describes it; from that the hash is computed anew.
"""

import hashlib
import json
import subprocess
import sys
import time
from pathlib import Path

import pytest
import rclpy
from rclpy.executors import SingleThreadedExecutor
from type_description_interfaces.msg import TypeDescription
from type_description_interfaces.srv import GetTypeDescription

from environment.setup import overlay
from environment.setup.layout import Layout
from environment.setup.main import ROOT
from environment.tests.interfaces_node import NODE, load, topic_of

UPSTREAM = json.loads(Path(__file__).with_name('type_hashes.json').read_text())
# A package that the course does not have yet has no hash to compare.
PACKAGES = overlay.discover(Layout(ROOT).sources)
HASHES = {name: value for name, value in UPSTREAM.items() if name.split('/')[0] in PACKAGES}
MESSAGES, SERVICES, ACTIONS = (
    sorted(n for n in HASHES if n.split('/')[1] == kind) for kind in ('msg', 'srv', 'action')
)
TIMEOUT = 20.0  # seconds


@pytest.fixture(scope='module')
def node():
    """A node that sees, in the graph, the other process and all its endpoints."""
    command = [sys.executable, '-m', 'environment.tests.interfaces_node']
    with subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True, cwd=ROOT) as other:
        context = rclpy.Context()
        rclpy.init(context=context)
        asking = rclpy.create_node('asking', context=context)
        try:
            other.stdin.write(json.dumps(sorted(HASHES)) + '\n')
            other.stdin.flush()
            assert other.stdout.readline() == 'ready\n'
            yield asking
        finally:
            asking.destroy_node()
            rclpy.shutdown(context=context)
            other.stdin.close()
            other.wait(TIMEOUT)


def from_graph(node, topic: str, *, publishers: bool, raw: bool = False) -> str:
    """The type hash of the one endpoint that offers or takes `topic`. `raw`: a topic of DDS, not of ROS."""
    ask = node.get_publishers_info_by_topic if publishers else node.get_subscriptions_info_by_topic
    end = time.monotonic() + TIMEOUT
    while time.monotonic() < end:
        found = [e for e in ask(topic, no_mangle=raw) if e.node_name == NODE]
        if found:
            assert len(found) == 1
            return str(found[0].topic_type_hash)
        # Discovery has no event in rclpy that a script can wait for.
        time.sleep(0.02)
    raise TimeoutError(f'{topic} did not appear in the graph')


def built(interface: str) -> dict[str, str]:
    """The hashes that the build wrote for an interface and for its parts."""
    package, kind, name = interface.split('/')
    file = Layout(ROOT).prefix / 'share' / package / kind / f'{name}.json'
    return {entry['type_name']: entry['hash_string'] for entry in json.loads(file.read_text())['type_hashes']}


def hash_of(description: TypeDescription) -> str:
    """REP 2011's hash, version 1: SHA-256 of the description as JSON, default values left out."""

    def individual(one) -> dict:
        return {
            'type_name': one.type_name,
            'fields': [
                {
                    'name': field.name,
                    'type': {
                        'type_id': field.type.type_id,
                        'capacity': field.type.capacity,
                        'string_capacity': field.type.string_capacity,
                        'nested_type_name': field.type.nested_type_name,
                    },
                }
                for field in one.fields
            ],
        }

    text = json.dumps(
        {
            'type_description': individual(description.type_description),
            'referenced_type_descriptions': [individual(one) for one in description.referenced_type_descriptions],
        }
    )
    return 'RIHS01_' + hashlib.sha256(text.encode()).hexdigest()


def ask(node, interface: str, type_hash: str) -> GetTypeDescription.Response:
    """What the other process's node says of the interface with this hash."""
    client = node.create_client(GetTypeDescription, f'/{NODE}/get_type_description')
    executor = SingleThreadedExecutor(context=node.context)
    executor.add_node(node)
    try:
        assert client.wait_for_service(TIMEOUT)
        future = client.call_async(GetTypeDescription.Request(type_name=interface, type_hash=type_hash))
        executor.spin_until_future_complete(future, TIMEOUT)
        assert future.done(), 'no answer'
        return future.result()
    finally:
        executor.remove_node(node)
        executor.shutdown()
        node.destroy_client(client)


def test_there_is_something_to_compare():
    packages = {name.split('/')[0] for name in HASHES}
    assert {'example_interfaces', 'tf2_msgs'} <= packages
    assert MESSAGES
    assert SERVICES
    assert ACTIONS


@pytest.mark.parametrize('interface', MESSAGES)
def test_messages_in_the_graph(node, interface):
    assert from_graph(node, topic_of(interface), publishers=True) == HASHES[interface]


@pytest.mark.parametrize('interface', SERVICES)
def test_the_parts_of_services_in_the_graph(node, interface):
    topic, parts = topic_of(interface), built(interface)
    assert from_graph(node, f'rq{topic}Request', publishers=False, raw=True) == parts[f'{interface}_Request']
    assert from_graph(node, f'rr{topic}Reply', publishers=True, raw=True) == parts[f'{interface}_Response']


@pytest.mark.parametrize('interface', ACTIONS)
def test_the_parts_of_actions_in_the_graph(node, interface):
    topic, parts = topic_of(interface) + '/_action', built(interface)
    assert from_graph(node, f'{topic}/feedback', publishers=True) == parts[f'{interface}_FeedbackMessage']
    for service, part in (('send_goal', 'SendGoal'), ('get_result', 'GetResult')):
        request = from_graph(node, f'rq{topic}/{service}Request', publishers=False, raw=True)
        reply = from_graph(node, f'rr{topic}/{service}Reply', publishers=True, raw=True)
        assert request == parts[f'{interface}_{part}_Request']
        assert reply == parts[f'{interface}_{part}_Response']


@pytest.mark.parametrize('interface', sorted(HASHES))
def test_the_description_that_the_node_sends(node, interface):
    answer = ask(node, interface, HASHES[interface])
    assert answer.successful, answer.failure_reason
    assert answer.type_description.type_description.type_name == interface
    assert hash_of(answer.type_description) == HASHES[interface]


def test_a_hash_of_no_type_in_use_is_refused_by_the_node(node):
    """Else the test above could not fail."""
    assert not ask(node, 'example_interfaces/msg/Int64', 'RIHS01_' + 'f' * 64).successful


@pytest.mark.parametrize('interface', sorted(HASHES))
def test_what_the_build_wrote(interface):
    assert built(interface)[interface] == HASHES[interface]


EXAMPLES = {
    'msg': """Bool Byte ByteMultiArray Char Empty Float32 Float32MultiArray Float64 Float64MultiArray Int16
        Int16MultiArray Int32 Int32MultiArray Int64 Int64MultiArray Int8 Int8MultiArray MultiArrayDimension
        MultiArrayLayout String UInt16 UInt16MultiArray UInt32 UInt32MultiArray UInt64 UInt64MultiArray UInt8
        UInt8MultiArray WString""",
    'srv': 'AddTwoInts SetBool Trigger',
    'action': 'Fibonacci',
}


@pytest.mark.parametrize(('kind', 'names'), EXAMPLES.items())
def test_example_interfaces_is_whole(kind, names):
    for name in names.split():
        load(f'example_interfaces/{kind}/{name}')


def test_example_messages_have_the_fields_of_their_namesakes():
    """Where std_msgs has a message of the same name, the fields are the same."""
    import std_msgs.msg

    compared = 0
    for name in EXAMPLES['msg'].split():
        if hasattr(std_msgs.msg, name):
            ours = load(f'example_interfaces/msg/{name}').get_fields_and_field_types()
            theirs = getattr(std_msgs.msg, name).get_fields_and_field_types()
            assert ours == {f: t.replace('std_msgs/', 'example_interfaces/') for f, t in theirs.items()}, name
            compared += 1
    assert compared >= 28


def test_constants_of_tf2_errors():
    error = load('tf2_msgs/msg/TF2Error')
    names = ('NO_ERROR', 'LOOKUP_ERROR', 'CONNECTIVITY_ERROR', 'EXTRAPOLATION_ERROR', 'INVALID_ARGUMENT_ERROR')
    assert [getattr(error, n) for n in (*names, 'TIMEOUT_ERROR', 'TRANSFORM_ERROR')] == list(range(7))
