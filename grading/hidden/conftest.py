"""What the hidden tests share."""

import random

import pytest


@pytest.fixture
def draw(request):
    """Draws a test's inputs: random, and the same for every learner and every run."""
    return random.Random(request.node.nodeid.rpartition('/')[2])
