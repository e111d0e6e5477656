"""`ros2 doctor`, and that a command knows the whole graph on a busy machine."""

import os
import re
import socket
import subprocess
import sys

import pytest

from helpers.kernel import domains

REPORTS = [
    'NETWORK CONFIGURATION',
    'PACKAGE VERSIONS',
    'PLATFORM INFORMATION',
    'QOS COMPATIBILITY LIST',
    'RMW MIDDLEWARE',
    'ROS 2 INFORMATION',
    'TOPIC LIST',
]


def test_doctor_on_an_empty_graph(ros2):
    done = ros2.run('doctor')
    assert (done.returncode, done.stdout) == (0, '\nAll 5 checks passed\n\n')
    assert ros2.run('wtf').stdout == done.stdout


def test_doctor_report(ros2):
    text = ros2.output('doctor', '--report')
    assert re.findall(r'^   (\S.*)$', text, re.MULTILINE) == REPORTS
    for line in (
        'system           : Linux',
        'middleware name    : rmw_fastrtps_cpp',
        'distribution name      : jazzy',
        'compatibility status    : No publisher/subscriber pairs found',
        'topic               : none',
        'publisher count     : 0',
        'subscriber count    : 0',
    ):
        assert line in text.splitlines()
    assert re.search(r'^ros2doctor +: latest=N/A, local=\d+\.\d+\.\d+$', text, re.MULTILINE)


@pytest.mark.parametrize('option', ['--exclude-packages', '-ep'])
def test_doctor_leaves_the_packages_out(ros2, option):
    assert ros2.run('doctor', option).stdout == '\nAll 4 checks passed\n\n'
    text = ros2.output('doctor', '--report', option)
    assert re.findall(r'^   (\S.*)$', text, re.MULTILINE) == [each for each in REPORTS if each != 'PACKAGE VERSIONS']


def test_doctor_hello_tells_in_a_table_who_is_heard(ros2):
    greeting = """{data: "hello, it's me robot"}"""
    with ros2.start('topic', 'pub', '-r', '20', '/canyouhearme', 'std_msgs/msg/String', greeting):
        lines = ros2.output('doctor', 'hello', '--once', '--emit-period', '4.0').splitlines()
    head = f'{"":<15} {"Hostname":<20} {"Msg Count /1.0s":<10}'
    assert (
        lines[0] == 'MULTIMACHINE COMMUNICATION SUMMARY' and lines[2] == 'Subscribed from:' and lines.count(head) == 2
    )
    # With --once there is one greeting, however long it listens.
    assert lines[1] == 'Topic: /canyouhearme, Published Msg Count: 1'
    assert re.fullmatch(r' {16}robot {16}\d+ *', lines[4])


def test_doctor_hello_counts_in_a_table_that_a_program_gives(ros2):
    script = """
from argparse import Namespace
from socket import gethostname
from ros2doctor.verb.hello import HelloVerb, SummaryTable

table = SummaryTable()
args = Namespace(topic='/hello', emit_period=0.1, print_period=5.0, ttl=None, once=True)
HelloVerb().main(args=args, summary_table=table)
assert table._pub == 1 and gethostname() not in {**table._sub, **table._receive}, vars(table)
table.increment_sub('away')
table.increment_sub('away')
table.increment_receive('far')
table.format_print_summary('/hello', 5.0)
table.reset()
assert (table._pub, table._send, table._sub, table._receive) == (0, 0, {}, {})
"""
    done = subprocess.run(
        [sys.executable, '-c', script], env=ros2.environ, cwd=ros2.directory, capture_output=True, text=True, timeout=60
    )
    assert (done.returncode, done.stderr) == (0, '')
    first, _, second = done.stdout.partition('-' * 60)
    assert 'Published Msg Count: 1\n' in first and 'Published Msg Count: 1\n' in second
    assert re.findall(r' {16}(\w+) +(\d+) *$', second, re.MULTILINE) == [('away', '2'), ('far', '1')]


def test_doctor_says_what_is_wrong(ros2):
    bad = type(ros2)({**ros2.environ, 'ROS_DISTRO': ''}, ros2.directory)
    done = bad.run('doctor', '-rf')
    assert re.search(r'platform\.py: \d+: UserWarning: ERROR: ROS_DISTRO is not set\.\n', done.stderr)
    assert done.stdout.startswith('\n1/5 check(s) failed\n\nFailed modules: platform\n\n   PLATFORM INFORMATION\n')
    old = type(ros2)({**ros2.environ, 'ROS_DISTRO': 'foxy'}, ros2.directory)
    assert 'Distribution foxy is no longer supported or deprecated.' in old.run('doctor').stderr
    assert old.run('doctor', '--include-warnings').stdout.startswith('\n1/5 check(s) failed\n')


def test_doctor_finds_the_mismatch(ros2, node):
    node('deaf')
    done = ros2.run('doctor')
    assert re.search(
        r"UserWarning: ERROR: QoS compatibility error found on topic '/mismatch': .*reliab", done.stderr, re.IGNORECASE
    )
    assert done.stdout == '\n1/5 check(s) failed\n\nFailed modules: middleware\n'
    assert 'topic [type]            : /mismatch [std_msgs/msg/String]' in ros2.lines('doctor', '-r')


def test_every_node_of_several_processes_is_listed_at_once(ros2, node):
    for name in ('robot', 'worker', 'managed', 'adder'):
        node(name)
    expected = {'/adder', '/managed', '/plain', '/robot', '/worker'}
    for _ in range(3):
        assert expected <= set(ros2.lines('node', 'list'))


# A receiver as on a machine with no time: datagrams that come while the buffer is full get lost.
LOSSY = """
<profiles xmlns="http://www.eprosima.com/XMLSchemas/fastRTPS_Profiles">
  <transport_descriptors>
    <transport_descriptor>
      <transport_id>small</transport_id>
      <type>UDPv4</type>
      <receiveBufferSize>4608</receiveBufferSize>
      <maxMessageSize>4000</maxMessageSize>
    </transport_descriptor>
  </transport_descriptors>
  <participant profile_name="lossy" is_default_profile="true">
    <rtps>
      <userTransports><transport_id>small</transport_id></userTransports>
      <useBuiltinTransports>false</useBuiltinTransports>
    </rtps>
  </participant>
</profiles>
"""


# `ros2` as it is, but for the bound of its wait: with both processors busy, six seconds may not be enough here.
PATIENT = """
import sys
from ros2cli.node import discovery
discovery.LONGEST_TIME = 60.0
from ros2cli.cli import main
sys.exit(main())
"""


def test_what_got_lost_on_the_way_is_awaited(ros2, node, tmp_path):
    node('worker')
    actions = ros2.lines('action', 'list')
    assert actions
    profile = tmp_path / 'lossy.xml'
    profile.write_text(LOSSY)
    environ = {**ros2.environ, 'FASTRTPS_DEFAULT_PROFILES_FILE': str(profile)}
    for _ in range(4):
        patient = subprocess.run(
            [sys.executable, '-c', PATIENT, 'action', 'list'], env=environ, capture_output=True, text=True, timeout=120
        )
        assert (patient.returncode, patient.stderr, patient.stdout.splitlines()) == (0, '', actions)


def test_a_participant_that_never_answers_costs_a_bounded_time(ros2):
    """A foreign program on one of the domain's ports looks like a participant."""
    with domains.claim() as domain_id, socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as foreign:
        foreign.bind(('127.0.0.1', 7400 + 250 * domain_id + 10 + 2 * 100))
        lonely = type(ros2)({**ros2.environ, 'ROS_DOMAIN_ID': str(domain_id)}, ros2.directory)
        assert lonely.lines('topic', 'list') == ['/parameter_events', '/rosout']


def test_lost_datagrams_are_counted():
    from ros2cli.node import discovery

    with (
        domains.claim() as domain_id,
        socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as deaf,
        socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as sender,
    ):
        deaf.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4608)
        deaf.bind(('127.0.0.1', 7400 + 250 * domain_id + 10))
        assert [each.lost for each in discovery._discovery_sockets(domain_id)] == [0]
        for _ in range(50):
            sender.sendto(bytes(1000), deaf.getsockname())
        (found,) = discovery._discovery_sockets(domain_id)
        assert (found.port, found.inode) == (deaf.getsockname()[1], str(os.fstat(deaf.fileno()).st_ino))
        assert 0 < found.lost < 50
        assert discovery._lost_before(domain_id) == {}  # one's own count from the beginning


def test_the_ports_are_those_of_real_participants(ros2, node):
    node('worker')
    code = (
        'import sys; from ros2cli.node.direct import DirectNode; from ros2cli.node import discovery\n'
        'with DirectNode(None) as node:\n'
        '    ports = {each.port for each in discovery._discovery_sockets(node.context.get_domain_id())}\n'
        '    heard = node.get_publishers_info_by_topic("ros_discovery_info", no_mangle=True)\n'
        '    print(len(ports), len(heard))\n'
    )
    done = subprocess.run([sys.executable, '-c', code], capture_output=True, text=True, env=ros2.environ)
    ports, heard = map(int, done.stdout.split())
    assert ports == heard >= 2


@pytest.mark.parametrize(
    'version,wanted,fits',
    [
        ('0.1', '^0.1', True),
        ('0.1.3', '^0.1', True),
        ('0.2', '^0.1', False),
        ('1.4', '^1.2', True),
        ('1.1', '^1.2', False),
        ('2.0', '^1.2', False),
    ],
)
def test_versions_of_the_plug_in_interface(version, wanted, fits):
    from ros2cli.plugin_system import PluginException, satisfies_version

    if fits:
        satisfies_version(version, wanted)
    else:
        with pytest.raises(PluginException):
            satisfies_version(version, wanted)
