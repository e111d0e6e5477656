"""The tests' process: `python -m helpers.runner.tester FD`, its job as JSON on standard input, its events on FD.

The job may come in two lines: first launcher, domain and limits, with which both sides prepare themselves; the rest
later.

A process of its own, so that neither a learner's kernel nor a grader that runs many submissions shares a participant,
a Python state or a crash with the tests.
"""

import importlib
import json
import os
import sys

from helpers.runner import spent
from helpers.runner.lifetime import die_with_parent, leave


def main() -> int:
    # After a killed grader no process is left that could disturb the next one on the same domain.
    die_with_parent()
    descriptor = int(sys.argv[1])
    os.set_inheritable(descriptor, False)
    job, prepared = json.loads(sys.stdin.readline()), None
    if 'programs' not in job:
        with spent.part('prepared'):
            prepared = _prepare(job, descriptor)
            import pytest  # noqa: F401 - for later
        rest = sys.stdin.read()
        if not rest:  # nobody needs it any more
            prepared[0].close()
            return 0
        job |= json.loads(rest)
    run(job, descriptor, prepared)
    return 0


def run(job: dict, descriptor: int, prepared: tuple | None = None) -> None:
    """Run the tests that `job` names and report to `descriptor`. `prepared`: what `_prepare` has given already."""
    with spent.part('start'):
        server, report = prepared or _prepare(job, descriptor)
    try:
        report({'event': 'sandbox', 'name': server.sandbox})
        only = None if job['only'] is None else set(job['only'])
        with spent.part('pytest'):
            status = _run_tests(job, server, report, only)
        report({'event': 'spent', 'seconds': dict(spent.seconds)})
        report({'event': 'end', 'status': int(status)})
    finally:
        server.close()


def _prepare(job: dict, descriptor: int):
    """Start the learner's side; returns its server, and the function that reports to the session."""
    module, _, name = job['launcher'].partition(':')
    start = getattr(importlib.import_module(module), name)
    from helpers.runner import start_processes

    # The learner's side imports ROS while this side does.
    limits = start_processes.Limits(**job['limits'])
    started = start(job['domain'], limits)
    from helpers.runner import plugin
    from helpers.runner.client import ForkServer

    return ForkServer(started, limits), plugin.reporter(descriptor)


def _run_tests(job: dict, server, report, only: set[str] | None) -> int:
    """Run pytest; returns its status.

    Switched off is what only serves pytest's own report: rewritten assertions, the garbage collection at its end.
    """
    import pytest

    from helpers.runner import plugin

    return pytest.main(
        [
            '-c',
            os.devnull,
            '--rootdir',
            os.getcwd(),
            '--import-mode=importlib',
            '--strict-markers',
            '-q',
            '--continue-on-collection-errors',
            '--assert=plain',
            '-p',
            'no:unraisableexception',
            '-p',
            'no:cacheprovider',
            '--tb=no',
            '--no-header',
            *job['tests'],
        ],
        plugins=[
            plugin.Plugin(
                job['programs'],
                server,
                job['domain'],
                report,
                only,
                job['named'],
                limit=job['limit'],
                seed=job['seed'],
                seeds=job['seeds'],
            )
        ],
    )


if __name__ == '__main__':
    leave(main())
