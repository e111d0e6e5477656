"""Runs an exercise's tests against the learner's program.

The tests and the learner's code live in two processes that meet only over DDS and a JSON channel:

    session            starts both and collects the results (`check`, `./course check`, `./course grade`)
    tester, plugin     the tests' process: pytest, with the `learner` fixture, verdicts instead of tracebacks
    fork_server        the learner's side: forks a worker per program
    worker             a process with the learner's program
    start_processes    how both sides are started; a sandbox has its own way
"""

from helpers.runner.verdicts import about, broken, expect, waiting

__all__ = ['about', 'broken', 'expect', 'waiting']
