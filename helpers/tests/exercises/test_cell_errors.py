"""What the kernel says of the error of a cell. For names that a restart has taken away, see test_resuming.py."""

import sys

STOPPED_IMPORT = """
import signal
signal.signal(signal.SIGALRM, signal.default_int_handler)
class Stop:
    def find_spec(self, name, *rest):
        if name == 'numpy.dtypes':
            signal.raise_signal(signal.SIGALRM)
import sys; sys.meta_path.insert(0, Stop())
import numpy
"""


def test_an_import_that_was_stopped_is_told(kernel):
    """A compiled package cannot be imported again then."""
    kernel.ok('%load_ext helpers.exercises.cell_errors')
    circular = "raise ImportError(\"cannot import name 'x' from partially initialized module 'y'\")"
    assert kernel.run(circular).stdout == '', 'nothing was stopped: it is a fault of the program itself'
    assert kernel.run(STOPPED_IMPORT).error == 'KeyboardInterrupt'
    kernel.ok('del sys.meta_path[0]')
    missed = kernel.run('import numpy')
    error = 'RuntimeError' if sys.version_info < (3, 11) else 'ImportError'  # of numpy 2.2, and of later ones
    assert missed.error == error and missed.stdout.startswith('A package was stopped in the middle')
    assert kernel.run(circular).stdout.startswith('A package was stopped')


def test_a_cell_interrupted_before_it_begins(kernel):
    """IPython then has no result for those who listen to the ends of cells."""
    kernel.ok('%load_ext helpers.exercises.cell_errors\nimport helpers.exercises.exercise_check')
    told = kernel.ok('get_ipython().events.trigger("post_run_cell", None)')
    assert told.stdout == told.stderr == ''


def test_a_node_that_was_destroyed_is_told(kernel):
    """Cells that are run out of order meet it; rclpy's own message names no node."""
    kernel.ok('%load_ext helpers.exercises.cell_errors\nimport helpers, rclpy\nhelpers.ros.start()')
    kernel.ok('node = rclpy.create_node("gone")\nnode.destroy_node()')
    missed = kernel.run('node.get_topic_names_and_types()')
    assert missed.error == 'InvalidHandle' and 'Run the cell that makes it again' in missed.stdout
    assert kernel.run('1 / 0').stdout == ''


def test_a_name_of_a_cell_that_ran_is_not_proposed_for_itself(kernel):
    """The cell failed before, or the name has been deleted, or its line comes later in the same cell."""
    kernel.ok('%load_ext helpers.exercises.cell_errors\nimport helpers')
    assert kernel.run('# two numbers\nfirst = 1 / 0\nsecond = 2').error == 'ZeroDivisionError'
    for name in ('first', 'second'):
        said = kernel.run(f'{name} + 1').stdout
        assert said.startswith(f'`{name}` comes from a cell that ended with an error, before the line that makes'), said
        assert ': # two numbers\nMend that cell and run it again' in said
    kernel.ok('# two numbers\nfirst = 1\nsecond = 2')
    kernel.ok('del first')
    said = kernel.run('first + second').stdout
    assert said == '`first` has been deleted since. This cell makes it; run it again: # two numbers\n'
    for name, late in (('total', 'print(total)\ntotal = 3'), ('amount', 'amount = amount + 3')):
        said = kernel.run(late).stdout
        assert said == f'`{name}` has no value yet: the line of this cell that gives it one has not run.\n'
        assert kernel.run(late).stdout == said, 'the same cell, run again'
    said = kernel.run('print(second + third)\nthird = second = 3').stdout
    assert said.startswith('`third` has no value yet')
    kernel.run('# a failure\nfourth = 1 / 0')
    said = kernel.run('print(fourth)\nfourth = 5').stdout
    assert said.startswith('`fourth` comes from a cell that ended with an error') and '# a failure' in said
    said = kernel.run('counted += 1').stdout
    assert (
        said
        == '`counted` has no value yet. Give it a first one, such as counted = 0, before the line that changes it.\n'
    )
    assert kernel.run('sum_of = [0]\nprint(sum_off)').stdout == 'Nothing is called `sum_off` here. Is `sum_of` meant?\n'


def test_other_errors_are_explained_as_by_the_check(kernel):
    kernel.ok('%load_ext helpers.exercises.cell_errors\nimport helpers\nfrom std_msgs.msg import String')
    field = kernel.run("String().dat = 'hello'")
    assert field.error == 'AttributeError' and field.stdout == 'The message has no field `dat`; there is `data`.\n'
    kernel.ok('class Lamp:\n    def __init__(self):\n        self.lit = False')
    lamp = kernel.run('Lamp().litt')
    assert lamp.stdout == 'Nothing in your code sets `litt`; there is `lit`.\n'
    near = kernel.run("Strin(data='hello')")
    assert near.error == 'NameError' and near.stdout == 'Nothing is called `Strin` here. Is `String` meant?\n'
    kernel.ok('import rclpy\nhelpers.ros.start()\nnode = rclpy.create_node("n")')
    kernel.ok('def tick():\n    String().dat = 1\n\n\ntimer = node.create_timer(0.01, tick)')
    late = kernel.run('with helpers.spinning(node):\n    helpers.wait_for(lambda: False)')
    assert late.error == 'CallbackError' and '│ The message has no field `dat`; there is `data`.' in late.stderr
    text = 'class Blinker(Node):\n    def __init__(self):\n        super().__init__("b")\n        '
    kernel.ok('from rclpy.node import Node')
    for line, said in (
        ('get_logger().info("on")', '`get_logger` is a method of Node: is `self.` missing before it?'),
        ('self.lit = 1\n        print(lit)', 'Your class has `self.lit`: is `self.` missing before it?'),
        ('create_timer(1.0, print)', '`create_timer` is a method of Node: is `self.` missing before it?'),
    ):
        found = kernel.run(f'{text}{line}\n\n\nBlinker()')
        assert (found.error, found.stdout) == ('NameError', f'{said}\n')
    small = kernel.run('print(string(data=""))')
    assert small.stdout == 'Is `String` meant? The name of a class begins with a capital letter.\n'
    kernel.ok(
        'class Lamp:\n    def __init__(self):\n        self.lit = False\n\n    def tick(self):\n        print(lit)'
    )
    kernel.ok('lamp = Lamp()\nnode = rclpy.create_node("m")\ntimer = node.create_timer(0.01, lamp.tick)')
    late = kernel.run('with helpers.spinning(node):\n    helpers.wait_for(lambda: False)')
    assert '│ Your class has `self.lit`: is `self.` missing before it?' in late.stderr
    assert kernel.run('import nobody_has_this').stdout == kernel.run('[].nothing').stdout == ''
