"""Keeps what pytest starts apart on the wire: a ROS domain for each process, and one for each test that asks.

It also chooses what runs: everything with COURSE_ALL_TESTS=1 in the environment, else a sample of what costs much. The
sample is drawn anew for each run; its seed is printed, and COURSE_SAMPLE=SEED draws the same again.
"""

import os
import secrets
import zlib
from collections import Counter
from contextlib import ExitStack

import pytest

from helpers.kernel import domains

_held = ExitStack()


def pytest_configure(config):
    """Give this process, and all that it starts, its own domain. Each worker of xdist comes through here."""
    os.environ['COURSE_SAMPLE'] = os.environ.get('COURSE_SAMPLE') or secrets.token_hex(4)  # xdist's workers inherit it
    os.environ['ROS_DOMAIN_ID'] = str(_held.enter_context(domains.claim()))


def pytest_report_header():
    """Say what is drawn."""
    if os.environ.get('COURSE_ALL_TESTS'):
        return 'everything runs (COURSE_ALL_TESTS)'
    seed = os.environ['COURSE_SAMPLE']
    return f'a sample runs: COURSE_SAMPLE={seed} draws it again, COURSE_ALL_TESTS=1 runs everything'


def pytest_collection_modifyitems(config, items):
    """Leave out what is sampled; with several workers, bring the rest into an order that keeps all of them busy."""
    if not os.environ.get('COURSE_ALL_TESTS'):
        _sample(config, items)
    if hasattr(config, 'workerinput'):
        # What takes long first, lest it be still running when all else is done; then, as xdist does, large modules.
        # xdist itself would start modules with few tests last: it has to be told --no-loadscope-reorder.
        sizes = Counter(_scope(item) for item in items)
        items.sort(key=lambda item: (item.get_closest_marker('early') is None, -sizes[_scope(item)]))


def _scope(item):
    return item.nodeid.rpartition('::')[0]


def _sample(config, items):
    """Leave out what costs much and seldom finds more than the rest."""
    seen, left_out = Counter(), []
    for item in items:
        sample = item.get_closest_marker('one_of')
        name = item.nodeid.partition('[')[0]
        first = zlib.crc32(f'{os.environ["COURSE_SAMPLE"]} {name}'.encode())
        if item.get_closest_marker('thorough') or sample and (first + seen[name]) % sample.args[0]:
            left_out.append(item)
        seen[name] += 1
    config.hook.pytest_deselected(items=left_out)
    items[:] = [item for item in items if item not in set(left_out)]


def pytest_unconfigure(config):
    """Give the domain back."""
    _held.close()


@pytest.fixture
def domain(monkeypatch):
    """A ROS domain id that nothing else uses, also set in the environment."""
    with domains.claim() as domain_id:
        monkeypatch.setenv('ROS_DOMAIN_ID', str(domain_id))
        yield domain_id
