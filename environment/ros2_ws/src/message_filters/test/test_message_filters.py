"""Filters of messages, with messages that are put in by hand, and one subscription."""

import pytest
from builtin_interfaces.msg import Time as Stamp
from message_filters import ApproximateTimeSynchronizer, Cache, Chain, SimpleFilter, Subscriber, TimeSynchronizer
from rclpy.time import Time
from std_msgs.msg import Header, String

from environment.tests.running import domain, peer  # noqa: F401


class Stamped:
    """A message with a header."""

    def __init__(self, milliseconds, name=''):
        seconds, rest = divmod(milliseconds, 1000)
        self.header = Header(stamp=Stamp(sec=seconds, nanosec=rest * 1_000_000))
        self.name = name or milliseconds


def at(milliseconds):
    return Time(nanoseconds=milliseconds * 1_000_000, clock_type=Time().clock_type)


def output(message_filter):
    """A list that the filter's outputs go to, by the messages' names."""
    sets = []
    message_filter.registerCallback(lambda *messages: sets.append(tuple(message.name for message in messages)))
    return sets


def test_callbacks_get_the_message_and_their_own_arguments():
    source, got = SimpleFilter(), []
    first = source.registerCallback(lambda *words: got.append(words), 'x', 2)
    second = source.registerCallback(lambda *words: got.append(words))
    source.signalMessage(1)
    assert got == [(1, 'x', 2), (1,)]
    del source.callbacks[first]
    third = source.registerCallback(got.append)
    assert len({first, second, third}) == 3  # a key is not given twice


def test_a_cache_keeps_the_latest():
    source = SimpleFilter()
    cache = Cache(source, 3)
    passed = output(cache)
    for milliseconds in (100, 200, 300, 400):
        source.signalMessage(Stamped(milliseconds))
    assert passed == [(100,), (200,), (300,), (400,)]
    assert (cache.getOldestTime().nanoseconds, cache.getLastestTime().nanoseconds) == (200_000_000, 400_000_000)
    clock = cache.getLastestTime().clock_type
    times = {t: Time(nanoseconds=t * 1_000_000, clock_type=clock) for t in (0, 100, 200, 250, 300, 400, 500)}
    assert [m.name for m in cache.getInterval(times[200], times[300])] == [200, 300]
    assert cache.getElemAfterTime(times[250]).name == 300
    assert cache.getElemBeforeTime(times[250]).name == 200
    assert cache.getElemAfterTime(times[500]) is None and cache.getElemBeforeTime(times[100]) is None
    assert cache.getLast().name == 400
    with pytest.raises(AssertionError):
        cache.getInterval(times[300], times[200])


def test_a_cache_takes_messages_without_a_header_only_if_told():
    source = SimpleFilter()
    strict, lax = Cache(source, 2), Cache(source, 2, allow_headerless=True)
    source.signalMessage(String(data='x'))
    assert strict.getLast() is None and strict.getLastestTime() is None and strict.getOldestTime() is None
    assert lax.getLast().data == 'x'


def test_equal_stamps_go_together():
    left, right = SimpleFilter(), SimpleFilter()
    sets = output(TimeSynchronizer([left, right], 2))
    right.signalMessage(Stamped(10, 'r10'))
    right.signalMessage(Stamped(11, 'r11'))
    left.signalMessage(Stamped(10, 'l10'))
    left.signalMessage(Stamped(20, 'l20'))
    right.signalMessage(Stamped(20, 'r20'))
    assert sets == [('l10', 'r10'), ('l20', 'r20')]
    for milliseconds in (30, 40, 50):  # the queue holds two: 30 leaves
        left.signalMessage(Stamped(milliseconds))
    for milliseconds in (30, 40, 50):
        right.signalMessage(Stamped(milliseconds))
    assert sets[2:] == [(40, 40), (50, 50)]


def test_what_is_older_than_the_last_set_is_forgotten():
    left, right = SimpleFilter(), SimpleFilter()
    sets = output(TimeSynchronizer([left, right], 10))
    for one, milliseconds in ((left, 10), (right, 20), (left, 20), (right, 10)):
        one.signalMessage(Stamped(milliseconds))
    assert sets == [(20, 20)]
    for one in (left, right):  # the time jumped back, as when a bag is played again: a whole set is handed on
        one.signalMessage(Stamped(5, 'again'))
    assert sets[1:] == [('again', 'again')]


def test_stamps_that_are_near_go_together_the_nearest_first():
    left, right, third = SimpleFilter(), SimpleFilter(), SimpleFilter()
    sets = output(ApproximateTimeSynchronizer([left, right, third], 10, 0.05))
    left.signalMessage(Stamped(100, 'l100'))
    left.signalMessage(Stamped(130, 'l130'))
    third.signalMessage(Stamped(120, 't120'))
    assert sets == []
    right.signalMessage(Stamped(125, 'r125'))
    assert sets == [('l130', 'r125', 't120')]
    right.signalMessage(Stamped(300, 'r300'))
    third.signalMessage(Stamped(310, 't310'))
    left.signalMessage(Stamped(350, 'l350'))  # 50 ms are not less than 50 ms
    assert len(sets) == 1
    left.signalMessage(Stamped(320, 'l320'))
    assert sets[1:] == [('l320', 'r300', 't310')]


def test_without_a_header_only_if_told():
    left, right = SimpleFilter(), SimpleFilter()
    got = []
    for allow in (False, True):
        synchronizer = ApproximateTimeSynchronizer([left, right], 10, 60.0, allow_headerless=allow)
        synchronizer.registerCallback(lambda one, two, allow=allow: got.append((allow, one.data, two.data)))
    left.signalMessage(String(data='a'))
    right.signalMessage(String(data='b'))
    assert got == [(True, 'a', 'b')]


def test_an_error_in_a_callback_does_not_lock_the_synchronizer():
    left, right = SimpleFilter(), SimpleFilter()
    synchronizer = TimeSynchronizer([left, right], 2)
    synchronizer.registerCallback(lambda *_: 1 / 0)
    left.signalMessage(Stamped(1))
    with pytest.raises(ZeroDivisionError):
        right.signalMessage(Stamped(1))
    assert not synchronizer.lock.locked()


def test_a_chain_is_one_filter():
    class Named(SimpleFilter):
        def __init__(self, name):
            super().__init__()
            self.name = name

        def add(self, message):
            self.signalMessage(message + self.name)

    source, got = SimpleFilter(), []
    chain = Chain(source)
    chain.registerCallback(got.append)
    source.signalMessage('0')
    for name in 'abc':
        chain.addFilter(Named(name))
    source.signalMessage('1')
    assert got == ['0', '1abc']
    assert chain.getFilter(1).name == 'b'
    with pytest.raises(KeyError):
        chain.getFilter(-1)
    with pytest.raises(RuntimeError, match='Already connected'):
        chain.connectInput(source)


def test_a_subscription_is_a_filter(peer):  # noqa: F811
    subscriber = Subscriber(peer.node, String, 'words')
    got = []
    subscriber.registerCallback(got.append)
    assert subscriber.getTopic() == 'words' and subscriber.topic_name == '/words'
    peer.publisher(String, 'words').publish(String(data='hello'))
    peer.until(lambda: got, 'the message')
    assert got[0].data == 'hello'
