"""Sliders: what is called when, what is shown, what is left; those of parameters and of QoS."""

import pytest

from helpers import QosSliders, Sliders, parameter_sliders, spinning, wait_for
from helpers.kernel.ros import nodes
from helpers.show.widgets import VIEW


def test_the_function_gets_the_first_values_then_each_move_and_an_error_is_shown():
    calls = []

    def turn(roll, side):
        calls.append((roll, side))
        if roll > 90:
            raise ValueError('too far')
        return f'roll is {roll}'

    with Sliders(turn, roll=(-180, 180, 10, '°'), side=['left', 'right']) as sliders:
        assert calls == [(10, 'left')]
        assert repr(sliders) == 'roll: 10 °\nside: left\nroll is 10'
        sliders._on_move('side', 'right')
        assert calls[-1] == (10, 'right')
        sliders._on_move('roll', 100)
        assert repr(sliders).endswith('ValueError: too far') and sliders.values == {'roll': 100, 'side': 'right'}


def test_what_the_function_raises_at_first_is_raised():
    with pytest.raises(ZeroDivisionError):
        Sliders(lambda x: str(1 / x), x=(0, 1))


def test_sliders_end_with_their_node_and_with_those_of_a_later_call(ros):
    import rclpy

    first, second = rclpy.create_node('first'), rclpy.create_node('second')
    Sliders(lambda x: '', first, x=(0, 1))
    sliders = Sliders(lambda x: '', second, x=(0, 1))
    assert not nodes.is_alive(first) and nodes.is_alive(second)
    ros.stop()
    assert not nodes.is_alive(second)
    sliders.stop()


@pytest.fixture
def governor(ros):
    import rclpy
    from rcl_interfaces.msg import FloatingPointRange, IntegerRange, ParameterDescriptor, SetParametersResult

    node = rclpy.create_node('governor')
    bounds = FloatingPointRange(from_value=0.0, to_value=2.0)
    node.declare_parameter('speed', 0.5, ParameterDescriptor(description='m/s', floating_point_range=[bounds]))
    node.declare_parameter('gears', 3, ParameterDescriptor(integer_range=[IntegerRange(from_value=1, to_value=5)]))
    node.declare_parameter('free', 1.0)
    node.add_on_set_parameters_callback(
        lambda parameters: SetParametersResult(successful=parameters[0].value != 2.0, reason='too fast')
    )
    with spinning(node):
        yield node


def test_a_slider_for_each_bounded_parameter_sets_it_and_tells_what_the_node_says(governor):
    sliders = parameter_sliders('/governor')
    assert sliders.values == {'speed': 0.5, 'gears': 3}
    sliders._on_move('speed', 1.25)
    wait_for(lambda: 'speed = 1.25: done' in repr(sliders), timeout=30)
    assert governor.get_parameter('speed').value == 1.25
    sliders._on_move('gears', 4)
    wait_for(lambda: governor.get_parameter('gears').value == 4, timeout=30)
    sliders._on_move('speed', 2.0)
    wait_for(lambda: 'refused: too fast' in repr(sliders), timeout=30)
    assert governor.get_parameter('speed').value == 1.25
    sliders.stop()
    assert governor.count_clients('/governor/set_parameters') == 0


def test_without_bounds_there_is_no_slider(ros):
    import rclpy

    with spinning(rclpy.create_node('plain')), pytest.raises(ValueError, match='no parameter of /plain has bounds'):
        parameter_sliders('/plain')


def test_the_pair_shows_what_its_qos_do(ros):
    pair = QosSliders(depth=1, rate=50)
    wait_for(lambda: len(pair.read) > 5, timeout=30)
    assert len(pair.sent) > 2 * len(pair.read)
    pair._sliders._on_move('publisher', 'BEST_EFFORT')
    wait_for(lambda: pair._offered == (50, 'BEST_EFFORT'), timeout=30)
    pair.read.clear()
    wait_for(lambda: 'nothing is read' in pair._sliders._text, timeout=30)
    pair._sliders._on_move('subscription', 'BEST_EFFORT')
    wait_for(lambda: len(pair.read) > 3, timeout=30)
    sender, reader = pair._sender, pair._reader
    pair.stop()
    assert not nodes.is_alive(sender) and not nodes.is_alive(reader)


SHOW = """
from helpers import Sliders
sliders = Sliders(lambda depth: f'depth is {depth}', depth=(1, 10))
"""


def test_a_front_end_without_widgets_shows_a_still_and_so_does_the_end(kernel):
    shown = []

    def note(message):
        if message['msg_type'] in ('display_data', 'update_display_data', 'execute_result'):
            shown.append(message['content']['data'])

    for code in (SHOW + 'sliders', 'sliders.stop()'):
        reply = kernel.client.execute_interactive(code, output_hook=note, timeout=60, allow_stdin=False)
        assert reply['content']['status'] == 'ok', reply['content']
    live, still = shown
    assert VIEW in live and 'depth is 1' in live['text/html']
    assert VIEW not in still and 'depth is 1' in still['text/plain']


AGAIN = """
import helpers
helpers.ros.start()
pair = helpers.QosSliders()
helpers.wait_for(lambda: pair.read, timeout=30)
"""


def test_a_cell_with_sliders_can_be_run_again(kernel):
    kernel.ok(AGAIN)
    kernel.ok(AGAIN)
    kernel.ok('helpers.ros.stop()')
    assert kernel.complaints() == ''
