"""Every mistake of an author is named with file, line and mend."""

import pytest

from grading.authoring import build, rules
from grading.authoring.errors import ChapterErrors
from grading.tests.authoring.conftest import write
from grading.tests.authoring.sources import CHECK, DEMONSTRATION, EXERCISE, FRONT, TINY, TITLE, line_of

HEADER = ':exercise: {"id": "7.1", "points": 10, "names": ["double"]}'
FIRST = '# Exercise 7.1: twice as much'


def test_the_tiny_chapter_has_no_mistake(tree):
    (chapter,) = build.read_all(tree)
    assert [cell.kind for cell in chapter.cells] == ['markdown', 'code', 'markdown', 'code', 'code', 'code']
    assert chapter.cells[3].line == line_of(FIRST)


@pytest.mark.parametrize(('old', 'new', 'line', 'problem', 'remedy'), [
    ('    # END SOLUTION\n', '', '# BEGIN SOLUTION', 'BEGIN SOLUTION without # END SOLUTION', 'write # END SOLUTION'),
    ('    # BEGIN SOLUTION\n    # STUB: return None\n', '', '# END SOLUTION', 'END SOLUTION without', 'write # BEGIN'),
    ('"points": 10, ', '', FIRST, 'exercise 7.1 without points', 'add "points"'),
    ('"points": 10', '"points": 0', FIRST, 'exercise 7.1 without points', 'add "points"'),
    ('```{code-cell} ipython3\n:exercise',
     '### Exercise 7.1: double (5 points)\n\n```{code-cell} ipython3\n:exercise', FIRST,
     '10 points, and 5 in the heading', 'write the same'),
    (', "names": ["double"]', '', FIRST, 'exercise 7.1 without names', 'add "names"'),
    ('"id": "7.1"', '"id": 7.1', FIRST, 'exercise id 7.1', 'quoted "7.N"'),
    ('"id": "7.1"', '"id": "8.1"', FIRST, "exercise id '8.1'", 'quoted "7.N"'),
    ('"points": 10', '"points": 10, "weight": 2', FIRST, "unknown field 'weight'", 'use id, points and names'),
    (HEADER, ':exercise: yes', FIRST, 'metadata without fields', 'write :exercise: {"id"'),
    (HEADER, ':exercise: {"id": "7.1"', None, 'could not be read', 'mend the YAML'),
    (HEADER, HEADER + '\n:tag: [a]', FIRST, "unknown metadata 'tag'", 'use one of'),
    (HEADER, HEADER + '\n:tags: [nbval-ignore-outputs]', FIRST, "unknown tag 'nbval-ignore-outputs'", 'use one of'),
    (HEADER, HEADER + '\n:tags: nbval-skip', ':tags: nbval-skip', 'metadata: ', 'write tags as :tags: ['),
    (FIRST, '# Exercise 7.2: twice', '# Exercise 7.2', 'the first line of exercise 7.1', 'make it so'),
    (FIRST + '\n', '', 'def double', 'the first line of exercise 7.1', 'make it so'),
    ('    # STUB: return None\n', '', FIRST, 'the stub of exercise 7.1 does not parse', 'STUB: pass'),
    ('return 2 * number', 'return 2 *', FIRST, 'the solution of exercise 7.1 does not parse', 'mend it'),
    ('# STUB: return None', '# STUB: return 2 * number', FIRST, 'its stub is its solution', 'mark the solution'),
    ('def double', 'def triple', FIRST, 'does not define double', 'define it'),
    ('check("7.1")', 'double(2)', FIRST, 'exercise 7.1 has no check cell', 'add a cell check("7.1")'),
    (HEADER + '\n', '', FIRST, 'a solution region outside of an exercise', "add the cell's metadata"),
    ('Some prose.', 'Some prose.\n\n# BEGIN SOLUTION', '# BEGIN SOLUTION', 'solution marker in prose', 'move it'),
    ('# 7 Tiny', 'Seven', None, 'no title', 'begin the text'),
    ("    print('checked', identifier)\n", '    x = 1\n' * 25, 'def check', 'a code cell of 26 lines', 'split it'),
])
def test_a_mistake_names_file_line_and_mend(tree, old, new, line, problem, remedy):
    assert TINY.count(old) == 1
    text = TINY.replace(old, new)
    write(tree, text)
    with pytest.raises(ChapterErrors) as caught:
        build.read_all(tree)
    hits = [error for error in caught.value.errors if problem in error.problem]
    assert len(hits) == 1, str(caught.value)
    assert remedy in hits[0].remedy
    expected = f'solutions/07_tiny.md:{line_of(line, text)}: ' if line else 'solutions/07_tiny.md:'
    assert str(hits[0]).startswith(expected)


def test_all_mistakes_are_told_at_once(tree):
    write(tree, TINY.replace('"points": 10, ', '').replace('check("7.1")', 'pass').replace('# 7 Tiny', 'Seven'))
    with pytest.raises(ChapterErrors) as caught:
        build.read_all(tree)
    assert len(str(caught.value).splitlines()) == 3


def test_a_cell_of_25_lines_is_allowed(tree):
    write(tree, TINY.replace("    print('checked', identifier)\n", '    x = 1\n' * 24))
    assert build.read_all(tree)


def test_an_exercise_may_be_tried_out_before_its_check(tree):
    write(tree, TINY.replace(CHECK, '```{code-cell} ipython3\nprint(double(2))\n```\n\n' + CHECK))
    assert build.read_all(tree)


def test_a_check_after_the_next_exercise_is_too_late(tree):
    second = EXERCISE.replace('7.1', '7.2')
    write(tree, FRONT + TITLE + DEMONSTRATION + EXERCISE + second + CHECK + CHECK.replace('7.1', '7.2'))
    with pytest.raises(ChapterErrors, match='exercise 7.1 has no check cell') as caught:
        build.read_all(tree)
    assert len(caught.value.errors) == 1


@pytest.mark.parametrize('name', ['07_tiny.md', '07_other.md'])
def test_an_id_is_given_once_in_all_chapters(tree, name):
    if name == '07_tiny.md':
        write(tree, TINY + '\n' + EXERCISE + CHECK)
    else:
        write(tree, TINY, name)
    with pytest.raises(ChapterErrors, match='exercise 7.1 is there twice') as caught:
        build.read_all(tree)
    assert len(caught.value.errors) == 1


def test_long_cells_give_advice_only(tree):
    write(tree, TINY.replace("    print('checked', identifier)\n", '    x = 1\n' * 20))
    assert rules.advice(build.read_all(tree)[0]) == []  # the median of four cells is small
    write(tree, FRONT + TITLE + DEMONSTRATION.replace("    print('checked', identifier)\n", '    x = 1\n' * 20))
    assert 'aim at 6' in rules.advice(build.read_all(tree)[0])[0]
