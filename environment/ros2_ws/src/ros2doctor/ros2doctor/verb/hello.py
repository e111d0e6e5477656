"""The verb `ros2 doctor hello`."""

import os
import re
import socket
import time

from ros2cli.helpers import positive_float, positive_int

from ros2doctor.verb import VerbExtension

DEFAULT_GROUP, DEFAULT_PORT = '225.0.0.1', 49150

_GREETING = "hello, it's me "


class SummaryTable:
    """How many greetings were sent since the last summary, and how many came from each other machine."""

    def __init__(self):
        """Begin with none."""
        self.reset()

    def reset(self):
        """Begin anew."""
        self._pub = self._send = 0
        self._sub = {}
        self._receive = {}

    def increment_pub(self):
        """Count a message that was published."""
        self._pub += 1

    def increment_send(self):
        """Count a datagram that was sent."""
        self._send += 1

    def increment_sub(self, hostname):
        """Count a message of a machine."""
        self._sub[hostname] = self._sub.get(hostname, 0) + 1

    def increment_receive(self, hostname):
        """Count a datagram of a machine."""
        self._receive[hostname] = self._receive.get(hostname, 0) + 1

    def format_print_summary(self, topic, print_period, *, group=DEFAULT_GROUP, port=DEFAULT_PORT):
        """Print the summary."""
        print('MULTIMACHINE COMMUNICATION SUMMARY')
        print(f'Topic: {topic}, Published Msg Count: {self._pub}')
        print('Subscribed from:')
        _print_table(self._sub, print_period)
        print(f'Multicast Group/Port: {group}/{port}, Sent Msg Count: {self._send}')
        print('Received from:')
        _print_table(self._receive, print_period)
        print('-' * 60)


class HelloVerb(VerbExtension):
    """Check network connectivity between multiple hosts."""

    def add_arguments(self, parser, cli_name):
        """Add the arguments."""
        parser.add_argument(
            '-t', '--topic', nargs='?', default='/canyouhearme', help='Topic to use (default: /canyouhearme)'
        )
        parser.add_argument(
            '-ep',
            '--emit-period',
            metavar='N',
            type=positive_float,
            default=0.1,
            help='Seconds between two messages (default: 0.1)',
        )
        parser.add_argument(
            '-pp',
            '--print-period',
            metavar='N',
            type=positive_float,
            default=1.0,
            help='Seconds between two summaries (default: 1.0)',
        )
        parser.add_argument('--ttl', type=positive_int, help='How many routers a multicast datagram may pass')
        parser.add_argument(
            '-1', '--once', action='store_true', help='Greet once, listen for the emit period, and print one summary'
        )

    def main(self, *, args, summary_table=None):
        """Publish and send, and print who is heard, until Ctrl+C."""
        from ros2cli.node.direct import DirectNode
        from std_msgs.msg import String

        table = SummaryTable() if summary_table is None else summary_table
        me = socket.gethostname()
        name = f'ros2doctor_{re.sub(r"[^0-9a-zA-Z_]", "_", me)}_{os.getpid()}_node'
        greeting = _GREETING + me
        with (
            DirectNode(None, node_name=name, discover=False) as node,
            _receiver() as receiver,
            _sender(args.ttl) as sender,
        ):
            publisher = node.create_publisher(String, args.topic, 10)
            node.create_subscription(String, args.topic, lambda heard: _count(heard.data, me, table.increment_sub), 10)

            def listen():
                for words in _datagrams(receiver):
                    _count(words, me, table.increment_receive)
                return False

            printed = time.monotonic()
            while True:
                if time.monotonic() - printed > args.print_period:
                    table.format_print_summary(args.topic, args.print_period)
                    table.reset()
                    printed = time.monotonic()
                table.increment_pub()
                publisher.publish(String(data=greeting))
                _send(sender, greeting, table)
                node.spin(until=listen, timeout=args.emit_period)
                if args.once:
                    table.format_print_summary(args.topic, args.print_period)
                    return


def _count(words, me, increment):
    # As on a stock machine, a greeting ends in the machine's name, and one's own machine is not counted.
    sender = words.rpartition(' ')[2]
    if words.startswith(_GREETING) and sender != me:
        increment(sender)


def _send(sender, greeting, table):
    try:
        sender.sendto(greeting.encode(), (DEFAULT_GROUP, DEFAULT_PORT))
    except OSError:  # no network: the summary shows that nothing was sent
        return
    table.increment_send()


def _datagrams(receiver):
    while True:
        try:
            yield receiver.recv(4096).decode(errors='replace')
        except BlockingIOError:
            return


def _receiver():
    receiver = socket.socket(socket.AF_INET, socket.SOCK_DGRAM, socket.IPPROTO_UDP)
    receiver.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
    receiver.bind(('', DEFAULT_PORT))
    try:
        receiver.setsockopt(
            socket.IPPROTO_IP, socket.IP_ADD_MEMBERSHIP, socket.inet_aton(DEFAULT_GROUP) + socket.inet_aton('0.0.0.0')
        )
    except OSError:  # no network: nothing will be heard
        pass
    receiver.setblocking(False)
    return receiver


def _sender(ttl):
    sender = socket.socket(socket.AF_INET, socket.SOCK_DGRAM, socket.IPPROTO_UDP)
    if ttl is not None:
        sender.setsockopt(socket.IPPROTO_IP, socket.IP_MULTICAST_TTL, ttl)
    return sender


def _print_table(heard, period):
    for sender, count in [('Hostname', f'Msg Count /{period}s'), *heard.items()]:
        print(f'{"":<15} {sender:<20} {count:<10}')
