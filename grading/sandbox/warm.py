"""Two servers that import everything once and fork for each submission: `python -m grading.sandbox.warm KIND FD`.

One forks processes of tests, the other one forks servers of learner's programs. They run as an ordinary user, never run
a learner's code themselves, and know no submission. They end when the socket FD closes.

    tests      {"folders": [], "domain": 0} + job, events, printed, control, life
    programs   {"domain": 0} + control, printed
"""

import json
import os
import signal
import socket
import sys
from types import ModuleType

from grading.sandbox import layout
from helpers.runner import preloading


def main() -> None:
    kind, descriptor = sys.argv[1], int(sys.argv[2])
    os.set_inheritable(descriptor, False)
    os.umask(0o077)
    preloading.warm_up()
    side: ModuleType
    if kind == 'tests':
        from grading.sandbox import tests_side

        side = tests_side
    else:
        from grading.sandbox import learners_side

        side = learners_side
    side.warm_up()
    layout.keeper()  # for all that it forks
    serve(socket.socket(fileno=descriptor), side.run)


def serve(requests: socket.socket, run) -> None:
    """Fork a process for each request, which gets the request and its file descriptors."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C is for the grader
    signal.signal(signal.SIGCHLD, signal.SIG_IGN)  # the kernel buries the children
    while True:
        data, descriptors, _, _ = socket.recv_fds(requests, 65536, 8)
        if not data:
            return
        pid = os.fork()
        if pid == 0:
            code = 1
            try:
                signal.signal(signal.SIGCHLD, signal.SIG_DFL)
                requests.close()
                code = run(json.loads(data), *descriptors) or 0
            except BaseException:  # noqa: BLE001 - the child must not return into the server's loop
                import traceback

                traceback.print_exc()
            finally:
                os._exit(code)
        for descriptor in descriptors:
            os.close(descriptor)


if __name__ == '__main__':
    main()
