"""The timeline: what it records of callbacks and messages, and how it is shown."""

import re
import threading
from xml.etree import ElementTree

import pytest
from example_interfaces.action import Fibonacci
from example_interfaces.srv import AddTwoInts
from rclpy.action import ActionClient, ActionServer
from rclpy.callback_groups import MutuallyExclusiveCallbackGroup
from rclpy.client import Client
from rclpy.executors import MultiThreadedExecutor
from rclpy.node import Node
from rclpy.publisher import Publisher
from rclpy.service import Service

from helpers import spin_for, spinning, timeline, wait_for
from helpers.kernel import executors
from helpers.show import timeline_chart
from helpers.show.timeline import Callback, Timeline
from helpers.tests.sample_nodes import Listener, Talker

pytestmark = pytest.mark.usefixtures('ros')


class Adder(Node):
    """Answers when `gate` is open."""

    def __init__(self):
        super().__init__('adder')
        self.gate = threading.Event()
        self.create_service(AddTwoInts, 'add', self.on_add)

    def on_add(self, request, response):
        self.gate.wait(5)
        response.sum = request.a + request.b
        return response


class Asker(Node):
    """Asks once, in the way of its timer's callback."""

    def __init__(self, how, group=None):
        super().__init__('asker')
        self.client = self.create_client(AddTwoInts, 'add', callback_group=group)
        self.sums = []
        self.timer = self.create_timer(0.01, getattr(self, how))

    def chain(self):
        self.timer.cancel()
        self.client.call_async(AddTwoInts.Request(a=1, b=2)).add_done_callback(self.on_sum)

    def on_sum(self, future):
        self.sums.append(future.result().sum)

    async def wait(self):
        self.timer.cancel()
        self.sums.append((await self.client.call_async(AddTwoInts.Request(a=1, b=2))).sum)

    def block(self):
        self.timer.cancel()
        self.sums.append(self.client.call(AddTwoInts.Request(a=1, b=2)).sum)


def asked(how, group=None, **options):
    asker, adder = Asker(how, group), Adder()
    adder.gate.set()
    with timeline() as chart, spinning(asker, adder, **options):
        wait_for(lambda: asker.sums == [3])
        spin_for(0.05)
    return chart


def by_name(chart):
    return {callback.name: callback for callback in chart.callbacks}


def test_publish_and_receive():
    with timeline() as chart, spinning(Talker(), listener := Listener()):
        wait_for(lambda: len(listener.heard) >= 2)
    sent = [message for message in chart.messages if message.kind == 'publish']
    received = [message for message in chart.messages if message.kind == 'receive']
    assert {(message.name, message.node) for message in sent} == {('/chatter', 'talker')}
    assert {(message.name, message.node) for message in received} == {('/chatter', 'listener')}
    assert sent[0].time <= received[0].time
    assert {(run.node, run.name) for run in chart.callbacks} == {('talker', 'tick'), ('listener', 'hear')}
    assert all(callback.start <= callback.end for callback in chart.callbacks) and len(chart.threads) == 1


def test_a_service_call_in_one_thread():
    chart = asked('chain')
    names = [callback.name for callback in sorted(chart.callbacks, key=lambda callback: callback.start)]
    assert names == ['chain', 'on_add', 'on_sum']
    kinds = [message.kind for message in chart.messages]
    assert kinds == ['request', 'take', 'respond', 'answer']
    assert {message.call for message in chart.messages} == {1}
    assert not any(callback.awaited for callback in chart.callbacks)


def test_await_lets_others_run():
    chart = asked('wait', MutuallyExclusiveCallbackGroup())
    waited, added = by_name(chart)['wait'], by_name(chart)['on_add']
    assert waited.awaited and waited.thread == added.thread
    assert waited.parts[0][1] <= added.start and added.end <= waited.parts[-1][0]


def test_a_blocking_call_holds_its_thread():
    chart = asked('block', MutuallyExclusiveCallbackGroup(), executor=MultiThreadedExecutor)
    blocked, added = by_name(chart)['block'], by_name(chart)['on_add']
    assert blocked.thread != added.thread and blocked.start <= added.start <= added.end <= blocked.end
    assert not blocked.awaited and len(chart.callbacks) == 2
    assert list(chart.threads.values()) == ['thread 1', 'thread 2']


def test_a_callback_that_does_not_end():
    asker = Asker('wait')  # one group for timer and client: the response is never taken
    with timeline() as chart, spinning(asker):
        wait_for(lambda: chart.callbacks and chart.callbacks[0].parts[0][1])
    (stuck,) = chart.callbacks
    assert stuck.end is None and stuck.awaited and 'not ended' in repr(chart)


def test_the_execution_of_a_goal():
    class Counter(Node):
        def __init__(self):
            super().__init__('counter')
            self.server = ActionServer(self, Fibonacci, 'count', self.execute)

        def execute(self, goal):
            goal.succeed()
            return Fibonacci.Result()

    user = Node('user')
    client = ActionClient(user, Fibonacci, 'count')
    with timeline() as chart, spinning(Counter(), user):
        wait_for(client.server_is_ready)
        goal = client.send_goal_async(Fibonacci.Goal())
        wait_for(goal.done)
        wait_for(goal.result().get_result_async().done)
        client.destroy()
    assert {('counter', 'execute'), ('counter', 'action server')} <= {(run.node, run.name) for run in chart.callbacks}
    assert all(run.name != '_execute_goal' for run in chart.callbacks)


def test_two_clients_are_told_apart():
    askers, adder = [Asker('chain'), Asker('chain')], Adder()
    with timeline() as chart, spinning(*askers), spinning(adder):
        wait_for(lambda: sum(message.kind == 'request' for message in chart.messages) == 2)
        adder.gate.set()
        wait_for(lambda: all(asker.sums for asker in askers))
        spin_for(0.05)
    for call in {message.call for message in chart.messages if message.call}:
        assert {message.kind for message in chart.messages if message.call == call} >= {'request', 'answer'}


def test_off_is_off():
    plain = Publisher.publish, Client.call_async, Service.send_response
    others = executors.observers.copy()
    with timeline():
        assert Publisher.publish is not plain[0]
        with timeline():
            pass
        assert Publisher.publish is not plain[0] and len(executors.observers) == len(others) + 1
    assert (Publisher.publish, Client.call_async, Service.send_response) == plain and executors.observers == others


def test_the_chart():
    chart = asked('wait', MutuallyExclusiveCallbackGroup())
    bundle = chart._repr_mimebundle_()
    root = ElementTree.fromstring(re.search('<svg.*?</svg>', bundle['text/html'], re.DOTALL)[0])
    words = [element.text for element in root.iter() if element.tag.endswith('}text')]
    assert {'asker', 'adder', 'sent', 'received', 'awaits', 'thread 1', 'on_add'} <= set(words)
    assert root.get('role') == 'img' and root[0].text.startswith('Timeline: 2 callbacks in 1 thread, 4 messages')
    assert bundle['text/plain'] == root[1].text and 'adder takes a request of /add' in bundle['text/plain']


def test_two_labels_beside_their_bars_do_not_cover_each_other():
    chart = Timeline()
    chart.threads, chart.end = {1: 'thread 1'}, 0.6
    chart.callbacks = [
        Callback('patient', 'first', 1, 0.0, 0.01, [(0.0, 0.01)]),
        Callback('patient', 'tick', 1, 0.5, 0.52, [(0.5, 0.503), (0.518, 0.52)]),
        Callback('patient', 'callback', 1, 0.51, 0.515, [(0.51, 0.515)]),
    ]
    assert re.findall('>(first|tick|callback)</text>', timeline_chart.svg(chart)) == ['first', 'callback']


def test_an_empty_chart():
    with timeline() as chart:
        pass
    assert repr(chart).startswith('Timeline: 0 callbacks in 0 threads')
    ElementTree.fromstring(f'<div>{chart._repr_mimebundle_()["text/html"]}</div>')
