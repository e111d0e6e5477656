"""How many programs run in a place, as is seen from outside: nothing that they print, or keep to themselves, counts."""

import pytest

from grading import sandbox
from helpers.runner import session
from helpers.tests import small

TESTS = '''
import pytest

DAEMON = "import os, time\\nif os.fork(): os._exit(0)\\nos.setsid()\\ntime.sleep(60)"
LEFT = "import os, time\\nif os.fork() == 0:\\n    os.setsid()\\n    time.sleep(60)"


@pytest.mark.parametrize(('script', 'wanted'), [
    ('exec sleep 60', 0),  # the task itself
    ('sleep 60 & sleep 60 & wait', 2),
    ('sh -c "sleep 60; true" & wait', 1),  # a shell that waits is one program with what it has started
    (f'python3 -c "{DAEMON}"; sleep 60 & wait', 2),
    (f'python3 -c "{DAEMON}" & sleep 60; true', 2),
])
def test_they_are_counted(learner, script, wanted):
    """Also those that belong to nobody any more."""
    place = learner.workspace({'note.txt': 'x'})
    task = place.start('sh', '-c', script)
    expect(learner.wait_until(lambda: task.programs == wanted, 30), f'{task.programs} programs.')
    task.end()
    expect(task.programs == 0, f'{task.programs} programs after the end.')


def test_what_is_left_behind(learner):
    """The task has ended, and what it has started goes on."""
    place = learner.workspace({'note.txt': 'x'})
    task = place.start('python3', '-c', LEFT)
    expect(task.wait(30.0) == 0, 'It has not ended.')
    expect(task.programs == 1, f'{task.programs} programs.')
    expect(learner.server.programs('elsewhere') == 0, 'A place where nothing is.')
'''


@pytest.mark.timeout(240)
def test_what_runs_is_counted(tmp_path):
    report = session.run(
        small.cells(small.TALKER),
        [small.exercise()],
        session.Options(visible=small.write_tests(tmp_path, TESTS), launcher=sandbox.launcher('bubblewrap')),
    )
    assert report.exercises[0].passed, (report.exercises[0].tests, report.log)
