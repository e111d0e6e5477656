"""Runs the tests of some exercises against the learner's programs and collects the results.

`check` in a notebook, `./course check`, `submit` and `grade` all come through `run`; grading adds the hidden tests.
"""
import importlib
import json
import os
import select
import subprocess
import tempfile
import time
from collections import Counter
from collections.abc import Callable, Iterable, Mapping
from concurrent.futures import ThreadPoolExecutor
from dataclasses import asdict, dataclass, field, replace
from pathlib import Path

from helpers import domains
from helpers.exercises import manifest, notebooks, program
from helpers.exercises.manifest import Exercise
from helpers.runner import launch, results, seeds, verdicts
from helpers.runner.results import ExerciseResult, TestResult
from helpers.runner.text import LEFT_OUT, MAX_OUTPUT, clean

VISIBLE = Path(__file__).resolve().parents[1] / 'checks'
TEST_TIMEOUT = 120.0  # seconds of wall time for one test; its own waits are shorter
START_TIMEOUT = 60.0  # seconds until the tests are collected


@dataclass(frozen=True)
class Options:
    """How a session runs. `hidden` is the folder of hidden tests, if these are to run."""

    hidden: Path | None = None
    visible: Path = VISIBLE
    launcher: str = 'helpers.runner.launch:start'
    limits: launch.Limits = launch.LIMITS
    test_timeout: float = TEST_TIMEOUT
    retries: int = 1  # how often a test with a grader's fault runs again
    processes: int = 1  # among how many processes of tests the exercises are shared out
    seed: str = ''  # what the tests draw is derived from it; a fresh one if empty
    tests: Mapping[str, Iterable[str]] = field(default_factory=dict)  # exercise -> names of the tests to run; else all


@dataclass
class Report:
    """What a session found: a result per exercise, and the sandbox in which the learner's code ran."""

    exercises: list[ExerciseResult]
    sandbox: str = ''
    log: list[str] = field(default_factory=list)  # for the instructor
    seed: str = ''  # the session's: with it the tests draw the same inputs again
    spent: Counter[str] = field(default_factory=Counter, compare=False)  # seconds by part, see `helpers.runner.spent`


def run(cells: list[notebooks.Cell], exercises: Iterable[Exercise], options: Options | None = None,
        say: Callable[[str], None] = lambda text: None) -> Report:
    """Judge `exercises` with the learner's code cells (in their order). `say` is told of each test that has finished.

    Never raises for anything in the learner's code; a fault of the runner's own is a grader_error in the results.
    """
    options = options or Options()
    options = replace(options, seed=options.seed or seeds.fresh())
    exercises = list(exercises)
    judged: dict[str, ExerciseResult] = {}
    programs: dict[str, dict] = {}
    for exercise in exercises:
        try:
            programs[exercise.id] = program.build(cells, exercise).as_dict()
        except program.NotAttempted as reason:
            judged[exercise.id] = results.without_tests(exercise, results.NOT_ATTEMPTED, clean(reason))
        except program.InvalidExercise as reason:
            judged[exercise.id] = results.without_tests(exercise, verdicts.INVALID_SUBMISSION, clean(reason))
    running = [exercise for exercise in exercises if exercise.id in programs]
    shares = [share for share in (running[k::options.processes] for k in range(options.processes)) if share]

    def collect(share: list[Exercise]) -> _Collection:
        collection = _Collection(options)
        chapters = sorted({exercise.chapter for exercise in share})
        folders = [folder / f'chapter_{chapter:02}' for folder in (options.visible, options.hidden) if folder
                   for chapter in chapters]
        collection.run({exercise.id: programs[exercise.id] for exercise in share},
                       [folder for folder in folders if folder.is_dir()], say)
        return collection

    if len(shares) <= 1:  # in the caller's thread, so that the stop button ends it at once
        collections = [collect(share) for share in shares]
    else:
        with ThreadPoolExecutor(len(shares)) as pool:
            collections = list(pool.map(collect, shares))
    for share, collection in zip(shares, collections, strict=True):
        for exercise in share:
            judged[exercise.id] = results.judge(exercise, collection.of(exercise.id))
    return Report([judged[exercise.id] for exercise in exercises],
                  next((collection.sandbox for collection in collections), ''),
                  [line for collection in collections for line in collection.log], options.seed,
                  sum((collection.spent for collection in collections), Counter()))


class _Collection:
    """The tests of one session and what became of them."""

    def __init__(self, options: Options):
        self.options = options
        self.tests: dict[str, TestResult] = {}
        self.sandbox = ''
        self.log: list[str] = []
        self.spent: Counter[str] = Counter()
        self._begun: Counter[str] = Counter()  # how often each test was begun
        self._doubled: set[str] = set()

    def of(self, exercise: str) -> list[TestResult]:
        """The results of one exercise's tests."""
        return [test for test in self.tests.values() if test.exercise == exercise]

    def run(self, programs: dict[str, dict], folders: list[Path], say) -> None:
        """Run all tests; those that a dying process left behind, or that met a grader's fault, run again."""
        only, idle = None, 0
        while idle <= self.options.retries:
            wanted, before = only, self._begun.copy()
            self._round(programs, folders, only, say)
            only = [name for name, test in self.tests.items() if test.verdict == verdicts.GRADER_ERROR
                    and name not in self._doubled and self._begun[name] <= self.options.retries]
            if self.tests and not only:
                break
            # Only what was asked for counts: so each test is progress a bounded number of times.
            progress = any(count > before[name] for name, count in self._begun.items()
                           if wanted is None or name in wanted)
            idle = 0 if progress else idle + 1
        if self.options.hidden is not None:
            for exercise in programs:
                if not any(test.hidden for test in self.of(exercise)):
                    self._owe(exercise, 'hidden tests', 'there are no hidden tests')

    def _round(self, programs: dict[str, dict], folders: list[Path], only: list[str] | None, say) -> None:
        """One process of tests, to its end."""
        seen: set[str] = set()
        judged: set[str] = set()
        running, begun = '', 0.0
        with (domains.claim() as domain, tempfile.TemporaryDirectory(prefix='course-tests-') as cwd,
              open(Path(cwd, 'printed'), 'w+b') as printed):
            process, events = self._start(programs, folders, only, domain, cwd, printed)
            try:
                for event in _events(process, events, self.options.test_timeout):
                    match event['event']:
                        case 'collected':
                            self._collected(event, seen)
                        case 'running':
                            running = event['test']
                            self._begun[running] += 1
                            begun = time.monotonic()
                        case 'result' if event['test'] in judged:
                            self._owe(self.tests[event['test']].exercise, event['test'], 'it has two results')
                        case 'result' if event['test'] == running and running in self.tests:
                            judged.add(running)
                            self._result(event, time.monotonic() - begun)
                            say(running)
                        case 'broken':
                            self._broken(event, programs)
                        case 'sandbox':
                            self.sandbox = event['name']
                        case 'spent':
                            self.spent.update(event['seconds'])
                        case 'timeout':
                            self.log.append(f"no progress in {running or 'the start of the tests'}")
                        case 'garbled':
                            self.log.append(f"the tests' process sent what is no event after {running or 'its start'}")
            finally:
                process.kill()
                status = process.wait()
                os.close(events)
                printed.seek(0)
                text = printed.read(100_000).decode(errors='replace')[-4000:]
        for name in seen:
            if self.tests[name].fault:
                self.log.append(f'{name}: {self.tests[name].fault}')
        if status != 0 or not seen:
            self.log.append(f"the tests' process ended with status {status}: {text}")

    def _start(self, programs, folders, only, domain: int, cwd: str, printed):
        read, write = os.pipe()
        job = {'programs': programs, 'tests': list(map(str, folders)), 'domain': domain, 'only': only,
               'named': {exercise: list(names) for exercise, names in self.options.tests.items()},
               'launcher': self.options.launcher, 'limits': asdict(self.options.limits), 'seed': self.options.seed}
        environment = {**{k: v for k, v in os.environ.items() if not k.startswith(('PYTEST_', 'COV_'))},
                       **launch.ros_environment(domain), 'PYTEST_DISABLE_PLUGIN_AUTOLOAD': '1',
                       'ROS_LOG_DIR': cwd, 'PYTHONPATH': os.pathsep.join(
                           filter(None, [str(launch.ROOT), os.environ.get('PYTHONPATH')]))}
        with open(Path(cwd, 'job.json'), 'w+') as file:
            json.dump(job, file)
            file.seek(0)
            starter = importlib.import_module(self.options.launcher.partition(':')[0])
            process = getattr(starter, 'start_tests', launch.start_tests)(
                file, write, printed, cwd=cwd, environment=environment,
                folders=[folder for folder in (self.options.visible, self.options.hidden) if folder])
        os.close(write)
        return process, read

    def _collected(self, event: dict, seen: set[str]) -> None:
        name = event['test']
        if name in seen:
            self._doubled.add(name)
            self._owe(event['exercise'], name, 'two tests have this name')
        seen.add(name)
        if name not in self.tests:
            hidden = self.options.hidden is not None and Path(event['path']).is_relative_to(self.options.hidden)
            # Until a result says otherwise, the grader owes one.
            self.tests[name] = TestResult(name, event['exercise'], hidden, event['weight'], verdicts.GRADER_ERROR,
                                          event['expected'])

    def _result(self, event: dict, seconds: float) -> None:
        test = self.tests[event['test']]
        test.seconds = round(seconds, 3)
        if test.test not in self._doubled:
            test.verdict = event['verdict'] if event['verdict'] in verdicts.VERDICTS else verdicts.GRADER_ERROR
            test.message, test.details = clean(event['message']), clean(event['details'], MAX_OUTPUT)
            test.output, test.fault = clean(event['output'], MAX_OUTPUT), event['fault']
            if test.output.endswith(' …'):
                test.output = f'{test.output[:-2]}\n{LEFT_OUT}'

    def _broken(self, event: dict, programs: dict[str, dict]) -> None:
        """A test file that cannot be read: by its name, test_3_1.py, it belongs to one exercise; else to all."""
        tested = manifest.tested_in(Path(event['where'].partition('::')[0]).name)
        for exercise in programs:
            if tested in (None, exercise):
                self._owe(exercise, event['where'], event['text'])

    def _owe(self, exercise: str, name: str, fault: str) -> None:
        """Note a fault of the grader's: no score for this exercise."""
        self.tests[name] = TestResult(name, exercise, True, 1.0, verdicts.GRADER_ERROR, fault=fault)
        self._doubled.add(name)
        self.log.append(f'exercise {exercise}: {name}: {fault}')


# What each kind of event must have.
_FIELDS = {'collected': {'test': str, 'exercise': str, 'weight': (int, float), 'path': str, 'expected': str},
           'running': {'test': str}, 'broken': {'where': str, 'text': str}, 'sandbox': {'name': str},
           'spent': {'seconds': dict},
           'result': {'test': str, 'verdict': str, 'message': str, 'details': str, 'output': str, 'fault': str}}


def _event(line: bytes) -> dict | None:
    """An event of the tests' process; None if it is none."""
    try:
        event = json.loads(line)
        fields = _FIELDS.get(event['event'], {})
    except (ValueError, KeyError, TypeError, RecursionError):
        return None
    return event if all(isinstance(event.get(key), kind) for key, kind in fields.items()) else None


def _events(process: subprocess.Popen, descriptor: int, test_timeout: float):
    """The events of the tests' process; `timeout` and the end if none came in time.

    That is START_TIMEOUT for the first test to begin, then `test_timeout`.
    """
    buffer, limit = b'', START_TIMEOUT
    while True:
        deadline = time.monotonic() + limit
        while b'\n' not in buffer:
            if not select.select([descriptor], [], [], max(0.0, deadline - time.monotonic()))[0]:
                yield {'event': 'timeout'}
                return
            chunk = os.read(descriptor, 65536)
            if not chunk:
                return
            buffer += chunk
        line, _, buffer = buffer.partition(b'\n')
        event = _event(line)
        if event is None:
            yield {'event': 'garbled'}
            return
        if event['event'] == 'running':
            limit = test_timeout
        yield event
        if event['event'] == 'end':
            try:
                process.wait(timeout=10)
            except subprocess.TimeoutExpired:
                yield {'event': 'timeout'}
            return
