"""Send and receive one datagram."""

import math
import socket
import struct
import time
from typing import Any

DEFAULT_GROUP, DEFAULT_PORT = '225.0.0.1', 49150
_LARGEST = 4096
_LONGEST_WAIT = 0.25  # seconds; a signal that comes just before a wait begins is handled only after it


def send(data: bytes, *, group: str = DEFAULT_GROUP, port: int = DEFAULT_PORT, ttl: int | None = None) -> None:
    """Send a datagram to a group; `ttl`: how many routers it may pass (OSError)."""
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as sender:
        if ttl is not None:
            sender.setsockopt(socket.IPPROTO_IP, socket.IP_MULTICAST_TTL, ttl)
        sender.sendto(data, (group, port))


def receive(
    *, group: str = DEFAULT_GROUP, port: int = DEFAULT_PORT, timeout: float | None = None
) -> tuple[bytes, tuple[Any, ...]]:
    """
    Wait for a datagram to a group; return it and the address of its sender.

    :raises TimeoutError: if none comes within `timeout` seconds.
    """
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as receiver:
        receiver.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        receiver.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEPORT, 1)
        receiver.bind(('', port))
        membership = struct.pack('4sl', socket.inet_aton(group), socket.INADDR_ANY)
        receiver.setsockopt(socket.IPPROTO_IP, socket.IP_ADD_MEMBERSHIP, membership)
        end = math.inf if timeout is None else time.monotonic() + timeout
        while True:
            receiver.settimeout(max(0.001, min(_LONGEST_WAIT, end - time.monotonic())))
            try:
                return receiver.recvfrom(_LARGEST)
            except TimeoutError:
                if time.monotonic() >= end:
                    raise
