"""Figures: the directive in the chapters, the pictures that are kept, and mistakes in both."""

import re
import xml.etree.ElementTree as ElementTree

import pytest

from grading.authoring import chapter_build, figures, in_step, notebook_pair
from grading.authoring.chapter_errors import ChapterErrors
from grading.authoring.drawing import faults, style
from grading.tests.authoring.conftest import make_without_kernel, write
from grading.tests.authoring.sources import EXERCISE, TINY, line_of
from helpers import paths
from helpers.exercises import cell_ids
from helpers.tests.show.contrast import contrast

COURSE = chapter_build.CourseFolders(paths.ROOT)
DRAWING = """from grading.authoring.drawing import Sheet

ALT = 'A box with a word.'


def draw():
    sheet = Sheet('A box', height=100)
    sheet.box(20, 20, 100, 40, 'word')
    return sheet
"""
DIRECTIVE = """```{figure} a_box
A box, as it is.
```

"""
WITH_FIGURE = TINY.replace('Some prose.\n\n', f'Some prose.\n\n{DIRECTIVE}')


@pytest.fixture
def illustrated(tree):
    """The tiny course with one figure, built."""
    write(tree, WITH_FIGURE)
    draw(tree, DRAWING)
    make_without_kernel(tree)
    return tree


def draw(tree, text, name='a_box'):
    """Write the file of a figure and return its path."""
    tree.figures.mkdir(exist_ok=True)
    path = tree.figures / f'{name}.py'
    path.write_text(text)
    return path


def shown(notebook):
    """The text of the cell with the figure."""
    (cell,) = (cell for cell in notebook.cells if 'a_box' in cell.source)
    return cell


def test_both_notebooks_show_the_one_picture(illustrated):
    (chapter,) = chapter_build.read_all(illustrated)
    learner, solved = (shown(form(chapter)) for form in (notebook_pair.learner, notebook_pair.solved))
    assert '![A box with a word.](figures/a_box.svg)\n\n*A box, as it is.*\n' in learner.source
    assert '](../notebooks/figures/a_box.svg)' in solved.source
    for notebook, cell in ((illustrated.notebooks, learner), (illustrated.solutions, solved)):
        address = re.search(r'\]\((\S+)\)', cell.source)[1]
        assert (notebook / address).resolve() == illustrated.pictures.resolve() / 'a_box.svg'
    assert (illustrated.pictures / 'a_box.svg').is_file()
    assert in_step.drift(illustrated) == []


def test_the_learners_cell_counts_as_given(illustrated):
    """So that a learner who changes nothing in it gets the new version's cell."""
    (chapter,) = chapter_build.read_all(illustrated)
    cell = shown(notebook_pair.learner(chapter))
    assert cell_ids.untouched('markdown', cell.source, cell.id)


def test_a_picture_says_what_it_is_without_being_seen(illustrated):
    root = ElementTree.fromstring((illustrated.pictures / 'a_box.svg').read_text())
    assert root.get('role') == 'img'
    names = {child.get('id'): child.text for child in root if child.get('id')}
    assert [names[name] for name in root.get('aria-labelledby').split()] == ['A box', 'A box with a word.']


def test_an_edited_drawing_is_out_of_step_until_it_is_built(illustrated):
    draw(illustrated, DRAWING.replace("'word'", "'words'"))
    assert in_step.drift(illustrated) == ['notebooks/figures/a_box.svg is not what its source gives']
    make_without_kernel(illustrated)
    assert in_step.drift(illustrated) == []
    (illustrated.pictures / 'a_box.svg').unlink()
    assert in_step.drift(illustrated) == ['notebooks/figures/a_box.svg is missing']


def test_the_picture_of_a_figure_that_is_gone_goes(illustrated):
    (illustrated.figures / 'a_box.py').unlink()
    write(illustrated, TINY)
    assert 'notebooks/figures/a_box.svg has no source' in in_step.drift(illustrated)
    make_without_kernel(illustrated)
    assert in_step.drift(illustrated) == [] and list(illustrated.pictures.iterdir()) == []


@pytest.mark.parametrize(
    ('change', 'message'),
    [
        (('{figure} a_box', '{figure} a_bix'), "there is no figure 'a_bix'; draw it in solutions/figures/a_bix.py"),
        (('{figure} a_box', '{figure}'), "a figure cannot be called ''"),
        (('{figure} a_box', '{figure} ../a_box'), "a figure cannot be called '../a_box'"),
        (('A box, as it is.\n', ''), 'the figure a_box has no caption'),
        (('A box, as it is.\n```\n', 'A box, as it is.\n'), 'has no end'),
    ],
)
def test_a_wrong_directive_is_told_with_its_line(illustrated, change, message):
    # Behind the last code cell, so that a directive without an end runs to the end of the text.
    source = TINY + '\n\nMore prose.\n\n' + DIRECTIVE.replace(*change)
    write(illustrated, source)
    with pytest.raises(ChapterErrors) as info:
        chapter_build.read_all(illustrated)
    assert str(info.value).startswith(f'solutions/07_tiny.md:{line_of("{figure}", source)}: ')
    assert message in str(info.value)


def test_a_directive_in_a_card_is_told_with_its_line(illustrated):
    """The directive of the exercise before it takes fewer lines in the notebook than in the source."""
    names = ':names: double\n```\n\n'
    source = TINY.replace(EXERCISE, EXERCISE.replace(names, names + DIRECTIVE.replace('a_box', 'a_bix')))
    write(illustrated, source)
    with pytest.raises(ChapterErrors, match=f'07_tiny.md:{line_of("{figure}", source)}: there is no figure'):
        chapter_build.read_all(illustrated)


@pytest.mark.parametrize(
    ('change', 'message'),
    [
        (("ALT = 'A box with a word.'", ''), 'no alternative text'),
        (('A box with a word.', '  '), 'no alternative text'),
        (('A box with a word.', 'A [box]'), r"ALT has a '\['"),
        (('A box with a word.', r'A\nbox'), 'ALT has a'),
        (('def draw', 'def drawing'), r'no function draw\(\)'),
        (('return sheet', 'return None'), r'draw\(\) returns no Sheet'),
        (('sheet.box(20', 'sheet.bix(20'), "AttributeError: 'Sheet' object has no attribute 'bix'"),
        (('def draw():', 'def draw()'), 'SyntaxError'),
    ],
)
def test_a_wrong_drawing_is_told_where_it_is_placed(illustrated, change, message):
    draw(illustrated, DRAWING.replace(*change))
    line = line_of('{figure}', WITH_FIGURE)
    with pytest.raises(ChapterErrors, match=rf'07_tiny.md:{line}: the figure a_box: {message}.*\(figures/a_box.py:\d'):
        chapter_build.read_all(illustrated)


def test_a_figure_that_no_chapter_shows_is_a_mistake(illustrated):
    draw(illustrated, DRAWING, 'forgotten')
    with pytest.raises(ChapterErrors, match='figures/forgotten.py:1: no chapter shows the figure forgotten'):
        chapter_build.read_all(illustrated)


@pytest.mark.parametrize('path', figures.drawn(COURSE.figures), ids=lambda path: path.stem)
def test_a_figure_of_the_course_can_be_read(path):
    figure = figures.load(path)
    assert faults.found(figure.sheet) == []
    assert figure.sheet.width <= 700
    assert len(figure.svg.encode()) < 40_000
    assert 40 <= len(figure.alt) <= 600


@pytest.mark.parametrize(
    ('ink', 'fill', 'ground'),
    [(style.INK, style.FILL, style.GROUND), (style.DARK_INK, style.DARK_FILL, style.DARK_GROUND)],
    ids=['light', 'dark'],
)
def test_texts_stand_out_from_each_ground(ink, fill, ground):
    assert min(contrast(text, below) for text in ink.values() for below in (ground, *fill.values())) > 4.5


@pytest.mark.parametrize('path', figures.drawn(COURSE.figures), ids=lambda path: path.stem)
def test_on_a_dark_page_no_colour_of_a_figure_stays_light(path):
    svg = figures.load(path).svg
    drawn = set(re.findall(r'(?:fill|stroke)="#[0-9a-f]{6}"', svg))
    changed = {f'{attribute}="{colour}"' for attribute, colour in re.findall(r'\[(\w+)="(#[0-9a-f]{6})"\]', svg)}
    assert drawn == changed


def test_the_same_drawing_gives_the_same_picture():
    for path in figures.drawn(COURSE.figures)[:3]:
        figures._loaded.cache_clear()
        once = figures.load(path).svg
        figures._loaded.cache_clear()
        assert figures.load(path).svg == once


def test_no_reader_gets_the_source_of_a_diagram():
    """JupyterLab would draw Mermaid; GitHub's preview, nbconvert and print show its text."""
    for path in COURSE.notebooks.glob('*.ipynb'):
        assert 'mermaid' not in path.read_text()
