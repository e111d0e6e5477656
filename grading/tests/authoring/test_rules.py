"""Every mistake of an author is named with file, line and remedy."""

import pytest

from grading.authoring import chapter_build, rules
from grading.authoring.chapter_errors import ChapterErrors
from grading.tests.authoring.conftest import write
from grading.tests.authoring.sources import CHECK_HERE, DEMONSTRATION, EXERCISE, FRONT, TINY, TITLE, line_of

BEGIN = '```{exercise} 7.1 twice as much'
DIRECTIVE = BEGIN + '\n:points: 10\n:names: double\n```\n\n'
FIRST = 'def double(number):'
FENCE = '```{code-cell} ipython3\n'
CELL = FENCE + FIRST
HERE = CHECK_HERE + '\n'
REGION = EXERCISE[EXERCISE.index('    # BEGIN') : EXERCISE.index('```\n', EXERCISE.index('# END'))]


def test_the_tiny_chapter_has_no_mistake(tree):
    (chapter,) = chapter_build.read_all(tree)
    assert [cell.kind for cell in chapter.cells] == ['markdown', 'code', 'markdown', 'code', 'code', 'code']
    assert chapter.cells[3].line == line_of(FIRST)


@pytest.mark.parametrize(
    ('old', 'new', 'line', 'problem', 'remedy'),
    [
        (
            '    # END SOLUTION\n',
            '',
            '# BEGIN SOLUTION',
            'BEGIN SOLUTION without # END SOLUTION',
            'write # END SOLUTION',
        ),
        (
            '    # BEGIN SOLUTION\n    # STUB: return None\n',
            '',
            '# END SOLUTION',
            'END SOLUTION without',
            'write # BEGIN',
        ),
        (':points: 10\n', '', BEGIN, 'exercise 7.1 without points', 'add :points:'),
        (':points: 10', ':points: 0', BEGIN, 'exercise 7.1 without points', 'add :points:'),
        (':points: 10', ':points: many', BEGIN, 'exercise 7.1 without points', 'add :points:'),
        (':points: 10', ':weight: 2', ':weight', "option 'weight'", 'use points, names, check'),
        (':points: 10', ':points: 10\n:points: 9', ':points: 9', "option 'points'", 'each once'),
        (':points: 10', 'points: 10', 'points: 10', 'no option', 'write :name: value'),
        (':names: double\n', '', BEGIN, 'exercise 7.1 without names', 'add :names:'),
        (':names: double', ':names: 2 * x', BEGIN, 'exercise 7.1 without names', 'add :names:'),
        (':points: 10', ':points: 10\n:earlier: abc', BEGIN, "the earlier digest 'abc'", 'write 12 hexadecimal digits'),
        (BEGIN, '```{exercise} 7.1', '```{exercise} 7.1', "'7.1' without id or title", 'write ```{exercise} 3.1'),
        (BEGIN, '```{exercise} twice as much', '{exercise}', 'without id or title', 'write ```{exercise} 3.1'),
        (BEGIN, '```{exercise} 8.1 twice', '{exercise}', 'exercise 8.1 in chapter 7', 'the id 7.N'),
        (BEGIN, BEGIN + '\n```\n\n' + BEGIN, BEGIN, 'without points', 'add :points:'),
        (CELL, FENCE + ':tag: [a]\n' + FIRST, FIRST, "unknown metadata 'tag'", 'use one of'),
        (CELL, FENCE + ':exercise: {"id": "7.1"}\n' + FIRST, FIRST, "unknown metadata 'exercise'", 'use one of'),
        (CELL, FENCE + ':exercise: {"id"\n' + FIRST, None, 'could not be read', 'correct the YAML'),
        (CELL, FENCE + ':tags: [nbval-outputs]\n' + FIRST, FIRST, "unknown tag 'nbval-outputs'", 'use one of'),
        (CELL, FENCE + ':tags: nbval-skip\n' + FIRST, ':tags: nbval-skip', 'metadata: ', 'write tags as :tags: ['),
        (
            CELL,
            CELL.replace(FIRST, '# Exercise 7.1: twice\n' + FIRST),
            '# Exercise',
            'is written by hand',
            'leave it out',
        ),
        ('1 / 0', '```\n\n```{code-cell} ipython3\ncheck("7.1")', 'check("7.1")', 'is written by hand', 'leave it out'),
        (CELL, HERE + CELL, None, 'a check cell without an exercise', 'after the answer cell'),
        (DIRECTIVE, '', FIRST, 'a solution region outside of an exercise', 'declare the exercise before it'),
        (DIRECTIVE, DIRECTIVE + '- {rule}`a` One.\n- {rule}`a` Two.\n\n', 'Two', "rule 'a' twice", 'its own name'),
        (DIRECTIVE, DIRECTIVE + 'Do it.\n\n{rule}`A b` One.\n\n', 'One', "cannot be 'A b'", 'lower case'),
        (DIRECTIVE, DIRECTIVE + '- {rule}`a`\n\n', '{rule}', "the rule 'a' has no text", 'write its sentence'),
        ('Some prose.', 'Some {rule}`a` prose.', '{rule}', 'a rule outside of the card', 'between the directive'),
        (REGION, '    return 2\n', BEGIN, 'exercise 7.1 has no solution region', 'mark it'),
        ('    # STUB: return None\n', '', FIRST, 'the stub of exercise 7.1 does not parse', 'STUB: pass'),
        ('return 2 * number', 'return 2 *', FIRST, 'the solution of exercise 7.1 does not parse', 'correct it'),
        (
            REGION,
            f'{REGION}%%answer CODE a_ws/a.py\nx = 1\ny = (\n',
            FIRST,
            "the solution of exercise 7.1: a_ws/a.py, line 2: '(' was never closed",
            'correct it',
        ),
        ('# STUB: return None', '# STUB: return 2 * number', FIRST, 'its stub is its solution', 'mark the solution'),
        ('def double', 'def triple', 'def triple', 'does not define double', 'define it'),
        ('Some prose.', 'Some prose.\n\n# BEGIN SOLUTION', '# BEGIN SOLUTION', 'solution marker in prose', 'move it'),
        ('# 7 Tiny', 'Seven', None, 'no title', 'begin the text'),
        ("    print('checked', identifier)\n", '    x = 1\n' * 15, 'def check', 'a code cell of 16 lines', 'split it'),
        (
            'Some prose.',
            'Some [prose](https://docs.ros.org/en/rolling/a.html).',
            'Some [prose]',
            'a link to docs.ros.org/en/rolling',
            'the page of Jazzy',
        ),
        (
            'Some prose.',
            'Some prose.\n\n<details><summary>Hint</summary>\n\nThink.\n\n</details>\n\nMore prose.',
            'More prose.',
            'no distance from the folded hint',
            "a line '+++'",
        ),
    ],
)
def test_a_mistake_names_file_line_and_mend(tree, old, new, line, problem, remedy):
    assert TINY.count(old) == 1
    text = TINY.replace(old, new)
    write(tree, text)
    with pytest.raises(ChapterErrors) as caught:
        chapter_build.read_all(tree)
    hits = [error for error in caught.value.errors if problem in error.problem]
    assert len(hits) == 1, str(caught.value)
    assert remedy in hits[0].remedy
    expected = f'solutions/07_tiny.md:{line_of(line, text)}: ' if line else 'solutions/07_tiny.md:'
    assert str(hits[0]).startswith(expected)


def test_all_mistakes_are_told_at_once(tree):
    text = TINY.replace('def double', 'def triple').replace(
        f'{CELL[:23]}\ndef check', f'{CELL[:23]}\n:tag: a\ndef check'
    )
    write(tree, text.replace('# 7 Tiny', 'Seven'))
    with pytest.raises(ChapterErrors) as caught:
        chapter_build.read_all(tree)
    assert len(str(caught.value).splitlines()) == 3


@pytest.mark.parametrize('first', ['', '%%writefile a.py\n'])
def test_a_cell_of_15_lines_is_allowed_and_one_more_for_the_name_of_a_file(tree, first):
    cell = f'{FENCE}{first}def check(identifier):\n' + '    x = 1\n' * 14
    write(tree, TINY.replace(DEMONSTRATION, f'{cell}```\n\n'))
    assert chapter_build.read_all(tree)


TRIED = '```{code-cell} ipython3\nprint(double(2))\n```\n\n'


def test_the_check_cell_comes_after_the_answer_or_where_it_is_asked_for(tree):
    for text, expected in (
        (EXERCISE + TRIED, ['check("7.1")', 'print(double(2))']),
        (EXERCISE + TRIED + CHECK_HERE, ['print(double(2))', 'check("7.1")']),
    ):
        write(tree, FRONT + TITLE + DEMONSTRATION + text)
        (chapter,) = chapter_build.read_all(tree)
        assert [cell.split.solved for cell in chapter.cells[-2:]] == expected
        (check,) = (cell for cell in chapter.cells if cell.split.solved == 'check("7.1")')
        assert check.metadata == {'tags': ['nbval-ignore-output']}


def test_the_directive_gives_heading_first_line_metadata_and_check(tree):
    write(
        tree,
        TINY.replace(':names: double', ':names: double, triple\n:check: nbval-skip').replace(
            '    # END SOLUTION', '    # END SOLUTION\ntriple = 3'
        ),
    )
    (chapter,) = chapter_build.read_all(tree)
    card, answer, check = chapter.cells[2:5]
    assert card.split.solved == 'Some prose.\n\n### Exercise 7.1: twice as much (10 points)'
    assert answer.split.solved.splitlines()[:2] == ['# Exercise 7.1: twice as much', FIRST]
    assert answer.metadata == {'exercise': {'id': '7.1', 'points': 10, 'names': ['double', 'triple']}}
    assert answer.source_line(2) == line_of(FIRST) + 1  # an option more than in TINY
    assert (check.split.stub, check.metadata) == ('check("7.1")', {'tags': ['nbval-skip']})


CARD = """
Write it. {rule}`once` Call it **once**, never
`a__b__c` times. {rule}`twice-a_day` See [the *page*](https://a.org).

1. {rule}`rate` It publishes **4 times a second**,
   as `*args` says:
   - at _first_ this
   - then __that__
2. Not a rule.

- No rule either.
- {rule}`quiet` It says nothing.
## Heading
"""


def test_rules_of_a_card(tree):
    write(tree, TINY.replace(DIRECTIVE, DIRECTIVE + CARD))
    (chapter,) = chapter_build.read_all(tree)
    (row,) = chapter.exercises()
    assert [(rule.name, rule.text) for rule in row.rules] == [
        ('once', 'Call it once, never `a__b__c` times.'),
        ('twice-a_day', 'See the page.'),
        ('rate', 'It publishes 4 times a second, as `*args` says: at first this then that'),
        ('quiet', 'It says nothing.'),
    ]
    card = '\n'.join(cell.split.stub for cell in chapter.cells if cell.kind == 'markdown')
    assert '**once**: Call it **once**, never' in card and '- **quiet**: It says nothing.' in card
    assert '{rule}' not in card


@pytest.mark.parametrize('name', ['07_tiny.md', '07_other.md'])
def test_an_id_is_given_once_in_all_chapters(tree, name):
    if name == '07_tiny.md':
        write(tree, TINY + '\n' + EXERCISE)
    else:
        write(tree, TINY, name)
    with pytest.raises(ChapterErrors, match='exercise 7.1 is there twice') as caught:
        chapter_build.read_all(tree)
    assert len(caught.value.errors) == 1


def test_long_cells_give_advice_only(tree):
    write(tree, TINY.replace("    print('checked', identifier)\n", '    x = 1\n' * 14))
    assert rules.advice(chapter_build.read_all(tree)[0]) == []  # the median of four cells is small
    write(tree, FRONT + TITLE + DEMONSTRATION.replace("    print('checked', identifier)\n", '    x = 1\n' * 14))
    assert 'aim at 6' in rules.advice(chapter_build.read_all(tree)[0])[0]
