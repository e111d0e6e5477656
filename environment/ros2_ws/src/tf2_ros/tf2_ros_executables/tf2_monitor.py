"""Print how late and how often transforms arrive, for all frames or along one chain."""

from collections import defaultdict, deque

import rclpy
from node_program.running import ros
from rclpy.clock import Clock, ClockType
from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, QoSProfile
from rclpy.time import Time
from tf2_msgs.msg import TFMessage
from tf2_py import TransformException
from tf2_ros.buffer import Buffer
from tf2_ros.transform_listener import TransformListener

AUTHORITY = '<no authority available>'  # DDS does not tell the sender's node
PERIOD = 0.5  # seconds between samples of the chain's delay
SAMPLES = 20  # samples between reports
WEIGHT = 0.01  # of a new sample in the chain's mean delay
HISTORY = 1000  # messages that a mean is taken over


def _recent():
    return deque(maxlen=HISTORY)


def _seconds(stamp):
    return stamp.sec + stamp.nanosec / 1e9


def _figures(delays):
    return f'{sum(delays) / len(delays):g}', f'{max(0.0, *delays):g}'


class Delays:
    """How long transforms took from their stamps to their arrival, in seconds; without ROS."""

    def __init__(self):
        self._frames = defaultdict(_recent)
        self._messages = _recent()  # the mean of each message
        self._arrivals = _recent()
        self._chain_mean = self._chain_worst = 0.0

    def receive(self, message, now):
        """Note how old each transform of a message is."""
        ages = []
        for transform in message.transforms:
            ages.append(now - _seconds(transform.header.stamp))
            self._frames[transform.child_frame_id].append(ages[-1])
        self._messages.append(sum(ages) / max(1, len(ages)))
        self._arrivals.append(now)

    def sample_chain(self, stamp, now):
        """Note how old the latest transform along the chain is."""
        delay = now - _seconds(stamp)
        self._chain_mean += WEIGHT * (delay - self._chain_mean)
        self._chain_worst = max(self._chain_worst, delay)

    def report(self, chain=()):
        """Return the report in stock's words: for all frames, or for those on a chain."""
        if chain:
            lines = [
                f'\n\n\nRESULTS: for {chain[0]} to {chain[-1]}',
                f'Chain is: {" -> ".join(chain)}',
                f'Net delay     avg = {self._chain_mean:g}: max = {self._chain_worst:g}',
            ]
        else:
            lines = ['\n\n\nRESULTS: for all Frames']
        lines.append('\nFrames:')
        for frame in sorted(self._frames):
            if not chain or frame in chain:
                mean, worst = _figures(self._frames[frame])
                lines.append(f'Frame: {frame}, published by {AUTHORITY}, Average Delay: {mean}, Max Delay: {worst}')
        lines.append('\nAll Broadcasters:')
        if self._arrivals:
            rate = len(self._arrivals) / max(1e-8, self._arrivals[-1] - self._arrivals[0])
            mean, worst = _figures(self._messages)
            lines.append(f'Node: {AUTHORITY} {rate:g} Hz, Average Delay: {mean} Max Delay: {worst}')
        return '\n'.join(lines)


class Monitor(Node):
    """
    Prints the delays every ten seconds.

    :param asked: two frame ids to watch only what joins these, or nothing for all frames.
    """

    def __init__(self, asked=()):
        super().__init__('tf2_monitor_main')
        self.asked = tuple(asked)
        self.chain = []
        self.delays = Delays()
        self.samples = None  # None until the chain is known
        self.buffer = Buffer(node=self)
        self.listener = TransformListener(self.buffer, self)
        self.create_subscription(TFMessage, '/tf', self.receive, QoSProfile(depth=100))
        self.create_subscription(
            TFMessage, '/tf_static', self.receive, QoSProfile(depth=100, durability=DurabilityPolicy.TRANSIENT_LOCAL)
        )
        self.create_timer(PERIOD, self.tick, clock=Clock(clock_type=ClockType.STEADY_TIME))
        self.tick()

    def now(self):
        """Return the node's time in seconds."""
        return self.get_clock().now().nanoseconds / 1e9

    def receive(self, message):
        """Take a message into account."""
        self.delays.receive(message, self.now())

    def tick(self):
        """Wait for the chain; then sample its delay; report now and then."""
        if self.samples is None:
            if not self.begin():
                return
            self.samples = 0
        self.samples += 1
        if self.chain:
            try:
                self.delays.sample_chain(self.buffer.lookup_transform(*self.asked, Time()).header.stamp, self.now())
            except TransformException as error:  # the tree has changed
                self.get_logger().warning(f'Transform Exception {error}')
        if self.samples > SAMPLES:
            self.samples = 0
            print(self.delays.report(self.chain), flush=True)

    def begin(self):
        """Return whether there is something to watch; say so, or what is missing."""
        if not self.asked:
            print('Gathering data on all frames for 10 seconds...', flush=True)
            return True
        a, b = self.asked
        known, why_not = self.buffer.can_transform(a, b, Time(), return_debug_tuple=True)
        if not known:
            print(f'Waiting for transform {a} ->  {b}: {why_not}', flush=True)
            return False
        try:
            self.chain = self.buffer._chain(b, Time(), a, Time(), b)
        except TransformException as error:
            self.get_logger().warning(f'Transform Exception {error}')
            return False
        print(f'Gathering data on {a} -> {b} for 10 seconds...', flush=True)
        return True


def main():
    """Run the program; return its exit status."""
    with ros() as (words, executor):
        if len(words) not in (0, 2):
            print('TF_Monitor: usage: tf2_monitor framea frameb')
            return 255
        rclpy.spin(Monitor(words), executor)
    return 0
