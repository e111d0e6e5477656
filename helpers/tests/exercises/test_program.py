"""From cells to the program of one exercise."""

import pytest

from helpers.exercises import program
from helpers.exercises.notebooks import NotebookCell
from helpers.exercises.program import InvalidExercise, NotAttempted
from helpers.tests import small


def build(*cells, **changes):
    return program.build(list(cells), small.exercise(**changes))


def test_exercise_whole_and_others_filtered_in_order():
    made = build(
        NotebookCell('import os\nprint("x")', 1),
        small.cell('class Talker: pass\nprint("mine")'),
        NotebookCell('LATER = 1', 3),
    )
    assert [(part['source'].strip(), part['required']) for part in made.cells] == [
        ('import os', False),
        ('# Exercise 90.1: a talker\nclass Talker: pass', True),
        ('print("mine")', False),
    ]
    assert {part['label'] for part in made.cells[1:]} == {'Exercise 90.1'}


def test_what_the_program_needs_of_the_cells_below():
    """Cells can be run in any order; what stands below costs nothing if nobody needs it."""
    made = build(
        NotebookCell('def above(): return UNIT', 1),
        small.cell('class Talker:\n    def f(self): return above() + below() + len([])'),
        NotebookCell('import heavy\nUNIT = 1\nprint(3)', 3),
        NotebookCell('import math\ndef below(): return math.pi * FACTOR', 4),
        NotebookCell(
            'def above(): return 2\ndef unused(): pass\nFACTOR = 1\nFACTOR += 2\nOTHER = []\nOTHER.append(1)', 5
        ),
        NotebookCell('def len(x): pass', 6),
    )
    assert [part['source'].strip() for part in made.cells] == [
        'def above(): return UNIT',
        'UNIT = 1',
        'import math',
        'def below(): return math.pi * FACTOR',
        'FACTOR = 1',
        'FACTOR += 2',
        made.cells[-1]['source'].strip(),
    ]
    assert made.cells[-1]['required'] and not made.absent


@pytest.mark.parametrize(
    'demonstration',
    [
        'GOOD = compute()',
        'for GOOD in [1, 2]: pass',
        'with compute() as GOOD: pass',
        'if True:\n    print(1)\n    GOOD = 2',
        '%matplotlib inline\nGOOD = compute()',
    ],
)
@pytest.mark.parametrize('below', [False, True])
def test_why_a_name_is_not_there(demonstration, below):
    """A learner takes for there what another cell has computed."""
    cells = [NotebookCell(demonstration, 7), small.cell('class Talker:\n    x = GOOD')]
    absent = build(*(cells[::-1] if below else cells)).absent
    assert list(absent) == ['GOOD'] and '`GOOD` is made in cell 7' in absent['GOOD']
    assert not build(cells[0], small.cell('class Talker: pass')).absent
    assert not build(cells[0], small.cell('GOOD = 1\nclass Talker:\n    x = GOOD')).absent


@pytest.mark.parametrize('head', ['%%time\n', '%%capture out\n%%time\n'])
def test_an_answer_below_a_magic_that_runs_it_counts(head):
    cell = small.cell('class Talker: pass')
    made = build(NotebookCell(f'{head}{cell.source}', 2))
    blank = '\n' * head.count('\n')
    assert [part['source'] for part in made.cells] == [f'{blank}{cell.source}']


@pytest.mark.parametrize(
    ('command', 'instead'),
    [
        ('%matplotlib inline', 'pass'),
        ('!ros2 topic list', 'pass'),
        ('%time y = 5', 'y = 5'),
        ("!echo it's (", 'pass'),
        ('Talker?', 'pass'),
        ('?Talker', 'pass'),
        ('files = !ls', 'pass'),
        ('if True:\n    !ls', 'if True:\n    pass'),
    ],
)
def test_commands_in_an_answer_are_left_out(command, instead):
    """Also where they are the first lines. What stands in a string is no command."""
    text = 'class Talker:\n    text = """\n!this\n%that\n"""'
    made = build(small.cell(f'{text}\n{command}\nx = 7'))
    assert made.cells[-1]['source'].split('\n', 1)[1].strip() == f'{text}\n{instead}\nx = 7'
    assert 'was left out' in made.notes[0] and str(6 + command.count('\n') + 1) in made.notes[0]
    assert build(small.cell(f'{command}\n{text}')).notes


def test_an_answer_that_was_split_or_merged():
    """The cell was split below its heading; two cells were merged into one."""
    head, body = small.cell('').source.strip(), 'class Talker: pass'
    assert build(NotebookCell(head, 1), NotebookCell(body, 2)).cells[-1]['source'].endswith(body)
    with pytest.raises(InvalidExercise, match='must define'):  # a check stands between them
        build(NotebookCell(head, 1), NotebookCell('check("90.1")', 2), NotebookCell(body, 3))
    merged = NotebookCell(f'# Exercise 90.2: y\nx = 1\n{head}\n{body}', 1)
    assert body in build(merged).cells[-1]['source']


@pytest.mark.parametrize(
    'copy', ['# class Talker: pass', 'pass', 'class Talker: pass\nx = 1', 'class Talker:  # mine\n    pass\n\nx = 1  ']
)
def test_a_copy_that_is_no_answer_does_not_matter(copy):
    """A try that was commented out, what was given, the same once more."""
    stub = program.stub_digest('pass')
    answer = small.cell('class Talker: pass\nx = 1')
    for cells in ((small.cell(copy), answer), (answer, small.cell(copy))):
        assert 'x = 1' in build(*cells, stub=stub).cells[-1]['source']


def test_a_cell_that_only_tries_the_answer_does_not_matter():
    """It may have the same heading, above or below; two answers are refused all the same."""
    answer, trial = small.cell('class Talker: x = STEP'), small.cell('STEP = 1\nassert Talker().x')
    for cells in ((answer, trial), (trial, answer)):
        assert [part['source'].strip() for part in build(*cells).cells] == ['STEP = 1', answer.source]
    with pytest.raises(InvalidExercise, match='is there 2 times'):
        build(answer, trial, small.cell('class Talker: x = 2'))


def test_other_exercises_count_as_other_cells():
    made = build(small.cell('def helper(): pass\nhelper()', 2), small.cell('class Talker: pass'))
    assert [part['source'].strip() for part in made.cells[:-1]] == ['def helper(): pass']


def test_broken_other_exercise_does_not_matter():
    assert len(build(small.cell('class Oops(:', 2), small.cell('class Talker: pass')).cells) == 1


@pytest.mark.parametrize(
    ('source', 'message'),
    [
        ('class Listener: pass', 'must define `Talker`; it defines `Listener`'),
        ('x = 1 +', r'line 2: Python cannot read `x = 1 \+`'),
        ('class Talker: pass\n%%bash\nls', 'line 3: `%%bash` is a notebook command'),
        ('class Talker: pass\n!ls\nx = 1 +', r'line 4: Python cannot read `x = 1 \+`'),
        ('class Talker: pass\n\0', 'cannot read'),
        ('class Talker：pass', r'\(U\+FF1A\): type `:` in its place\)'),  # of a Chinese input method
        ('x = “a”', r'\(U\+201C\): type `"` in its place\)'),
        ('class\u00a0Talker: pass', r'U\+00A0: type a plain blank in its place\)'),
        ('class Talker: pass\u200b', r'U\+200B: this sign has no width'),
        ('x = 1 ½', r'\(U\+00BD\)\)'),  # there is no such key
        ('def f():\n    Talker = 1', 'must define `Talker`'),
        ('x = ' + '(' * 500 + ')' * 500, 'cannot read'),
    ],
)
def test_invalid_exercise(source, message):
    with pytest.raises(InvalidExercise, match=message):
        build(NotebookCell('class Talker: pass', 1), small.cell(source))


@pytest.mark.parametrize(
    'source',
    [
        'class Talker: pass',
        'def Talker(): pass',
        'Talker = 1',
        'from x import Talker',
        'import y as Talker',
        'if True:\n    class Talker: pass',
        'try:\n    x\nexcept E:\n    Talker = 1',
        'Talker, b = 1, 2',
        'Talker: int = 1',
    ],
)
def test_name_is_defined(source):
    build(small.cell(source))


def test_missing_and_doubled():
    with pytest.raises(InvalidExercise, match=r'was not found: its first line must be `# Exercise 90.1: a talker`'):
        build(NotebookCell('class Talker: pass', 1))
    with pytest.raises(InvalidExercise, match=r'is there 2 times \(cells 2 and 5\)'):
        build(small.cell('class Talker: pass'), NotebookCell('# Exercise 90.1: copy\nclass Talker: x = 1', 5))


def test_heading_is_recognised_leniently_but_not_by_prefix():
    assert program.exercise_id(NotebookCell('\n#  exercise 3.2 : x', 1)) == '3.2'
    assert program.exercise_id(NotebookCell('# Exercise 3.21: x', 1)) == '3.21'
    assert program.exercise_id(NotebookCell('x = 1\n# Exercise 3.2: x', 1)) is None


def test_id_helps_when_the_heading_is_gone():
    assert build(NotebookCell('class Talker: pass', 4, 'ex-90-1')).cells[0]['required']


def test_untouched_stub():
    for source in (small.STUB, f'# my thoughts\n{small.STUB}\n\n# more'):
        with pytest.raises(NotAttempted):
            build(small.cell(source))


def test_a_constant_that_a_demonstration_changes_is_named():
    """The check has it as it was made: without a word, its values would be a riddle."""
    answer = small.cell('class Talker:\n    def f(self): return WORDS')
    made = build(
        NotebookCell('WORDS = []\nfor word in read(): WORDS.append(word)\nOTHER = []\nOTHER.append(f())', 7), answer
    )
    assert made.notes == [
        '`WORDS` is changed in cell 7 by a statement that does not run here: the check has it as it was before. Make '
        '`WORDS` in the cell of the exercise.'
    ]
