"""The command `ros2 multicast`: does a datagram of one machine reach another one?"""

import socket
import struct

from ros2cli.command import CommandWithVerbs
from ros2cli.verb import VerbExtension

DEFAULT_GROUP, DEFAULT_PORT = '225.0.0.1', 49150
_MESSAGE = b'Hello World!'
_LARGEST = 4096


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
            with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as sender:
                if args.ttl is not None:
                    sender.setsockopt(socket.IPPROTO_IP, socket.IP_MULTICAST_TTL, args.ttl)
                sender.sendto(_MESSAGE, (args.group, args.port))
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
            with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as receiver:
                receiver.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
                receiver.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEPORT, 1)
                receiver.bind(('', args.port))
                membership = struct.pack('4sl', socket.inet_aton(args.group), socket.INADDR_ANY)
                receiver.setsockopt(socket.IPPROTO_IP, socket.IP_ADD_MEMBERSHIP, membership)
                receiver.settimeout(args.timeout)
                print('Waiting for UDP multicast datagram...')
                data, (host, port) = receiver.recvfrom(_LARGEST)
        except KeyboardInterrupt:  # how a wait without an end is given up
            return None
        except TimeoutError:
            return f'No datagram came within {args.timeout:g} s'
        except (OSError, OverflowError) as error:
            return f'Nothing can be received: {error}'
        print(f"Received from {host}:{port}: '{data.decode(errors='replace')}'")
