"""A server that imports everything once and forks for each request: `python -m helpers.runner.warm SIDE FD`.

SIDE is a module with three functions: `warm_up()` imports what it needs, `prepare(request)` is called in the server
before it forks, and `run(request, *descriptors)` in the forked process. The server runs neither a learner's code nor a
test itself, and opens no DDS participant. It ends when the socket FD closes.
"""

import importlib
import json
import os
import signal
import socket
import sys
from types import ModuleType

from helpers.runner import preloading
from helpers.runner.lifetime import leave

MOST_DESCRIPTORS = 8  # that come with one request


def main() -> None:
    name, descriptor = sys.argv[1], int(sys.argv[2])
    os.set_inheritable(descriptor, False)
    try:
        side = importlib.import_module(name)
        preloading.warm_up()
        side.warm_up()
    except ImportError as error:  # of a ROS that is not whole, or hidden by folders of PYTHONPATH
        sys.exit(f'course: ROS cannot be loaded: {error}. To see why, run in the terminal: ./course doctor')
    preloading.keep()
    serve(socket.socket(fileno=descriptor), side)
    leave(0)


def serve(requests: socket.socket, side: ModuleType) -> None:
    """Fork a process for each request, which gets the request and its file descriptors."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C is for the client
    signal.signal(signal.SIGCHLD, signal.SIG_IGN)  # the kernel buries the children
    while True:
        data, descriptors, _, _ = socket.recv_fds(requests, 65536, MOST_DESCRIPTORS)
        if not data:
            return
        request = json.loads(data)
        side.prepare(request)
        pid = os.fork()
        if pid == 0:
            code = 1
            try:
                signal.signal(signal.SIGCHLD, signal.SIG_DFL)
                requests.close()
                code = side.run(request, *descriptors) or 0
            except BaseException:  # noqa: BLE001 - the child must not return into the server's loop
                import traceback

                traceback.print_exc()
            finally:
                leave(code)
        for descriptor in descriptors:
            os.close(descriptor)


if __name__ == '__main__':
    main()
