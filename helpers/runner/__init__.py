"""Runs an exercise's tests against the learner's program.

The tests and the learner's code live in two processes that meet only over DDS and a JSON channel:

    session            starts both, or several pairs, and collects the results (`check`, `./course check`, `grade`)
    tester, plugin     the tests' process: pytest, with the `learner` fixture, verdicts instead of tracebacks
    fork_server        the learner's side: forks a worker per program
    worker             a process with the learner's program
    start_processes    bounds and environment of both sides; a sandbox has a launcher of its own
    warm, servers      the servers that both sides are forked from, and their client (`tests_process`)
    plain_tests, plain_programs    what these servers fork where there is no sandbox
"""

from helpers.runner.verdicts import about, broken, expect, waiting

__all__ = ['about', 'broken', 'expect', 'waiting']
