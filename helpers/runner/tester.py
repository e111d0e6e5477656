"""The tests' process: `python -m helpers.runner.tester FD`, its job as JSON on standard input, its events on FD.

A process of its own, so that neither a learner's kernel nor a grader that runs many submissions shares a participant,
a Python state or a crash with the tests.
"""
import importlib
import json
import os
import sys

from helpers.runner.lifetime import die_with_parent


def main() -> int:
    # A grader that is killed leaves nobody behind who could disturb the next one on the same domain.
    die_with_parent()
    descriptor = int(sys.argv[1])
    os.set_inheritable(descriptor, False)
    run(json.load(sys.stdin), descriptor)
    return 0


def run(job: dict, descriptor: int) -> None:
    """Run the tests that `job` names and report to `descriptor`."""
    module, _, name = job['launcher'].partition(':')
    start = getattr(importlib.import_module(module), name)
    from helpers.runner import launch
    # The learner's side imports ROS while this side does.
    limits = launch.Limits(**job['limits'])
    started = start(job['domain'], limits)
    import pytest

    from helpers.runner import plugin
    from helpers.runner.client import ForkServer
    report = plugin.reporter(descriptor)
    server = ForkServer(started, limits)
    try:
        report({'event': 'sandbox', 'name': server.sandbox})
        only = None if job['only'] is None else set(job['only'])
        status = pytest.main(
            ['-c', os.devnull, '--rootdir', os.getcwd(), '--import-mode=importlib', '--strict-markers', '-q',
             '--continue-on-collection-errors',
             '-p', 'no:cacheprovider', '--tb=no', '--no-header', *job['tests']],
            plugins=[plugin.Plugin(job['programs'], server, job['domain'], report, only, seed=job['seed'])])
        report({'event': 'end', 'status': int(status)})
    finally:
        server.close()


if __name__ == '__main__':
    sys.exit(main())
