"""Runs the tests of some exercises against the learner's programs and collects the results.

`check` in a notebook, `./course check`, `submit` and `grade` all come through `run`; grading adds the hidden tests.
"""

import json
import math
import os
import re
import select
import subprocess
import time
from collections import Counter, defaultdict
from collections.abc import Callable, Iterable, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field, replace
from itertools import zip_longest
from pathlib import Path

from helpers.exercises import manifest, notebooks, package_answers, program
from helpers.exercises.manifest import Exercise
from helpers.runner import results, seeds, start_processes, stopping, tests_process, verdicts
from helpers.runner.forked import Forked
from helpers.runner.results import ExerciseResult, TestResult
from helpers.runner.text import LEFT_OUT, MAX_OUTPUT, clean

VISIBLE = Path(__file__).resolve().parents[1] / 'checks'
TEST_TIMEOUT = 120.0  # seconds of wall time for one test; its own waits are shorter
BUSY = 4  # so many times as long the tests' process may be silent: on a busy machine a test has more time
SIDE_BY_SIDE = min(2, os.cpu_count() or 1)  # among so many processes a check shares out its tests
_WAITING = 1  # processes more than are asked for: tests often wait, for programs in real time and for each other
_LONG = (2, 7, 8)  # chapters whose exercises build packages and launch systems
TOTAL_TIMEOUT = 1800.0  # seconds of wall time for all tests of a session
START_TIMEOUT = 60.0  # seconds until the tests are collected


@dataclass(frozen=True)
class Options:
    """How a session runs. `hidden` is the folder of the exercises' folders, if their hidden tests are to run."""

    hidden: Path | None = None
    visible: Path = VISIBLE
    launcher: str = tests_process.PLAIN
    limits: start_processes.Limits = start_processes.LIMITS
    test_timeout: float = TEST_TIMEOUT
    total_timeout: float = TOTAL_TIMEOUT
    retries: int = 1  # how often a test runs again after an error of the grader's
    processes: int = 1  # among how many processes of tests the exercises are shared out; several get _WAITING more
    side_by_side: int = 1  # among how many the tests of an exercise that is alone, so that its learner waits less
    seed: str = ''  # what the tests draw is derived from it; a fresh one if empty
    seeds: Mapping[str, str] = field(default_factory=dict)  # exercise -> a seed of its own
    notebook: Sequence[notebooks.NotebookCell] = ()  # all cells, where only those that were run are judged
    folder: Path | None = None  # of the notebooks, where answers that are packages are; else they are in cells
    tests: Mapping[str, Iterable[str]] = field(default_factory=dict)  # exercise -> names of the tests to run; else all
    reference: Callable[[Exercise], dict | None] | None = None  # gives a program that is right, for `compare`


@dataclass
class SessionReport:
    """What a session found: a result per exercise, and the sandbox in which the learner's code ran."""

    exercises: list[ExerciseResult]
    sandbox: str = ''
    log: list[str] = field(default_factory=list)  # for the instructor
    seed: str = ''  # the session's: with it the tests draw the same inputs again
    spent: Counter[str] = field(default_factory=Counter, compare=False)  # seconds by part, see `helpers.runner.spent`
    seeds: dict[str, str] = field(default_factory=dict)  # by exercise: with it the tests draw the same inputs again


def run(
    cells: list[notebooks.NotebookCell],
    exercises: Iterable[Exercise],
    options: Options | None = None,
    say: Callable[[str], None] = lambda text: None,
) -> SessionReport:
    """Test `exercises` with the learner's code cells (in their order). `say` is told of each test that has finished.

    Never raises for anything in the learner's code; an error of the runner's own is a grader_error in the results.
    """
    options = options or Options()
    programs: dict[str, dict] = {}
    without: dict[str, tuple[str, str]] = {}
    exercises = list(exercises)
    for exercise in exercises:
        try:
            if exercise.folder and options.folder is not None:
                programs[exercise.id] = package_answers.of_folder(exercise, options.folder).as_dict()
            else:
                programs[exercise.id] = program.build(cells, exercise, options.notebook).as_dict()
        except program.NotAttempted as reason:
            without[exercise.id] = results.NOT_ATTEMPTED, str(reason)
        except program.InvalidExercise as reason:
            without[exercise.id] = verdicts.INVALID_SUBMISSION, str(reason)
    return judge(programs, without, exercises, options, say)


def judge(
    programs: dict[str, dict],
    without: Mapping[str, tuple[str, str]],
    exercises: Iterable[Exercise],
    options: Options | None = None,
    say: Callable[[str], None] = lambda text: None,
) -> SessionReport:
    """Judge `exercises`, whose programs are read already.

    :param programs: by exercise, what the learner's process loads (`helpers.exercises.program`).
    :param without: by exercise, why there is no program: a verdict, and a message for the learner.
    :raises stopping.Stopped: another thread has stopped it.
    """
    options = options or Options()
    options = replace(options, seed=options.seed or seeds.fresh())
    exercises = list(exercises)
    judged = {
        exercise.id: results.without_tests(exercise, without[exercise.id][0], clean(without[exercise.id][1]))
        for exercise in exercises
        if exercise.id not in programs
    }
    running = [exercise for exercise in exercises if exercise.id in programs]
    lanes = options.processes + _WAITING if options.processes > 1 else 1
    shares = _parts(running[0], options) if len(running) == 1 else _shares(running, lanes)
    deadline = time.monotonic() + options.total_timeout
    stop = stopping.Stop()

    def collect(share: _Share) -> _Collection:
        collection = _Collection(options, stop, deadline, share)
        places = [options.visible / f'chapter_{chapter:02}' for chapter in share.chapters]
        if options.hidden:
            places += [manifest.hidden_tests(options.hidden, exercise.id) for exercise in share.exercises]
        collection.run(
            {exercise.id: programs[exercise.id] for exercise in share.exercises},
            places := [place for place in places if place.exists()],
            say,
        )
        if options.reference is not None:
            for exercise in share.exercises:
                collection.compare(exercise, programs[exercise.id], options.reference, places, say)
        return collection

    collections = _side_by_side(collect, shares, lanes if len(running) > 1 else len(shares), stop)
    for exercise in running:
        mine = [one for one in collections if exercise in one.share.exercises]
        judged[exercise.id] = _result(exercise, mine, programs[exercise.id].get('notes', ()))
    return SessionReport(
        [judged[exercise.id] for exercise in exercises],
        next((collection.sandbox for collection in collections), ''),
        [line for collection in collections for line in collection.log],
        options.seed,
        sum((collection.spent for collection in collections), Counter()),
        {exercise.id: options.seeds.get(exercise.id, options.seed) for exercise in exercises},
    )


def _side_by_side(
    collect: 'Callable[[_Share], _Collection]', shares: 'list[_Share]', lanes: int, stop: stopping.Stop
) -> 'list[_Collection]':
    """What `collect` returns for each share, as many at a time as there are lanes."""
    with stop:
        if len(shares) <= 1:  # in the caller's thread, so that the stop button ends it at once
            return [collect(share) for share in shares]
        with ThreadPoolExecutor(lanes) as pool:
            try:
                return list(pool.map(collect, shares))
            except BaseException:  # Ctrl+C: the pool waits for its threads
                stop.now()
                raise


def _result(exercise: Exercise, collections: 'list[_Collection]', notes: Iterable[str]) -> ExerciseResult:
    """What the tests of an exercise have found, with the notes on how its program was read."""
    unseen = {rule: why for one in collections for rule, why in one.unseen[exercise.id].items()}
    found = results.scored(exercise, _in_order([one.of(exercise.id) for one in collections]), unseen)
    found.message = clean('\n'.join([*filter(None, [found.message]), *notes]))
    return found


@dataclass(frozen=True)
class _Share:
    """What one process of tests judges: these exercises, and of their tests each `every`th one from `first` on."""

    exercises: list[Exercise]
    first: int = 0
    every: int = 1

    @property
    def chapters(self) -> list[int]:
        return sorted({exercise.chapter for exercise in self.exercises})


def _shares(exercises: list[Exercise], lanes: int) -> list[_Share]:
    """The exercises by processes of tests: all together, or in parts of a chapter for so many lanes side by side.

    What builds and launches comes first, each exercise by itself, the longest ones of chapter 8 before the others: so
    no long part is left for the end.
    """
    if lanes <= 1 or len(exercises) <= lanes:
        parts = (exercises[k :: max(1, lanes)] for k in range(max(1, lanes)))
        return [_Share(part) for part in parts if part]
    long: list[_Share] = []
    shares: list[_Share] = []
    for chapter in dict.fromkeys(exercise.chapter for exercise in exercises):
        mine = [exercise for exercise in exercises if exercise.chapter == chapter]
        if chapter in _LONG:
            long += [_Share([exercise]) for exercise in mine]
        else:
            shares += [_Share(part) for part in (mine[k::lanes] for k in range(lanes)) if part]
    return long[::-1] + shares


def _parts(exercise: Exercise, options: Options) -> list[_Share]:
    """The tests of one exercise, shared out: none of the parts may be without a test.

    All together stay those of an answer that is a file or a package: what one test has built, the next one uses.
    """
    count = options.side_by_side
    if options.hidden or exercise.folder or any(name.isupper() for name in exercise.names):
        count = 1
    if count > 1:
        file = manifest.visible_tests(options.visible, exercise.id)
        text = file.read_text(encoding='utf-8') if file.is_file() else ''
        tests = len(re.findall('^def test_', text, re.MULTILINE))
        # One more than there should be rather than one that begins its second test when the others have ended.
        count = max(1, tests if tests <= count + 1 else count)
    return [_Share([exercise], first, count) for first in range(count)]


def _in_order(parts: list[list[TestResult]]) -> list[TestResult]:
    """Results of tests that were shared out one after the other, as they stand in their file."""
    found = {test.test: test for row in zip_longest(*parts) for test in row if test is not None}
    return list(found.values())  # a file that cannot be read is a fault in each part


class _Collection:
    """The tests of one session and what became of them."""

    def __init__(self, options: Options, stop: stopping.Stop, deadline: float, share: _Share):
        """`deadline`: until when its tests may run, by the monotonic clock."""
        self.options, self._stop, self._deadline, self.share = options, stop, deadline, share
        self.tests: dict[str, TestResult] = {}
        self.sandbox = ''
        self.log: list[str] = []
        self.spent: Counter[str] = Counter()
        self.unseen: dict[str, dict[str, str]] = defaultdict(dict)  # exercise -> rule -> why no test looks at it
        self._begun: Counter[str] = Counter()  # how often each test was begun
        self._doubled: set[str] = set()

    def of(self, exercise: str) -> list[TestResult]:
        """The results of one exercise's tests."""
        return [test for test in self.tests.values() if test.exercise == exercise]

    def run(self, programs: dict[str, dict], places: list[Path], say) -> None:
        """Run all tests; those that a dying process left behind, or that met an error of the grader's, run again."""
        only, idle = None, 0
        while idle <= self.options.retries:
            wanted, before = only, self._begun.copy()
            self._round(programs, places, [] if self._late() else only, say)
            if self._late():
                self._give_up()
                break
            only = [
                name
                for name, test in self.tests.items()
                if test.verdict == verdicts.GRADER_ERROR
                and name not in self._doubled
                and self._begun[name] <= self.options.retries
            ]
            if self.tests and not only:
                break
            if not self.tests:  # a process died before it had collected them: all are asked for again
                only = None
            # Only tests that were asked for count: each is begun a bounded number of times, so this loop ends.
            progress = any(
                count > before[name] for name, count in self._begun.items() if wanted is None or name in wanted
            )
            idle = 0 if progress else idle + 1
        if self.options.hidden is not None:
            for exercise in programs:
                if not any(test.hidden for test in self.of(exercise)):
                    self._owe(exercise, 'hidden tests', 'there are no hidden tests')

    def compare(
        self,
        exercise: Exercise,
        program: dict,
        reference: Callable[[Exercise], dict | None],
        places: list[Path],
        say: Callable[[str], None],
    ) -> None:
        """Find out who makes the faults that leave tests of an exercise open: the grader, or the learner's program.

        Each of these tests runs with a program that is right, in the same circumstances. If that one passes, the
        learner's runs once more. Who then meets a fault again, makes it, and the test is not passed.
        """
        faulty = [
            test
            for test in self.of(exercise.id)
            if test.verdict == verdicts.GRADER_ERROR and test.test not in self._doubled and self._begun[test.test]
        ]
        right = reference(exercise) if faulty and not self._late() else None
        if right is not None:
            for test in faulty:
                self._blame(test, exercise.id, program, right, places, say)
        if self._late():
            self._give_up()

    def _blame(
        self,
        test: TestResult,
        exercise: str,
        program: dict,
        right: dict,
        places: list[Path],
        say: Callable[[str], None],
    ) -> None:
        other = _Collection(self.options, self._stop, self._deadline, self.share)
        other._round({exercise: right}, places, [test.test], lambda name: None)
        if test.test in other.tests and other.tests[test.test].passed:
            self._round({exercise: program}, places, [test.test], say)
            if test.verdict == verdicts.GRADER_ERROR:
                test.verdict, test.message = verdicts.FAILED, _BREAKS_TESTS
                self.log.append(f'{test.test}: closed: only with this program the test does not come to its end')

    def _late(self) -> bool:
        return time.monotonic() > self._deadline

    def _give_up(self) -> None:
        """What has not run when the time for all tests is over will not run."""
        for test in self.tests.values():
            if test.verdict == verdicts.GRADER_ERROR and test.test not in self._doubled:
                test.verdict, test.fault = verdicts.TIMEOUT, ''
                test.message = (
                    f'The tests of all your programs together took longer than '
                    f'{self.options.total_timeout / 60:g} minutes. This one did not run any more.'
                )

    def _round(self, programs: dict[str, dict], places: list[Path], only: list[str] | None, say) -> None:
        """One process of tests, to its end."""
        seen: set[str] = set()
        judged: set[str] = set()
        running, begun = '', 0.0
        folders = [folder for folder in (self.options.visible, self.options.hidden) if folder]
        with (
            tests_process.running(
                self._job(programs, places, only), self.options.launcher, self.options.limits, folders
            ) as tests,
            self._stop.watching(tests.process.kill),
        ):
            try:
                for event in _events(tests.process, tests.events, self.options.test_timeout, self._deadline):
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
                            self.log.append(f'no progress in {running or "the start of the tests"}')
                        case 'garbled':
                            self.log.append(f"the tests' process sent what is no event after {running or 'its start'}")
            finally:
                status, text = tests.end()
        for name in seen:
            if self.tests[name].fault:
                self.log.append(f'{name}: {self.tests[name].fault}')
        if status != 0 or not seen:
            self.log.append(f"the tests' process ended with status {status}: {text}")

    def _job(self, programs: dict[str, dict], places: list[Path], only: list[str] | None) -> dict:
        """What the tests' process is to do (see `helpers.runner.tester`)."""
        return {
            'programs': programs,
            'tests': list(map(str, places)),
            'only': only,
            'seed': self.options.seed,
            'named': {exercise: list(names) for exercise, names in self.options.tests.items()},
            'seeds': dict(self.options.seeds),
            'limit': self.options.test_timeout,
            'share': [self.share.first, self.share.every],
        }

    def _collected(self, event: dict, seen: set[str]) -> None:
        name = event['test']
        if name in seen:
            self._doubled.add(name)
            self._owe(event['exercise'], name, 'two tests have this name')
        seen.add(name)
        if name not in self.tests:
            hidden = self.options.hidden is not None and Path(event['path']).is_relative_to(self.options.hidden)
            # Until its result comes, a test counts as an error of the grader's.
            self.tests[name] = TestResult(
                name,
                event['exercise'],
                hidden,
                event['weight'],
                verdicts.GRADER_ERROR,
                event['expected'],
                rules=event['rules'],
                given=event['given'],
            )
        self.unseen[event['exercise']].update(event['unseen'])

    def _result(self, event: dict, seconds: float) -> None:
        test = self.tests[event['test']]
        test.seconds = round(seconds, 3)
        again = event.get('again') is True and self._begun[test.test] <= self.options.retries
        if again and test.test not in self._doubled:
            test.verdict, test.fault = verdicts.GRADER_ERROR, f'to be tried again: {clean(event["message"])}'
            test.message = test.details = test.output = ''
        elif test.test not in self._doubled:
            test.verdict = event['verdict'] if event['verdict'] in verdicts.VERDICTS else verdicts.GRADER_ERROR
            test.rule, test.hint, test.so_far = event['rule'], event['hint'], event.get('so_far', [])
            test.message, test.details = clean(event['message']), clean(event['details'], MAX_OUTPUT)
            test.output, test.fault = clean(event['output'], MAX_OUTPUT), event['fault']
            if test.output.endswith(' …'):
                test.output = f'{test.output[:-2]}\n{LEFT_OUT}'

    def _broken(self, event: dict, programs: dict[str, dict]) -> None:
        """A test file that cannot be read: its path tells to which exercise it belongs; if not, to all."""
        tested = manifest.tested_in(Path(event['where']))
        for exercise in programs:
            if tested in (None, exercise):
                self._owe(exercise, event['where'], event['text'])

    def _owe(self, exercise: str, name: str, error: str) -> None:
        """Note an error of the grader's: no score for this exercise."""
        self.tests[name] = TestResult(name, exercise, True, 1.0, verdicts.GRADER_ERROR, fault=error)
        self._doubled.add(name)
        self.log.append(f'exercise {exercise}: {name}: {error}')


_BREAKS_TESTS = (
    'This test does not come to its end with your program, each time that it is tried; with another program it does. '
    'Does yours send or return something that is huge, broken, or of another kind than what is asked for, such as a '
    'text or nan in the place of a number?'
)

# What each kind of event must have.
_FIELDS: dict[str, dict[str, type | tuple[type, ...]]] = {
    'collected': {
        'test': str,
        'exercise': str,
        'weight': (int, float),
        'path': str,
        'expected': str,
        'rules': list,
        'given': bool,
        'unseen': dict,
    },
    'running': {'test': str, 'may_take': (int, float)},
    'broken': {'where': str, 'text': str},
    'sandbox': {'name': str},
    'spent': {'seconds': dict},
    'result': {
        'test': str,
        'verdict': str,
        'message': str,
        'details': str,
        'output': str,
        'fault': str,
        'rule': str,
        'hint': bool,
    },
}


def _event(line: bytes) -> dict | None:
    """An event of the tests' process; None if the text is not one."""
    try:
        event = json.loads(line)
        fields = _FIELDS.get(event['event'], {})
    except (ValueError, KeyError, TypeError, RecursionError):
        return None
    return event if all(isinstance(event.get(key), kind) for key, kind in fields.items()) else None


def _events(process: subprocess.Popen | Forked, descriptor: int, test_timeout: float, end: float = math.inf):
    """The events of the tests' process; `timeout` and the end if none came in time.

    That is START_TIMEOUT for the first test to begin, then BUSY times what a test may take: `test_timeout`, or what it
    says for itself.
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
            limit = max(1.0, min(BUSY * max(test_timeout, event['may_take']), end - time.monotonic()))
        yield event
        if event['event'] == 'end':
            try:
                process.wait(timeout=10)
            except subprocess.TimeoutExpired:
                yield {'event': 'timeout'}
            return
