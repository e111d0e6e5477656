"""Ctrl+C, SIGTERM and SIGHUP, while a command loads and while it works."""

import signal
import subprocess
import sys

import pytest

from environment.setup.main import ROOT

SIGNALS = [signal.SIGINT, signal.SIGTERM, signal.SIGHUP]
LOADS = 'import os, signal, sys; from environment.setup import interruption; '
# Whoever runs the tests may have it ignored: a shell does that for what it starts in the background.
BEFORE = 'signal.signal(int(sys.argv[1]), signal.{}); '
RAISES = """
interruption.raises()
try:
    os.kill(os.getpid(), int(sys.argv[1]))
except KeyboardInterrupt:
    print('interrupted')
"""
# As the set-up does it: the program that this process becomes says what a signal does that has come in between.
WAITS = f"""
interruption.waits()
os.kill(os.getpid(), int(sys.argv[1]))
os.execv(sys.executable, [sys.executable, '-c', {LOADS!r} + "print('begins', flush=True); interruption.ends_at_once()"])
"""


def run(code: str, number: signal.Signals, before: str = 'SIG_DFL') -> subprocess.CompletedProcess:
    """Run `code` in a process that is given a signal's number, and for which the signal is at first `before`."""
    command = [sys.executable, '-c', LOADS + BEFORE.format(before) + code, str(int(number))]
    return subprocess.run(command, cwd=ROOT, capture_output=True, text=True, timeout=60)


@pytest.mark.parametrize('number', SIGNALS)
def test_a_command_that_loads_ends_without_a_traceback(number):
    done = run('interruption.ends_at_once(); os.kill(os.getpid(), int(sys.argv[1]))', number)
    assert (done.returncode, done.stdout, done.stderr) == (-number, '', '')


@pytest.mark.parametrize('number', SIGNALS)
def test_a_command_at_work_tidies_up(number):
    done = run(RAISES, number)
    assert (done.returncode, done.stdout, done.stderr) == (0, 'interrupted\n', '')


@pytest.mark.parametrize('number', SIGNALS)
def test_a_signal_waits_while_python_starts(number):
    done = run(WAITS, number)
    assert (done.returncode, done.stdout, done.stderr) == (-number, 'begins\n', '')


@pytest.mark.parametrize('does', ['raises', 'ends_at_once'])
def test_nohup_counts(does):
    done = run(f'interruption.{does}(); os.kill(os.getpid(), int(sys.argv[1]))', signal.SIGHUP, 'SIG_IGN')
    assert done.returncode == 0, done.stderr


def test_nohup_counts_in_the_command_behind_the_set_up():
    """`nohup ./course grade …` goes on when its terminal is closed."""
    ask = ['./course', 'shell', '--', 'python3', '-c', 'import signal; print(signal.getsignal(signal.SIGHUP).name)']
    done = subprocess.run(
        ['sh', '-c', 'trap "" HUP; exec "$@"', 'sh', *ask], cwd=ROOT, capture_output=True, text=True, timeout=120
    )
    assert done.stdout == 'SIG_IGN\n', done.stderr
