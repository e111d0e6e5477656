"""spin_for, wait_for, collect: what they return, what they say when they fail, and interrupts at any moment."""

import signal
import threading
import time

import pytest
import rclpy
from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy
from rclpy.task import Future
from std_msgs.msg import Int32, String

from helpers import CallbackError, collect, spin_for, spinning, wait_for
from helpers.kernel import conditions
from helpers.kernel.nodes import living
from helpers.tests.sample_nodes import Faulty, Listener, Talker

BEST_EFFORT = QoSProfile(depth=1, reliability=ReliabilityPolicy.BEST_EFFORT)
LATCHED = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)


@pytest.fixture(autouse=True)
def _started(ros):
    return ros


@pytest.fixture
def interruptible():
    """Python's own answer to SIGINT, also where the tests run in the background of a shell and it is ignored."""
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    yield
    signal.signal(signal.SIGINT, before)


def test_wait_for_returns_what_the_condition_returns():
    with spinning(talker := Talker()):
        assert wait_for(lambda: talker.count > 2 and talker.count) > 2


def test_a_wait_that_fails_says_what_for_and_what_lives():
    idle = Node('idle')
    with spinning(listener := Listener()), pytest.raises(TimeoutError) as info:
        wait_for(lambda: len(listener.heard) >= 3, timeout=0.1)
    assert str(info.value) == (
        'waited 0.1 s for len(listener.heard) >= 3; len(listener.heard) is 0; spinning: /listener; '
        'alive but not spinning, so that no callback runs: /idle'
    )
    with pytest.raises(TimeoutError, match='waited 0.1 s for a word; alive but not spinning'):
        wait_for(lambda: False, timeout=0.1, message='a word')
    idle.destroy_node()
    with pytest.raises(TimeoutError, match='for never.*no node is alive'):
        wait_for(never, timeout=0.01)


def test_a_lambda_is_quoted():
    with pytest.raises(TimeoutError, match=r'for 1 \+ 1 == 3; no node'):
        wait_for(lambda: 1 + 1 == 3, timeout=0.01)


THERE, WORDS = True, ['one', 'two']


@pytest.mark.parametrize(
    ('condition', 'said'),
    [
        (lambda: THERE and len(WORDS) >= 3, 'len(WORDS) is 2'),
        (lambda: 'three' in WORDS, "WORDS is ['one', 'two']"),
        (lambda: THERE and not WORDS, "WORDS is ['one', 'two']"),
        (lambda: 3 < len(WORDS), 'len(WORDS) is 2'),
        (lambda: {'one', 'three'} <= set(WORDS), "set(WORDS) is {'one', 'two'}"),
        (lambda: WORDS[1].startswith('x'), "WORDS[1].startswith('x') is False"),
        (lambda: False, ''),
        (lambda: WORDS[7] == 'x', ''),
        (lambda: any(word == 'x' for word in WORDS), "any((word == 'x' for word in WORDS)) is False"),
        (lambda: not all(word in WORDS for word in WORDS), 'all((word in WORDS for word in WORDS)) is True'),
        (lambda: [] or 0, ''),
    ],
    ids=lambda value: value if isinstance(value, str) else '',
)
def test_what_a_condition_lacks_is_told(condition, said):
    assert conditions.lacking(condition) == said


def test_what_stands_in_a_function_is_found():
    count = 3
    assert conditions.lacking(lambda: count == 4) == 'count is 3'
    assert conditions.lacking(never) == ''


def test_wait_for_needs_a_function():
    with pytest.raises(TypeError, match='takes a function'):
        wait_for(True)


def test_spin_for_spins_in_this_thread():
    node, threads = Node('here'), set()
    node.create_timer(0.01, lambda: threads.add(threading.get_ident()))
    began = time.monotonic()
    spin_for(0.3, node)
    assert 0.3 <= time.monotonic() - began
    while not threads:  # a busy machine may leave no time for a single callback
        spin_for(0.1, node)
    assert threads == {threading.get_ident()}


def test_spin_for_waits_with_what_spins_in_the_background():
    talker, listener = Talker(), Listener()
    with spinning(talker):
        while len(listener.heard) < 3:
            spin_for(0.2, talker, listener)


def test_a_callback_that_raises_ends_spin_for():
    faulty = Faulty()
    with pytest.raises(CallbackError, match='timer callback Faulty.tick of node faulty'):
        spin_for(30, faulty)
    count = faulty.count
    with pytest.raises(CallbackError):
        spin_for(30, faulty)
    assert faulty.count == count + 1


def test_a_coroutine_goes_on_in_the_next_spin_for():
    node, done, seen = Node('patient'), Future(), []

    async def wait():
        timer.cancel()
        seen.append('began')
        seen.append(await done)

    timer = node.create_timer(0.01, wait)
    ticks = node.create_timer(0.01, lambda: None, callback_group=rclpy.callback_groups.ReentrantCallbackGroup())
    while not seen:
        spin_for(0.1, node)
    done.set_result('went on')
    while len(seen) < 2:
        spin_for(0.1, node)
    assert seen == ['began', 'went on']
    assert not ticks.is_canceled()


def test_collect_returns_messages_and_leaves_no_node():
    with spinning(Talker()):
        # Deep enough that nothing is dropped while this thread has to wait for a processor.
        texts = [message.data for message in collect('/chatter', String, count=3, qos=1000)]
        numbers = [int(text.split()[1]) for text in texts]
        assert numbers == list(range(numbers[0], numbers[0] + 3))
        assert [node.get_name() for node in living()] == ['talker']


@pytest.mark.parametrize(
    ('qos', 'publisher_qos', 'text'),
    [
        (10, BEST_EFFORT, 'the QoS of /talker does not fit: Best effort publisher and reliable subscription'),
        (LATCHED, 10, 'the QoS of /talker does not fit: Volatile publisher'),
        (10, 10, '/talker is connected, but does not spin'),
    ],
)
def test_collect_says_why_nothing_came(qos, publisher_qos, text):
    talker = Node('talker')
    talker.create_publisher(String, '/chatter', publisher_qos)
    with pytest.raises(TimeoutError, match=f'0 of 2 messages came on /chatter in 0.6 s; .*{text}'):
        collect('/chatter', String, count=2, timeout=0.6, qos=qos)


def test_collect_names_the_type_that_a_topic_carries():
    talker = Node('talker')
    talker.create_publisher(String, '/chatter', 10)
    with pytest.raises(TypeError, match='/chatter carries std_msgs/msg/String, not std_msgs/msg/Int32'):
        collect('/chatter', Int32)


def test_collect_names_a_silent_topic_and_a_ros_that_is_not_started(ros):
    with pytest.raises(TimeoutError, match='nobody publishes on it'):
        collect('/silence', String, timeout=0.1)
    ros.stop()
    with pytest.raises(RuntimeError, match=r'run helpers.ros.start\(\) first'):
        collect('/silence', String)


@pytest.mark.parametrize(
    'wait', [lambda: spin_for(1), lambda: wait_for(lambda: True), lambda: collect('/chatter', String)]
)
def test_waits_are_refused_in_callbacks(wait):
    node = Node('impatient')
    timer = node.create_timer(0.01, lambda: (timer.cancel(), wait()))
    with spinning(node), pytest.raises(CallbackError, match='inside the timer callback .* return, and let a timer'):
        wait_for(lambda: False)


@pytest.mark.usefixtures('interruptible')
@pytest.mark.parametrize('background', [True, False])
def test_interrupts_at_any_moment_leave_all_callbacks_alive(background):
    """50 interrupts at varying moments of fast callbacks; a callback group left locked would stop the count."""
    node, count = Node('fast'), [0]
    publisher = node.create_publisher(String, '/echo', 10)

    def hear(message):
        count[0] += 1
        publisher.publish(message)  # itself again: always busy

    node.create_subscription(String, '/echo', hear, 10)
    node.create_timer(0.001, lambda: None)
    if background:
        spinning(node)
    wanted, main = threading.Semaphore(0), threading.main_thread().ident
    enough = threading.Event()

    def press():
        for number in range(50):
            wanted.acquire()
            threading.Event().wait(0.0007 * (number % 13))
            signal.pthread_kill(main, signal.SIGINT)
        enough.set()

    thread = threading.Thread(target=press, daemon=True)
    thread.start()
    pressed = 0
    publisher.publish(String(data='go'))
    while pressed < 50:
        try:
            wanted.release()
            spin_for(20) if background else spin_for(20, node)
        except KeyboardInterrupt:
            pressed += 1
    thread.join()
    assert enough.is_set()
    before = count[0]
    publisher.publish(String(data='again'))
    for _ in range(100):
        spin_for(0.1) if background else spin_for(0.1, node)
        if count[0] > before + 3:
            break
    assert count[0] > before + 3
    assert rclpy.ok()


def never():
    return False
