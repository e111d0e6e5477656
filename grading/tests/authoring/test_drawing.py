"""The drawing module: what is found to be unreadable, and where labels go."""

import xml.etree.ElementTree as ElementTree
from itertools import product

import pytest

from grading.authoring.drawing import Lanes, Plot, Sheet, faults, metrics, queue

SVG = '{http://www.w3.org/2000/svg}'


@pytest.fixture
def sheet():
    return Sheet('A drawing', height=200)


@pytest.mark.parametrize(
    ('put', 'message'),
    [
        (lambda sheet: sheet.text(10, 100, 'to the left of the sheet'), 'is not on the sheet'),
        (lambda sheet: sheet.text(690, 100, 'to the right of it'), 'is not on the sheet'),
        (lambda sheet: sheet.text(350, 198, 'below'), 'is not on the sheet'),
        (lambda sheet: sheet.text(350, 100, 'small', size=11), 'at least 12'),
        (lambda sheet: sheet.text(330, 60, 'a word') and sheet.text(350, 64, 'another'), "'a word' and 'another' over"),
        (lambda sheet: sheet.box(300, 80, 40, 30, 'longer than its box'), 'lies on the border of the box'),
        (lambda sheet: sheet.text(330, 60, 'a word') and sheet.line([(300, 40), (360, 80)]), 'lies on the line'),
        (lambda sheet: sheet.box(650, 80, 60, 30), 'the box at 650, 80 is not on the sheet'),
    ],
)
def test_what_cannot_be_read_is_found(sheet, put, message):
    sheet.text(350, 150, 'far away from all')
    assert faults.found(sheet) == []
    put(sheet)
    (fault,) = faults.found(sheet)
    assert message in fault


@pytest.mark.parametrize(
    ('end', 'side'),
    [
        *product([(500, 100), (200, 100)], ['', 'above', 'below']),
        *product([(350, 20), (350, 180)], ['', 'left', 'right']),
        *product([(450, 30), (200, 150)], ['', 'above', 'below', 'left', 'right']),
    ],
)
def test_a_label_is_beside_its_arrow_and_on_the_side_that_is_asked_for(sheet, end, side):
    start = (350.0, 100.0)
    sheet.arrow(start, end, 'label', side=side)
    assert faults.found(sheet) == []
    (text,) = sheet.texts
    middle = (start[0] + end[0]) / 2, (start[1] + end[1]) / 2
    x, y = (text.left + text.right) / 2 - middle[0], (text.top + text.bottom) / 2 - middle[1]
    assert {'': True, 'above': y < 0, 'below': y > 0, 'left': x < 0, 'right': x > 0}[side]


def test_an_arrow_between_boxes_begins_and_ends_at_their_borders(sheet):
    one, other = sheet.box(100, 80, 50, 40), sheet.box(400, 80, 50, 40)
    sheet.arrow(one, other)
    (line,) = sheet.lines
    assert line[0] == (150, 100)
    assert 390 < line[-1][0] < 400 and line[-1][1] == 100  # it ends inside of its head


def test_marks_are_set_and_not_shown(sheet):
    sheet.text(350, 100, 'call `spin()` **now** & <then>')
    (text,) = ElementTree.fromstring(sheet.svg('x', 'y')).iter(f'{SVG}text')
    assert ''.join(text.itertext()) == 'call spin() now & <then>'
    assert [span.text for span in text if 'monospace' in span.get('font-family', '')] == ['spin()']
    assert [span.text for span in text if span.get('font-weight')] == ['now']


def test_a_wide_text_is_known_to_be_wide():
    assert metrics.width('iiii', 14) < metrics.width('aaaa', 14) < metrics.width('WWWW', 14)
    assert metrics.width('wide', 14) < metrics.width('**wide**', 14)
    assert metrics.width('`ill`', 14) == metrics.width('`www`', 14)


def test_a_queue_has_a_cell_for_each_text(sheet):
    box = queue(sheet, 100, 50, ['1', '2', ''], cell=40)
    assert (box.w, len(sheet.boxes), [text.text for text in sheet.texts]) == (120, 3, ['1', '2'])


def test_lanes_and_plots_put_values_in_their_places(sheet):
    lanes = Lanes(sheet, ['thread'], left=100, right=612, end=10)
    assert [lanes.x(time) for time in (0, 5, 10)] == [100, 350, 600]
    plot = Plot(sheet, 80, 100, 500, 50, (0, 10), (0, 1), (), (), 'x', 'y')
    assert (plot.at(0, 0), plot.at(10, 1)) == ((80, 150), (580, 100))
