"""The verb `ros2 topic pub`."""

from ros2cli.helpers import collect_stdin, parse_yaml_dictionary, positive_float, unsigned_int
from ros2cli.node.arguments import add_direct_arguments

from ros2topic.api import (
    TopicMessagePrototypeCompleter,
    TopicNameCompleter,
    TopicTypeCompleter,
    expand_topic,
    load_message_class,
)
from ros2topic.verb import VerbExtension


class PubVerb(VerbExtension):
    """Publish a message to a topic."""

    def add_arguments(self, parser, cli_name):
        """Add the arguments."""
        from ros2topic.api.qos import add_qos_arguments

        argument = parser.add_argument('topic_name', help='Name of the topic to publish on, for example /chatter')
        argument.completer = TopicNameCompleter(include_hidden_topics_key='include_hidden_topics')
        argument = parser.add_argument('message_type', help='Type of the message, for example std_msgs/msg/String')
        argument.completer = TopicTypeCompleter(topic_name_key='topic_name')
        source = parser.add_mutually_exclusive_group()
        argument = source.add_argument(
            'values',
            nargs='?',
            default='{}',
            help="Fields of the message as YAML, for example 'data: Hello World'; the others keep their defaults. "
            "'now' for a time and 'auto' for a header mean the time of publishing",
        )
        argument.completer = TopicMessagePrototypeCompleter(topic_type_key='message_type')
        source.add_argument('--stdin', action='store_true', help='Read the fields from standard input')
        parser.add_argument(
            '-r',
            '--rate',
            metavar='N',
            type=positive_float,
            default=1.0,
            help='How often to publish, in Hz (default: 1)',
        )
        parser.add_argument(
            '-p', '--print', metavar='N', type=int, default=1, help='Print only every Nth message (default: 1)'
        )
        count = parser.add_mutually_exclusive_group()
        count.add_argument('-1', '--once', action='store_true', help='Publish one message and end')
        count.add_argument('-t', '--times', type=unsigned_int, default=0, help='Publish so many messages and end')
        parser.add_argument(
            '-w',
            '--wait-matching-subscriptions',
            type=unsigned_int,
            default=None,
            help='Wait for so many matching subscriptions (default: 1 with --once or --times, otherwise 0)',
        )
        parser.add_argument(
            '--max-wait-time-secs',
            type=positive_float,
            default=None,
            help='Give up waiting for subscriptions after so many seconds (default: never)',
        )
        parser.add_argument(
            '--keep-alive',
            metavar='N',
            type=positive_float,
            default=0.1,
            help='Stay for N seconds after the last message, so that it is delivered (default: 0.1)',
        )
        parser.add_argument('-n', '--node-name', help='Name of the publishing node')
        add_qos_arguments(parser, 'publish')
        add_direct_arguments(parser)

    def main(self, *, args):
        """Publish until Ctrl+C or as often as asked."""
        from rclpy.exceptions import InvalidNodeNameException
        from rclpy.validate_node_name import validate_node_name
        from ros2cli.node.direct import DirectNode

        if args.wait_matching_subscriptions is None:
            args.wait_matching_subscriptions = int(args.once or args.times > 0)
        if args.max_wait_time_secs is not None and not args.wait_matching_subscriptions:
            return '--max-wait-time-secs option is only effective with --wait-matching-subscriptions, --once or --times'
        message_class = load_message_class(args.message_type)
        values = parse_yaml_dictionary(
            collect_stdin() if args.stdin else args.values, 'The passed value needs to be a dictionary in YAML format'
        )
        if args.node_name:
            try:
                validate_node_name(args.node_name)
            except InvalidNodeNameException as e:
                return str(e)
        with DirectNode(args, node_name=args.node_name) as node:
            expand_topic(node, args.topic_name)
            return self._publish(node, message_class, values, args)

    def _publish(self, node, message_class, values, args):
        from rosidl_runtime_py import set_message_fields

        from ros2topic.api.qos import qos_profile_from_arguments

        message = message_class()
        try:
            stamps = set_message_fields(message, values, expand_header_auto=True, expand_time_now=True)
        except Exception as e:
            return f'Failed to populate field: {e}'
        times = 1 if args.once else args.times
        publisher = node.create_publisher(message_class, args.topic_name, qos_profile_from_arguments(args))
        wanted = args.wait_matching_subscriptions
        if not self._wait(node, publisher, wanted, args.max_wait_time_secs):
            return (
                f'Timed out waiting for subscribers: Expected {wanted} subcribers but only got '
                f'{publisher.get_subscription_count()} subscribers'
            )

        print('publisher: beginning loop')
        count = 0

        def publish():
            nonlocal count
            now = node.get_clock().now().to_msg()
            for set_stamp in stamps:
                set_stamp(now)
            count += 1
            if args.print and count % args.print == 0:
                print(f'publishing #{count}: {message!r}\n')
            try:
                publisher.publish(message)
            except (AssertionError, TypeError, ValueError, OverflowError) as e:
                raise RuntimeError(f'Failed to publish: {e or type(e).__name__}') from None

        publish()
        if times != 1:
            timer = node.create_timer(1.0 / args.rate, publish)
            node.spin(until=lambda: times and count >= times)
            timer.cancel()
        self._deliver(node, publisher, args.keep_alive)

    def _wait(self, node, publisher, wanted, timeout):
        waited = 0.0
        while publisher.get_subscription_count() < wanted:
            print(f'Waiting for at least {wanted} matching subscription(s)...')
            step = 1.0 if timeout is None else min(1.0, timeout - waited)
            if step <= 0 or node.spin(until=lambda: publisher.get_subscription_count() >= wanted, timeout=step):
                break
            waited += step
        return publisher.get_subscription_count() >= wanted

    def _deliver(self, node, publisher, seconds):
        from rclpy.duration import Duration

        # Reliable subscribers acknowledge; nobody tells of the others, and of those with a slow machine.
        try:
            publisher.wait_for_all_acked(Duration(seconds=2))
        except Exception:  # not every middleware can
            pass
        node.spin(timeout=seconds)
