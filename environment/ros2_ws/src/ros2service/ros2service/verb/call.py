"""The verb `ros2 service call`."""

import time

from ros2cli.helpers import collect_stdin, parse_yaml_dictionary
from ros2cli.node import NODE_NAME_PREFIX

from ros2service.api import ServiceNameCompleter, ServicePrototypeCompleter, ServiceTypeCompleter, load_service_class
from ros2service.verb import VerbExtension


class CallVerb(VerbExtension):
    """Call a service."""

    def add_arguments(self, parser, cli_name):
        """Add the arguments."""
        argument = parser.add_argument('service_name', help='Name of the service, for example /add_two_ints')
        argument.completer = ServiceNameCompleter(include_hidden_services_key='include_hidden_services')
        argument = parser.add_argument('service_type', help='Its type, for example std_srvs/srv/Empty')
        argument.completer = ServiceTypeCompleter(service_name_key='service_name')
        source = parser.add_mutually_exclusive_group()
        argument = source.add_argument(
            'values',
            nargs='?',
            default='{}',
            help="Fields of the request as YAML, for example '{a: 1, b: 2}'; the others keep their defaults",
        )
        argument.completer = ServicePrototypeCompleter(service_type_key='service_type')
        source.add_argument('--stdin', action='store_true', help='Read the fields from standard input')
        parser.add_argument('-r', '--rate', metavar='N', type=float, help='Repeat the call at this rate, in Hz')

    def main(self, *, args):
        """Call the service once, or until Ctrl+C."""
        from ros2cli.node.direct import DirectNode
        from rosidl_runtime_py import set_message_fields

        if args.rate is not None and args.rate <= 0:
            return 'rate must be greater than zero'
        service_class = load_service_class(args.service_type)
        values = parse_yaml_dictionary(
            collect_stdin() if args.stdin else args.values, 'The passed value needs to be a dictionary in YAML format'
        )
        request = service_class.Request()
        try:
            set_message_fields(request, values)
        except Exception as e:
            return f'Failed to populate field: {e}'
        type_name = args.service_type.replace('/srv/', '/').replace('/', '_')
        with DirectNode(None, node_name=f'{NODE_NAME_PREFIX}_requester_{type_name}') as node:
            return self._call(node, service_class, args.service_name, request, args.rate)

    def _call(self, node, service_class, name, request, rate):
        from rclpy.exceptions import InvalidServiceNameException

        try:
            client = node.create_client(service_class, name)
        except (InvalidServiceNameException, ValueError) as e:
            return str(e)
        # The graph is known, so a server that is there shows as soon as the two have matched.
        if not node.spin(until=client.service_is_ready, timeout=0.5):
            print('waiting for service to become available...')
            node.spin(until=client.service_is_ready)
        while True:
            print(f'requester: making request: {request!r}\n')
            called = time.monotonic()
            try:
                response = node.wait_for(client.call_async(request))
            except (AssertionError, TypeError, ValueError, OverflowError) as e:
                return f'Failed to send the request: {e or type(e).__name__}'
            print(f'response:\n{response!r}\n')
            if rate is None:
                return None
            node.spin(timeout=max(0.0, called + 1.0 / rate - time.monotonic()))
