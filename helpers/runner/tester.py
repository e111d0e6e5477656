"""What the tests' process does: its job comes as a dictionary, its events go to a file descriptor.

It is a process of its own, so that neither a learner's kernel nor a grader that runs many submissions shares a
participant, a Python state or a crash with the tests.
"""

import importlib
import os

from helpers.runner import spent


def run(job: dict, descriptor: int) -> None:
    """Run the tests that `job` names and report to `descriptor`."""
    os.environ['ROS_DOMAIN_ID'] = str(job['domain'])
    with spent.part('start'):
        server, report = _prepare(job, descriptor)
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

    limits = start_processes.Limits(**job['limits'])
    started = start(job['domain'], limits)
    from helpers.runner import plugin
    from helpers.runner.fork_client import ForkServer

    return ForkServer(started, limits), plugin.reporter(descriptor)


def arguments(places: list[str]) -> list[str]:
    """pytest's arguments for the tests in these folders and files.

    Switched off is what only serves pytest's own report: rewritten assertions, the garbage collection at its end; and
    each conftest.py, which is for the course's own tests. Without `--confcutdir` pytest would list the files of each
    folder above the tests, up to the root of the disk: one of them may not be readable, or hold very many files.
    """
    folders = [place if os.path.isdir(place) else os.path.dirname(place) for place in places]
    return [
        '-c',
        os.devnull,
        '--rootdir',
        os.getcwd(),
        *(['--confcutdir', folders[0]] if folders else []),
        '--import-mode=importlib',
        '--strict-markers',
        '-q',
        '--continue-on-collection-errors',
        '--assert=plain',
        '--noconftest',
        '-p',
        'no:unraisableexception',
        '-p',
        'no:cacheprovider',
        '--tb=no',
        '--no-header',
        *places,
    ]


def _run_tests(job: dict, server, report, only: set[str] | None) -> int:
    """Run pytest; returns its status."""
    import pytest

    from helpers.runner import plugin

    return pytest.main(
        arguments(job['tests']),
        plugins=[
            plugin.Plugin(
                job['programs'],
                server,
                job['domain'],
                report,
                only,
                job['named'],
                limit=job['limit'],
                share=tuple(job['share']),
                seed=job['seed'],
                seeds=job['seeds'],
            )
        ],
    )
