"""Limits that are hit, what is left behind, and submissions side by side."""

import contextlib
import secrets
import signal
import subprocess
import sys
import threading
import time

import psutil
import pytest

from grading import sandbox
from helpers import paths
from helpers.runner import session, start_processes, tests_process
from helpers.tests import small

LAUNCHER = sandbox.launcher('bubblewrap')

BOMBS = """
import os


def memory():
    held = []
    for _ in range(100):
        held.append(bytearray(b'x') * 2**24)


def family():
    for _ in range(8):
        if os.fork() == 0:
            held = bytearray(b'x') * 100 * 2**20
            time.sleep(100)
    time.sleep(100)


def forks():
    count = 0
    with contextlib.suppress(OSError):
        while os.fork():
            count += 1
        else:
            time.sleep(100)
    return count


def disk():
    written = []
    for place in ('/tmp', '/dev/shm', os.path.expanduser('~')):
        with contextlib.suppress(OSError):
            for number in range(100):
                with open(f'{place}/{number}', 'wb', buffering=0) as file:
                    file.write(b'x' * 2**20)
        written.append(sum(os.stat(f'{place}/{name}').st_size >> 20 for name in os.listdir(place) if name.isdigit()))
        for name in os.listdir(place):
            if name.isdigit():
                os.remove(f'{place}/{name}')
    return written


def inodes():
    number = 0
    with contextlib.suppress(OSError):
        for number in range(100_000):
            os.symlink('x', f'/tmp/{number}')
    for made in range(number):
        os.remove(f'/tmp/{made}')
    return number


def files():
    held = []
    with contextlib.suppress(OSError):
        while True:
            held.append(open('/dev/null'))
    return len(held)


def all_die():
    for pid in (-1, 1):  # all others; the sandbox's first process
        with contextlib.suppress(ProcessLookupError):
            os.kill(pid, signal.SIGKILL)
    os.kill(os.getpid(), signal.SIGKILL)


def fine():
    return sorted(entry for entry in os.listdir('/proc') if entry.isdigit())
"""
# What is under test is which bound ends a program: the one on time must not come first on a slow machine.
TESTS = '''
from helpers.runner import plugin
from helpers.runner.timeouts import Timeouts
plugin.TIMEOUTS = Timeouts(call=60.0)
pytestmark = [pytestmark, pytest.mark.limits(
    memory=900 * 2**20, total_memory=600 * 2**20, processes=64, tmp=4 * 2**20, home=5 * 2**20, shared=3 * 2**20)]


def test_memory(learner):
    """The bound of one process."""
    learner.call('memory')


def test_family(learner):
    """The bound of all processes."""
    learner.call('family')


def test_forks(learner):
    """Processes."""
    expect(20 < learner.call('forks') < 64, 'not bounded')


def test_disk(learner):
    """Places."""
    written = learner.call('disk')
    expect(written == [4, 3, 5], f'{written}')


def test_inodes(learner):
    """Names."""
    expect(10_000 < learner.call('inodes') <= 20_000, 'not bounded')


def test_files(learner):
    """Open files."""
    expect(200 < learner.call('files') < 256, 'not bounded')


def test_kill(learner):
    """It can only kill itself."""
    learner.call('all_die')


def test_last(learner):
    """Nothing of the others is left: the sandbox's first process and this one."""
    expect(len(learner.call('fine')) == 2, f"{learner.call('fine')}")
'''


@pytest.fixture(scope='module')
def folder(tmp_path_factory):
    """Where the tests are: one place for all, so that the warm servers, which are for a place, are started once."""
    return tmp_path_factory.mktemp('course')


def run(folder, program, test, number=1, names=('Talker',), **options):
    checks = small.write_tests(folder, test, number)
    return session.run(
        small.cells(program, number),
        [small.exercise(number, names)],
        session.Options(visible=checks, launcher=LAUNCHER, **options),
    )


def left(cookie: str) -> list[str]:
    """The processes of this machine that have `cookie` in their command."""
    found = []
    for process in psutil.process_iter():
        with contextlib.suppress(psutil.Error):
            if cookie in process.cmdline():
                found.append(str(process))
    return found


def gone(cookie: str) -> bool:
    """Whether they end within 30 s."""
    deadline = time.monotonic() + 30
    while left(cookie) and time.monotonic() < deadline:
        time.sleep(0.05)
    return not left(cookie)


@pytest.mark.timeout(300)
def test_each_bound_has_its_verdict(folder):
    report = run(folder, 'import contextlib\nimport signal\nimport time\n' + BOMBS, TESTS, names=('fine',))
    tests = {test.test.partition('::test_')[2]: test for test in report.exercises[0].tests}
    assert {name: test.verdict for name, test in tests.items()} == {
        'memory': 'learner_crashed',
        'family': 'learner_crashed',
        'forks': 'passed',
        'disk': 'passed',
        'inodes': 'passed',
        'files': 'passed',
        'kill': 'learner_crashed',
        'last': 'passed',
    }, (tests, report.log)
    assert 'MemoryError' in tests['memory'].message or 'more memory than it may' in tests['memory'].message
    assert 'more memory than it may' in tests['family'].message
    assert 'SIGKILL' in tests['kill'].message


DAEMON = '''
import os
import subprocess


def Talker():
    """Start a process that has left its group and its parent, and hears no signal."""
    if os.fork() == 0:
        os.setsid()
        for number in range(1, 32):
            with contextlib.suppress(OSError, ValueError):
                signal.signal(number, signal.SIG_IGN)
        os.execv('/bin/sleep', ['{cookie}', '1000'])
    while not any('{cookie}' in open(f'/proc/{{pid}}/cmdline').read() for pid in os.listdir('/proc') if pid.isdigit()):
        pass
    return 1
'''


def daemon(cookie):
    return 'import contextlib\nimport signal\n' + DAEMON.format(cookie=cookie)


def test_nothing_outlives_the_session(folder):
    cookie = f'sleep-{secrets.token_hex(8)}'
    report = run(
        folder,
        daemon(cookie),
        '''
def test_daemon(learner):
    """It starts one."""
    expect(learner.call('Talker') == 1, 'no')
''',
    )
    assert report.exercises[0].passed, (report.exercises[0].tests, report.log)
    assert not left(cookie)


@pytest.mark.timeout(180)
def test_nothing_outlives_a_grader_that_is_killed(tmp_path):
    cookie = f'sleep-{secrets.token_hex(8)}'
    (tmp_path / 'grader.py').write_text(f"""\
from pathlib import Path
from grading.tests.sandbox import test_bounds
test_bounds.run(Path({str(tmp_path)!r}), test_bounds.daemon({cookie!r}), '''
def test_daemon(learner):
    \"\"\"It starts one, and then nothing happens.\"\"\"
    learner.call('Talker')
    time.sleep(1000)
''')
""")
    grader = subprocess.Popen([sys.executable, str(tmp_path / 'grader.py')], cwd=paths.ROOT)
    try:
        deadline = time.monotonic() + 120  # for all that a grader starts
        while not left(cookie):
            assert time.monotonic() < deadline and grader.poll() is None
            time.sleep(0.05)
    finally:
        grader.kill()
        grader.wait()
    assert gone(cookie)


def test_tests_that_are_killed_are_a_fault_of_the_grader(folder):
    cookie = f'sleep-{secrets.token_hex(8)}'
    report = run(
        folder,
        daemon(cookie),
        '''
def test_daemon(learner):
    """The tests die: a learner may have done it, over the network that they share."""
    learner.call('Talker')
    os.kill(os.getpid(), 9)
''',
        retries=0,
    )
    assert (report.exercises[0].verdict, report.exercises[0].score) == ('grader_error', None)
    assert '-9' in report.log[-1] and gone(cookie)


TALKER = """\
class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        self.publisher = self.create_publisher(String, 'chatter', 10)
        self.create_timer(0.1, lambda: self.publisher.publish(String(data='{name}')))
"""
LISTENER = """
def test_alone(learner):
    \"\"\"It hears its own talker only, while the other one's speaks.\"\"\"
    heard = learner.listen('/chatter', String)
    learner.start('Talker')
    for _ in range(10):
        learner.run(0.5)
        time.sleep(0.1)
    expect(set(heard.data) == {'%s'} and len(heard) == 50, f'{heard.data}')
"""


def test_submissions_on_one_domain_do_not_hear_each_other(folder, monkeypatch):
    @contextlib.contextmanager
    def claim():
        yield 7

    monkeypatch.setattr(tests_process.domains, 'claim', claim)
    reports = {}

    def one(number, name):
        reports[name] = run(folder, TALKER.format(name=name), LISTENER % name, number)

    threads = [threading.Thread(target=one, args=pair) for pair in enumerate(('ada', 'bob'), 1)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    for report in reports.values():
        assert report.exercises[0].passed, (report.exercises[0].tests, report.log)


def test_limits_come_from_the_test(folder):
    """A test's own limits hold for it only; the others have the session's."""
    report = run(
        folder,
        """
import os
import resource


def Talker():
    place = os.statvfs('/tmp')
    return [resource.getrlimit(resource.RLIMIT_CPU)[0], place.f_blocks * place.f_frsize]
""",
        '''
@pytest.mark.limits(cpu=7, tmp=2**24)
def test_own(learner):
    """Own."""
    expect(learner.call('Talker') == [7, 2**24], f"{learner.call('Talker')}")


def test_usual(learner):
    """The session's."""
    expect(learner.call('Talker') == [9, 2**23], f"{learner.call('Talker')}")
''',
        limits=start_processes.Limits(cpu=9, tmp=2**23),
    )
    assert report.exercises[0].passed, (report.exercises[0].tests, report.log)


@pytest.mark.parametrize('number', [signal.SIGTERM, signal.SIGINT])
def test_a_program_that_is_stopped_by_a_signal(folder, number):
    report = run(
        folder,
        f'import os\ndef Talker():\n    os.kill(os.getpid(), {int(number)})\n    return 1\n',
        '''
def test_signal(learner):
    """SIGINT is ignored, SIGTERM ends it."""
    learner.call('Talker')
''',
    )
    verdict = 'passed' if number == signal.SIGINT else 'learner_crashed'
    assert report.exercises[0].verdict == verdict, report.exercises[0].tests
