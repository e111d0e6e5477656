"""Reads what learners hand in: one submission at a time, each in a child process with bounds on time and memory.

Archives, notebooks, programs and labels are hostile until shown otherwise. A parser that is fed with them may need
hours, take all memory or crash; here that ends a child, and is this one submission's own fault. The child runs nothing
of the learner's. What it sends back is JSON and bytes, within a bound.

A server, `python -m grading.reader FD`, imports the parsers once and forks for each request.
"""

import atexit
import contextlib
import importlib
import json
import os
import pickle
import resource
import select
import signal
import socket
import subprocess
import sys
import threading
import time
import traceback
from collections.abc import Iterable
from typing import Any

from helpers.paths import ROOT

CPU = 20  # seconds of computing
WALL = 120  # seconds, on a machine under load
MEMORY = 2 * 2**30  # bytes of address space
MAX_ANSWER = 96 * 2**20  # bytes
TOO_MUCH = 'It takes too much time or memory to be read: clear its outputs, and hand in plain notebooks.'

_MODULES = ('grading.submission', 'grading.submissions', 'grading.similarity')  # that read; imported once


class TooMuch(Exception):
    """What was to be read took too much time or memory, or the reader's process crashed."""


class ReaderServer:
    """The process that forks the readers."""

    def __init__(self):
        self.owner = os.getpid()
        self._requests, theirs = socket.socketpair(socket.AF_UNIX, socket.SOCK_SEQPACKET)
        path = os.pathsep.join(filter(None, [str(ROOT), os.environ.get('PYTHONPATH')]))
        with theirs:
            self._process = subprocess.Popen(
                [sys.executable, '-m', 'grading.reader', str(theirs.fileno())],
                stdin=subprocess.DEVNULL,
                pass_fds=[theirs.fileno()],
                env={**os.environ, 'PYTHONPATH': path},
                start_new_session=True,
            )

    def ask(self, task: str, arguments: tuple) -> tuple[object, list[bytes]]:
        """What `ask` says. Raises OSError when the server has ended."""
        given, answer, write = os.memfd_create('given'), *os.pipe()
        try:
            with open(given, 'w+b', closefd=False) as file:
                pickle.dump((os.getcwd(), task, arguments), file)  # from here to a process of ours; never back
            socket.send_fds(self._requests, [b'read'], [given, write])
        except OSError:
            os.close(answer)
            raise
        finally:
            os.close(given)
            os.close(write)
        try:
            return _unpacked(_received(answer))
        finally:
            os.close(answer)

    def close(self) -> None:
        """End the server."""
        self._requests.close()
        if os.getpid() == self.owner:
            self._process.wait()


_lock = threading.Lock()
_server: ReaderServer | None = None


def ask(task: str, *arguments) -> tuple[Any, list[bytes]]:
    """Have a child call `module:function` with these arguments; returns a JSON value, and bytes that belong to it.

    :raises TooMuch: it took too much time or memory, or crashed.
    """
    with contextlib.suppress(OSError):
        return _running().ask(task, arguments)
    return _running(fresh=True).ask(task, arguments)


def _running(fresh: bool = False) -> ReaderServer:
    global _server
    with _lock:
        if _server is None or _server.owner != os.getpid() or fresh:
            _close()
            _server = ReaderServer()
        return _server


def _close() -> None:
    global _server
    if _server is not None and _server.owner == os.getpid():
        _server.close()
    _server = None


atexit.register(_close)


def _received(descriptor: int) -> bytes:
    """All that comes, until the other end is closed."""
    deadline, kept = time.monotonic() + WALL + 10, bytearray()
    while True:
        if not select.select([descriptor], [], [], max(0.0, deadline - time.monotonic()))[0]:
            raise TooMuch(TOO_MUCH)
        chunk = os.read(descriptor, 2**20)
        if not chunk:
            return bytes(kept)
        kept += chunk
        if len(kept) > MAX_ANSWER:
            raise TooMuch(TOO_MUCH)


def _unpacked(data: bytes) -> tuple[object, list[bytes]]:
    line = data.partition(b'\n')[0]
    try:
        head = json.loads(line)
        value, sizes = head['value'], head['sizes']
    except (ValueError, KeyError, TypeError, RecursionError):
        raise TooMuch(TOO_MUCH) from None
    blobs, place = [], len(line) + 1
    if sum(sizes) != len(data) - place:
        raise TooMuch(TOO_MUCH)
    for size in sizes:  # what is left is not copied each time: there may be hundreds of blobs
        blobs.append(data[place : place + size])
        place += size
    return value, blobs


# The child


def _read(given: int, answer: int) -> None:
    """Do one task and write what comes of it."""
    signal.alarm(WALL)
    resource.setrlimit(resource.RLIMIT_CPU, (CPU, CPU))
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    with open(given, 'rb') as file:
        file.seek(0)
        folder, task, arguments = pickle.load(file)
    os.chdir(folder)  # paths may be relative, and the server was started elsewhere
    module, _, function = task.partition(':')
    value, blobs = getattr(importlib.import_module(module), function)(*arguments)
    _write(answer, value, blobs)


def _write(descriptor: int, value, blobs: Iterable[bytes]) -> None:
    blobs = list(blobs)
    head = json.dumps({'value': value, 'sizes': [len(blob) for blob in blobs]}).encode()
    with open(descriptor, 'wb') as file:
        for part in (head, b'\n', *blobs):
            file.write(part)


def main() -> None:
    requests = socket.socket(fileno=int(sys.argv[1]))
    for module in _MODULES:
        importlib.import_module(module)
    import nbformat

    nbformat.validate(nbformat.from_dict({'nbformat': 4, 'nbformat_minor': 5, 'metadata': {}, 'cells': []}))
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C is for the grader
    signal.signal(signal.SIGCHLD, signal.SIG_IGN)  # the kernel buries the children
    while True:
        data, descriptors, _, _ = socket.recv_fds(requests, 64, 2)
        if not data:
            return
        if os.fork() == 0:
            try:
                requests.close()
                _read(*descriptors)
            except MemoryError:
                pass
            except BaseException as error:  # noqa: BLE001 - the child must not return into the server's loop
                places = traceback.extract_tb(error.__traceback__)  # not its text, which may be anybody's
                print(f'reader: {type(error).__name__} at {places[-1].filename}:{places[-1].lineno}', file=sys.stderr)
            finally:
                os._exit(0)
        for descriptor in descriptors:
            os.close(descriptor)


if __name__ == '__main__':
    main()
