"""The command `ros2 multicast`: does a datagram of one machine reach another one?"""

from ros2multicast.api import DEFAULT_GROUP, DEFAULT_PORT, receive, send

from ros2cli.command import CommandWithVerbs
from ros2cli.verb import VerbExtension

_MESSAGE = b'Hello World!'


class MulticastCommand(CommandWithVerbs):
    """Various multicast related sub-commands."""

    VERB_GROUP = 'ros2multicast.verb'


def _add_arguments(parser):
    parser.add_argument('--group', default=DEFAULT_GROUP, help=f'Multicast group (default: {DEFAULT_GROUP})')
    parser.add_argument('--port', type=int, default=DEFAULT_PORT, help=f'UDP port (default: {DEFAULT_PORT})')


class SendVerb(VerbExtension):
    """Send a single UDP multicast packet."""

    def add_arguments(self, parser, cli_name):
        """Add the arguments."""
        _add_arguments(parser)
        parser.add_argument('--ttl', type=int, help='How many routers it may pass')

    def main(self, *, args):
        """Send it."""
        print('Sending one UDP multicast datagram...')
        try:
            send(_MESSAGE, group=args.group, port=args.port, ttl=args.ttl)
        except (OSError, OverflowError) as error:
            return f'The datagram was not sent: {error}'


class ReceiveVerb(VerbExtension):
    """Receive a single UDP multicast packet."""

    def add_arguments(self, parser, cli_name):
        """Add the arguments."""
        _add_arguments(parser)
        parser.add_argument('--timeout', type=float, help='Give up after so many seconds (default: never)')

    def main(self, *, args):
        """Wait for it and print it."""
        try:
            print('Waiting for UDP multicast datagram...')
            data, (host, port) = receive(group=args.group, port=args.port, timeout=args.timeout)
        except KeyboardInterrupt:  # how a wait without an end is given up
            return None
        except TimeoutError:
            return f'No datagram came within {args.timeout:g} s'
        except (OSError, OverflowError) as error:
            return f'Nothing can be received: {error}'
        print(f"Received from {host}:{port}: '{data.decode(errors='replace')}'")
