"""After a restart of the kernel: names that are missing are explained, and `resume` brings them back."""

import nbformat
import pytest

CELLS = [
    'import math\nprint("a demonstration")',
    'class Talker:\n    """Speaks."""\n    words = "hello"\n\n\ntalker = Talker()\nraise RuntimeError("demonstration")',
    'HALF = 0.5\nunknown = nobody_knows\nwords = talker.words',
    'place = open("made", "w")\nprint("a long output")',
    '# Exercise 90.1: a talker\ndef answer():\n    return HALF',
    'from helpers import resume; resume()',
    'print(LATER)',
    'LATER = 1',
]
WHOLE = 3  # has the tag
CONTINUE = CELLS[5]


@pytest.fixture
def folder(tmp_path):
    notebook = nbformat.v4.new_notebook(cells=[nbformat.v4.new_code_cell(source) for source in CELLS])
    notebook.cells[WHOLE].metadata['tags'] = ['resume']
    nbformat.write(notebook, tmp_path / '90_small.ipynb')
    (tmp_path / '00_broken.ipynb').write_text('{')
    return tmp_path


def edit(notebook, old, new):
    """Replace a text in the cells of a notebook's file."""
    content = nbformat.read(notebook, 4)
    for cell in content.cells:
        cell.source = cell.source.replace(old, new)
    nbformat.write(content, notebook)


def test_what_the_cells_above_define_comes_back(folder, kernel):
    told = kernel.ok(CONTINUE).stdout
    assert 'a demonstration' not in told and 'a long output' not in told
    assert told.splitlines() == [
        'Back from the 5 cells above: HALF, Talker, answer, math, place.',
        "Not brought back: a part of cell 3 (NameError: name 'nobody_knows' is not defined).",
    ]
    assert kernel.value('answer(), Talker.words, (HALF, math.floor(2.5)), "talker" in globals()') == (
        0.5,
        'hello',
        (0.5, 2),
        False,
    )
    assert (folder / 'made').exists()
    assert kernel.value('__import__("helpers").cell_text("90.1")') == CELLS[4]
    kernel.ok('talker = Talker()')
    assert kernel.ok(CONTINUE).stdout.startswith('Back from the 5 cells above: words.'), 'now there is a talker'
    assert kernel.ok(CONTINUE).stdout.startswith('Nothing was missing: all that the 5 cells above define is there.')


def test_a_cell_that_was_never_saved_is_told(folder, kernel):
    assert 'save the notebook (Ctrl+S)' in kernel.ok('from helpers import resume\nresume()').stdout


def test_what_a_demonstration_makes_is_told_after_resume(folder, kernel):
    kernel.ok('%load_ext helpers.exercises.cell_errors\n' + CONTINUE)
    kernel.ok(CONTINUE)
    assert kernel.run('talker.words').stdout == (
        '`talker` comes from a cell above that has run in part, for `resume`: class Talker:\n'
        'It is part of a demonstration: run that cell again.\n'
    )


def test_an_object_of_another_cell_is_told(folder, kernel):
    """Names are used again: who leaves a cell out has what an earlier one made."""
    notebook = folder / '90_small.ipynb'
    edit(notebook, 'print(LATER)', 'print(place.name)')
    kernel.ok('%load_ext helpers.exercises.cell_errors\nplace = 3')
    missed = kernel.run('print(place.name)')
    assert missed.error == 'AttributeError' and missed.stdout == (
        '`place` is here what an earlier cell has made. The cell above that makes it anew has not run since the kernel '
        'started: place = open("made", "w")\n'
    )
    edit(notebook, 'print(place.name)', 'assert place > 5')
    assert kernel.run('assert place > 5').stdout.startswith('`place` is here what an earlier cell has made.')
    assert kernel.run('raise AttributeError("of place.name")').stdout == ''
    invalid = 'assert place < 5; raise type("InvalidHandle", (Exception,), {})'
    edit(notebook, 'assert place > 5', invalid)
    assert 'has been destroyed' in (said := kernel.run(invalid).stdout) and '`place` is here what an earlier' in said
    assert kernel.run(CELLS[WHOLE].replace('place', 'raise OSError; place')).error == 'OSError'
    edit(notebook, 'place = open', 'raise OSError; place = open')
    said = kernel.run(invalid).stdout
    assert 'The cell above that makes it anew ended with an error: raise OSError; place' in said
    edit(notebook, 'raise OSError; place = open', 'place = open')
    edit(notebook, CELLS[WHOLE], f'{CELLS[WHOLE]}\nraise OSError')
    late = f'{CELLS[WHOLE]}\nraise OSError'  # what stands before the error has been made
    assert kernel.run(late).error == 'OSError' and late in [cell.source for cell in nbformat.read(notebook, 4).cells]
    assert '`place`' not in kernel.run(invalid).stdout
    kernel.ok(CELLS[WHOLE])
    assert '`place`' not in kernel.run(invalid).stdout


def test_a_module_is_the_same_in_whatever_cell_it_is_imported(folder, kernel):
    notebook = folder / '90_small.ipynb'
    edit(notebook, 'print(LATER)', "math.floor('x')")
    kernel.ok('%load_ext helpers.exercises.cell_errors\nimport math')
    missed = kernel.run("math.floor('x')")
    assert missed.error == 'TypeError' and '`math` is here' not in missed.stdout


def test_a_cell_that_ran_with_another_text_is_not_said_to_have_been_left_out(folder, kernel):
    notebook = folder / '90_small.ipynb'
    identity = nbformat.read(notebook, 4).cells[WHOLE].id
    edit(notebook, 'print(LATER)', 'print(place.name)')
    kernel.ok(
        '%load_ext helpers.exercises.cell_errors\nplace = 3\nfrom helpers.kernel import journal\n'
        f'journal.cells[-1] = journal.cells[-1]._replace(id={identity!r})'
    )
    assert '`place`' not in kernel.run('print(place.name)').stdout
    edit(notebook, 'place = open', 'place = added = open')
    edit(notebook, 'print(place.name)', 'print(added)')
    assert kernel.run('print(added)').stdout == (
        '`added` comes from a cell above that was changed since it ran: place = added = open("made", "w")\n'
        'Run it again.\n'
    )


def test_a_missing_name_says_where_it_comes_from(folder, kernel):
    kernel.ok('%load_ext helpers.exercises.cell_errors')
    missed = kernel.run(CELLS[4] + '\nanswer()')
    assert missed.error == 'NameError' and missed.stdout == '', 'this cell is in no notebook'
    notebook = folder / '90_small.ipynb'
    edit(notebook, 'print(LATER)', 'Talker()')
    missed = kernel.run('Talker()')
    assert missed.error == 'NameError'
    assert missed.stdout.startswith(
        '`Talker` comes from a cell above that has not run since the kernel started: class Talker:\n'
    )
    assert 'from helpers import resume; resume()' in missed.stdout
    edit(notebook, 'LATER = 1', 'talker.words')
    assert kernel.run('talker.words').stdout.endswith('It is part of a demonstration: run that cell again.\n')
    assert kernel.run('undefined_anywhere').stdout == ''
    assert kernel.run('spin_for(1)').stdout == '`spin_for` belongs to the course. Write: from helpers import spin_for\n'
    missed = kernel.run('qos_profile_sensor_data')
    assert 'Write: from rclpy.qos import qos_profile_sensor_data\n' in missed.stdout
    kernel.ok(CONTINUE)
    kernel.ok('Talker()')
