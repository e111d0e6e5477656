"""Stand-ins for programs that a launch file starts: what they tell, and what is taken from others."""

import json
import socket
import subprocess
import sys
import time
from types import SimpleNamespace

import pytest

from helpers.runner import stand_ins
from helpers.runner.stand_ins import Start

DEEP = b'[' * 100_000


@pytest.fixture
def heard():
    return stand_ins.of(SimpleNamespace(server=SimpleNamespace(workspaces={})))


@pytest.fixture
def started(heard, tmp_path):
    """Starts the stand-in `robot` with these arguments; it is ended after the test."""
    program = tmp_path / 'robot.py'
    program.write_text(f'{heard.text("robot")}\n\nmain()\n')
    running = []

    def start(*arguments: str) -> subprocess.Popen:
        running.append(subprocess.Popen([sys.executable, program, *arguments]))
        return running[-1]

    yield start
    for process in running:
        process.kill()
        process.wait()


def come(heard, *names: str, count: int = 1) -> list[Start]:
    """The starts of these programs, as soon as there are so many."""
    deadline = time.monotonic() + 20.0
    while len(heard.starts(*names)) < count and time.monotonic() < deadline:
        time.sleep(0.01)
    return heard.starts(*names)


def say(heard, line: bytes) -> socket.socket:
    """Connect as a stand-in does, and say this."""
    port = int(heard.text('x').partition("'127.0.0.1', ")[2].partition(')')[0])
    end = socket.create_connection(('127.0.0.1', port))
    end.sendall(line)
    return end


def message(heard, **changed) -> bytes:
    token = heard.text('x').partition("'token': '")[2].partition("'")[0]
    return json.dumps({'token': token, 'name': 'robot', 'arguments': [], 'files': {}, **changed}).encode() + b'\n'


def test_arguments_and_parameter_files_are_told(heard, started, tmp_path):
    given, other = tmp_path / 'values.yaml', tmp_path / 'other.yaml'
    given.write_text('a: 1\n')
    other.write_text('b: 2\n')
    words = '--ros-args', '--params-file', str(given), '-r', '__ns:=/one', '--params-file', '/nowhere.yaml', str(other)
    started(*words)
    (start,) = come(heard, 'robot')
    assert start == Start('robot', words, {str(given): 'a: 1\n'})
    assert heard.starts('world') == []


def test_a_stand_in_runs_until_it_is_released(heard, started):
    process = started()
    assert come(heard, 'robot')
    with pytest.raises(subprocess.TimeoutExpired):
        process.wait(0.3)
    heard.release()
    assert process.wait(10.0) == 0
    assert heard.starts('robot') == []


@pytest.mark.parametrize(
    'changed', [{'token': 'other'}, {'arguments': 'words'}, {'arguments': [1]}, {'files': {'a': '\ud800'}}, {'name': 7}]
)
def test_what_is_no_start_is_left_out(heard, changed):
    with say(heard, message(heard, **changed)), say(heard, message(heard)):
        assert come(heard, 'robot') == [Start('robot', (), {})]


@pytest.mark.parametrize('line', [DEEP + b'\n', b'\xff\n', b'\n', b'x' * (stand_ins.MAX_BYTES + 1)])
def test_what_nobody_can_read_is_left_out(heard, line):
    with say(heard, line), say(heard, message(heard)):
        assert come(heard, 'robot') == [Start('robot', (), {})]


def test_who_says_nothing_is_waited_for_once(heard, monkeypatch):
    monkeypatch.setattr(heard, '_patience', 0.5)
    silent = [say(heard, b'') for _ in range(5)]
    with say(heard, message(heard)):
        begin = time.monotonic()
        assert come(heard, 'robot') == [Start('robot', (), {})]
    assert time.monotonic() - begin < 0.5 + 5 * stand_ins.HURRY + 1.0
    for end in silent:
        end.close()
