"""Child processes: their output, their end, and the end of what they started."""

import signal
import subprocess
import sys

import psutil
import pytest

from helpers import background

COUNT = 'import time\nfor n in range(3): print("line", n)\ntime.sleep(600)'


def python(code, **options):
    return background([sys.executable, '-c', code], **options)


def test_output_is_read_while_it_runs():
    with python(COUNT) as child:
        assert child.wait_for_output('line 2', 30) == 'line 2'
        assert child.wait_for_output(lambda line: line.endswith('1'), 30) == 'line 1', 'earlier lines count'
        assert child.lines == ['line 0', 'line 1', 'line 2']
        assert child.running and 'running, 3 lines' in repr(child)
    assert not child.running


def test_a_string_is_split_and_variables_are_added():
    with background('sh -c "echo $WORD; sleep 600"', env={'WORD': 'hello'}) as child:
        assert child.wait_for_output('hello', 30) == 'hello'


def test_lines_can_be_echoed(capsys):
    with python('print(1); print(2)', echo=True) as child, pytest.raises(RuntimeError, match='status 0'):
        child.wait_for_output('3', 30)
    assert capsys.readouterr().out == '1\n2\n'


def test_what_does_not_come_is_named_with_the_last_lines():
    with python(COUNT) as child:
        child.wait_for_output('line 2', 30)
        lines = 'its last lines:\n    line 0\n    line 1\n    line 2'
        with pytest.raises(TimeoutError, match=f"did not print 'line 3' in 0.1 s; {lines}"):
            child.wait_for_output('line 3', 0.1)


def test_an_early_end_shows_status_and_last_lines():
    with python('import sys; print("so far", flush=True); sys.exit("no such robot")') as child:
        lines = 'its last lines:\n    so far\n    no such robot'
        with pytest.raises(RuntimeError, match=f"ended with status 1 before it printed 'ready'; {lines}"):
            child.wait_for_output('ready', 30)
        assert child.returncode == 1


def test_a_folder_that_is_not_there_is_told(tmp_path):
    """Not that there is no Python: the system reports both in the same way."""
    with pytest.raises(FileNotFoundError, match='there is no folder .*/nowhere: run the cells above that make it'):
        background([sys.executable, '-c', 'pass'], cwd=tmp_path / 'nowhere')


def test_an_unknown_command():
    with pytest.raises(FileNotFoundError, match="no command 'ros3'"):
        background('ros3 run x y')


def test_a_folder_of_path_that_may_not_be_read_does_not_hide_that_there_is_no_command(monkeypatch):
    def refuse(*arguments, **options):
        raise PermissionError(13, 'Permission denied')

    monkeypatch.setattr(subprocess, 'Popen', refuse)
    with pytest.raises(FileNotFoundError, match="no command 'ros3'"):
        background('ros3 run x y')
    with pytest.raises(PermissionError):
        background('sh -c true')


def test_stop_asks_first_and_is_idempotent():
    child = python(
        'import time\ntry:\n    print("up"); time.sleep(600)\nexcept KeyboardInterrupt:\n    print("asked"); exit(5)'
    )
    child.wait_for_output('up', 30)
    assert child.stop(timeout=30) == 5
    assert child.stop() == 5
    assert child.lines == ['up', 'asked']


def test_stop_asks_also_where_sigint_is_ignored():
    """As in a program that a shell has started with `&`."""
    before = signal.signal(signal.SIGINT, signal.SIG_IGN)
    try:
        child = python('import time; print("up"); time.sleep(600)')
        child.wait_for_output('up', 30)
        assert child.stop(timeout=30) == -signal.SIGINT
        assert signal.getsignal(signal.SIGINT) is signal.SIG_IGN
    finally:
        signal.signal(signal.SIGINT, before)


@pytest.mark.parametrize('own_session', [False, True])
def test_stop_ends_also_what_ignores_it_and_its_children(own_session):
    """`ros2 launch` gives each of its programs a session of its own."""
    child = python(
        'import signal, subprocess, sys, time\n'
        'signal.signal(signal.SIGINT, signal.SIG_IGN)\n'
        f'command, apart = [sys.executable, "-c", "import time; time.sleep(600)"], {own_session}\n'
        'p = subprocess.Popen(command, start_new_session=apart)\n'
        'print("up")\n'
        'time.sleep(600)'
    )
    child.wait_for_output('up', 30)
    family = [psutil.Process(child.pid), *psutil.Process(child.pid).children()]
    assert len(family) == 2
    assert child.stop(timeout=0.2) == -9
    assert psutil.wait_procs(family, timeout=30)[1] == []


def test_a_terminal_has_keys():
    code = 'import sys, os\nprint(os.isatty(0), os.isatty(1))\nfor line in sys.stdin: print("read", repr(line))'
    with python(code, terminal=True) as child:
        child.wait_for_output('True True', 30)
        child.type('up')
        child.type('q')
        child.type('enter')
        assert child.wait_for_output('read', 30) == "read '\\x1b[Aq\\n'"
    assert child.stop() < 0 or not child.running
    with pytest.raises(RuntimeError, match='terminal=True'):
        child.type('q')


def test_without_a_terminal_there_is_nothing_to_type_on():
    with python(COUNT) as child, pytest.raises(RuntimeError, match='terminal=True'):
        child.type('q')
