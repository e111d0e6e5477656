"""Hidden tests of exercise 7.4, a program that stands still. All stacks are drawn, or taken from a drawn program."""

import pytest

from helpers.checks.chapter_07 import stacks
from helpers.checks.chapter_07.findings import compare
from helpers.checks.chapter_07.test_7_4 import test_interrupt  # noqa: F401 - they draw other inputs here
from helpers.programs import faults
from helpers.runner import about

pytestmark = pytest.mark.exercise('7.4')


def check(learner, *states, rule, times=6):
    for _ in range(times):
        with about(rule):
            stacks.diagnose(learner, *states, rule=rule)


@pytest.mark.given
@pytest.mark.rules('healthy', 'own-call')
def test_healthy_threads(learner):
    """Threads that spin, are idle, or wait for an answer outside of a callback, are healthy.

    Only what stands in a callback stops others; a wait for a server is the exception.
    """
    check(learner, 'idle', 'spinning', rule='healthy')
    check(learner, 'waits in main', rule='healthy')
    for _ in range(2):
        with about('healthy'):
            stacks.diagnose(learner, 'at work', rule='healthy', plain=True)
    check(learner, 'at work', rule='healthy')
    check(learner, 'serving', rule='healthy', times=2)
    stacks.judge_task(learner)


@pytest.mark.rules('server', 'call', 'spin', 'busy', 'own-call', 'all')
@pytest.mark.weight(2)
@pytest.mark.parametrize('cause', stacks.CAUSES)
def test_one_thread(learner, cause):
    """A thread that stands still is found, with the function and the source line of its own call.

    The newest of the program's calls counts, and rclpy has files called client.py and executors.py, too.
    """
    for _ in range(3):
        with about(cause):
            stacks.diagnose(learner, cause, plain=True)
    for state in [state for state, of in stacks.OTHERS if of == cause]:
        for _ in range(stacks.OFTEN):
            with about(cause):
                stacks.diagnose(learner, state, plain=True)
    if cause == 'busy':
        stacks.judge_others(learner)
    check(learner, cause, rule='own-call')
    check(learner, cause, 'idle', 'spinning', rule='all')


@pytest.mark.rules('all')
def test_several_threads(learner):
    """Each thread is judged by itself.

    A MultiThreadedExecutor can hang in several callbacks.
    """
    check(learner, 'idle', *learner.random.sample(stacks.CAUSES, 3), 'spinning', rule='all')
    check(learner, 'idle', 'spinning', *learner.random.sample(stacks.CAUSES, 2), rule='all', times=2)
    check(learner, learner.random.choice(stacks.CAUSES), 'same', 'same', 'spinning', rule='all', times=2)


@pytest.mark.rules('call', 'busy')
@pytest.mark.weight(2)
@pytest.mark.parametrize('kind', ['call', 'loop'])
def test_real_program(learner, kind):
    """The stacks of a program that hangs now tell the same.

    It is one of those that `faults.stage('hang')` stages.
    """
    fault = faults.plan('hang', learner.random.getrandbits(32), kind)
    (truth,) = fault.diagnosis
    program, line = truth.where, truth.evidence
    files = {name: text for name, text in fault.files.items() if name.endswith('.py')}
    text = stacks.take(learner, files, program, line, newer='call' if kind == 'call' else '')
    expected = (truth.fault, 'on_timer', truth.cause, line)
    compare(learner.call('diagnose_stacks', text, files), [expected], stacks.WHY, given=text)


@pytest.mark.rules('answer')
@pytest.mark.weight(2)
def test_answer(learner):
    """If the server answers, the client prints the answer and ends with status 0.

    The client's node must be spun to get it.
    """
    stacks.judge_answer(learner, 'hidden')


@pytest.mark.rules('no-answer')
@pytest.mark.weight(2)
def test_silent_server(learner):
    """If the server is there and never answers, the client prints so and ends with status 1.

    Every wait has a timeout, also the one for the answer.
    """
    stacks.judge_no_answer(learner, 'hidden')


@pytest.mark.rules('no-server')
def test_no_server(learner):
    """Without a server, the client prints so after its time and ends with status 1.

    wait_for_service(timeout_sec=…) returns False if there is none.
    """
    stacks.judge_no_server(learner, 'hidden')
