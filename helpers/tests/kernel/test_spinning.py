"""Background spinning in one process: side by side, replaced, failing, nested, stopped."""

import threading
import time
from functools import partial

import pytest
import rclpy
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.executors import MultiThreadedExecutor, SingleThreadedExecutor
from rclpy.node import Node
from rclpy.task import Future
from std_srvs.srv import Trigger

from helpers import CallbackError, spinning, wait_for
from helpers.kernel.executors import DaemonPool
from helpers.kernel.handles import handles
from helpers.kernel.nodes import is_alive, living
from helpers.tests.sample_nodes import Faulty, Listener, Talker

BOTH = pytest.mark.parametrize('executor', [SingleThreadedExecutor, MultiThreadedExecutor])


@pytest.fixture(autouse=True)
def _nothing_left(ros):
    """Whatever a test does: once ROS has stopped, no thread and no node is left."""
    before = set(threading.enumerate())
    yield
    ros.stop()
    assert [t for t in threading.enumerate() if t not in before] == []
    assert living() == []
    assert handles() == []


@BOTH
def test_nodes_run_side_by_side(executor):
    talker, listener = Talker(), Listener()
    with spinning(talker, listener, executor=executor) as handle:
        wait_for(lambda: len(listener.heard) >= 3)
        assert handle.running
        assert repr(handle) == '<spinning: /talker, /listener>'
    assert not handle.running
    assert not is_alive(talker) and not is_alive(listener)


def test_stop_twice_and_start_again():
    handle = spinning(Talker())
    handle.stop()
    handle.stop()
    with spinning(talker := Talker()):
        wait_for(lambda: talker.count)


def test_a_node_moves_to_its_new_handle_and_the_others_go_on():
    talker, listener = Talker(), Listener()
    first = spinning(talker, listener)
    second = spinning(talker)
    assert first.nodes == (listener,) and second.nodes == (talker,)
    wait_for(lambda: len(listener.heard) >= 2)
    spinning(listener)
    assert not first.running and second.running


def test_a_node_of_the_same_name_is_replaced():
    old, listener = Talker(), Listener()
    spinning(old, listener)
    with spinning(new := Talker()):
        assert not is_alive(old) and is_alive(new)
        listener.heard.clear()
        wait_for(lambda: listener.heard)
        assert living() == [listener, new]


def test_names_in_other_namespaces_are_other_nodes():
    one, two = Talker(namespace='one'), Talker(namespace='/two')
    spinning(one)
    spinning(two)
    assert is_alive(one) and is_alive(two)


@pytest.mark.parametrize(
    ('arguments', 'kind', 'text'),
    [
        (lambda: (), ValueError, 'at least one node'),
        (lambda: (Talker,), TypeError, 'Talker is a class: create the node first'),
        (lambda: ('talker',), TypeError, 'takes nodes, not str'),
        (lambda: (_destroyed(),), ValueError, 'this Talker has been destroyed .* run the cell'),
        (lambda: (_foreign(), Talker()), ValueError, 'different contexts|shut down'),
    ],
)
def test_what_cannot_spin_is_refused_in_one_sentence(arguments, kind, text):
    with pytest.raises(kind, match=text):
        spinning(*arguments())
    assert handles() == []


def test_an_own_executor_can_be_used_once():
    executor = MultiThreadedExecutor(num_threads=3)
    with spinning(talker := Talker(), executor=executor):
        wait_for(lambda: talker.count)
    with pytest.raises(ValueError, match='has been shut down'):
        spinning(Talker(), executor=executor)


# ---- exceptions in callbacks


@BOTH
def test_an_exception_is_shown_and_all_nodes_go_on(executor, capsys):
    faulty, listener = Faulty(), Listener()
    handle = spinning(faulty, listener, executor=executor)
    message = 'timer callback Faulty.tick of node faulty raised ValueError: no voice'
    with pytest.raises(CallbackError, match=message) as info:
        wait_for(lambda: False)
    assert isinstance(info.value.__cause__, ValueError)
    assert info.value.node == 'faulty'
    count, heard = faulty.count, len(listener.heard)
    _until(lambda: faulty.count > count + 3 and len(listener.heard) > heard + 3)
    shown = capsys.readouterr().err
    assert 'An exception in timer callback Faulty.tick of node faulty' in shown
    assert 'ValueError: no voice' in shown
    assert 'rclpy/' not in shown, "the traceback begins in the learner's code"
    with pytest.raises(CallbackError, match='times'):
        handle.check()


def test_an_exception_is_raised_once():
    handle = spinning(failing := Node('failing'))
    timer = failing.create_timer(0.01, lambda: (timer.cancel(), 1 / 0))
    _until(lambda: handle._failures)
    with pytest.raises(CallbackError, match='ZeroDivisionError'):
        handle.check()
    handle.check()
    wait_for(lambda: True)


def test_the_end_of_the_block_raises_what_nobody_waited_for():
    with pytest.raises(CallbackError, match='no voice'), spinning(faulty := Faulty()):
        _until(lambda: faulty.count > 4)


def test_an_error_of_the_block_is_not_hidden():
    with pytest.raises(KeyError), spinning(faulty := Faulty()):
        _until(lambda: faulty.count > 4)
        raise KeyError


def test_exit_in_a_callback_is_an_error_and_ends_nothing():
    node = Node('quitter')
    node.create_timer(0.01, lambda: exit(3))
    other = Talker()
    spinning(node, other)
    with pytest.raises(CallbackError, match='SystemExit'):
        wait_for(lambda: False)
    count = other.count
    _until(lambda: other.count > count + 2)


def test_the_callback_is_named_whatever_it_is():
    node = Node('many')
    service = node.create_service(Trigger, 'ask', _fail)
    client = node.create_client(Trigger, 'ask')
    handle = spinning(node)
    assert client.wait_for_service(timeout_sec=10)
    client.call_async(Trigger.Request())
    with pytest.raises(CallbackError, match=r"service callback of 'ask' _fail of node many"):
        _until(lambda: handle.check())
    node.destroy_service(service)

    node.create_service(Trigger, 'answer', lambda request, response: response)
    answers = node.create_client(Trigger, 'answer')
    assert answers.wait_for_service(timeout_sec=10)
    answers.call_async(Trigger.Request()).add_done_callback(_fail)
    with pytest.raises(CallbackError, match=r'task _fail of node many'):
        _until(lambda: handle.check())

    talker = Talker('t')
    node.create_subscription(talker.publisher.msg_type, '/chatter', lambda m: _fail(), 10)
    spinning(talker)
    with pytest.raises(CallbackError, match=r"subscription callback on '/chatter' <lambda> of node many"):
        _until(lambda: handle.check())


def test_an_exception_after_an_await_is_reported():
    node, done = Node('patient'), Future()

    async def wait_and_fail():
        timer.cancel()
        await done
        raise ValueError('after the wait')

    timer = node.create_timer(0.01, wait_and_fail)
    handle = spinning(node)
    _until(timer.is_canceled)
    done.set_result(1)
    node.create_timer(0.01, lambda: None)  # 7.1.6 looks at waiting coroutines when something else happens
    with pytest.raises(CallbackError, match='after the wait'):
        _until(lambda: handle.check())


# ---- who spins


@pytest.mark.parametrize(
    ('name', 'spin'),
    [
        ('rclpy.spin_once', lambda node: rclpy.spin_once(node, timeout_sec=0)),
        ('rclpy.spin', lambda node: rclpy.spin(node)),
        ('rclpy.spin_until_future_complete', lambda node: rclpy.spin_until_future_complete(node, Future(), None, 1)),
        ('executor.spin_once', lambda node: node.executor.spin_once(timeout_sec=0)),
        ('executor.add_node', lambda node: SingleThreadedExecutor().add_node(node)),
    ],
)
@BOTH
def test_spinning_inside_a_callback_is_named_and_the_node_stays(executor, name, spin):
    node = Node('nested')
    timer = node.create_timer(0.01, lambda: (timer.cancel(), spin(node)))
    spinning(node, executor=executor)
    with pytest.raises(CallbackError, match='spin') as info:
        wait_for(lambda: False)
    text = str(info.value)
    assert f'{name}() was called inside the timer callback' in text
    assert 'Do not spin in a callback' in text
    ticks = []
    node.create_timer(0.01, lambda: ticks.append(1))
    wait_for(lambda: len(ticks) > 2)


def test_spinning_from_a_cell_what_already_spins_is_refused():
    spinning(talker := Talker())
    with pytest.raises(RuntimeError, match=r'rclpy.spin_once\(\) was called, but talker already spins'):
        rclpy.spin_once(talker, timeout_sec=0)
    count = talker.count
    wait_for(lambda: talker.count > count + 2)
    spinning(Listener())
    rclpy.spin_once(Node('free'), timeout_sec=0)  # others may be spun as ever


class Executor719(SingleThreadedExecutor):
    """rclpy 7.1.9's additional rule: a second spin of one executor raises RuntimeError."""

    def __init__(self, **options):
        super().__init__(**options)
        self.lock = threading.Lock()

    def spin_once_until_future_complete(self, future, timeout_sec=None):
        if not self.lock.acquire(blocking=False):
            raise RuntimeError('Executor is already spinning')
        try:
            super().spin_once_until_future_complete(future, timeout_sec)
        finally:
            self.lock.release()


def test_a_nested_spin_of_rclpy_719(capsys):
    node = Node('nested')
    timer = node.create_timer(
        0.01, lambda: (timer.cancel(), node.executor.spin_once_until_future_complete(Future(), 0.1))
    )
    handle = spinning(node, executor=Executor719)
    with pytest.raises(CallbackError, match='Executor is already spinning'):
        wait_for(lambda: False)
    assert 'Inside a callback do not spin' in capsys.readouterr().err
    assert handle.running


def test_callbacks_of_a_multi_threaded_executor_overlap():
    node, group = Node('parallel'), ReentrantCallbackGroup()
    meet, met = threading.Barrier(2), []

    def come(number):
        timers[number].cancel()
        meet.wait(20)  # passes only while the other callback is inside, too
        met.append(threading.get_ident())

    timers = [node.create_timer(0.01, partial(come, number), callback_group=group) for number in range(2)]
    with spinning(node, executor=MultiThreadedExecutor):
        wait_for(lambda: len(set(met)) == 2, timeout=20)


# ---- what changes while nodes spin


def test_a_multi_threaded_executor_rests_while_all_of_its_threads_are_busy(monkeypatch):
    """Rclpy hands out a task again and again until a thread has begun it (its issue 1452), and those pile up."""
    submitted, release = [], threading.Event()
    submit = DaemonPool.submit
    monkeypatch.setattr(DaemonPool, 'submit', lambda pool, work: (submitted.append(work), submit(pool, work)))
    listener, executor = Listener(), MultiThreadedExecutor(num_threads=2)
    with spinning(listener, executor=executor), spinning(talker := Talker()):
        wait_for(lambda: listener.heard)
        for _ in range(2):
            executor.create_task(lambda: release.wait(20))
        wait_for(lambda: submitted[-1].entity is not None and not submitted[-1].task.done())  # a message waits
        before, count = len(submitted), talker.count
        wait_for(lambda: talker.count > count + 20)
        assert len(submitted) - before < 100
        listener.heard.clear()
        release.set()
        wait_for(lambda: listener.heard)


def test_what_is_created_while_spinning_runs():
    with spinning(node := Node('late')):
        ticks = []
        node.create_timer(0.01, lambda: ticks.append(1))
        wait_for(lambda: len(ticks) > 2)


def test_a_node_destroyed_while_spinning_leaves_the_others_alone():
    talkers = [Talker(f'talker_{number}') for number in range(10)]
    listener = Listener()
    handle = spinning(listener, *talkers)
    for talker in talkers:
        wait_for(lambda: listener.heard)
        talker.destroy_node()
        listener.heard.clear()
    assert handle.running
    last = Talker('last')
    spinning(last)
    wait_for(lambda: listener.heard)


@BOTH
def test_a_callback_may_destroy_its_own_node(executor):
    node, listener = Talker('brief'), Listener()
    node.create_timer(0.01, node.destroy_node, callback_group=ReentrantCallbackGroup())
    handle = spinning(node, listener, executor=executor)
    _until(lambda: not is_alive(node))
    with spinning(Talker()):
        wait_for(lambda: listener.heard)
    assert handle.nodes == (listener,)


def test_a_callback_may_stop_its_own_spinning():
    node = Node('ends')
    node.create_timer(0.01, lambda: handle.stop())
    handle = spinning(node)
    _until(lambda: not handle.running)
    assert not is_alive(node)
    with spinning(talker := Talker()):
        wait_for(lambda: talker.count)


@BOTH
def test_a_callback_that_never_returns_is_interrupted(executor):
    node, inside = Node('stuck'), threading.Event()

    def forever():
        inside.set()
        while True:
            time.sleep(0.001)

    node.create_timer(0.01, forever)
    handle = spinning(node, executor=executor)
    assert inside.wait(10)
    handle.stop(timeout=0.1)
    assert not handle.running
    assert not is_alive(node)


def test_a_wait_that_fails_names_the_callback_that_blocks_all_others():
    node, inside, go = Node('stuck'), threading.Event(), threading.Event()

    def block():
        inside.set()
        go.wait(20)

    node.create_timer(0.01, block)
    with spinning(node):
        assert inside.wait(10)
        with pytest.raises(TimeoutError, match=r'the timer callback block of node stuck has been running for \d'):
            wait_for(lambda: False, timeout=1.2)
        go.set()


def test_shutdown_while_spinning(ros):
    handle = spinning(Talker())
    rclpy.shutdown()
    _until(lambda: not handle.running)
    ros.start()
    with spinning(talker := Talker()):
        wait_for(lambda: talker.count)


def test_idle_spinning_needs_no_processor():
    nodes = [Node(f'idle_{number}') for number in range(3)]
    with spinning(*nodes[:2]), spinning(nodes[2], executor=MultiThreadedExecutor):
        never = threading.Event()

        def share():
            before = time.process_time()
            never.wait(2.0)
            return (time.process_time() - before) / 2.0

        _until(lambda: share() < 0.05)  # after discovery; a loop that asks without a pause never comes to rest


def _fail(*_):
    raise ValueError('this always fails')


def _destroyed():
    node = Talker()
    node.destroy_node()
    return node


def _foreign():
    context = rclpy.Context()
    context.init()
    node = Node('foreign', context=context)
    context.try_shutdown()
    return node


def _until(condition, timeout=20.0):
    """A bounded wait that does not look at callback errors, unlike wait_for."""
    end = time.monotonic() + timeout
    while not condition():
        assert time.monotonic() < end, 'it did not happen'
        time.sleep(0.005)
