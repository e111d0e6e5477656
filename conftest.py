"""Keeps what pytest starts apart on the wire: a ROS domain for each process, and one for each test that asks."""

import os
from contextlib import ExitStack

import pytest

from helpers import domains

_held = ExitStack()


def pytest_configure(config):
    """Give this process, and all that it starts, its own domain. Each worker of xdist comes through here."""
    os.environ['ROS_DOMAIN_ID'] = str(_held.enter_context(domains.claim()))


def pytest_unconfigure(config):
    """Give the domain back."""
    _held.close()


@pytest.fixture
def domain(monkeypatch):
    """A ROS domain id that nothing else uses, also set in the environment."""
    with domains.claim() as domain_id:
        monkeypatch.setenv('ROS_DOMAIN_ID', str(domain_id))
        yield domain_id
