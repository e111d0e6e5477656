"""From cells to the program of one exercise."""

import pytest

from helpers.exercises import program
from helpers.exercises.notebooks import NotebookCell
from helpers.exercises.program import InvalidExercise, NotAttempted
from helpers.tests import small


def kept(source):
    return [text.strip() for _, text in program.definitions(NotebookCell(source, 1))]


@pytest.mark.parametrize(
    'source',
    [
        'import os',
        'from a import b',
        'def f():\n    return 1',
        'async def f():\n    pass',
        'class A:\n    x = 1',
        '@decorated\nclass A:\n    pass',
        'X = 1',
        'X = -1.5 + 2j',
        'X, Y = 1, 2',
        'X, (Y, *Z) = A',
        'X: int = 3',
        "X = {'a': [1, (2,)]}",
        'QOS = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)',
        'T = rclpy.time.Time(seconds=3)',
        'D = Duration(seconds=0.5)',
        'Alias = some.module.Class',
        'now = lambda: 5',
        'A = B = 3',
        'X = Y[0]',
    ],
)
def test_definitions_are_kept(source):
    assert kept(source) == [source]


@pytest.mark.parametrize(
    'source',
    [
        'print(1)',
        'rclpy.init()',
        "node = Node('x')",
        'x = f()',
        'x += 1',
        'for i in range(3):\n    y = i',
        'with spinning(node):\n    pass',
        'node.x = 1',
        'node.x, node.y = 1, 2',
        'x, (y, *node.z) = 1, (2, 3)',
        'd["a"] = 1',
        'del x',
        'assert x',
        'x = [f() for _ in y]',
        'if True:\n    import os',
        'while True: pass',
        'QOS = QoSProfile(depth=f())',
        'x = await y',
        'await y',
        '%%bash\nls',
        '!rm -rf x',
        'def broken(:',
        '"just text"',
        'x = (y := 3)',
        'raise SystemExit',
    ],
)
def test_demonstrations_are_dropped(source):
    assert kept(source) == []


def test_notebook_commands_are_dropped_line_by_line():
    commands = '%matplotlib inline\nimport os\n!ls\nx = !ls\nfiles = %sx ls\nos?\n?os\nY = 2'
    assert kept(commands) == ['import os', 'Y = 2']
    assert kept('text = """\n%not a command\n"""') == ['text = """\n%not a command\n"""']
    assert kept('x = 7 \\\n % 2') == ['x = 7 \\\n % 2']


@pytest.mark.parametrize('head', ['%%time\n', '%%capture out\n', '\n%%capture\n%%time\n'])
def test_a_cell_that_runs_below_a_magic_counts(head):
    """As it does in the notebook. What a shell gets does not."""
    found = program.definitions(NotebookCell(f'{head}import os\ndef f():\n    return 3\n', 1))
    assert [text.partition('\n')[0] for _, text in found] == ['import os', 'def f():']
    assert found[0][0] == head.count('\n') + 1
    assert program.definitions(NotebookCell('%%bash\nimport os\n', 1)) == ()


def test_commands_within_functions_do_not_cost_them():
    source = 'def f():\n    !ls -la \\\n        /tmp\n    %timeit 1\n    return 3\n\ndef g():\n    !ls\n'
    found = program.definitions(NotebookCell(source, 1))
    assert [line for line, _ in found] == [1, 7]
    namespace = {}
    exec(found[0][1], namespace)
    assert namespace['f']() == 3


def test_line_numbers_are_kept():
    cell = NotebookCell('print(1)\n\ndef f():\n    pass\nprint(2)', 1)
    assert program.definitions(cell) == ((3, 'def f():\n    pass\n'),)
    cell = NotebookCell('import a; print(1); import b', 1)
    assert program.definitions(cell) == ((1, 'import a\n'), (1, 'import b\n'))


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
        ('# Exercise 90.1: a talker\nclass Talker: pass\nprint("mine")', True),
    ]
    assert made.cells[1]['label'] == 'Exercise 90.1'


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


@pytest.mark.parametrize('copy', ['# class Talker: pass', 'pass', 'class Talker: pass\nx = 1'])
def test_a_copy_that_is_no_answer_does_not_matter(copy):
    """A try that was commented out, what was given, the same once more."""
    stub = program.stub_digest('pass')
    answer = small.cell('class Talker: pass\nx = 1')
    for cells in ((small.cell(copy), answer), (answer, small.cell(copy))):
        assert 'x = 1' in build(*cells, stub=stub).cells[-1]['source']


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
        build(small.cell('class Talker: pass'), NotebookCell('# Exercise 90.1: copy\nclass Talker: pass', 5))


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
