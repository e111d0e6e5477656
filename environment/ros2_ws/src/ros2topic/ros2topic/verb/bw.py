"""The verb `ros2 topic bw`."""

import time
from collections import deque

from ros2cli.helpers import positive_int
from ros2cli.node.arguments import add_direct_arguments

from ros2topic.api import TopicNameCompleter, get_msg_class
from ros2topic.verb import VerbExtension

DEFAULT_WINDOW_SIZE = 100


class BwVerb(VerbExtension):
    """Display bandwidth used by topic."""

    def add_arguments(self, parser, cli_name):
        """Add the arguments."""
        parser.description = (
            'Display bandwidth used by topic.\n\n'
            'It is that of the messages that arrive here; with a busy machine or another quality of service\n'
            'it need not be what is published.'
        )
        argument = parser.add_argument('topic', help='Name of the topic whose bandwidth to measure')
        argument.completer = TopicNameCompleter(include_hidden_topics_key='include_hidden_topics')
        parser.add_argument(
            '--window',
            '-w',
            type=positive_int,
            default=DEFAULT_WINDOW_SIZE,
            metavar='WINDOW',
            help=f'How many of the latest messages to average over (default: {DEFAULT_WINDOW_SIZE})',
        )
        add_direct_arguments(parser)

    def main(self, *, args):
        """Print the bandwidth every second until Ctrl+C."""
        from rclpy.qos import qos_profile_sensor_data
        from ros2cli.node.direct import DirectNode

        with DirectNode(args) as node:
            message_class = get_msg_class(node, args.topic, blocking=True, include_hidden_topics=True)
            meter = _BandwidthMeter(node.get_clock() if args.use_sim_time else None, args.window)
            node.create_subscription(message_class, args.topic, meter.receive, qos_profile_sensor_data, raw=True)
            print(f'Subscribed to [{args.topic}]')
            node.create_timer(1.0, meter.print)
            node.spin()


class _BandwidthMeter:
    def __init__(self, clock, window_size):
        self._clock = clock
        self._received = deque(maxlen=window_size)  # (seconds, bytes)

    def _now(self):
        return time.monotonic() if self._clock is None else self._clock.now().nanoseconds * 1e-9

    def receive(self, data):
        self._received.append((self._now(), len(data)))

    def print(self):
        if len(self._received) < 2:
            return
        duration = self._now() - self._received[0][0]
        if duration <= 0:  # simulated time went back
            self._received.clear()
            return
        sizes = [size for _, size in self._received]
        per_second = sum(sizes) / duration
        # One unit for all figures of a line, chosen by the bandwidth.
        if per_second < 1000:

            def text(size):
                return f'{size:.0f} B'
        elif per_second < 1_000_000:

            def text(size):
                return f'{size / 1000:.2f} KB'
        else:

            def text(size):
                return f'{size / 1_000_000:.2f} MB'

        print(
            f'{text(per_second)}/s from {len(sizes)} messages\n\tMessage size mean: {text(sum(sizes) / len(sizes))}'
            f' min: {text(min(sizes))} max: {text(max(sizes))}'
        )
