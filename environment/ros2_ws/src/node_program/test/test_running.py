"""Programs made with `run` and `ros`, run as processes: how they end, and what they say then."""

import os
import signal
import sys

import pytest

from environment.tests.running import PATIENCE, ended

PROGRAM = """
import sys
import rclpy
from node_program.running import CannotStart, ros, run
from rclpy.node import Node

class Speaker(Node):
    def __init__(self):
        super().__init__('speaker')
        self.declare_parameter('rate', 1.0)
        self.create_timer(0.01, self.speak)

    def speak(self):
        print('spoken', flush=True)
        if 'an_error' in sys.argv:
            raise ValueError('a fault of the program')

class Silent(Node):
    def __init__(self):
        super().__init__('silent')
        self.get_logger().fatal('nothing to say')
        raise CannotStart('nothing to say')

if 'silent' in sys.argv:
    run(Silent)
elif 'words' in sys.argv:
    with ros() as (words, executor):
        print(words)
else:
    run(Speaker)
"""


@pytest.fixture
def begin(start, tmp_path):
    """Start the program with the words of a command line."""
    (tmp_path / 'speaker.py').write_text(PROGRAM)
    return lambda *words: start(sys.executable, str(tmp_path / 'speaker.py'), *words)


@pytest.mark.parametrize('number', [signal.SIGINT, signal.SIGTERM])
def test_a_signal_ends_it_quietly(begin, number):
    process = begin()
    process.wait_for_output('spoken', timeout=PATIENCE)
    os.kill(process.pid, number)
    status, output = ended(process)
    assert status == 0 and set(output.split()) == {'spoken'}


@pytest.mark.parametrize(
    ('words', 'says'),
    [
        (['--help'], "speaker.py: found unknown ROS arguments: ['--help']"),
        (['-r', 'a'], "speaker.py: Couldn't parse remap rule: '-r a'."),
        (['-p', 'rate:=a: b: c'], 'speaker.py: the value of -p rate:=… is not YAML'),
        (['-p', 'rate:=true'], "speaker.py: Trying to set parameter 'rate' to 'True' of type 'BOOL'"),
    ],
)
def test_what_cannot_be_used_is_told_in_one_line(begin, words, says):
    status, output = ended(begin('--ros-args', *words))
    assert status == 1 and output.splitlines()[-1].startswith(says) and 'Traceback' not in output
    assert '.c:' not in output.splitlines()[-1]


def test_a_node_that_cannot_start_has_said_why(begin):
    status, output = ended(begin('silent'))
    assert status == 1 and output.count('nothing to say') == 1 and 'Traceback' not in output


def test_a_fault_of_the_program_keeps_its_traceback(begin):
    status, output = ended(begin('an_error'))
    assert status == 1 and output.rstrip().endswith('ValueError: a fault of the program') and 'Traceback' in output


def test_the_words_are_those_that_are_not_for_ros(begin):
    assert ended(begin('words', 'a', '--ros-args', '-r', 'b:=c', '--', 'd')) == (0, "['words', 'a', 'd']")


def test_a_reader_that_has_had_enough_ends_it_quietly(begin, tmp_path, start):
    begin()  # the file is written with it
    line = f'{sys.executable} {tmp_path / "speaker.py"} | head -n 2'
    assert ended(start('bash', '-o', 'pipefail', '-c', line)) == (0, 'spoken\nspoken')
