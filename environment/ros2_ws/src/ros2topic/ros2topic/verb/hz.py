"""The verb `ros2 topic hz`."""

from ros2cli.helpers import positive_int
from ros2cli.node.arguments import add_direct_arguments

from ros2topic.api import TopicNameCompleter, get_msg_class
from ros2topic.verb import VerbExtension

DEFAULT_WINDOW_SIZE = 10000
_SECOND = 1_000_000_000


class HzVerb(VerbExtension):
    """Print the average receiving rate to screen."""

    def add_arguments(self, parser, cli_name):
        """Add the arguments."""
        parser.description = (
            'Print the average receiving rate to screen.\n\n'
            'The rate is that of the messages that arrive here; with a busy machine or another quality of service\n'
            'it need not be the rate at which they are published.'
        )
        argument = parser.add_argument('topic_name', help='Name of the topic to listen to, for example /chatter')
        argument.completer = TopicNameCompleter(include_hidden_topics_key='include_hidden_topics')
        parser.add_argument(
            '--window',
            '-w',
            dest='window_size',
            type=positive_int,
            default=DEFAULT_WINDOW_SIZE,
            metavar='WINDOW',
            help=f'How many of the latest messages to average over (default: {DEFAULT_WINDOW_SIZE})',
        )
        parser.add_argument(
            '--filter',
            dest='filter_expr',
            default=None,
            metavar='EXPR',
            help='Python expression that chooses which messages count; m is the message',
        )
        parser.add_argument(
            '--wall-time',
            dest='use_wtime',
            action='store_true',
            help='Measure in wall time, for a simulation that publishes no clock',
        )
        add_direct_arguments(parser)

    def main(self, *, args):
        """Print the rate about every second until Ctrl+C."""
        from rclpy.clock import Clock, ClockType
        from rclpy.qos import qos_profile_sensor_data
        from ros2cli.node.direct import DirectNode

        with DirectNode(args) as node:
            message_class = get_msg_class(node, args.topic_name, blocking=True, include_hidden_topics=True)
            clock = Clock(clock_type=ClockType.SYSTEM_TIME) if args.use_wtime else node.get_clock()
            meter = _RateMeter(clock, args.window_size, args.filter_expr)
            node.create_subscription(
                message_class, args.topic_name, meter.receive, qos_profile_sensor_data, raw=args.filter_expr is None
            )
            node.spin(until=meter.print_if_due)


class _RateMeter:
    def __init__(self, clock, window_size, filter_expr):
        from ros2topic.api.statistics import Window

        self._clock = clock
        self._code = compile(filter_expr, '--filter', 'eval') if filter_expr else None
        self._intervals = Window(window_size)
        self._latest = None
        self._printed = None

    def receive(self, msg):
        if self._code is not None and not eval(self._code, {'m': msg}):
            return
        now = self._clock.now().nanoseconds
        if now == 0 or (self._latest is not None and now < self._latest):
            if self._intervals:
                print('time has reset, resetting counters')
            self._intervals.clear()
            self._latest = self._printed = None if now == 0 else now
            return
        if self._latest is not None:
            self._intervals.add(now - self._latest)
        self._latest = now

    def print_if_due(self):
        if not self._intervals:
            return False
        if self._printed is None:
            self._printed = self._latest
        elif self._latest >= self._printed + _SECOND:
            self._printed = self._latest
            summary = self._intervals.summary()
            print(f'average rate: {_SECOND / summary.mean if summary.mean > 0 else 0:.3f}\n{summary.line()}')
        return False
