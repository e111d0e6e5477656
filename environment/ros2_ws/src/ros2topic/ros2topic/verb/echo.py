"""The verb `ros2 topic echo`."""

from ros2cli.helpers import positive_float, unsigned_int
from ros2cli.node.arguments import add_arguments

from ros2topic.api import TopicNameCompleter, expand_topic, get_msg_class, load_message_class
from ros2topic.verb import VerbExtension

DEFAULT_TRUNCATE_LENGTH = 128


class EchoVerb(VerbExtension):
    """Output messages from a topic."""

    def add_arguments(self, parser, cli_name):
        """Add the arguments."""
        from ros2topic.api.qos import add_qos_arguments

        add_arguments(parser)
        argument = parser.add_argument('topic_name', help='Name of the topic to listen to, for example /chatter')
        argument.completer = TopicNameCompleter(include_hidden_topics_key='include_hidden_topics')
        parser.add_argument('message_type', nargs='?', help='Type of its messages, for example std_msgs/msg/String')
        add_qos_arguments(parser, 'subscribe', 'sensor_data', 'what all publishers offer')
        parser.add_argument(
            '--csv',
            action='store_true',
            help='Print the values of all fields in a line, separated by commas, for example to plot them. With '
            '--include-message-info these come first: source_timestamp, received_timestamp, '
            'publication_sequence_number, reception_sequence_number',
        )
        parser.add_argument(
            '--field',
            default=None,
            help="Print only this field; '.' leads into a field, for example --field pose.pose.position",
        )
        parser.add_argument(
            '--full-length', '-f', action='store_true', help='Do not cut arrays, bytes and strings short'
        )
        parser.add_argument(
            '--truncate-length',
            '-l',
            type=unsigned_int,
            default=DEFAULT_TRUNCATE_LENGTH,
            help=f'How many elements of arrays, bytes and strings to print (default: {DEFAULT_TRUNCATE_LENGTH})',
        )
        parser.add_argument('--no-arr', action='store_true', help='Print type and length of arrays, not their elements')
        parser.add_argument('--no-str', action='store_true', help='Print the length of strings, not their text')
        parser.add_argument('--flow-style', action='store_true', help='Print each list in one line (not with --csv)')
        parser.add_argument('--lost-messages', action='store_true', help='Does nothing: lost messages are reported')
        parser.add_argument('--no-lost-messages', action='store_true', help='Do not report lost messages')
        parser.add_argument('--raw', action='store_true', help='Print the messages as they are on the wire')
        parser.add_argument(
            '--filter',
            dest='filter_expr',
            help='Python expression that chooses which messages are printed; m is the message',
        )
        parser.add_argument('--once', action='store_true', help='End after the first message')
        parser.add_argument('--timeout', metavar='N', type=positive_float, help='End after N seconds', default=None)
        parser.add_argument(
            '--include-message-info', '-i', action='store_true', help='Print when each message was sent and received'
        )

    def main(self, *, args):
        """Print messages until Ctrl+C."""
        from rclpy.event_handler import SubscriptionEventCallbacks, UnsupportedEventTypeError
        from ros2cli.node.strategy import NodeStrategy

        from ros2topic.api.qos import choose_qos

        printer = _Printer(args)
        with NodeStrategy(args) as node:
            expand_topic(node, args.topic_name)
            qos_profile = choose_qos(node, args.topic_name, args)
            if args.message_type is None:
                message_class = get_msg_class(node, args.topic_name, include_hidden_topics=True)
            else:
                message_class = load_message_class(args.message_type)
            if message_class is None:
                return 'Could not determine the type for the passed topic'

            def subscribe(event_callbacks):
                return node.create_subscription(
                    message_class, args.topic_name, printer, qos_profile, event_callbacks=event_callbacks, raw=args.raw
                )

            try:
                subscribe(None if args.no_lost_messages else SubscriptionEventCallbacks(message_lost=_report_lost))
            except UnsupportedEventTypeError:  # not every middleware tells
                subscribe(None)
            node.spin(until=lambda: args.once and printer.printed > 0, timeout=args.timeout)


class _Printer:
    """The subscription's callback."""

    def __init__(self, args):
        self.args = args
        self.printed = 0
        self.fields = None if args.field is None else [name for name in args.field.split('.') if name]
        if self.fields == []:
            raise RuntimeError(f"Invalid field value '{args.field}'")
        self.code = None
        if args.filter_expr:
            try:
                self.code = compile(args.filter_expr, '--filter', 'eval')
            except SyntaxError as e:
                raise RuntimeError(f'Invalid filter expression: {e.msg}') from None
        self.how = {
            'truncate_length': None if args.full_length else args.truncate_length,
            'no_arr': args.no_arr,
            'no_str': args.no_str,
        }

    # rclpy looks at the parameters to see whether the information is wanted.
    def __call__(self, msg, info):
        if self.args.once and self.printed:
            return
        value = self._chosen(msg)
        if self.code is not None and not self._passes(value):
            return
        self.printed += 1
        if not hasattr(value, 'get_fields_and_field_types'):
            self._print_bare(value, info)
        elif self.args.csv:
            self._print_csv(value, info)
        else:
            self._print_yaml(value, info)

    def _chosen(self, value):
        for name in self.fields or ():
            try:
                value = getattr(value, name)
            except AttributeError as e:
                raise RuntimeError(f"Invalid field '{'.'.join(self.fields)}': {e}") from None
        return value

    def _passes(self, value):
        try:
            return eval(self.code, {'m': value})
        except Exception as e:
            raise RuntimeError(f'The filter expression failed: {type(e).__name__}: {e}') from None

    def _print_bare(self, value, info):
        if self.args.include_message_info:
            print(f'---Got new message, message info:---\n{info}\n---Message data:---')
        print(value, end='\n---\n')

    def _print_csv(self, value, info):
        from rosidl_runtime_py import message_to_csv

        line = message_to_csv(value, **self.how)
        if self.args.include_message_info:
            line = ','.join([*map(str, info.values()), line])
        print(line)

    def _print_yaml(self, value, info):
        from rosidl_runtime_py import message_to_yaml

        text = message_to_yaml(value, flow_style=self.args.flow_style, **self.how)
        if self.args.include_message_info:
            import yaml

            print(yaml.dump(dict(info)), end='---\n')
        print(text, end='---\n')


def _report_lost(status):
    print(
        f'A message was lost!!!\n\ttotal count change:{status.total_count_change}\n\ttotal count: {status.total_count}',
        end='---\n',
    )
