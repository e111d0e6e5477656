"""Cells such as `%%bash` in a real kernel: the stop button ends their programs, and leaves none behind."""

import sys
import time
import uuid

import psutil
import pytest

from helpers.programs import script_cells

pytestmark = pytest.mark.one_of(2)

# In one piece: the stop button is pressed when the word is there, and what follows it might be missing.
READY = "import os, signal, time; os.write(1, b'ready\\n'); "


@pytest.fixture
def course(kernel):
    kernel.ok('import helpers')
    return kernel


@pytest.fixture
def mark():
    """A word for the command lines of a test's programs."""
    return f'mark{uuid.uuid4().hex}'


def python(program: str, mark: str) -> str:
    return f'{sys.executable} -c "{program}" {mark}'


def left(mark: str) -> list[list[str]]:
    found = [process.info for process in psutil.process_iter(['cmdline', 'status'])]
    return [info['cmdline'] for info in found if mark in (info['cmdline'] or []) and info['status'] != 'zombie']


@pytest.mark.parametrize(
    'lines',
    ['{sleeps}', '{sleeps} &\n{sleeps} > /dev/null &\nwait', '({sleeps} | cat)', 'trap "" TERM\n{sleeps}'],
    ids=['alone', 'background', 'pipe', 'deaf shell'],
)
def test_the_stop_button_ends_all_programs_at_once(course, mark, lines):
    sleeps = python(READY + 'time.sleep(600)', mark)
    begin = time.monotonic()
    result = course.run(f'%%bash\n{lines.format(sleeps=sleeps)}\necho went on', interrupt_at='ready')
    assert result.error == 'KeyboardInterrupt'
    assert 'ready' in result.stdout and 'went on' not in result.stdout
    assert 'was killed' not in result.stderr
    assert not left(mark)
    assert time.monotonic() - begin < 60  # on a busy machine, too
    assert course.run('%%bash\necho again').stdout == 'again\n'


def test_a_program_has_time_for_its_end(course, mark):
    tidies = f"""
import os, time
try: {READY} time.sleep(600)
except KeyboardInterrupt: time.sleep(1); print('tidied up')"""
    result = course.run(f'%%bash\n{python(tidies, mark)}\necho went on', interrupt_at='ready')
    assert result.error == 'KeyboardInterrupt'
    assert result.stdout.split() == ['ready', 'tidied', 'up']
    assert not left(mark)


@pytest.mark.parametrize('magic', ['bash', 'sh', 'script bash'])
def test_a_program_that_ignores_every_request_is_killed(course, mark, magic):
    deaf = (
        'import signal; '
        + ''.join(f'signal.signal(signal.{name}, signal.SIG_IGN); ' for name in ('SIGINT', 'SIGTERM'))
        + READY
    )
    begin = time.monotonic()
    result = course.run(f'%%{magic}\n{python(deaf + "time.sleep(600)", mark)}', interrupt_at='ready')
    assert result.error == 'KeyboardInterrupt'
    assert time.monotonic() - begin >= script_cells.PATIENCE
    assert result.stdout == 'ready\n' and 'was killed' in result.stderr
    assert not left(mark)


def test_an_interpreter_itself(course, mark):
    text = f"import os, time\ntry:\n    os.write(1, b'ready\\n')\n    time.sleep(600)\nfinally:\n    print('{mark}')"
    result = course.run(f'%%script {sys.executable} - {mark}\n{text}', interrupt_at='ready')
    assert result.error == 'KeyboardInterrupt' and result.stdout.split() == ['ready', mark]
    assert not left(mark)


def test_without_the_stop_button_all_is_as_in_ipython(course):
    result = course.run('%%bash\necho ä; echo wrong >&2; printf no-end')
    assert (result.stdout, result.stderr, result.error) == ('ä\nno-end', 'wrong\n', '')
    result = course.run('%%bash\nexit 3')
    assert result.error == 'CalledProcessError' and 'status 3' in result.message
    assert not course.run('%%bash --no-raise-error\nexit 3').error
    course.ok('%%bash --out told --err complained\necho one\necho two >&2')
    assert course.value('told, complained') == ('one\n', 'two\n')
    assert "Couldn't find program: 'nobody'" in course.run('%%script nobody\nx').stdout
    assert course.run('%%bash\nread line\nthis is data\necho "$line"').stdout == 'this is data\n'
    long = '#' * 200_000
    assert course.run(f'%%bash\n: {long}\necho end').stdout == 'end\n'
    course.ok('%%bash --bg --out later\necho later')
    assert course.run('%%bash\nhead -c 300000 /dev/zero | tr "\\0" x').stdout == 'x' * 300_000
