"""What a learner's program can see and reach: one program is asked everything."""

import json
import os
import secrets
import socket
import sys
from pathlib import Path

import pytest

from grading import sandbox
from grading.sandbox import station
from helpers import paths
from helpers.runner import session, start_processes
from helpers.tests import small

TEST = '''
def test_facts(learner):
    """Facts."""
    learner.call('facts', {port}, {name!r}, {paths!r})
'''


@pytest.fixture(scope='module')
def host(tmp_path_factory):
    """What the grader's machine has, and the program must not find: its folders, and who listens on it."""
    folder = tmp_path_factory.mktemp('grader')
    with socket.create_server(('127.0.0.1', 0)) as tcp, socket.socket(socket.AF_UNIX) as unix:
        name = f'course-{secrets.token_hex(8)}'
        unix.bind('\0' + name)
        unix.listen()
        # They can be reached from here, so that a failure inside means something.
        socket.create_connection(tcp.getsockname(), 2).close()
        with socket.socket(socket.AF_UNIX) as client:
            client.connect('\0' + name)
        yield {'folder': folder, 'port': tcp.getsockname()[1], 'name': name}


@pytest.fixture(scope='module')
def facts(host):
    """What the program found."""
    hidden = ('grading', 'solutions', 'notebooks', '.git', 'course', 'helpers/checks/exercises.json')
    seen = [str(paths.ROOT / name) for name in (*hidden, 'helpers/runner/worker.py', '.venv/bin/python')]
    seen += [str(host['folder']), '/etc/passwd', '/etc/hostname', '/proc/2/root/../root/.ssh']
    text = TEST.format(port=host['port'], name=host['name'], paths=seen)
    checks = small.write_tests(host['folder'], text)
    os.environ['GRADER_TOKEN'] = host['name']
    try:
        station.close()  # the servers that start now could inherit it
        program = Path(__file__).with_name('program_facts.py').read_text()
        report = session.run(
            small.cells(program),
            [small.exercise(names=('facts',))],
            session.Options(visible=checks, launcher=sandbox.launcher('bubblewrap')),
        )
    finally:
        del os.environ['GRADER_TOKEN']
    assert report.exercises[0].passed, (report.exercises[0].tests, report.log)
    assert report.sandbox == 'bubblewrap'
    return json.loads(report.exercises[0].tests[0].output)


def test_it_is_nobody_and_may_nothing(facts):
    status = facts['status']
    assert {status[key] for key in ('CapInh', 'CapPrm', 'CapEff', 'CapBnd', 'CapAmb')} == {'0' * 16}
    assert status['Uid'].split() == status['Gid'].split() == ['1000'] * 4
    assert (status['NoNewPrivs'], status['Seccomp']) == ('1', '2')


def test_its_namespaces_are_its_own(facts):
    for kind in ('user', 'pid', 'net', 'ipc', 'uts', 'mnt', 'cgroup'):
        assert facts['namespaces'][kind] != os.readlink(f'/proc/self/ns/{kind}'), kind
    assert facts['host'] == 'sandbox'


def test_it_sees_no_other_process(facts):
    assert len(facts['pids']) == 2 and facts['parent'] == 0


def test_it_sees_no_test_and_nothing_of_the_grader(facts):
    seen = {path for path, there in facts['seen'].items() if there}
    assert seen == {str(paths.ROOT / 'helpers/runner/worker.py'), str(paths.ROOT / '.venv/bin/python')}
    above = {part for path in (paths.ROOT, Path(sys.base_prefix)) for part in path.parts}  # these are there, but empty
    assert set(facts['folders']['/home']) - above == {'learner'} and not facts['modules']
    assert not {'passwd', 'shadow', 'hostname', 'resolv.conf', 'machine-id'} & set(facts['folders']['/etc'])
    assert not {'root', 'var', 'sys', 'run', 'mnt', 'opt', 'srv', 'boot'} & set(facts['folders']['/']) - above
    assert not [name for name in facts['folders']['/dev'] if name.startswith(('sd', 'vd', 'kvm', 'mem', 'fuse'))]


def test_only_three_places_can_be_written(facts):
    places = {path for path, error in facts['writes'].items() if not error}
    assert places == {'/tmp/x', '/dev/shm/x', '/home/learner/x'}
    assert all(facts['writes'][path] for path in ('/proc/sys/kernel/core_pattern', '/dev/x'))


def test_there_is_no_network_but_its_own(facts):
    assert all(facts['network'].values()), facts['network']
    assert facts['interfaces'] == ['lo']


def test_its_environment_is_the_same_for_all(facts, host):
    environment = facts['environment']
    assert (environment['LC_ALL'], environment['LANGUAGE']) == ('C.UTF-8', '')
    assert host['name'] not in environment.values() and 'GRADER_TOKEN' not in environment
    assert environment['HOME'] == '/home/learner' and str(host['folder']) not in str(environment)
    assert set(environment) <= {
        *start_processes.ros_environment(0),
        'PATH',
        'LANGUAGE',
        'LD_LIBRARY_PATH',
        'AMENT_PREFIX_PATH',
        '_ROS_WHEELS_BOOTSTRAP_COMPLETE',
        'PYTHONPATH',
        'HOME',
        'TMPDIR',
        'ROS_LOG_DIR',
        'COURSE_RUNNER',
        'ROS_DISTRO',
        'VIRTUAL_ENV',
        'LC_ALL',
        'LC_CTYPE',
    }


def test_its_open_files_are_its_own(facts):
    fds = facts['fds']
    assert fds['0'] == '/dev/null' and fds['1'] == fds['2'] and fds['1'].startswith('pipe:')
    others = [link for number, link in fds.items() if number not in '012']
    assert len([link for link in others if link.startswith('socket:')]) <= 1  # its channel
    assert all(link.startswith(('socket:', '/tmp/', '/proc/')) for link in others), others


def test_system_calls_are_filtered(facts):
    allowed = {call for call, error in facts['calls'].items() if not error}
    assert allowed == {'getpid'}
    assert facts['calls'].pop('clone3') == 'Function not implemented'  # so that the C library takes clone
    assert facts['calls'].pop('getpid') == ''
    assert set(facts['calls'].values()) == {'Operation not permitted'}, facts['calls']


def test_its_limits_are_set(facts):
    limits = start_processes.Limits()
    assert {key: value[1] for key, value in facts['limits'].items()} == {
        'RLIMIT_AS': limits.memory,
        'RLIMIT_CPU': limits.cpu,
        'RLIMIT_NOFILE': limits.files,
        'RLIMIT_FSIZE': limits.file_size,
        'RLIMIT_CORE': 0,
        'RLIMIT_NPROC': limits.processes,
    }
