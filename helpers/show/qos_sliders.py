"""`QosSliders`: a publisher and a slow subscription, live, whose rate, depth and reliability are sliders."""

import time
from collections import deque

from helpers.kernel.spinning import spinning
from helpers.show import inline_svg
from helpers.show.colours import BAD, GOOD
from helpers.show.sliders import Slider, Sliders

WORK = 0.1  # s that the reader needs for one message
_WINDOW = 3.0  # s in the picture
_PERIOD = 0.5  # s from one picture to the next
_LOOK = 0.05  # s between two looks at what is wanted
_WIDTH, _SENT, _READ, _BOTTOM = 560, 24, 104, 138  # px of the picture, and where its rows are
_RELIABILITIES = ['RELIABLE', 'BEST_EFFORT']


class QosSliders:
    """Watch a publisher and a subscription, and change their QoS, in the output of this cell.

    The node ``/sender`` publishes numbers; ``/reader`` needs 0.1 s for each one. The picture has a line for each number
    that was read, from the moment it was sent to the moment it was read. It goes on until `stop`, or until the next
    sliders.

    :param depth: of the subscription, at first.
    :param rate: messages a second, at first.
    :raises RuntimeError: ROS is not started.
    """

    def __init__(self, depth: int = 1, rate: int = 50):
        import rclpy

        if not rclpy.ok():
            raise RuntimeError('ROS is not started: run helpers.ros.start() first')
        self.sent: deque = deque(maxlen=1000)  #: (number, s) of the latest messages
        self.read: deque = deque(maxlen=1000)  #: the same, when the reader took them
        self._wanted: dict = {}
        self._offered: tuple = ()  # what the publisher was made with
        self._requested: tuple = ()  # what the subscription was made with
        self._count = 0
        self._sender, self._reader = rclpy.create_node('sender'), rclpy.create_node('reader')
        self._publisher = self._timer = self._subscription = None
        self._sliders = Sliders(
            self._want,
            self._sender,
            self._reader,
            depth=Slider(1, 50, depth, help='of the subscription'),
            rate=Slider(1, 100, rate, 'Hz'),
            publisher=_RELIABILITIES,
            subscription=_RELIABILITIES,
        )
        self._sender.create_timer(_LOOK, self._keep_publisher)
        self._sender.create_timer(_PERIOD, lambda: self._sliders.show(self._picture()))
        self._reader.create_timer(_LOOK, self._keep_subscription)
        spinning(self._sender)
        spinning(self._reader)

    def stop(self) -> None:
        """End it; a still with the last picture stays. Idempotent."""
        self._sliders.stop()

    def __repr__(self) -> str:
        return repr(self._sliders)

    # Each node changes its own endpoints, between two callbacks.

    def _want(self, **values) -> str:
        self._wanted = values
        return self._picture() if self.sent else ''

    def _keep_publisher(self) -> None:
        from std_msgs.msg import Int32

        wanted = self._wanted
        offered = wanted['rate'], wanted['publisher']
        if offered != self._offered:
            self._offered = offered
            if self._timer is not None:
                self._sender.destroy_timer(self._timer)
                self._sender.destroy_publisher(self._publisher)
            self._publisher = self._sender.create_publisher(Int32, 'numbers_live', _qos(10, wanted['publisher']))
            self._timer = self._sender.create_timer(1 / wanted['rate'], self._send)

    def _keep_subscription(self) -> None:
        from std_msgs.msg import Int32

        wanted = self._wanted
        requested = wanted['depth'], wanted['subscription']
        if requested != self._requested:
            self._requested = requested
            if self._subscription is not None:
                self._reader.destroy_subscription(self._subscription)
            self._subscription = self._reader.create_subscription(
                Int32, 'numbers_live', self._on_number, _qos(*requested)
            )

    def _send(self) -> None:
        from std_msgs.msg import Int32

        self._count += 1
        self.sent.append((self._count, time.monotonic()))
        self._publisher.publish(Int32(data=self._count))

    def _on_number(self, message) -> None:
        self.read.append((message.data, time.monotonic()))
        time.sleep(WORK)  # the work

    def _picture(self) -> str:
        now = time.monotonic()
        sent = {number: when for number, when in self.sent.copy() if now - when < 2 * _WINDOW}
        read = [(number, when) for number, when in self.read.copy() if now - when < _WINDOW]
        since = min(sent.values(), default=now - _WINDOW)  # less than the window at the beginning
        summary = _summary(now, max(_LOOK, min(_WINDOW, now - since)), sent, read)
        return f'<div>{inline_svg.html(_svg(now, sent, read), _WIDTH, summary)}</div><div>{summary}</div>'


def _qos(depth: int, reliability: str):
    from rclpy.qos import QoSProfile, ReliabilityPolicy

    return QoSProfile(depth=depth, reliability=ReliabilityPolicy[reliability])


def _summary(now: float, seconds: float, sent: dict, read: list) -> str:
    rate = sum(now - when < seconds for when in sent.values()) / seconds
    if not read:
        return f'sent: {rate:.0f} a second; nothing is read'
    ages = [when - sent[number] for number, when in read if number in sent]
    times = [when for _, when in read]
    span = max(times) - min(times)
    heard = min(len(read) / seconds, (len(read) - 1) / span) if span else len(read) / seconds  # n marks, n - 1 pauses
    age = f', on average {sum(ages) / len(ages):.2f} s after it was sent' if ages else ''
    return f'sent: {rate:.0f} a second; read: {heard:.0f} a second{age}'


def _svg(now: float, sent: dict, read: list) -> str:
    def x(when):
        return 60 + (_WIDTH - 70) * (1 - (now - when) / _WINDOW)

    marks = [f'M {x(when):.0f} {_SENT - 6} v 6' for when in sent.values() if now - when < _WINDOW]
    lines = [
        f'M {x(sent[number]):.0f} {_SENT} L {x(when):.0f} {_READ} v 6'
        for number, when in read
        if number in sent and now - sent[number] < _WINDOW
    ]
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{_WIDTH}" viewBox="0 0 {_WIDTH} {_BOTTOM}" '
        f'font-family="sans-serif" font-size="13" fill="currentColor" style="{inline_svg.PAGE_COLOUR}">'
        f'<text x="8" y="{_SENT}">sent</text><text x="8" y="{_READ + 6}">read</text>'
        f'<text x="60" y="{_BOTTOM - 8}">{_WINDOW:.0f} s ago</text>'
        f'<text x="{_WIDTH - 10}" y="{_BOTTOM - 8}" text-anchor="end">now</text>'
        f'<path d="{" ".join(marks)}" stroke="#777777"/>'
        f'<path d="{" ".join(lines)}" stroke="{GOOD if lines else BAD}" fill="none"/></svg>'
    )
