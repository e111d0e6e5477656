"""The tests' side without a sandbox, for `helpers.runner.warm`: a process of tests for each session."""

import json
import os
import socket

from helpers.runner import forked, preloading, start_processes, tester
from helpers.runner.lifetime import die_with_parent, leave


def warm_up() -> None:
    """Import what tests need."""
    preloading.warm_up_for_pytest(preloading.TESTS_SIDE)


def prepare(request: dict) -> None:
    """Nothing: which modules tests need, they know."""


def run(request: dict, job: int, events: int, printed: int, control: int, life: int) -> None:
    """Run the tests in a child and send its status over the socket `life`. If that one closes, it is killed.

    The request has `cwd` and `environment`.
    """
    pid = os.fork()
    if pid == 0:
        _become_tests(request, job, events, printed, control)
    forked.close_all_but([life])
    watched = socket.socket(fileno=life)
    forked.report(watched, forked.attend(pid, watched))


def _become_tests(request: dict, job: int, events: int, printed: int, control: int) -> None:
    """In the forked child: run the tests. Never returns."""
    code = 1
    try:
        die_with_parent()
        forked.stand_alone(printed, [job, events, control])
        forked.move(request['cwd'], request['environment'])
        start_processes.control = socket.socket(fileno=control)
        with open(job) as file:
            file.seek(0)
            given = json.load(file)
        start_processes.home = given['home']
        tester.run(given, events)
        code = 0
    except BaseException:  # noqa: BLE001 - the child must not return
        import traceback

        traceback.print_exc()
    finally:
        leave(code)
