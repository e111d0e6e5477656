"""Each fault, live: the tool that the chapter names shows it, it can be repaired, and it leaves nothing behind."""

import os
import signal
from contextlib import contextmanager

import psutil
import pytest

from helpers.programs import faults
from helpers.programs.faults.machine import SYSTEM_PATH

SHORT = 1.0  # s; long enough to see that a system does not work

pytestmark = pytest.mark.one_of(8)


@contextmanager
def staged(folder, what, kind, seed=3):
    """A fault that must be broken at first and work at the end of the block, and of which nothing may stay."""
    before = {child.pid for child in psutil.Process().children(recursive=True)}
    path = folder / 'system'
    with faults.stage(what, seed, kind, path) as fault:
        assert not fault.verify(timeout=SHORT)
        yield fault
        verdict = fault.verify()
        assert verdict, f'{verdict}\n' + '\n'.join(p.output for p in fault.programs.values())
    assert not path.exists()
    left = [child for child in psutil.Process().children(recursive=True) if child.pid not in before]
    assert all('reaper.py' in ' '.join(child.cmdline()) for child in left), left


def told(fault, script, *texts):
    """What commands print, as soon as all texts are in it; for graphs, of which a tool may not see everything yet."""
    for _ in range(5):
        status, shown = fault.ask(script)
        if status == 0 and all(text in shown for text in texts):
            return shown
    raise AssertionError(f'{script}: status {status}, and not {texts} in\n{shown}')


@pytest.mark.skipif(not os.access('/usr/bin/apt-get', os.X_OK), reason='apt is tried, and there is no apt-get here')
@pytest.mark.parametrize(
    'kind, message',
    [
        ('key_file', 'is not signed'),
        ('wrong_key', 'is not signed'),
        ('suite', 'does not have a Release file'),
        ('codename', 'jammy'),
        ('component', "doesn't have the component"),
        ('malformed', 'Malformed entry 1'),
    ],
)
def test_a_source_line_of_apt(tmp_path, kind, message, capsys):
    with staged(tmp_path, 'no_source', kind) as fault:
        fault.symptom()
        shown = capsys.readouterr().out
        assert message in shown and 'Candidate' not in shown
        assert not fault.fits(), 'reading agrees with apt'
        fault.repair()
        assert fault.fits()


@pytest.mark.parametrize('kind', faults.plan('no_source').kinds)
def test_a_source_line_where_there_is_no_apt(tmp_path, kind, capsys, monkeypatch):
    monkeypatch.setattr('helpers.programs.faults.apt.SYSTEM_PATH', str(tmp_path))
    with staged(tmp_path, 'no_source', kind) as fault:
        fault.symptom()
        assert capsys.readouterr().out.startswith('There is no apt-get on this machine')
        assert 'ros-archive-keyring.gpg' in fault.ask('ls usr/share/keyrings')[1]
        fault.repair()


@pytest.mark.parametrize('name', ['no_source', 'no_colcon'])
def test_a_path_with_a_space(tmp_path, name):
    with faults.stage(name, 1, folder=tmp_path / 'my course' / 'system') as fault:
        fault.repair()
        assert fault.verify()
    assert not fault.path.exists()


@pytest.mark.parametrize('kind', faults.plan('no_ros2').kinds)
def test_a_shell_without_ros2(tmp_path, kind, capsys):
    with staged(tmp_path, 'no_ros2', kind) as fault:
        fault.symptom()
        assert 'ros2: command not found' in capsys.readouterr().out
        _, path = fault.ask('echo $PATH')
        assert ('opt/ros/jazzy' in path) is False
        fault.repair()


@pytest.mark.parametrize('kind', faults.plan('no_colcon').kinds)
def test_a_shell_without_colcon(tmp_path, kind, capsys):
    with staged(tmp_path, 'no_colcon', kind) as fault:
        fault.symptom()
        assert 'colcon: command not found' in capsys.readouterr().out
        assert fault.ask('ros2 --help')[0] == 0
        assert str(fault.path / 'home' / fault.facts['folder'] / 'colcon') in fault.ask('find ~ -name colcon')[1]
        fault.repair()


@pytest.mark.parametrize('kind, message', [('module', 'ModuleNotFoundError'), ('script_dir', 'No executable found')])
def test_an_entry_point(tmp_path, kind, message, capsys):
    with staged(tmp_path, 'no_program', kind) as fault:
        fault.run(fault.command)
        assert message in capsys.readouterr().out
        fault.repair()


def test_two_distributions(tmp_path, domain):
    with staged(tmp_path, 'mixed_distros', 'both') as fault:
        assert fault.facts['distro'] in fault.ask('echo $ROS_DISTRO')[1]
        assert fault.ask('cd ros2_ws && colcon build')[0] == 1
        log = fault.path / 'home' / 'ros2_ws' / 'log' / 'latest_build' / fault.package / 'stderr.log'
        assert 'ImportError' in log.read_text() and 'opt/ros/' + fault.facts['distro'] in log.read_text()
        fault.repair()


@pytest.mark.parametrize('kind', ['reliability', 'namespace', 'type'])
def test_no_data(tmp_path, domain, kind):
    with staged(tmp_path, 'no_data', kind) as fault:
        truth = fault.facts
        heard = 0 if kind == 'namespace' else 1
        shown = told(
            fault,
            f'ros2 topic info --verbose {truth["publisher_topic"]}',
            'Publisher count: 1',
            f'Subscription count: {heard}',
        )
        if kind == 'reliability':
            assert {'BEST_EFFORT', 'RELIABLE'} <= {line.split()[-1] for line in shown.splitlines() if line.strip()}
        if kind == 'type':
            assert truth['offered'] in shown and truth['requested'] in shown
        fault.repair()


@pytest.mark.parametrize('kind', ['domain', 'range'])
def test_machines_that_do_not_see_each_other(tmp_path, domain, kind):
    with staged(tmp_path, 'unseen', kind) as fault:
        assert (fault.facts['variable'] == 'ROS_DOMAIN_ID') == (kind == 'domain')
        values = {fault.ask(f'echo ${fault.facts["variable"]}', on=machine)[1] for machine in fault.machines}
        assert len(values) == 2
        fault.repair()


@pytest.mark.parametrize('kind', ['no_server', 'type'])
def test_a_client_that_waits(tmp_path, domain, kind):
    with staged(tmp_path, 'waiting', kind) as fault:
        truth = fault.facts
        asked = f'{truth["client_service"]}: {truth["client_type"]}'
        shown = told(fault, f'ros2 node info /{truth["client"]}', asked)
        assert asked in shown.partition('Service Clients:')[2]
        if kind == 'no_server':
            assert f'/{truth["server"]}' not in fault.ask('ros2 node list')[1]
        fault.repair()


@pytest.mark.parametrize('kind', ['call', 'loop'])
def test_a_program_that_hangs(tmp_path, domain, kind, capsys):
    with staged(tmp_path, 'hang', kind) as fault:
        fault.symptom()
        assert 'it goes on' in capsys.readouterr().out
        fault.stacks()
        stack = capsys.readouterr().out
        file = (fault.path / fault.diagnosis[0].where).read_text().splitlines()
        number = next(i for i, line in enumerate(file, 1) if line.strip() == fault.diagnosis[0].evidence)
        assert f'{fault.diagnosis[0].where}", line {number} in {fault.facts["callback"]}' in stack
        fault.show_programs()
        assert 'hread 0x' not in capsys.readouterr().out, 'what a program says itself has no stacks in it'
        fault.repair()


def test_stacks_of_a_program_that_cannot_tell(tmp_path, domain, capsys):
    with faults.stage('hang', 3, 'loop', tmp_path / 'system') as fault:
        deaf = fault.files[fault.diagnosis[0].where].replace('faulthandler.register', '# ')
        fault.write(fault.diagnosis[0].where, deaf)
        fault.stacks()
        assert f'({fault.program} has no faulthandler.register: no stacks)' in capsys.readouterr().out
        fault.signal(fault.program, signal.SIGKILL, timeout=5.0)
        assert fault.settled(fault.program) == [f'({fault.program} does not run: no stacks)']
        fault.write('start.txt', '')
        with pytest.raises(ValueError, match=f'{fault.program}: there run no programs'):
            fault.stacks()


@pytest.mark.parametrize('kind', ['namespace', 'urdf'])
def test_no_robot_model(tmp_path, domain, kind, capsys):
    with staged(tmp_path, 'no_model', kind) as fault:
        fault.symptom()
        shown = capsys.readouterr().out
        assert 'no robot description' in shown and ('FATAL' in shown) == (kind == 'urdf')
        if kind == 'namespace':
            told(fault, 'ros2 topic info /robot_description', 'Publisher count: 0')
            told(fault, f'ros2 topic info {fault.facts["published"]}', 'Publisher count: 1')
        fault.repair()


@pytest.mark.parametrize('kind', faults.plan('falls').kinds)
def test_a_robot_that_does_not_stand_or_drive(tmp_path, domain, kind):
    with staged(tmp_path, 'falls', kind) as fault:
        text = (fault.path / 'robot.urdf').read_text()
        assert ('<collision>' in text) == (kind != 'no_collision')
        fault.repair()


@pytest.mark.parametrize('kind', ['swapped', 'parent'])
def test_a_transform(tmp_path, domain, kind):
    with staged(tmp_path, 'no_transform', kind) as fault:
        source = fault.facts['chain'][-1]
        with fault.terminal().start(f'exec ros2 run tf2_ros tf2_echo odom {source}') as echo:
            echo.wait_for_output('Translation: [-' if kind == 'swapped' else 'not part of the same tree', 20)
        fault.repair()


@pytest.mark.parametrize('kind', faults.plan('wrong_time').kinds)
def test_a_wrong_clock(tmp_path, domain, kind, capsys):
    with staged(tmp_path, 'wrong_time', kind) as fault:
        fault.symptom()
        shown = capsys.readouterr().out
        if kind == 'no_clock':
            told(fault, f'ros2 param get {fault.facts["asleep"]} use_sim_time', 'Boolean value is: True')
            told(fault, 'ros2 topic info /clock', 'Publisher count: 0')
        else:
            assert 'thrown away: ' in shown and 'published' in shown
            stamp = told(fault, f'timeout 20 ros2 topic echo --once {fault.facts["topic"]}', 'sec: ')
            assert int(stamp.split('sec: ')[1].split()[0]) < 10**9, 'seconds since the machine was started'
        fault.repair()


@pytest.mark.parametrize('kind', faults.plan('too_slow').kinds)
def test_a_rate_that_is_too_low(tmp_path, domain, kind, capsys):
    with staged(tmp_path, 'too_slow', kind) as fault:
        fault.symptom()
        assert ' messages a second' in capsys.readouterr().out
        shown = told(fault, f'timeout 30 ros2 topic hz {fault.facts["topic"]} | head -n 1', 'average rate: ')
        rate, (truth,) = float(shown.split('average rate: ')[1].split()[0]), fault.diagnosis
        assert rate < 1.5 * float(truth.evidence) < 5
        fault.repair()


@pytest.mark.parametrize('kind', faults.plan('no_parameter').kinds)
def test_a_parameter_that_did_not_arrive(tmp_path, domain, kind, capsys):
    with staged(tmp_path, 'no_parameter', kind) as fault:
        fault.symptom()
        assert len(set(fault.places())) == 1 and 'x = ' in capsys.readouterr().out
        ask = f'ros2 param get {fault.facts["node"]} {fault.facts["parameter"]}'
        told(fault, ask, f'Double value is: {fault.diagnosis[0].evidence}')
        fault.repair()
        fault.up()
        told(fault, ask, f'Double value is: {fault.facts["value"]}')


def test_two_faults_at_once(tmp_path, domain):
    with staged(tmp_path, 'mystery', 'two', seed=3) as fault:
        first, second = fault.repaired, fault.diagnosis
        assert len(second) == 2 and first
        fault.repair()


def test_editing_starts_only_what_has_changed(tmp_path, domain):
    with staged(tmp_path, 'no_data', 'name') as fault:
        publisher = fault.programs[fault.publisher].pid
        wrong, right = fault.facts['subscriber_topic'], fault.facts['publisher_topic']
        fault.edit(fault.diagnosis[0].where, wrong.strip('/'), right.strip('/'))
        assert fault.start() == [fault.listener]
        assert fault.programs[fault.publisher].pid == publisher


def test_a_folder_of_somebody_else_is_left_alone(tmp_path):
    (tmp_path / 'thesis.txt').write_text('three years')
    with pytest.raises(FileExistsError, match='move it away'):
        faults.stage('no_ros2', folder=tmp_path)
    assert (tmp_path / 'thesis.txt').read_text() == 'three years'


def test_staging_again_stops_the_earlier_one(tmp_path, domain):
    first = faults.stage('waiting', 1, folder=tmp_path / 'system')
    first.start()
    programs = list(first.programs.values())
    with faults.stage('waiting', 2, folder=tmp_path / 'system') as second:
        assert not any(program.running for program in programs)
        assert set(second.files) <= {path.name for path in second.path.iterdir()}


def test_the_same_edit_again_changes_nothing(tmp_path, capsys):
    with faults.stage('no_ros2', 1, 'unsourced', tmp_path / 'system') as fault:
        fault.write('notes.txt', 'one two')
        for edit in (('one', 'three'), ('two', 'four'), ('one', 'three')):
            fault.edit('notes.txt', *edit)
        assert capsys.readouterr().out == 'notes.txt: this edit has been made already\n'
        assert (fault.path / 'notes.txt').read_text() == 'three four'
        with pytest.raises(ValueError, match="has no 'one'"):  # that edit has never been made
            fault.edit('notes.txt', 'one', 'four')


def test_edits_are_exact_and_stay_inside(tmp_path):
    with faults.stage('no_ros2', 1, 'unsourced', tmp_path / 'system') as fault:
        with pytest.raises(ValueError, match=r"has no 'no such text': fault.show\('home/.bashrc'\) prints it"):
            fault.edit('home/.bashrc', 'no such text', '')
        with pytest.raises(ValueError, match="has 'export ' 2 times: give more of the text"):
            fault.edit('home/.bashrc', 'export ', '')
        with pytest.raises(ValueError, match='not inside'):
            fault.write('../elsewhere', '')
        with pytest.raises(ValueError, match="no machine 'moon': there are home"):
            fault.run('ls', on='moon')
        with pytest.raises(FileNotFoundError, match=r'no file .bashrc; it has home/.bashrc'):
            fault.show('.bashrc')
    for verb in (fault.verify, fault.symptom, lambda: fault.show('home/.bashrc'), lambda: fault.run('ls')):
        with pytest.raises(RuntimeError, match=r"stage it again, faults.stage\('no_ros2', seed=1\)"):
            verb()


def test_a_tool_that_the_system_has_itself_is_hidden(tmp_path, monkeypatch):
    """On a stock machine colcon is in /usr/bin, where every terminal finds it."""
    usr = tmp_path / 'usr'
    usr.mkdir()
    for command in ('bash', 'env', 'ls', 'cat', 'find'):
        (usr / command).symlink_to(f'{SYSTEM_PATH.split(":")[0]}/{command}')
    (usr / 'colcon').symlink_to('/bin/true')
    monkeypatch.setattr('helpers.programs.faults.machine.SYSTEM_PATH', str(usr))
    with faults.stage('no_colcon', 1, 'missing', tmp_path / 'system') as fault:
        assert fault.ask('colcon --help')[0] == 127
        assert fault.ask('ls')[0] == 0
