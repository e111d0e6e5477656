"""Runs an exercise's tests against the learner's program.

The tests and the learner's code live in two processes that meet only over DDS and a JSON channel:

    session   starts both and collects the results (`check`, `./course check`, `./course grade`)
    plugin    the pytest side: the `learner` fixture, verdicts instead of tracebacks
    zygote    the learner's side: forks a worker per program
    launch    how the learner's side is started (the sandbox's place)
"""
from helpers.runner.verdicts import expect

__all__ = ['expect']
