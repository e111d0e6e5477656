"""Exercises whose answer is a package: the directive, the two forms of the cell, and what an execution leaves."""

import pytest

from grading.authoring import chapter, execution, notebook_pair, rules
from grading.authoring.chapter_errors import AuthoringError
from grading.tests.authoring.sources import EXERCISE, TINY
from helpers.exercises import manifest

PACKAGE = """```{code-cell} ipython3
# BEGIN SOLUTION
PACKAGE = {
'setup.py': '''
%s''',
}
# END SOLUTION
```

"""


def package(tree, folder='my_ws/src/tiny', names='PACKAGE', lines=1):
    """The tiny chapter, whose exercise asks for a package."""
    exercise = EXERCISE.partition('```{code-cell}')[0]
    exercise = exercise.replace(':names: double', f':names: {names}\n:folder: {folder}')
    text = TINY.replace(EXERCISE, exercise + PACKAGE % ('# a line\n' * lines))
    path = tree.solutions / '07_tiny.md'
    path.write_text(text)
    return path


def test_an_exercise_whose_answer_is_a_package(tree):
    made = chapter.read(package(tree, lines=90))
    assert not rules.check([made])
    (exercise,) = made.exercises()
    assert exercise.folder == 'my_ws/src/tiny' and exercise.names == ('PACKAGE',)
    (cell,) = [cell for cell in made.cells if cell.card]
    assert cell.split.stub.splitlines() == [
        '# Exercise 7.1: twice as much',
        '# Your answer is the folder my_ws/src/tiny: there is nothing to write into this cell.',
    ]
    assert manifest.load(_written(tree, exercise))[exercise.id] == exercise


def _written(tree, exercise):
    path = tree.solutions / 'exercises.json'
    path.write_text(manifest.dumps([exercise]))
    return path


@pytest.mark.parametrize(
    'wrong', [{'folder': '../x_ws/src/tiny'}, {'folder': '/tmp'}, {'folder': 'src/tiny'}, {'names': 'double'}]
)
def test_a_folder_that_cannot_be(tree, wrong):
    with pytest.raises(AuthoringError, match='write :folder: NAME_ws/src/PACKAGE and :names: PACKAGE'):
        chapter.read(package(tree, **wrong))


def test_an_execution_leaves_somebodys_package_as_it_was(tree, monkeypatch):
    made, mine = chapter.read(package(tree)), tree.notebooks / 'my_ws/src/tiny/setup.py'

    class Client:
        def __init__(self, *args, **options):
            pass

        def execute(self, **options):
            assert not mine.exists()
            mine.parent.mkdir(parents=True)
            mine.write_text('solution')

    monkeypatch.setattr(execution, '_Client', Client)
    notebook = notebook_pair.solved(made)
    tree.notebooks.mkdir(exist_ok=True)
    execution.execute(notebook, made, tree.notebooks)
    assert not mine.parent.exists()
    mine.parent.mkdir(parents=True)
    mine.write_text('mine')
    execution.execute(notebook, made, tree.notebooks)
    assert mine.read_text() == 'mine' and [path.name for path in mine.parents[1].iterdir()] == ['tiny']
    aside = tree.notebooks / 'my_ws/tiny_put_aside'
    aside.mkdir()
    with pytest.raises(AuthoringError, match='move it back'):
        execution.execute(notebook, made, tree.notebooks)
    assert mine.read_text() == 'mine' and aside.is_dir()
