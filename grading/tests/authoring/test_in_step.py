"""``build --check`` finds every way in which a generated file and its source can part."""

import json

import pytest

from grading.authoring import in_step
from grading.authoring.chapter_errors import ChapterErrors
from grading.tests.authoring.conftest import write
from grading.tests.authoring.sources import TINY

SOLVED, LEARNER, LIST = 'solutions/07_tiny.ipynb', 'notebooks/07_tiny.ipynb', 'helpers/checks/exercises.json'


def edit(tree, name, change):
    """Change a JSON file in place, in the layout that it has."""
    path = tree.root / name
    data = json.loads(path.read_text())
    change(data)
    indent = 2 if name == LIST else 1
    path.write_text(json.dumps(data, indent=indent, ensure_ascii=False) + '\n')


def test_what_was_just_built_is_in_step(built):
    assert in_step.drift(built) == []
    for name in (SOLVED, LEARNER, LIST):
        edit(built, name, lambda data: None)  # the editing itself is no drift
    assert in_step.drift(built) == []


@pytest.mark.parametrize(
    ('name', 'change', 'message'),
    [
        (SOLVED, lambda nb: nb['cells'][3]['source'].append('\n# edited'), 'differs from its source in the source'),
        (SOLVED, lambda nb: nb['cells'][5]['metadata'].clear(), 'differs from its source in the metadata'),
        (SOLVED, lambda nb: nb['cells'][0].update(id='other'), f'{SOLVED} has other cells'),
        (SOLVED, lambda nb: nb['cells'].pop(), f'{SOLVED} has other cells'),
        (
            SOLVED,
            lambda nb: nb['cells'][1].update(execution_count=None),
            f'{SOLVED} has cells that were never executed',
        ),
        (SOLVED, lambda nb: nb['metadata']['language_info'].update(version='3.9'), "in the notebook's metadata"),
        (
            SOLVED,
            lambda nb: nb['cells'][1]['outputs'].append(
                {'output_type': 'stream', 'name': 'stdout', 'text': 'x' * 1_000_000}
            ),
            f'{SOLVED} is larger than 1000 kB',
        ),
        (LEARNER, lambda nb: nb['cells'][3]['source'].append('\n# edited'), f'{LEARNER} is not what its source gives'),
        (LEARNER, lambda nb: nb['cells'][1].update(execution_count=1), f'{LEARNER} is not what its source gives'),
        (LEARNER, lambda nb: nb['cells'][1]['metadata'].update(a=1), f'{LEARNER} is not what its source gives'),
        (LIST, lambda data: data['exercises'][0].update(points=20), f'{LIST} is not what its source gives'),
        (LIST, lambda data: data['exercises'].clear(), f'{LIST} is not what its source gives'),
    ],
)
def test_an_edited_file_is_found(built, name, change, message):
    edit(built, name, change)
    (line,) = in_step.drift(built)
    assert message in line


@pytest.mark.parametrize('name', [SOLVED, LEARNER, LIST])
def test_a_missing_file_is_found(built, name):
    (built.root / name).unlink()
    assert in_step.drift(built) == [f'{name} is missing']


def test_a_damaged_notebook_is_found(built):
    (built.root / SOLVED).write_text('{')
    (line,) = in_step.drift(built)
    assert line.startswith(f'{SOLVED} cannot be read')


def test_an_edited_source_is_found(built):
    write(built, TINY.replace('Some prose.', 'Other prose.'))
    assert [line.split()[0] for line in in_step.drift(built)] == [SOLVED, LEARNER]


def test_a_changed_solution_is_found_in_the_solved_notebook_only(built):
    write(built, TINY.replace('2 * number', 'number * 2'))
    assert [line.split()[0] for line in in_step.drift(built)] == [SOLVED]


def test_a_notebook_without_a_source_is_found(built):
    (built.notebooks / '09_gone.ipynb').write_text('{}')
    assert in_step.drift(built) == ['notebooks/09_gone.ipynb has no source']


def test_mistakes_in_a_source_come_first(built):
    write(built, TINY.replace(':points: 10\n', ''))
    with pytest.raises(ChapterErrors, match='without points'):
        in_step.drift(built)
