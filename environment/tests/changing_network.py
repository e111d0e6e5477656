"""A machine whose network goes away while a node runs: python changing_network.py.

It runs in a network namespace of its own, with the right to change it. It prints what the node has heard of a program
that began before the change, and of one that began after it.
"""

import contextlib
import fcntl
import socket
import struct
import subprocess
import sys
import time

import rclpy
from std_msgs.msg import String

# Requests of netdevice(7).
_SET_FLAGS, _SET_ADDRESS = 0x8914, 0x8916
_ALIAS = b'lo:1'  # a second address of the only device there is
PATIENCE = 20.0  # s

TALKER = """
import sys

import rclpy
from std_msgs.msg import String

rclpy.init()
node = rclpy.create_node('talker')
publisher = node.create_publisher(String, 'words', 10)
node.create_timer(0.1, lambda: publisher.publish(String(data=sys.argv[1])))
rclpy.spin(node)
"""


def _ask(request: int, value: bytes) -> None:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as any_socket:
        fcntl.ioctl(any_socket, request, struct.pack('16s24s', _ALIAS, value))


def set_address(address: str) -> None:
    _ask(_SET_ADDRESS, struct.pack('H2x4s8x', socket.AF_INET, socket.inet_aton(address)))


def remove_address() -> None:
    """Without the flag that it is up, an alias is gone."""
    _ask(_SET_FLAGS, struct.pack('h', 0))


@contextlib.contextmanager
def talker(word: str):
    program = subprocess.Popen([sys.executable, '-c', TALKER, word])
    try:
        yield
    finally:
        program.kill()
        program.wait()


def main() -> None:
    set_address('10.0.1.2')
    rclpy.init()
    node, heard = rclpy.create_node('listener'), set()
    node.create_subscription(String, 'words', lambda message: heard.add(message.data), 10)

    def listen(word: str) -> None:
        end = time.monotonic() + PATIENCE
        while word not in heard and time.monotonic() < end:
            rclpy.spin_once(node, timeout_sec=0.1)

    with talker('before'):
        listen('before')
        remove_address()
        with talker('after'):
            listen('after')
    print(*sorted(heard))


if __name__ == '__main__':
    main()
