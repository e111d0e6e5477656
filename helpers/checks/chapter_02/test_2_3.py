"""Visible tests of exercise 2.3, an interface."""

import pytest

from helpers.checks.chapter_02 import builds
from helpers.runner import expect

pytestmark = pytest.mark.exercise('2.3')


def test_fields(learner):
    """The package builds, and Charge and Dock have the fields of the specification, in its order.

    A field is a type, a space and a name. In a .srv file, `---` divides the request from the response.
    """
    found = {key: [f'{kind} {name}' for name, kind in value] for key, value in builds.interface(learner).items()
             if isinstance(value, list)}
    station, answer = ['string station', 'float speed'], ['boolean docked', 'string message']
    expect((found['request'], found['response']) != (answer, station),
           'Request and response of Dock are exchanged: what stands above `---` is the request.')
    for key, what, wanted in (
        ('msg', 'Charge', ['std_msgs/Header header', 'uint8 percent', 'boolean charging']),
        ('request', 'the request of Dock', station), ('response', 'the response of Dock', answer),
    ):
        expect(found[key] == wanted, f'The fields of {what} are {found[key]}, expected {wanted}.')
