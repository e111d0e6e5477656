"""The tests of one submission, in the tests' sandbox: a side for `helpers.runner.warm`.

The tests are the grader's own, but they listen to a network on which a learner's program speaks. What it may send can
at worst end this process, which has no privileges, no way out and a bound on its memory; then no mark is given.
"""

import json
import os
import resource
import socket
import sys
from contextlib import suppress
from pathlib import Path

from grading.sandbox import bubblewrap, mounts, namespaces
from grading.sandbox.holder import Holder, SandboxError
from helpers.runner import forked, preloading

MEMORY = 4 * 2**30  # bytes of address space
BUFFER = 212_992  # bytes in each direction of a socket, as other kinds have


def warm_up() -> None:
    """Import what tests need. The server is an ordinary user's, and so is all that it forks."""
    os.umask(0o077)
    preloading.warm_up_for_pytest(preloading.TESTS_SIDE)


def prepare(request: dict) -> None:
    """Nothing: the server knows no submission."""


def run(request: dict, job: int, events: int, printed: int, control: int, life: int) -> None:
    """Run the tests and send their status over the socket `life`. If that one closes, they are killed."""
    os.dup2(printed, 1)
    os.dup2(printed, 2)
    watched = socket.socket(fileno=life)
    try:
        holder = Holder(mounts.tests(map(Path, request['folders'])))
    except SandboxError as error:
        print(f'the sandbox did not start: {error}', flush=True)
        forked.report(watched, 1)
        return
    _bound_sockets(holder.pid)
    namespaces.join(holder.pidfd, namespaces.ALL)
    pid = os.fork()
    if pid == 0:
        _become_tests(request, job, events, control)
    namespaces.give_up_privileges()
    for descriptor in (job, events, control):
        os.close(descriptor)
    status = forked.attend(pid, watched)  # first: a sandbox does not end before all in it are buried
    holder.close()
    forked.report(watched, status)


def _bound_sockets(pid: int) -> None:
    """Have TCP keep to the usual sizes in the network of a process: else a socket gets some tens of megabytes.

    In a container, these settings may be read-only: then they stay as they are. The calling process is in that network
    afterwards, and in the namespace of users that it belongs to.
    """
    network = os.open(f'/proc/{pid}/ns/net', os.O_RDONLY)
    namespaces.join(namespaces.owner(network), namespaces.NEWUSER)
    namespaces.join(network, namespaces.NEWNET)
    with suppress(OSError):
        for name, usual in (('tcp_rmem', 131_072), ('tcp_wmem', 16_384)):
            Path('/proc/sys/net/ipv4', name).write_text(f'4096 {usual} {BUFFER}')


def _become_tests(request: dict, job: int, events: int, control: int) -> None:
    """In the forked child: run the tests. Never returns."""
    code = 1
    try:
        namespaces.give_up_privileges()
        forked.close_all_but([job, events, control])
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
