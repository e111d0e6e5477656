"""Fixtures for tests of the kernel helpers; the root conftest.py gives each test its ROS domain."""

import pytest

from helpers.tests.real_kernel import Kernel


@pytest.fixture
def ros(domain):
    """ROS, started; stopped after the test, with whatever the test left."""
    from helpers import ros

    ros.start()
    yield ros
    ros.stop()


@pytest.fixture
def kernel(domain, tmp_path):
    """A real IPython kernel in a process of its own."""
    with Kernel(tmp_path) as started:
        yield started
