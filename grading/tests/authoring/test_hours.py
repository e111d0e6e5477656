"""The hours that a chapter promises come from one rule of thumb, which CONTRIBUTING.md gives."""

import re

import pytest

from grading.authoring import chapter, chapter_build
from helpers import paths

WORDS, CELLS, POINT = 150, 2, 1.2  # words and cells of code in a minute, minutes for a point
NUMBERS = ('zero', 'one', 'two', 'three', 'four', 'five', 'six', 'seven', 'eight')
COURSE = chapter_build.CourseFolders(paths.ROOT)


def estimated(cells):
    """Hours."""
    prose = [re.sub(r'<[^>]*>|https?://\S+', '', cell.split.stub) for cell in cells if cell.kind == 'markdown']
    words = sum(len(text.split()) for text in prose)
    run = sum(cell.kind == 'code' for cell in cells)
    points = sum(int(points) for text in prose for points in re.findall(r'\((\d+) points\)', text))
    return (words / WORDS + run / CELLS + points * POINT) / 60


@pytest.mark.parametrize('path', chapter.sources(COURSE.solutions), ids=lambda path: path.stem)
def test_the_hours_of_a_chapter_follow_the_rule(path):
    cells = chapter.read(path).cells
    told = re.search(r'\*\*Time\.\*\* About (\w+) hours', '\n'.join(cell.source for cell in cells))[1]
    assert abs(NUMBERS.index(told) - estimated(cells)) <= 1
