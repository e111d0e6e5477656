"""The verb `ros2 service echo`."""

from ros2cli.helpers import unsigned_int
from ros2cli.node.arguments import add_arguments

from ros2service.api import ServiceNameCompleter, ServiceTypeCompleter, get_service_class, load_service_class
from ros2service.verb import VerbExtension

DEFAULT_TRUNCATE_LENGTH = 128


class EchoVerb(VerbExtension):
    """Echo a service."""

    def add_arguments(self, parser, cli_name):
        """Add the arguments."""
        from ros2topic.api.qos import add_qos_arguments

        parser.description = (
            'Print the requests and responses of a service.\n\n'
            'Only services and clients that were told to publish their events are heard (configure_introspection).'
        )
        add_arguments(parser)
        argument = parser.add_argument('service_name', help='Name of the service, for example /add_two_ints')
        argument.completer = ServiceNameCompleter(include_hidden_services_key='include_hidden_services')
        argument = parser.add_argument('service_type', nargs='?', help='Its type, for example std_srvs/srv/Empty')
        argument.completer = ServiceTypeCompleter(service_name_key='service_name')
        add_qos_arguments(parser, 'subscribe', 'services_default')
        parser.add_argument(
            '--csv', action='store_true', help='Print the values of all fields in a line, separated by commas'
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

    def main(self, *, args):
        """Print the events until Ctrl+C."""
        from ros2cli.node.strategy import NodeStrategy
        from ros2topic.api.qos import qos_profile_from_arguments

        with NodeStrategy(args) as node:
            if args.service_type is None:
                service_class = get_service_class(node, args.service_name, include_hidden_services=True)
            else:
                service_class = load_service_class(args.service_type)
            if service_class is None:
                return 'Could not load the type for the passed service'
            node.create_subscription(
                service_class.Event,
                f'{args.service_name}/_service_event',
                lambda event: _print(event, args),
                qos_profile_from_arguments(args),
            )
            node.spin()


def _print(event, args):
    from rosidl_runtime_py import message_to_csv, message_to_ordereddict
    from rosidl_runtime_py.convert import dump_yaml
    from service_msgs.msg import ServiceEventInfo

    how = {
        'truncate_length': None if args.full_length else args.truncate_length,
        'no_arr': args.no_arr,
        'no_str': args.no_str,
    }
    names = {
        getattr(ServiceEventInfo, name): name
        for name in ('REQUEST_SENT', 'REQUEST_RECEIVED', 'RESPONSE_SENT', 'RESPONSE_RECEIVED')
    }
    kind = names.get(event.info.event_type, str(event.info.event_type))
    if args.csv:
        print(kind + ',' + message_to_csv(event, **how).partition(',')[2])
        return
    fields = message_to_ordereddict(event, **how)
    fields['info']['event_type'] = kind
    print(dump_yaml(fields, args.flow_style), end='---\n')
