"""``./course test``: everything that CI checks, in steps; the notebooks run beside the unit tests."""

import os
import secrets
import subprocess
import sys
import tempfile
import time
from collections import Counter
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from dataclasses import dataclass, field, replace
from importlib.util import find_spec
from pathlib import Path
from typing import IO, Annotated

import typer

from helpers import paths
from helpers.programs.english import ENGLISH

SETTINGS = {'context_settings': {'ignore_unknown_options': True, 'help_option_names': ['--help']}}
FEW = 16  # up to so many failed tests run once more, one at a time: a busy machine may be the cause
NO_TESTS = 5  # pytest's status if nothing was collected
Arguments = Annotated[list[str] | None, typer.Argument(metavar='[PYTEST ARGS]', help='Run pytest with these only.')]


@dataclass
class Step:
    """One step's outcome. A step that is no pytest run counts as one test."""

    name: str
    passed: int = 0
    failed: int = 0
    skipped: int = 0
    seconds: float = 0.0
    failures: list[str] = field(default_factory=list)  # the failed tests' names
    succeeded: set[str] = field(default_factory=set)  # names of those that passed
    unstable: list[str] = field(default_factory=list)  # those that failed beside others and passed alone
    left_out: list[str] = field(default_factory=list)  # for each skipped test, why; it says what to install


@dataclass
class Run:
    """A run of pytest. A few tests that fail beside others run once more, alone."""

    name: str
    arguments: list[str]
    workers: int
    again: Callable[[Step], list[str]]  # pytest's arguments for what failed in this step; none: nothing runs again
    whole_files: bool = False  # what runs again includes tests that have passed


def test(arguments: Arguments = None):
    """Run all tests: style, types, unit tests, notebooks in step with their sources, every notebook.

    With arguments, only pytest runs, with these.
    """
    os.chdir(paths.ROOT)
    os.environ.update(ENGLISH)
    if arguments:
        raise typer.Exit(min(subprocess.call([sys.executable, '-m', 'pytest', *arguments]), 2))
    (paths.ROOT / 'build').mkdir(exist_ok=True)
    # Inside of the course, so that pytest finds conftest.py for the notebooks written here too.
    if not os.environ.get('COURSE_ALL_TESTS'):
        seed = os.environ['COURSE_SAMPLE'] = os.environ.get('COURSE_SAMPLE') or secrets.token_hex(4)
        print(f'A sample runs: COURSE_SAMPLE={seed} draws it again, COURSE_ALL_TESTS=1 runs everything.')
    # Thousands of processes follow: each would compile all its modules anew.
    os.environ.pop('PYTHONDONTWRITEBYTECODE', None)
    begin = time.monotonic()
    with tempfile.TemporaryDirectory(prefix='test-', dir=paths.ROOT / 'build') as scratch, _compiling():
        steps = [step for run in _plan() for step in run(Path(scratch))]
    raise typer.Exit(_summary(steps, time.monotonic() - begin))


@contextmanager
def _compiling() -> Iterator[None]:
    """Compile all test modules beside the first steps, which need one processor: else each of pytest's workers does."""
    command = [sys.executable, '-m', 'pytest', '--collect-only', '-q', '-p', 'no:cacheprovider']
    with subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL) as process:
        try:
            yield
        finally:
            process.kill()


def _plan():
    complete = find_spec('grading') is not None  # the learner's edition has neither sources nor reference outputs
    yield _texts_and_types if complete else _texts
    yield _tests_and_notebooks if complete else _tests


def _texts(scratch: Path) -> list[Step]:
    return [
        _command('format', ['-m', 'ruff', 'format', '--check', '.']),
        _command('style', ['-m', 'ruff', 'check', '.']),
    ]


def _texts_and_types(scratch: Path) -> list[Step]:
    """What looks at texts only, and beside it the types, which take longer."""
    output = scratch / 'types.log'
    with ThreadPoolExecutor(1) as pool, output.open('w', encoding='utf-8') as file:
        types = pool.submit(_command, 'types', ['-m', 'mypy'], file)
        steps = [
            *_texts(scratch),
            _command('build --check', ['-m', 'helpers.cli', 'build', '--check']),
            _command('build --rules', ['-m', 'helpers.cli', 'build', '--rules']),
        ]
        steps.append(types.result())
    print(output.read_text(encoding='utf-8', errors='replace'), flush=True)
    return steps


def _tests(scratch: Path) -> list[Step]:
    return _side_by_side([_unit_tests(_workers())], scratch)


def _tests_and_notebooks(scratch: Path) -> list[Step]:
    """The unit tests, and beside them the notebooks, so that no processor waits for the last one of either."""
    workers = _workers()
    third = max(1, workers // 3)
    try:
        notebooks = _notebooks(scratch, third)
    except ValueError as error:
        _heading('notebooks')
        print(error)
        return [*_tests(scratch), Step('notebooks', failed=1)]
    return _side_by_side([_unit_tests(workers - third), notebooks], scratch)


def _unit_tests(workers: int) -> Run:
    arguments = ['--dist=loadscope', '--no-loadscope-reorder']
    return Run('unit tests', arguments, workers, lambda step: ['--last-failed', '--last-failed-no-failures=none'])


def _notebooks(scratch: Path, workers: int) -> Run:
    """The run of copies of the notebooks, which are written here.

    :raises ValueError: there is no notebook, or one that cannot be read.
    """
    from grading.authoring import execution, repeated

    found = [*sorted((paths.ROOT / 'solutions').glob('*.ipynb')), *sorted(paths.NOTEBOOKS.glob('*.ipynb'))]
    copies = repeated.write(found, scratch, _runs(found))
    if not copies:
        raise ValueError('no notebook in solutions/ and notebooks/; run ./course build')
    return _run_of_notebooks(copies, repeated.nbval_arguments(execution.kernel_name()), workers)


def _run_of_notebooks(copies: list[Path], arguments: list[str], workers: int) -> Run:
    def again(step: Step) -> list[str]:
        failed = [copy for copy in copies if any(_of_notebook(failure, copy) for failure in step.failures)]
        return [*arguments, *map(str, failed)] if failed else []

    return Run('notebooks', [*arguments, *map(str, copies)], min(workers, len(copies)), again, whole_files=True)


def _side_by_side(runs: list[Run], scratch: Path) -> list[Step]:
    """Run them at the same time; then what failed in each of them once more, one test at a time.

    What the first one prints is seen at once, the others' output when all have ended.
    """
    first, *others = runs
    outputs = [scratch / f'{run.name}.log' for run in others]
    with ThreadPoolExecutor(len(runs)) as pool:
        beside = [pool.submit(_first_run, run, scratch, output) for run, output in zip(others, outputs, strict=True)]
        steps = [_first_run(first, scratch), *(step.result() for step in beside)]
    for output in outputs:
        print(output.read_text(encoding='utf-8', errors='replace'), flush=True)
    return [_with_second_run(run, step, scratch) for run, step in zip(runs, steps, strict=True)]


def _first_run(run: Run, scratch: Path, output: Path | None = None) -> Step:
    arguments = ['-q', f'-n{run.workers}', *run.arguments]
    if not output:
        return _pytest(run.name, scratch, arguments)
    with output.open('w', encoding='utf-8') as file:
        return _pytest(run.name, scratch, arguments, file)


def _with_second_run(run: Run, step: Step, scratch: Path) -> Step:
    arguments = run.again(step) if 0 < step.failed <= FEW else []
    if not arguments:
        return step
    again = _pytest(f'{run.name} again, one at a time', scratch, ['-q', *arguments])
    passed = step.passed + (step.failed - again.failed if run.whole_files else again.passed)
    return _after(step, again, passed)


def _after(step: Step, again: Step, passed: int) -> Step:
    """What counts after what failed has run again, alone.

    A test may fail because others took the processor. It must pass alone, and is reported as unstable.
    """
    unstable = [name for name in step.failures if name in again.succeeded]
    left = [name for name in step.failures if name not in again.succeeded]  # also what did not come to run again
    return replace(
        step,
        passed=passed,
        failed=max(len(left), again.failed),
        seconds=step.seconds + again.seconds,
        failures=left,
        unstable=unstable,
    )


def _of_notebook(failure: str, copy: Path) -> bool:
    """Whether the name of a failed cell, as JUnit's file has it, belongs to this notebook."""
    return f'{copy.parent.name}.{copy.stem}' in failure.replace('/', '.')


def _runs(notebooks: list[Path]):
    from grading.authoring import repeated

    if os.environ.get('COURSE_ALL_TESTS'):
        return repeated.all_twice
    return repeated.sample(notebooks, os.environ['COURSE_SAMPLE'])


def _workers() -> int:
    # More than cores: most of a ROS test is waiting for another process.
    return max(2, min(12, 3 * len(os.sched_getaffinity(0))))


def _command(name: str, arguments: list[str], output: IO[str] | None = None) -> Step:
    _heading(name, output)
    begin = time.monotonic()
    status = subprocess.call([sys.executable, *arguments], stdout=output, stderr=output)
    return Step(name, passed=int(status == 0), failed=int(status != 0), seconds=time.monotonic() - begin)


def _pytest(name: str, scratch: Path, arguments: list[str], output: IO[str] | None = None) -> Step:
    """Run pytest; the counts come from its JUnit file. A run that ends badly without a failed test is one failure.

    :param output: where it prints; None is this program's own output.
    """
    _heading(name, output)
    report = scratch / f'{name.replace(" ", "_").replace(",", "")}.xml'
    begin = time.monotonic()
    command = [sys.executable, '-m', 'pytest', f'--junitxml={report}', *arguments]
    status = subprocess.call(command, stdout=output, stderr=output)
    step = Step(name, seconds=time.monotonic() - begin)
    _count(step, report)
    if status not in (0, NO_TESTS) and not step.failed:
        step.failed = 1
    if status == NO_TESTS or not step.passed + step.failed + step.skipped:
        print('no test was found', file=output)
        step.failed = 1
    return step


def _count(step: Step, report: Path) -> None:
    from xml.etree import ElementTree

    if not report.exists():
        return
    root = ElementTree.parse(report).getroot()
    step.left_out = [skip.get('message', '') for skip in root.iter('skipped')]
    for suite in root.iter('testsuite'):
        total, failed, skipped = (int(suite.get(key, 0)) for key in ('tests', 'failures', 'skipped'))
        failed += int(suite.get('errors', 0))
        step.passed, step.failed, step.skipped = total - failed - skipped, failed, skipped
        for case in suite.iter('testcase'):
            name = f'{case.get("classname")}.{case.get("name")}'
            if case.find('failure') is not None or case.find('error') is not None:
                step.failures.append(name)
            elif case.find('skipped') is None:
                step.succeeded.add(name)


def _heading(name: str, output: IO[str] | None = None) -> None:
    print(f'\n=== {name} ===', file=output, flush=True)


def _summary(steps: list[Step], seconds: float) -> int:
    _heading('summary')
    for step in steps:
        verdict = 'FAILED' if step.failed else 'passed'
        counts = f'{step.passed:5} passed {step.failed:4} failed {step.skipped:4} skipped'
        print(f'{verdict}  {step.name:24} {counts} {step.seconds:7.1f} s')
    unstable = [name for step in steps for name in step.unstable]
    for name in unstable:
        print(f'unstable: {name} failed beside other tests and passed alone')
    for reason, count in Counter(reason for step in steps for reason in step.left_out).items():
        print(f'skipped: {count} test{"s" * (count > 1)}: {reason}')
    passed, failed, skipped = (sum(getattr(step, key) for step in steps) for key in ('passed', 'failed', 'skipped'))
    print(f'{len(unstable)} unstable')
    print(f'{passed} passed, {failed} failed, {skipped} skipped in {seconds:.0f} s')
    return int(failed > 0)
