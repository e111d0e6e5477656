"""The map of chapters and stacks: its names, its lines, and numbers that do not exist."""

import pytest

from helpers.show.route_map import route_map


def test_one_line_for_each_chapter_that_a_stack_needs():
    picture = route_map(['Topics', 'Services', 'Actions'], {'Driving': (1, 3), 'Arms': (2,)})
    assert picture._repr_png_().startswith(b'\x89PNG')
    assert repr(picture) == 'Driving: Topics, Actions\nArms: Services'
    axes = picture.figure.axes[0]
    assert {text.get_text() for text in axes.texts} == {'Topics', 'Services', 'Actions', 'Driving', 'Arms'}
    places = {text.get_text(): text.get_position()[1] for text in axes.texts}
    ends = [(line.get_ydata()[0], line.get_ydata()[-1]) for line in axes.lines]
    assert ends == [
        (places['Topics'], places['Driving']),
        (places['Actions'], places['Driving']),
        (places['Services'], places['Arms']),
    ]


def test_a_chapter_that_there_is_not():
    with pytest.raises(ValueError, match='there are 1 chapters, and no number 2'):
        route_map(['Topics'], {'Driving': (1, 2)})
