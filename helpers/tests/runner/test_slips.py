"""What an answer's text shows of slips: one sentence for each, and none where it shows nothing."""

import pytest

from helpers.runner import slips
from helpers.runner.explanations import explain

ANSWER = """
OUTSIDE = 3
class Beacon(Node):
    LIMIT = 3

    def __init__(self):
        super().__init__('beacon')
        self.count = 0
        self.publisher = self.create_publisher(String, 'beacon', 10)
        timer = self.create_timer(0.25, self.on_timer)

    def on_timmer(self):
        text = f'alive {self.count}'
        self.rounds += 1

    def on_reset(self, message):
        self.start = self.get_clock().now()
"""


@pytest.mark.parametrize(
    ('kind', 'text', 'said'),
    [
        (
            'NameError',
            "name 'publisher' is not defined",
            'Your class has `self.publisher`: is `self.` missing before it?',
        ),
        (
            'UnboundLocalError',
            "cannot access local variable 'count' where it is not associated with a value",
            'Your class has `self.count`: is `self.` missing before it?',
        ),
        (
            'UnboundLocalError',
            "local variable 'count' referenced before assignment",  # of Python 3.10
            'Your class has `self.count`: is `self.` missing before it?',
        ),
        ('UnboundLocalError', "cannot access local variable 'text' where it is not associated with a value", ''),
        (
            'AttributeError',
            "'Beacon' object has no attribute 'timer'",
            '`timer = …` makes a variable that the function forgets at its end: write `self.timer = …`.',
        ),
        (
            'AttributeError',
            "'Beacon' object has no attribute 'on_timer'",
            'Nothing in your code sets `on_timer`; there is `on_timmer`.',
        ),
        (
            'AttributeError',
            "'Beacon' object has no attribute 'pub'",
            'Nothing in your code sets `pub`; there is `publisher`.',
        ),
        ('AttributeError', "'Beacon' object has no attribute 'speed'", 'Nothing in your code sets `speed`.'),
        ('AttributeError', "'Beacon' object has no attribute 'OUTSIDE'", 'Nothing in your code sets `OUTSIDE`.'),
        (
            'AttributeError',
            "'Beacon' object has no attribute 'create_publsher'",
            'Nothing in your code sets `create_publsher`; there is `create_publisher`.',
        ),
        (
            'AttributeError',
            "'Beacon' object has no attribute 'count'",
            '`self.count` is asked for before `__init__` has set it, or `__init__` does not set it each time.',
        ),
        (
            'AttributeError',
            "'Beacon' object has no attribute 'start'",
            'Only `on_reset` sets `self.start`, and it has not run yet. Set a first value in `__init__`.',
        ),
        (
            'AttributeError',
            "'Beacon' object has no attribute 'rounds'",
            '`self.rounds` has no value that could be changed: set a first one in `__init__`.',
        ),
        ('AttributeError', "'Other' object has no attribute 'timer'", ''),
        ('NameError', "name 'textt' is not defined", 'No cell that the check uses defines `textt`. Is `text` meant?'),
        ('NameError', "name 'Sting' is not defined", 'No cell that the check uses defines `Sting`. Is `String` meant?'),
        (
            'NameError',
            "name 'TransformBroadcster' is not defined",
            'No cell that the check uses defines `TransformBroadcster`. Is `TransformBroadcaster` meant?',
        ),
        ('NameError', "name 'lenn' is not defined", 'No cell that the check uses defines `lenn`. Is `len` meant?'),
        (
            'NameError',
            "name 'node' is not defined",  # a variable that was never made, and not the class Node
            'No cell that the check uses defines `node`. Is it a typing error, or is a cell gone that came with the '
            'chapter? A fresh copy of the notebook has all of them.',
        ),
        (
            'AttributeError',
            "module 'rclpy' has no attribute 'Node'",
            'It is elsewhere. Write: from rclpy.node import Node',
        ),
        ('AttributeError', "module 'rclpy' has no attribute 'nobody'", ''),
    ],
)
def test_a_slip_in_the_answer_is_named(kind, text, said):
    assert explain(kind, text, answer=ANSWER) == said


@pytest.mark.parametrize('name', ['_init_', '__init', '__int__', 'init'])
def test_a_misspelt_constructor(name):
    text = "Node.__init__() missing 1 required positional argument: 'node_name'"
    said = explain('TypeError', text, answer=ANSWER.replace('__init__(self)', f'{name}(self)'))
    assert said == f'Is `{name}` the constructor? It is written `__init__`, with two underscores on each side.'
    assert explain('TypeError', text, answer=ANSWER) == "It takes the name of the node: super().__init__('name')."


@pytest.mark.parametrize('text', ['class A(', 'x = 1\0', 'a' + '.b' * 100_000, '(' * 5000, r"'\d'"])
def test_any_text_can_be_looked_at(text):
    assert slips.missing_self('x', text) == slips.unset_attribute('x', text) == slips.misspelt_constructor(text) == ''
