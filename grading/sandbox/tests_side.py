"""The tests of one submission, in the tests' sandbox.

The tests are the grader's own, but they listen to a network on which a learner's program speaks. What it may send can
at worst end this process, which has no privileges, no way out and a bound on its memory; then no mark is given.
"""

import contextlib
import importlib
import json
import os
import resource
import select
import signal
import socket
import sys
from pathlib import Path

from grading.sandbox import bubblewrap, layout, namespaces
from grading.sandbox.holder import Holder, SandboxError

MEMORY = 4 * 2**30  # bytes of address space


def warm_up() -> None:
    """Import what tests need."""
    from _pytest import config

    for name in config.default_plugins:
        importlib.import_module(f'_pytest.{name}')
    import helpers.runner.client
    import helpers.runner.plugin
    import helpers.runner.tester  # noqa: F401


def run(request: dict, job: int, events: int, printed: int, control: int, life: int) -> None:
    """Run the tests and send their status over the socket `life`. If that one closes, they are killed."""
    os.dup2(printed, 1)
    os.dup2(printed, 2)
    watched = socket.socket(fileno=life)
    try:
        holder = Holder(layout.tests(map(Path, request['folders'])))
    except SandboxError as error:
        print(f'the sandbox did not start: {error}', flush=True)
        watched.send(b'1')
        return
    namespaces.join(holder.pidfd, namespaces.ALL)
    pid = os.fork()
    if pid == 0:
        _become_tests(request, job, events, control)
    namespaces.give_up_privileges()
    for descriptor in (job, events, control):
        os.close(descriptor)
    ended = os.pidfd_open(pid)
    sources: list[socket.socket | int] = [ended, watched]
    ready, _, _ = select.select(sources, [], [])
    if ended not in ready:
        os.kill(pid, signal.SIGKILL)
    _, status = os.waitpid(pid, 0)  # first: a sandbox does not end before all in it are buried
    holder.close()
    with contextlib.suppress(OSError):  # nobody may be there any more
        watched.send(str(os.waitstatus_to_exitcode(status)).encode())


def _become_tests(request: dict, job: int, events: int, control: int) -> None:
    """In the forked child: run the tests. Never returns."""
    code = 1
    try:
        namespaces.give_up_privileges()
        namespaces.close_all_but([job, events, control])
        os.chdir('/tmp')
        resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
        os.environ |= {'ROS_DOMAIN_ID': str(request['domain']), 'PYTEST_DISABLE_PLUGIN_AUTOLOAD': '1'}
        bubblewrap.control = socket.socket(fileno=control)
        from helpers.kernel import domains
        from helpers.runner import tester

        domains.hold(request['domain'])  # no test may take it for a domain of its own
        with open(job) as file:
            file.seek(0)
            tester.run(json.load(file), events)
        code = 0
    except BaseException:  # noqa: BLE001 - the child must not return
        import traceback

        traceback.print_exc()
    finally:
        sys.stdout.flush()
        sys.stderr.flush()
        os._exit(code)
