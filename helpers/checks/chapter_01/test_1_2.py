"""Visible tests of exercise 1.2, read an environment."""

import pytest

from helpers.runner import expect

pytestmark = pytest.mark.exercise('1.2')

GOOD = {'AMENT_PREFIX_PATH': '/opt/ros/jazzy', 'ROS_DISTRO': 'jazzy',
        'PYTHONPATH': '/opt/ros/jazzy/lib/python3.12/site-packages'}


def ask(learner, environ, wanted):
    got = learner.call('diagnose', environ)
    expect(got == wanted, f'{environ} gives {got!r}, expected {wanted!r}.')


def test_nothing_is_wrong(learner):
    """An environment with a sourced Jazzy has no fault: the dictionary is empty.

    A variable that is missing is no fault, but for AMENT_PREFIX_PATH.
    """
    ask(learner, GOOD, {})


def test_unsourced_and_a_bad_domain(learner):
    """{'ROS_DOMAIN_ID': 'seven'} has two faults, and both are named.

    Do not stop at the first fault.
    """
    ask(learner, {'ROS_DOMAIN_ID': 'seven'}, {'AMENT_PREFIX_PATH': 'not sourced', 'ROS_DOMAIN_ID': 'not a domain'})


def test_two_distributions(learner):
    """Humble and Jazzy in one AMENT_PREFIX_PATH are mixed.

    Split the path at the colons, and look which folders begin with /opt/ros/.
    """
    ask(learner, {**GOOD, 'AMENT_PREFIX_PATH': '/opt/ros/jazzy:/opt/ros/humble'}, {'AMENT_PREFIX_PATH': 'mixed'})


def test_discovery_is_off(learner):
    """ROS_AUTOMATIC_DISCOVERY_RANGE=OFF is named 'off'.

    With OFF, nodes do not find each other even on one machine.
    """
    ask(learner, {**GOOD, 'ROS_AUTOMATIC_DISCOVERY_RANGE': 'OFF'}, {'ROS_AUTOMATIC_DISCOVERY_RANGE': 'off'})
