"""The processor time of what runs in a place: by it, a build that waits for ever is told from one that is late."""

import pytest

from grading import sandbox
from helpers.runner import session
from helpers.tests import small

TESTS = '''
SPIN = "import time\\nwhile time.process_time() < 1.5: pass\\ntime.sleep(60)"


def test_a_command_that_computes(learner):
    """What its children have used counts, too."""
    place = learner.workspace({'note.txt': 'x'})
    task = place.start('sh', '-c', f'python3 -c "{SPIN}" & wait')
    expect(learner.wait_until(lambda: learner.server.used(place.name) > 1.4, 60), 'It is not seen.')
    task.end()
    expect(learner.server.used(place.name) < 0.2, 'It is still there.')


def test_a_command_that_waits(learner):
    """It opens a pipe of its own."""
    place = learner.workspace({'note.txt': 'y'})
    task = place.start('sh', '-c', 'mkfifo pipe; cat pipe')
    expect(task.wait(2.0) is None, 'It has ended.')
    expect(learner.server.used(place.name) < 1.0, f'{learner.server.used(place.name)} s.')
    expect(learner.server.used('elsewhere') == 0, 'A place where nothing is.')
'''


@pytest.mark.timeout(180)
def test_what_is_used_is_known(tmp_path):
    report = session.run(
        small.cells(small.TALKER),
        [small.exercise()],
        session.Options(visible=small.write_tests(tmp_path, TESTS), launcher=sandbox.launcher('bubblewrap')),
    )
    assert report.exercises[0].passed, (report.exercises[0].tests, report.log)
