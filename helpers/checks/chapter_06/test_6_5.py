"""Visible tests of exercise 6.5, follow, but not blindly."""

import pytest

from helpers.checks.chapter_06.pursuit import Pursuit, zeros
from helpers.runner import expect

pytestmark = pytest.mark.exercise('6.5')


def test_follow(learner):
    """turtle2 comes to turtle1, and stays about 1 m away.

    Every 0.1 s: look up turtle1 in the frame of turtle2, and publish what chase says.
    """
    there = Pursuit(learner)
    there.run(4.0)
    expect(not there.stands or there.distance < 1.6, 'turtle2 stands, far from turtle1.')
    expect(0.7 < there.distance < 1.6, f'After 4 s turtle2 is {there.distance:.1f} m from turtle1, expected about 1 m. '
                                       'It began 4.9 m away.')


def test_unknown(learner):
    """Before any transform has come, the commands are zeros.

    A look-up raises a TransformException: catch it.
    """
    there = Pursuit(learner)
    learner.run(1.0)
    expect(len(there.commands) >= 9, f'No transforms came, and {len(there.commands)} commands in 1 s, expected 10.')
    expect(all(map(zeros, there.commands.messages)), 'No transforms came, and a command drives.')


def test_silence(learner):
    """When turtle1 says no longer where it is, turtle2 stands.

    The stamp of what you looked up says how old it is.
    """
    there = Pursuit(learner)
    there.run(1.0)
    there.run(0.8, names=['turtle2'])
    expect(there.stands, 'turtle1 has said nothing for 0.8 s, and the commands still drive. The newest transform may '
                         'be old: look at its stamp.')
