"""An exercise's cell in which its learner also tries the answer."""

import pytest

from helpers.exercises import program, trials
from helpers.exercises.notebooks import NotebookCell
from helpers.runner.learner import Learner
from helpers.tests import small

ANSWER = 'X = 1\nclass Talker:\n    pass\n'


def parts(source):
    return [(part.line, part.text, part.required) for part in trials.parts(source, ['Talker']) if not part.left_out]


@pytest.mark.parametrize(
    'source',
    [
        ANSWER,
        f'print(0)\n{ANSWER}',
        f'{ANSWER}\nimport os\n\ndef helper():\n    return 3\nY = 2\n',
        f'{ANSWER}Talker = decorated(Talker)\n',
        f'{ANSWER}pass\n# the end',
        'class Listener:\n    pass\nprint(1)',  # the name is in another cell
        'if True:\n    class Talker: pass\n',
        f'{ANSWER}' + 'print(1)\n' * 1000,
    ],
)
def test_an_answer_without_a_trial_is_one_part(source):
    assert parts(source) == [(1, source, True)]


def test_each_trial_is_a_part_of_its_own():
    """What comes between is needed, and so is a name that is bound anew; lines keep their numbers."""
    source = f'{ANSWER}\nprint(Talker)\n@some\ndef f():\n    pass\nassert f()\nTalker = better(Talker)\nT["x"] = 1\n'
    assert parts(source) == [
        (1, ANSWER, True),
        (5, 'print(Talker)\n', False),
        (6, '@some\ndef f():\n    pass\n', True),
        (9, 'assert f()\n', False),
        (10, 'Talker = better(Talker)\n', True),
        (11, 'T["x"] = 1\n', False),
    ]


@pytest.mark.parametrize(
    'trial',
    [
        'with spinning(Talker()):\n    print(1)',
        'with spinning(Talker()), timeline() as chart:\n    pass',
        'spin_for(1, node)',
        'value = wait_for(lambda: heard)',
        'for _ in range(3):\n    spin_for(1)',
        'simulator = background("ros2 run turtlesim turtlesim_node")',
        'rclpy.spin(Talker())',
        'for _ in range(9):\n    rclpy.spin_once(node, timeout_sec=0.5)',
        'executor.spin_until_future_complete(future)',
        'time.sleep(5)',
        'answer = client.call(Trigger.Request())',
        'found = client.wait_for_service(timeout_sec=5)',
    ],
)
def test_what_waits_is_left_out(trial):
    assert parts(f'{ANSWER}{trial}\nprint(2)') == [(1, ANSWER, True), (trial.count('\n') + 5, 'print(2)', False)]
    cell = NotebookCell(f'# Exercise 90.1: a talker\n{ANSWER}{trial}', 1)
    (note,) = program.build([cell], small.exercise()).notes
    first = trial.partition('\n')[0]
    assert f'line 5: `{first}` was left out' in note


def test_what_only_a_program_by_itself_does_is_not_mentioned():
    main = "if __name__ == '__main__':\n    rclpy.spin(Talker())\n"
    assert parts(f'{ANSWER}{main}') == [(1, ANSWER, True), (4, main, False)]
    cell = NotebookCell(f'# Exercise 90.1: a talker\n{ANSWER}{main}', 1)
    assert program.build([cell], small.exercise()).notes == []


def test_a_function_that_waits_is_known_by_what_it_calls():
    """Wherever it stands: above, below or in another cell, and over any number of calls."""
    source = f'{ANSWER}def main():\n    rclpy.spin(Talker())\n\nmain()\nprint(2)\ntry_it()\nshow(Talker)\n'
    others = [
        'def show(kind):\n    return look(kind)\n',
        'def look(kind):\n    with spinning(kind()):\n        pass\n',
        'def try_it():\n    return try_it\n',
    ]
    left_out = [part.text for part in trials.parts(source, ['Talker'], others) if part.left_out]
    assert left_out == ['main()\n', 'show(Talker)\n']
    cells = [NotebookCell(text, 1) for text in (*others, f'# Exercise 90.1: a talker\n{source}')]
    assert len(program.build(cells, small.exercise()).notes) == 2
    assert len(program.build(cells[::-1], small.exercise()).notes) == 2


@pytest.mark.parametrize(
    ('source', 'expected'),
    [
        (
            'class Talker: pass\nprint(1); print(2)',
            [(1, 'class Talker: pass\n', True), (2, 'print(1); print(2)', False)],
        ),
        ('class Talker: pass\nprint(1); X = 2', [(1, 'class Talker: pass\n', True), (2, 'print(1); X = 2', True)]),
        ('class Talker: pass; print(1)', [(1, 'class Talker: pass; print(1)', True)]),
        ('Talker = 1; spin_for(1)', [(1, 'Talker = 1; spin_for(1)', True)]),
        (
            'Talker = 1\nprint(1); spin_for([\n1]); print(\n2)\nprint(3)',
            [(1, 'Talker = 1\n', True), (5, 'print(3)', False)],
        ),
    ],
)
def test_statements_in_one_line_stay_together(source, expected):
    assert parts(source) == expected


def test_a_text_is_read_from_a_cell_with_a_trial():
    """It stands there as it is, and nothing of the cell runs."""
    source = f'{small.cell("").source}CONFIG = "rate: 1"\nPACKAGE = {{"a.py": "x = 1"}}\nprint(CONFIG)\n1 / 0\n'
    made = program.build([NotebookCell(source, 1)], small.exercise(names=('CONFIG', 'PACKAGE')))
    learner = Learner.__new__(Learner)
    learner.program = made.as_dict()
    assert learner.text('CONFIG') == 'rate: 1' and learner.files() == {'a.py': 'x = 1'}
