"""The verb `ros2 doctor hello`."""

import os
import socket

from ros2cli.helpers import positive_float

from ros2doctor.verb import VerbExtension

_GROUP, _PORT = '225.0.0.1', 49150


class HelloVerb(VerbExtension):
    """Check network connectivity between multiple hosts."""

    def add_arguments(self, parser, cli_name):
        """Add the arguments."""
        parser.add_argument('-t', '--topic', default='/canyouhearme', help='Topic to use (default: /canyouhearme)')
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
        parser.add_argument('--ttl', type=int, help='How many routers a multicast datagram may pass')
        parser.add_argument('-1', '--once', action='store_true', help='End after one summary')

    def main(self, *, args):
        """Publish and send, and print who is heard, until Ctrl+C."""
        from ros2cli.node.direct import DirectNode
        from std_msgs.msg import String

        me = f'{socket.gethostname()}/{os.getpid()}'
        text = f"hello, it's me {me}"
        heard_topic, heard_multicast = {}, {}
        sent = {'topic': 0, 'multicast': 0}

        def hear(store, words):
            sender = words.rpartition(' ')[2]
            if words.startswith("hello, it's me ") and sender != me:
                store[sender] = store.get(sender, 0) + 1

        with DirectNode(None, discover=False) as node, _receiver() as receiver, _sender(args.ttl) as sender:
            publisher = node.create_publisher(String, args.topic, 10)
            node.create_subscription(String, args.topic, lambda message: hear(heard_topic, message.data), 10)

            def emit():
                publisher.publish(String(data=text))
                sent['topic'] += 1
                try:
                    sender.sendto(text.encode(), (_GROUP, _PORT))
                    sent['multicast'] += 1
                except OSError:  # no network: the summary shows that nothing was sent
                    pass

            def listen():
                while True:
                    try:
                        words = receiver.recv(4096).decode(errors='replace')
                    except BlockingIOError:
                        return False
                    hear(heard_multicast, words)

            node.create_timer(args.emit_period, emit)
            while True:
                node.spin(until=listen, timeout=args.print_period)
                _print(args, sent, heard_topic, heard_multicast)
                if args.once:
                    return
                for counts in (heard_topic, heard_multicast):
                    counts.clear()
                sent.update(topic=0, multicast=0)


def _receiver():
    receiver = socket.socket(socket.AF_INET, socket.SOCK_DGRAM, socket.IPPROTO_UDP)
    receiver.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
    receiver.bind(('', _PORT))
    try:
        receiver.setsockopt(
            socket.IPPROTO_IP, socket.IP_ADD_MEMBERSHIP, socket.inet_aton(_GROUP) + socket.inet_aton('0.0.0.0')
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


def _print(args, sent, heard_topic, heard_multicast):
    print('MULTIMACHINE COMMUNICATION SUMMARY')
    print(f'Topic: {args.topic}, Published Msg Count: {sent["topic"]}')
    print('Subscribed from:')
    _print_table(heard_topic, args.print_period)
    print(f'Multicast Group/Port: {_GROUP}/{_PORT}, Sent Msg Count: {sent["multicast"]}')
    print('Received from:')
    _print_table(heard_multicast, args.print_period)
    print('-' * 60)


def _print_table(heard, period):
    for sender, count in [('Hostname', f'Msg Count /{period}s'), *sorted(heard.items())]:
        print(f'{"":<15} {sender:<20} {count:<10}')
