"""The verb `ros2 topic delay`."""

from ros2cli.helpers import positive_int
from ros2cli.node.arguments import add_direct_arguments

from ros2topic.api import TopicNameCompleter, get_msg_class
from ros2topic.verb import VerbExtension

DEFAULT_WINDOW_SIZE = 10000


class DelayVerb(VerbExtension):
    """Display delay of topic from timestamp in header."""

    def add_arguments(self, parser, cli_name):
        """Add the arguments."""
        argument = parser.add_argument('topic', help='Name of the topic whose delay to measure')
        argument.completer = TopicNameCompleter(include_hidden_topics_key='include_hidden_topics')
        parser.add_argument(
            '--window',
            '-w',
            type=positive_int,
            default=DEFAULT_WINDOW_SIZE,
            help=f'How many of the latest messages to average over (default: {DEFAULT_WINDOW_SIZE})',
        )
        add_direct_arguments(parser)

    def main(self, *, args):
        """Print the delay every second until Ctrl+C."""
        from rclpy.qos import qos_profile_sensor_data
        from ros2cli.node.direct import DirectNode

        with DirectNode(args) as node:
            message_class = get_msg_class(node, args.topic, blocking=True, include_hidden_topics=True)
            meter = _DelayMeter(node.get_clock(), args.window)
            node.create_subscription(message_class, args.topic, meter.receive, qos_profile_sensor_data)
            node.create_timer(1.0, meter.print)
            node.spin()


class _DelayMeter:
    def __init__(self, clock, window_size):
        from ros2topic.api.statistics import Window

        self._clock = clock
        self._delays = Window(window_size)
        self._latest = None
        self._printed = None

    def receive(self, msg):
        from rclpy.time import Time

        if not hasattr(msg, 'header'):
            raise RuntimeError('msg does not have header')
        now = self._clock.now().nanoseconds
        if now == 0 or (self._latest is not None and now < self._latest):
            if self._delays:
                print('time has reset, resetting counters')
            self._delays.clear()
        if now == 0:
            return
        self._delays.add(now - Time.from_msg(msg.header.stamp).nanoseconds)
        self._latest = now

    def print(self):
        if not self._delays:
            return
        if self._latest == self._printed:
            print('no new messages')
            return
        self._printed = self._latest
        summary = self._delays.summary()
        print(f'average delay: {summary.mean * 1e-9:.3f}\n{summary.line()}')
