"""Print how late and how often transforms arrive, for all frames or along one chain."""

import sys
from collections import defaultdict, deque

from rclpy.clock import Clock, ClockType
from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, QoSProfile
from rclpy.time import Time
from tf2_msgs.msg import TFMessage
from tf2_py import TransformException
from tf2_ros.buffer import Buffer
from tf2_ros.transform_listener import TransformListener
from tf2_ros_executables.program import ros, spin

AUTHORITY = '<no authority available>'   # DDS does not tell the sender's node
PERIOD = 0.5      # seconds between samples of the chain's delay
SAMPLES = 20      # samples between reports
WEIGHT = 0.01     # of a new sample in the chain's mean delay
HISTORY = 1000    # messages that a mean is taken over


def _recent():
    return deque(maxlen=HISTORY)


class Monitor(Node):
    """
    Collects delays in seconds from the stamps to the arrival, and prints them every ten seconds.

    :param chain: two frame ids to watch only what joins these, or nothing for all frames.
    """

    def __init__(self, chain=()):
        super().__init__('tf2_monitor_main')
        self.asked = tuple(chain)
        self.chain = []
        self.delays = defaultdict(_recent)   # per frame
        self.sender_delays = _recent()
        self.sender_times = _recent()
        self.mean = self.worst = 0.0
        self.samples = None   # None until the chain is known
        self.buffer = Buffer(node=self)
        self.listener = TransformListener(self.buffer, self)
        self.create_subscription(TFMessage, '/tf', self.receive, QoSProfile(depth=100))
        self.create_subscription(TFMessage, '/tf_static', self.receive,
                                 QoSProfile(depth=100, durability=DurabilityPolicy.TRANSIENT_LOCAL))
        self.create_timer(PERIOD, self.tick, clock=Clock(clock_type=ClockType.STEADY_TIME))
        self.tick()

    def now(self):
        """Return the node's time in seconds."""
        return self.get_clock().now().nanoseconds / 1e9

    def receive(self, message):
        """Note how old each transform of a message is."""
        now = self.now()
        ages = []
        for transform in message.transforms:
            stamp = transform.header.stamp
            ages.append(now - (stamp.sec + stamp.nanosec / 1e9))
            self.delays[transform.child_frame_id].append(ages[-1])
        self.sender_delays.append(sum(ages) / max(1, len(ages)))
        self.sender_times.append(now)

    def tick(self):
        """Wait for the chain; then sample its delay; report now and then."""
        if self.samples is None:
            if not self.begin():
                return
            self.samples = 0
        self.samples += 1
        if self.chain:
            self.sample()
        if self.samples > SAMPLES:
            self.samples = 0
            self.report()

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

    def sample(self):
        """Take the delay of the whole chain into account."""
        try:
            stamp = self.buffer.lookup_transform(*self.asked, Time()).header.stamp
        except TransformException as error:   # the tree has changed
            self.get_logger().warning(f'Transform Exception {error}')
            return
        delay = self.now() - (stamp.sec + stamp.nanosec / 1e9)
        self.mean += WEIGHT * (delay - self.mean)
        self.worst = max(self.worst, delay)

    def report(self):
        """Print the collected figures."""
        if self.chain:
            a, b = self.asked
            print(f'\n\n\nRESULTS: for {a} to {b}\n'
                  f'Chain is: {" -> ".join(self.chain)}\n'
                  f'Net delay     avg = {self.mean:g}: max = {self.worst:g}')
        else:
            print('\n\n\nRESULTS: for all Frames')
        print('\nFrames:')
        for frame in sorted(self.delays):
            if not self.chain or frame in self.chain:
                delays = self.delays[frame]
                print(f'Frame: {frame}, published by {AUTHORITY}, Average Delay: {_mean(delays):g}, '
                      f'Max Delay: {max(0.0, *delays):g}')
        sys.stdout.flush()
        print('\nAll Broadcasters:', file=sys.stderr, flush=True)   # stock prints this one line there
        if self.sender_times:
            rate = len(self.sender_times) / max(1e-8, self.sender_times[-1] - self.sender_times[0])
            print(f'Node: {AUTHORITY} {rate:g} Hz, Average Delay: {_mean(self.sender_delays):g} '
                  f'Max Delay: {max(0.0, *self.sender_delays):g}', flush=True)


def _mean(values):
    return sum(values) / len(values)


def main():
    """Run the program; return its exit status."""
    with ros(sys.argv) as argv:
        words = argv[1:]
        if len(words) not in (0, 2):
            print('TF_Monitor: usage: tf2_monitor framea frameb')
            return 255
        spin(Monitor(words))
    return 0
