"""Keeps what pytest starts apart on the wire: a ROS domain for each process, and one for each test that asks.

It also chooses what runs: everything with COURSE_ALL_TESTS=1 in the environment, else a sample of what costs much. The
sample is drawn anew for each run; its seed is printed, and COURSE_SAMPLE=SEED draws the same again. A test that is
named, as in `pytest FILE::TEST`, runs, and so does one that has failed, with `pytest --last-failed`.
"""

import faulthandler
import os
import secrets
import zlib
from collections import Counter
from contextlib import ExitStack
from importlib.util import find_spec
from pathlib import Path

import pytest

from helpers.kernel import domains

_held = ExitStack()
_stderr = pytest.StashKey[int]()  # pytest's own stderr, while a test's goes to a file
_longest = pytest.StashKey[float]()  # seconds that a test may take
ROOT = Path(__file__).resolve().parent
ROS_PACKAGES = ROOT / 'environment' / 'ros2_ws' / 'src'
PACKAGES = sorted(folder.name for folder in ROS_PACKAGES.iterdir()) if ROS_PACKAGES.is_dir() else []


def pytest_configure(config):
    """Give this process, and all that it starts, its own domain. Each worker of xdist comes through here."""
    os.environ['COURSE_SAMPLE'] = os.environ.get('COURSE_SAMPLE') or secrets.token_hex(4)  # xdist's workers inherit it
    os.environ['ROS_DOMAIN_ID'] = str(_held.enter_context(domains.claim()))
    config.stash[_stderr] = os.dup(2)
    notebooks = config.getoption('nbval', False) or config.getoption('nbval_lax', False)
    if notebooks and find_spec('grading'):  # the learner's edition has no stored outputs to compare with
        config.pluginmanager.import_plugin('grading.authoring.nbval_plugin')


def pytest_report_header():
    """Say what is drawn."""
    if os.environ.get('COURSE_ALL_TESTS'):
        return 'everything runs (COURSE_ALL_TESTS)'
    seed = os.environ['COURSE_SAMPLE']
    return f'a sample runs: COURSE_SAMPLE={seed} draws it again, COURSE_ALL_TESTS=1 runs everything'


def pytest_ignore_collect(collection_path, config):
    """Do not even read the tests of ROS packages that are not drawn; None leaves the others to pytest.

    Nor the tests in a workspace that the cells of a notebook have made beside it, unless somebody names it: who runs
    the notebooks once more with `pytest --nbval solutions` means the notebooks.
    """
    if collection_path.parent == ROS_PACKAGES and _left_out(collection_path.name, config):
        return True
    made = collection_path.parent in (ROOT / 'notebooks', ROOT / 'solutions') and collection_path.is_dir()
    return True if made and not _named(collection_path, config) else None


def _named(folder, config):
    """Whether pytest was asked for something in this folder."""
    places = [(config.invocation_params.dir / argument.partition('::')[0]).resolve() for argument in config.args]
    return any(place.is_relative_to(folder) for place in places)


def pytest_collection_modifyitems(config, items):
    """Leave out what is sampled; with several workers, bring the rest into an order that keeps all of them busy."""
    again = config.getoption('lf', False) and config.cache.get('cache/lastfailed', None)
    named = any('::' in argument for argument in config.args)
    if not (os.environ.get('COURSE_ALL_TESTS') or again or named):
        _sample(config, items)
    if hasattr(config, 'workerinput'):
        # What takes long first, lest it be still running when all else is done; then, as xdist does, large modules.
        # xdist itself would start modules with few tests last: it has to be told --no-loadscope-reorder.
        sizes = Counter(_scope(item) for item in items)
        items.sort(key=lambda item: (item.get_closest_marker('early') is None, -sizes[_scope(item)]))


def _scope(item):
    return item.nodeid.rpartition('::')[0]


@pytest.hookimpl(optionalhook=True)
def pytest_xdist_make_scheduler(config, log):
    """Give the tests of a module to one worker, but each of those that stand for themselves and take long to any."""
    from xdist.scheduler import LoadScopeScheduling

    class Scheduling(LoadScopeScheduling):
        def _split_scope(self, nodeid):
            return nodeid if 'test_validity.py' in nodeid else super()._split_scope(nodeid)

        def remove_node(self, node):
            """Take the tests of a process that has ended back, but not the one it ended in: xdist runs it again."""
            units = self.assigned_work.pop(node)
            left = [(unit, test) for unit in units.values() for test, done in unit.items() if not done]
            if not left:
                return None
            unit, crashed = left[0]
            unit[crashed] = True
            self.workqueue.update({scope: unit for scope, unit in units.items() if not all(unit.values())})
            for other in self.assigned_work:
                self._reschedule(other)
            return crashed

    return Scheduling(config, log) if config.getvalue('dist') == 'loadscope' else None


def _sample(config, items):
    """Leave out what costs much and seldom finds more than the rest: a part of each sample, as the seed draws it."""
    seen, left_out = Counter(), []
    for item in items:
        sample = item.get_closest_marker('one_of')
        name = item.nodeid.partition('[')[0]
        if item.get_closest_marker('thorough'):
            left_out.append(item)
        elif sample and 'group' in sample.kwargs:
            drawn = _drawn(sample.kwargs.get('of', _module(item)), sample.kwargs['group'], sample.args[0])
            left_out += [] if drawn else [item]
        elif sample:
            left_out += [] if _drawn(name, seen[name], sample.args[0]) else [item]
        seen[name] += 1
    config.hook.pytest_deselected(items=left_out)
    kept = set(items) - set(left_out)
    items[:] = [item for item in items if item in kept]


def _left_out(package, config):
    """Whether the tests of this ROS package wait for another run: few changes reach all of these packages."""
    if os.environ.get('COURSE_ALL_TESTS') or package not in PACKAGES:
        return False
    whole = set(config.args) == set(config.getini('testpaths'))  # nobody has named what to run
    return whole and not _drawn('packages', PACKAGES.index(package), 12)


def _drawn(name, index, count):
    """Whether the seed draws number ``index`` of what is called ``name``: one of ``count`` that follow each other."""
    return (zlib.crc32(f'{os.environ["COURSE_SAMPLE"]} {name}'.encode()) + index) % count == 0


def _module(item):
    return item.nodeid.partition('::')[0]


@pytest.hookimpl(optionalhook=True, tryfirst=True)
def pytest_timeout_set_timer(item, settings):
    """End a test also where no signal does: in C++ code that waits for ever, or in its clean-up.

    Its process prints where each thread stands, and ends. xdist reports the test as failed and starts a new process.
    """
    item.stash[_longest] = 2 * settings.timeout
    _end_later(item)


@pytest.hookimpl(tryfirst=True)
def pytest_runtest_teardown(item):
    """The same for the clean-up: after a failure pytest has given up all timers, for a debugger's sake."""
    _end_later(item)


def _end_later(item):
    if _longest in item.stash:
        faulthandler.dump_traceback_later(item.stash[_longest], exit=True, file=item.config.stash[_stderr])


@pytest.hookimpl(wrapper=True, tryfirst=True)
def pytest_runtest_protocol():
    """The test has ended, and its fixtures."""
    try:
        return (yield)
    finally:
        faulthandler.cancel_dump_traceback_later()


def pytest_unconfigure(config):
    """Give the domain back."""
    _held.close()
    os.close(config.stash[_stderr])


@pytest.fixture
def domain(monkeypatch):
    """A ROS domain id that nothing else uses, also set in the environment."""
    with domains.claim() as domain_id:
        monkeypatch.setenv('ROS_DOMAIN_ID', str(domain_id))
        yield domain_id
