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


NESTED = """
class Ranger(Node):
    def __init__(self, timeout, *, tries=3):
        super().__init__('ranger')
        self.create_subscription(Range, 'range', self.on_range, 10)

        def on_range(self, message):
            self.tries += 1

        def later(future):
            pass

    def on_timeout(self):
        pass

def on_scan(self, scan):
    pass

def steer(x, y):
    def turn(self):
        pass

class Other:
    def __init__(self, speed):
        pass
"""


@pytest.mark.parametrize(
    ('name', 'said'),
    [
        ('on_range', '`def on_range` is inside of `__init__`: move it to the left, so that it belongs to the class.'),
        ('later', '`def later` is inside of `__init__`.'),  # which does not show what is meant
        ('on_scan', '`def on_scan` is outside of the class: move it to the right, so that it belongs to the class.'),
        ('steer', '`steer` is a function outside of your class: write it without `self.`.'),
        ('limit', '`limit` is a function outside of your class: write it without `self.`.'),  # in another cell
        ('turn', 'Nothing in your code sets `turn`.'),
        ('inner', 'Nothing in your code sets `inner`.'),
        ('timeout', '`timeout` is a parameter of `__init__`: write `self.timeout = timeout` there.'),
        ('tries', '`tries` is a parameter of `__init__`: write `self.tries = tries` there.'),
        ('time_out', 'Nothing in your code sets `time_out`; there is `on_timeout`.'),
        ('speed', 'Nothing in your code sets `speed`.'),  # a parameter of another class
        ('on_timeout', ''),
    ],
)
def test_a_method_or_a_value_that_stands_elsewhere(name, said):
    cells = [
        NESTED,
        'def limit(value):\n    def inner():\n        pass',
        'class A:\n    def inner(self):\n        pass',
    ]
    text = f"'Ranger' object has no attribute '{name}'"
    assert explain('AttributeError', text, answer=NESTED, cells=cells) == said


def test_a_variable_that_is_called_like_a_function_of_another_cell():
    told = explain('AttributeError', "'Beacon' object has no attribute 'timer'", answer=ANSWER, cells=['def timer():'])
    assert told.startswith('`timer = …` makes a variable')


def test_a_class_without_a_constructor_may_have_inherited_its_parameter():
    answer = NESTED + '\n\nclass Twice(Ranger):\n    pass'
    told = explain('AttributeError', "'Twice' object has no attribute 'timeout'", answer=answer)
    assert told.startswith('`timeout` is a parameter of `__init__`')


@pytest.mark.parametrize(
    ('name', 'line', 'said'),
    [
        ('create_timer', 'create_timer(0.5, self.on_timer)', True),
        ('get_logger', "get_logger().info('x')", True),
        ('get_logger', "get_logger('x').info('x')", False),  # the function of rclpy.logging
        ('timers', 'timers', False),  # a property, and a likely name of a variable
        ('get_clock', 'get_clock()', False),  # it stands outside of the class
    ],
)
def test_a_method_of_node_without_self(name, line, said):
    answer = f"class Own(Node):\n    def __init__(self):\n        super().__init__('own')\n        {line}\n"
    answer = answer if name != 'get_clock' else 'class Own(Node):\n    pass\n\n\nget_clock()'
    hint = f'`{name}` is a method of Node: is `self.` missing before it?'
    assert (explain('NameError', f"name '{name}' is not defined", answer=answer, lines=[line]) == hint) is said
    plain = explain('NameError', f"name '{name}' is not defined", answer=answer.replace('(Node)', ''), lines=[line])
    assert plain != hint, 'a class without a base is no node'


@pytest.mark.parametrize(
    ('name', 'answer', 'meant'),
    [
        ('string', "string(data='x')", 'String'),
        ('string', "self.create_publisher(string, 'a', 10)", 'String'),
        ('laserscan', "self.create_subscription(laserscan, 'a', print, 10)", 'LaserScan'),
        ('fibonacci', "ActionClient(self, fibonacci, 'a')", 'Fibonacci'),
        ('time', 'time.from_msg(stamp)', 'Time'),
        ('trigger', 'trigger.Request()', 'Trigger'),
        ('durabilitypolicy', 'durabilitypolicy.TRANSIENT_LOCAL', 'DurabilityPolicy'),
        ('node', 'class Own(node):\n    pass', 'Node'),
        ('station', 'class Station:\n    pass\n\n\nstation()', 'Station'),
        ('String', "String(data='x')", ''),  # it is only not imported
        ('Laserscan', 'Laserscan()', ''),  # another sentence tells that
        ('time', 'time.sleep(1)', ''),
        ('node', "node.create_publisher(String, 'a', 10)", ''),
        ('node', 'TransformBroadcaster(node)', ''),
        ('string', 'print(string)', ''),
        ('qos', 'QOS = 1\nqos()', ''),
        ('steer', 'steer()', ''),
    ],
)
def test_a_class_with_a_small_letter(name, answer, meant):
    told = explain('NameError', f"name '{name}' is not defined", answer=answer)
    hint = f'Is `{meant}` meant? The name of a class begins with a capital letter.'
    assert told == hint if meant else 'begins with a capital letter' not in told


def test_a_module_in_the_place_of_a_class():
    text = "module 'time' has no attribute 'from_msg'"
    assert explain('AttributeError', text, answer='import time\ntime.from_msg(stamp)').startswith('Is `Time` meant?')
    assert explain('AttributeError', "module 'time' has no attribute 'slep'", answer='time.slep(1)') == ''


@pytest.mark.parametrize('name', ['_init_', '__init', '__int__', 'init'])
def test_a_misspelt_constructor(name):
    text = "Node.__init__() missing 1 required positional argument: 'node_name'"
    said = explain('TypeError', text, answer=ANSWER.replace('__init__(self)', f'{name}(self)'))
    assert said == f'Is `{name}` the constructor? It is written `__init__`, with two underscores on each side.'
    assert explain('TypeError', text, answer=ANSWER) == "It takes the name of the node: super().__init__('name')."
    both = ANSWER.replace('def on_timmer', f'def {name}')
    assert explain('TypeError', text, answer=both) == "It takes the name of the node: super().__init__('name')."
    text = 'Node.__init__() takes 2 positional arguments but 3 were given'
    assert explain('TypeError', text, answer=ANSWER.replace('__init__(self)', f'{name}(self, a, b)')) == said
    assert explain('TypeError', text, answer=ANSWER) == ''


def test_a_misspelt_constructor_of_the_base():
    told = explain('AttributeError', "'super' object has no attribute '_init_'", answer=ANSWER)
    assert told == 'Is the constructor meant? It is written `__init__`, with two underscores on each side.'


@pytest.mark.parametrize(
    ('head', 'call'),
    [
        ('class A(Node)', "super().__init__('name')"),
        ('class A(rclpy.node.Node)', "super().__init__('name')"),
        ('class A(StationKeeper)', 'super().__init__(**options)'),
        ('class B(StationKeeper)', "super().__init__('name')"),  # another class than the one that is asked for
        ('class A(', "super().__init__('name')"),
    ],
)
def test_how_the_constructor_of_the_base_is_called(head, call):
    assert slips.super_call(f'{head}:\n    pass\n', 'A') == call


@pytest.mark.parametrize('text', ['class A(', 'x = 1\0', 'a' + '.b' * 100_000, '(' * 5000, r"'\d'"])
def test_any_text_can_be_looked_at(text):
    assert slips.missing_self('x', text) == slips.unset_attribute('x', text) == slips.misspelt_constructor(text) == ''
