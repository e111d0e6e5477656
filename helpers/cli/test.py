"""``./course test``: everything that CI checks, one step after the other."""

import os
import secrets
import subprocess
import sys
import tempfile
import time
from collections import Counter
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field, replace
from importlib.util import find_spec
from pathlib import Path
from typing import Annotated

import typer

from helpers import paths

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


def test(arguments: Arguments = None):
    """Run all tests: style, types, unit tests, notebooks in step with their sources, every notebook.

    With arguments, only pytest runs, with these.
    """
    os.chdir(paths.ROOT)
    if arguments:
        raise typer.Exit(min(subprocess.call([sys.executable, '-m', 'pytest', *arguments]), 2))
    (paths.ROOT / 'build').mkdir(exist_ok=True)
    # Inside of the course, so that pytest finds conftest.py for the notebooks written here too.
    if not os.environ.get('COURSE_ALL_TESTS'):
        seed = os.environ['COURSE_SAMPLE'] = os.environ.get('COURSE_SAMPLE') or secrets.token_hex(4)
        print(f'A sample runs: COURSE_SAMPLE={seed} draws it again, COURSE_ALL_TESTS=1 runs everything.')
    # Thousands of processes follow: each would compile all its modules anew.
    os.environ.pop('PYTHONDONTWRITEBYTECODE', None)
    with tempfile.TemporaryDirectory(prefix='test-', dir=paths.ROOT / 'build') as scratch, _compiling():
        steps = [run(Path(scratch)) for run in _plan()]
    raise typer.Exit(_summary(steps))


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
    yield _format
    yield _style
    if complete:
        yield _types
    yield _unit_tests
    if complete:
        yield _in_step
        yield _rules
        yield _notebooks


def _format(scratch: Path) -> Step:
    return _command('format', ['-m', 'ruff', 'format', '--check', '.'])


def _style(scratch: Path) -> Step:
    return _command('style', ['-m', 'ruff', 'check', '.'])


def _types(scratch: Path) -> Step:
    return _command('types', ['-m', 'mypy'])


def _unit_tests(scratch: Path) -> Step:
    step = _pytest('unit tests', scratch, ['-q', f'-n{_workers()}', '--dist=loadscope', '--no-loadscope-reorder'])
    if not 0 < step.failed <= FEW:
        return step
    again = _pytest(
        'unit tests again, one at a time', scratch, ['-q', '--last-failed', '--last-failed-no-failures=none']
    )
    return _after(step, again, step.passed + again.passed)


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


def _in_step(scratch: Path) -> Step:
    return _command('build --check', ['-m', 'helpers.cli', 'build', '--check'])


def _rules(scratch: Path) -> Step:
    return _command('build --rules', ['-m', 'helpers.cli', 'build', '--rules'])


def _notebooks(scratch: Path) -> Step:
    from grading.authoring import execution, repeated

    name = 'notebooks'
    found = [*sorted((paths.ROOT / 'solutions').glob('*.ipynb')), *sorted(paths.NOTEBOOKS.glob('*.ipynb'))]
    try:
        copies = repeated.write(found, scratch, _runs(found))
    except ValueError as error:
        _heading(name)
        print(error)
        return Step(name, failed=1)
    if not copies:
        _heading(name)
        print('no notebook in solutions/ and notebooks/; run ./course build')
        return Step(name, failed=1)
    return _run_notebooks(scratch, copies, repeated.nbval_arguments(execution.kernel_name()))


def _run_notebooks(scratch: Path, copies: list[Path], arguments: list[str]) -> Step:
    """Run notebooks side by side, and those of which a few cells failed once more, one at a time."""
    name = 'notebooks'
    step = _pytest(name, scratch, ['-q', f'-n{min(_workers(), len(copies))}', *arguments, *map(str, copies)])
    failed = [copy for copy in copies if any(_of_notebook(failure, copy) for failure in step.failures)]
    if not 0 < step.failed <= FEW or not failed:
        return step
    again = _pytest(f'{name} again, one at a time', scratch, ['-q', *arguments, *map(str, failed)])
    return _after(step, again, step.passed + step.failed - again.failed)


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


def _command(name: str, arguments: list[str]) -> Step:
    _heading(name)
    begin = time.monotonic()
    status = subprocess.call([sys.executable, *arguments])
    return Step(name, passed=int(status == 0), failed=int(status != 0), seconds=time.monotonic() - begin)


def _pytest(name: str, scratch: Path, arguments: list[str]) -> Step:
    """Run pytest; the counts come from its JUnit file. A run that ends badly without a failed test is one failure."""
    _heading(name)
    report = scratch / f'{name.replace(" ", "_").replace(",", "")}.xml'
    begin = time.monotonic()
    status = subprocess.call([sys.executable, '-m', 'pytest', f'--junitxml={report}', *arguments])
    step = Step(name, seconds=time.monotonic() - begin)
    _count(step, report)
    if status not in (0, NO_TESTS) and not step.failed:
        step.failed = 1
    if status == NO_TESTS or not step.passed + step.failed + step.skipped:
        print('no test was found')
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


def _heading(name: str) -> None:
    print(f'\n=== {name} ===', flush=True)


def _summary(steps: list[Step]) -> int:
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
    print(f'{passed} passed, {failed} failed, {skipped} skipped in {sum(step.seconds for step in steps):.0f} s')
    return int(failed > 0)
