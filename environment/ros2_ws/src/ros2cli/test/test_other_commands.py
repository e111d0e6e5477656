"""The commands daemon, component and multicast, and the node that commands use."""

import subprocess
import sys
import threading
import time
from concurrent.futures import ThreadPoolExecutor, wait

import pytest
from ros2cli.node.daemon import is_daemon_running, shutdown_daemon, spawn_daemon
from ros2multicast.api import receive, send

from environment.tests.running import PATIENCE


def test_there_is_no_daemon(ros2):
    for verb in ('status', 'stop'):
        assert ros2.output('daemon', verb) == 'The daemon is not running\n'
    assert ros2.output('daemon', 'start').startswith('No daemon is started')
    assert not is_daemon_running(args=[]) and not spawn_daemon(args=[]) and not shutdown_daemon(args=[])


def test_without_containers_there_are_no_components(ros2):
    assert ros2.output('component', 'list') == ''
    for argv in (['list', '/box'], ['load', '/box', 'composition', 'composition::Talker'], ['unload', '/box', '1']):
        assert ros2.error('component', *argv) == "Unable to find container node '/box'"
    assert ros2.error('component', 'types', 'no_such') == "Unable to find package 'no_such'"


def test_types_of_components_come_from_the_index(ros2, tmp_path):
    index = tmp_path / 'share' / 'ament_index' / 'resource_index' / 'rclcpp_components'
    index.mkdir(parents=True)
    (index / 'parts').write_text('parts::Wheel;lib/libparts.so\nparts::Axle;lib/libparts.so\n')
    environ = {**ros2.environ, 'AMENT_PREFIX_PATH': f'{tmp_path}:{ros2.environ.get("AMENT_PREFIX_PATH", sys.prefix)}'}
    command = type(ros2)(environ, tmp_path)
    assert command.lines('component', 'types') == ['parts', '  parts::Wheel', '  parts::Axle']
    assert command.error('component', 'types', 'parts') == "Unable to find package 'parts'"
    (index.parent / 'packages').mkdir()
    (index.parent / 'packages' / 'parts').touch()
    assert command.lines('component', 'types', 'parts') == ['parts::Wheel', 'parts::Axle']
    assert ros2.output('component', 'types', 'ros2cli') == '\n'


def test_programs_ask_for_components(ros2):
    code = """
from ros2cli.node.strategy import NodeStrategy
from ros2component.api import find_container_node_names, get_package_component_types, get_registered_component_types
from ros2node.api import get_node_names
with NodeStrategy([]) as node:
    assert find_container_node_names(node=node, node_names=get_node_names(node=node, include_hidden_nodes=True)) == []
assert get_package_component_types(package_name='ros2cli') == []
print(get_registered_component_types())
"""
    done = subprocess.run(
        [sys.executable, '-c', code], env=ros2.environ, timeout=2 * PATIENCE, capture_output=True, text=True
    )
    assert (done.returncode, done.stdout) == (0, '[]\n'), done


def test_a_datagram_is_sent_and_received(ros2):
    port = ['--port', '49153']
    with ros2.start('multicast', 'receive', *port, '--timeout', str(PATIENCE)) as receiver:
        receiver.wait_for_output('Waiting for UDP multicast datagram...', PATIENCE)
        end = time.monotonic() + PATIENCE
        while receiver.running:  # it says so before it listens
            assert time.monotonic() < end, 'nothing was received'
            done = ros2.run('multicast', 'send', *port)
            if done.returncode:  # a machine without a network has no way for multicast
                assert 'The datagram was not sent' in done.stderr
                return
            assert done.stdout == 'Sending one UDP multicast datagram...\n'
        assert receiver.returncode == 0 and "'Hello World!'" in receiver.lines[-1]
    assert ros2.error('multicast', 'receive', *port, '--timeout', '0.1') == 'No datagram came within 0.1 s'
    with ros2.start('multicast', 'receive', *port) as receiver:
        receiver.wait_for_output('Waiting for UDP multicast datagram...', PATIENCE)
        assert receiver.stop(PATIENCE) == 0  # Ctrl+C is how it is given up


def test_programs_send_and_receive_datagrams():
    """Only those to its own group and port."""
    end = time.monotonic() + PATIENCE
    with ThreadPoolExecutor() as threads:
        heard = threads.submit(receive, group='234.1.2.3', port=49154, timeout=PATIENCE)
        while not heard.done() and time.monotonic() < end:
            try:
                send(b'elsewhere', group='234.1.2.3', port=49155)
                send(b'here', group='234.1.2.3', port=49154, ttl=1)
            except OSError:  # a machine without a network has no way for multicast
                return
            wait([heard], timeout=0.05)
        assert heard.result()[0] == b'here'
    with pytest.raises(TimeoutError):
        receive(port=49156, timeout=0.05)


def test_a_signal_that_interrupts_no_wait_ends_one(ros2):
    """As one that comes just before the wait begins: Python learns of it only after the system call."""
    code = """
import os, signal, threading
from ros2multicast.api import receive

signal.signal(signal.SIGINT, signal.default_int_handler)  # a program started in the background ignores it

def interrupt():
    while open(f'/proc/self/task/{os.getpid()}/syscall').read().split()[0] not in ('7', '45', '73', '207'):
        pass  # until the main thread is in poll or recvfrom (their numbers on x86-64 and arm64)
    signal.pthread_kill(threading.get_ident(), signal.SIGINT)

thread = threading.Thread(target=interrupt)
thread.start()
signal.pthread_sigmask(signal.SIG_BLOCK, [signal.SIGINT])
try:
    receive(port=49157)
except KeyboardInterrupt:
    print('interrupted')
"""
    done = subprocess.run(
        [sys.executable, '-c', code], env=ros2.environ, timeout=PATIENCE, capture_output=True, text=True
    )
    assert (done.returncode, done.stdout) == (0, 'interrupted\n'), done


def test_a_node_of_a_command_lives_in_any_thread(ros2):
    code = """
import argparse, threading
from ros2cli.node.direct import DEFAULT_TIMEOUT, add_arguments
from ros2cli.node.strategy import NodeStrategy
parser = argparse.ArgumentParser()
add_arguments(parser)
assert parser.parse_args([]).spin_time == DEFAULT_TIMEOUT
names = []
def look():
    with NodeStrategy(None) as node:
        names.append(node.get_name())
thread = threading.Thread(target=look)
thread.start()
thread.join()
assert names[0].startswith('_ros2cli'), names
"""
    subprocess.run([sys.executable, '-c', code], check=True, env=ros2.environ, timeout=2 * PATIENCE)
    assert threading.current_thread() is threading.main_thread()


@pytest.fixture
def broken(ros2, tmp_path):
    """The command, where a plug-in is installed that cannot be imported, and one that is no command."""
    info = tmp_path / 'broken-1.0.dist-info'
    info.mkdir()
    (info / 'METADATA').write_text('Metadata-Version: 2.1\nName: broken\nVersion: 1.0\n')
    (info / 'entry_points.txt').write_text('[ros2cli.command]\nlost = no_such_module:Lost\nodd = json:loads\n')
    search = f'{tmp_path}:{ros2.environ.get("PYTHONPATH", "")}'
    return type(ros2)({**ros2.environ, 'PYTHONPATH': search}, tmp_path)


def test_extension_points_are_listed(broken):
    lines = broken.lines('extension_points')
    assert lines == sorted(lines)
    assert any(line.startswith('ros2topic.verb: ') for line in lines)
    assert 'ros2cli.command:' in {line.partition(' ')[0] for line in lines}
    verbose = broken.lines('extension_points', '--verbose')
    place = next(index for index, line in enumerate(verbose) if line.startswith('ros2cli.command: '))
    assert verbose[place + 1 : place + 4] == [
        '   module_name: ros2cli.command',
        '   attributes: CommandExtension',
        '   version: 0.1',
    ]


def test_extensions_are_listed_by_group(broken):
    lines = broken.lines('extensions')
    assert '  topic: Various topic related sub-commands' in lines
    groups = [line for line in lines if not line.startswith(' ')]
    assert groups == sorted(groups)
    verbs = lines[lines.index('ros2topic.verb') + 1 :]
    assert next(line for line in verbs if line.startswith('  echo: ')) == '  echo: Output messages from a topic'
    assert not any('lost' in line or line.startswith('-') for line in lines)


def test_extensions_that_cannot_be_used_are_told_why(broken):
    lines = broken.lines('extensions', '-a', '-v')
    place = lines.index('- lost: ')
    assert lines[place + 1 : place + 3] == ['-   module_name: no_such_module', '-   attributes: Lost']
    assert lines[place + 3 : place + 5] == [
        '-   distribution: broken 1.0',
        "-   reason: No module named 'no_such_module'",
    ]
    assert any(line.startswith('-   reason: loads() missing 1 required positional argument') for line in lines)
