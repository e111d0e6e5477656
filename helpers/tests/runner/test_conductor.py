"""How the hidden node in the learner's process waits for what it was sent."""

import pytest
from rclpy.executors import TimeoutException

from helpers.runner.conductor import Conductor
from helpers.runner.loaded_program import LoadedProgram, RequestError


class Executor:
    """Offers one callback after another: (whose node, what it does)."""

    def __init__(self, *offers):
        self.offers = list(offers)

    def wait_for_ready_callbacks(self, timeout_sec, nodes):
        if not self.offers:
            raise TimeoutException
        node, handler = self.offers.pop(0)
        return handler, None, node


@pytest.fixture
def conductor():
    """A conductor without ROS; its node is only something to be recognised."""
    conductor = object.__new__(Conductor)
    conductor.node = object()
    return conductor


def test_what_has_arrived_is_taken_even_after_the_time(conductor):
    heard = []
    conductor.executor = Executor((conductor.node, lambda: heard.append(1)), (conductor.node, lambda: heard.append(2)))
    conductor._hear(lambda: len(heard) == 2, timeout=-1.0)
    assert heard == [1, 2]


def test_silence_is_deaf_after_the_time(conductor):
    conductor.executor = Executor()
    with pytest.raises(RequestError) as fault:
        conductor._hear(lambda: False, timeout=0.0)
    assert fault.value.fields['kind'] == 'deaf'


def test_callbacks_of_others_are_not_run_and_do_not_put_the_end_off(conductor):
    ran = []
    conductor.executor = Executor(*[(object(), lambda: ran.append(1))] * 3)
    with pytest.raises(RequestError):
        conductor._hear(lambda: False, timeout=-1.0)
    assert not ran
    assert len(conductor.executor.offers) == 2


def test_what_is_imported_from_the_future_holds_for_later_cells():
    """As in a notebook; for those before it it does not."""
    program = LoadedProgram()
    cells = ['from __future__ import annotations\n', 'def f(x: Later):\n    return x\n']
    program.load([{'label': 'a', 'source': text, 'line': 3, 'required': True} for text in cells])
    assert program.find('f').__annotations__ == {'x': 'Later'}
    with pytest.raises(RequestError):
        LoadedProgram().load([{'label': 'a', 'source': cells[1], 'line': 1, 'required': True}])
