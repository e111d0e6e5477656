"""Checked statements run after the cell above them, in the build and under nbval, and are never shown."""

import re
import subprocess
import sys

import nbformat
import pytest

from grading.authoring import chapter_build, execution, in_step, repeated, rules
from grading.authoring.chapter_errors import ChapterErrors
from grading.tests.authoring.conftest import write
from grading.tests.authoring.sources import TINY, line_of
from helpers import paths

pytestmark = pytest.mark.one_of(2)

FENCE = '```{code-cell} ipython3\n'
SHOWS = f"""{FENCE}import sys
total = 3
print('total', total)
print('oh', file=sys.stderr)
[total]
```

"""
HOLDS = f"""{FENCE}:checked: true
kept = total  # is gone afterwards
assert kept == 3
assert printed == 'total 3\\noh\\n[3]\\n', printed
```

"""
GONE = f"{FENCE}print('kept' in globals(), 'printed' in globals())\n```\n\n"
SOURCE = TINY + '\n' + SHOWS + HOLDS + GONE


def quiet(line):
    """Take no notice of progress."""


def test_statements_that_hold_leave_no_trace(tree):
    write(tree, SOURCE)
    chapter_build.build(tree, say=quiet)
    (chapter,) = chapter_build.read_all(tree)
    solved = nbformat.read(tree.solved(chapter), as_version=4)
    assert [cell.execution_count for cell in solved.cells if cell.cell_type == 'code'] == [1, 2, 3, 4, 5, 6]
    assert solved.cells[-1].outputs[0].text == 'False False\n'
    assert 'assert' not in tree.learner(chapter).read_text()
    assert 'assert' not in ''.join(cell.source for cell in solved.cells)
    assert in_step.drift(tree) == []
    assert rules.checked_counts([chapter]) == {7: 2}


def test_what_a_cell_prints_after_its_end_counts(tree):
    late = f"{FENCE}import threading\nthreading.Timer(0.5, print, ('late',)).start()\n```\n\n"
    write(tree, f"{TINY}\n{late}{FENCE}:checked: true\nwords = printed.split()\nassert words == ['late']\n```\n")
    chapter_build.build(tree, say=quiet)


@pytest.mark.parametrize(
    ('old', 'new', 'line', 'problem'),
    [
        ('kept == 3', 'kept == 4', 'kept == 4', 'AssertionError: assert kept == 4; printed:'),
        ('total 3\\noh', 'total 4', 'total 4', 'total 4'),
        ('kept = total', 'kept = totl', ':checked:', "NameError: name 'totl' is not defined"),
    ],
)
def test_a_statement_that_does_not_hold_fails_the_build_at_its_line(tree, old, new, line, problem):
    text = SOURCE.replace(old, new)
    write(tree, text)
    with pytest.raises(ChapterErrors) as caught:
        chapter_build.build(tree, say=quiet)
    (error,) = caught.value.errors
    assert problem in error.problem and 'what the text says' in error.remedy
    assert error.line == line_of(line, text) + (line == ':checked:')


def test_a_changed_statement_is_run_again(tree):
    write(tree, SOURCE)
    chapter_build.build(tree, say=quiet)
    write(tree, SOURCE.replace('kept == 3', 'kept == 4'))
    assert 'metadata' in in_step.drift(tree)[0]
    with pytest.raises(ChapterErrors, match='assert kept == 4'):
        chapter_build.build(tree, say=quiet)


@pytest.mark.parametrize(
    ('text', 'problem'),
    [
        (SHOWS + HOLDS + HOLDS, 'do not follow a code cell'),
        (SHOWS + 'Prose.\n\n' + HOLDS, 'do not follow a code cell'),
        (SHOWS + HOLDS.replace('assert ', 'print '), 'checked statements: '),
        (SHOWS + re.sub('assert .*', 'pass', HOLDS), 'without an assertion'),
        (SHOWS + HOLDS.replace('true', 'true\n:tags: [nbval-skip]'), 'with other metadata'),
    ],
)
def test_mistakes_of_the_author_are_named(tree, text, problem):
    write(tree, TINY + '\n' + text)
    with pytest.raises(ChapterErrors) as caught:
        chapter_build.read_all(tree)
    assert problem in str(caught.value)


@pytest.mark.timeout(180)
def test_ci_runs_the_statements_too(tree, tmp_path):
    write(tree, SOURCE)
    chapter_build.build(tree, say=quiet)
    (chapter,) = chapter_build.read_all(tree)
    solved = nbformat.read(tree.solved(chapter), as_version=4)
    cell = next(cell for cell in solved.cells if 'checked' in cell.metadata)
    good = repeated.write([tree.solved(chapter), tree.learner(chapter)], tmp_path / 'good')
    assert [len(nbformat.read(path, as_version=4).cells) for path in good] == [2 + 1 + 2 * (6 + 1), 2 + 6]
    cell.metadata['checked'] += '\nassert total == 4'
    nbformat.write(solved, tree.solved(chapter))
    (copy,) = repeated.write([tree.solved(chapter)], tmp_path / 'bad')
    arguments = repeated.nbval_arguments(execution.kernel_name())
    command = [sys.executable, '-m', 'pytest', '-q', '-p', 'no:randomly', *arguments, '-p', 'conftest']
    done = subprocess.run([*command, copy], cwd=paths.ROOT, capture_output=True, text=True, timeout=150)
    failed = re.findall(r'^FAILED .*::(\S+)', done.stdout, re.MULTILINE)
    assert failed == [f'{cell.id}-first-checked', f'{cell.id}-second-checked'], done.stdout + done.stderr
    assert 'assert total == 4' in done.stdout


def test_each_chapter_of_the_course_has_its_checked_statements():
    counts = rules.checked_counts(chapter_build.read_all(chapter_build.CourseFolders(paths.ROOT)))
    assert set(counts) == set(rules.CHECKED_AT_LEAST)
    assert all(rules.CHECKED_AT_LEAST.values())
    assert [number for number, count in counts.items() if count < rules.CHECKED_AT_LEAST[number]] == []
