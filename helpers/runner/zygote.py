"""Fork server of the learner's side: imports ROS once, then forks one process per program.

It reads requests from its control socket; each `fork` request carries two file descriptors, the program's JSON
channel and its output pipe. It never runs learner's code itself and never opens a DDS participant, so a fork is
safe and as good as a fresh start. When the control socket closes, it kills what it forked and ends.

    {"op": "fork", "key": k} + 2 fds   ->  {"event": "forked", "key": k, "pid": p}
    {"op": "kill", "key": k}           ->  (none)
    (a child ended)                    ->  {"event": "ended", "key": k, "status": wait status}
"""
import array
import json
import os
import select
import signal
import socket
import sys

from helpers.runner.lifetime import die_with_parent

# What most programs import; the rest is imported by the program itself.
_MESSAGE_PACKAGES = ('std_msgs', 'geometry_msgs', 'sensor_msgs', 'nav_msgs', 'builtin_interfaces', 'rosgraph_msgs',
                     'rcl_interfaces')
_SERVICES = ('example_interfaces.srv', 'std_srvs.srv', 'example_interfaces.action', 'rclpy.action')
# Their C type support is loaded too.
_MESSAGES = {'std_msgs': ('String', 'UInt64', 'Int32', 'Bool', 'Float64', 'Header'), 'rosgraph_msgs': ('Clock',),
             'geometry_msgs': ('Twist', 'Pose', 'PoseStamped'), 'sensor_msgs': ('LaserScan',),
             'nav_msgs': ('OccupancyGrid', 'Odometry'),
             'rcl_interfaces': ('Log', 'ParameterEvent')}


def _warm_up() -> None:
    """Load code and shared libraries, without opening a participant.

    rcl brings two idle threads of LTTng's; a forked child lives without them.
    """
    import importlib

    import numpy  # noqa: F401
    import rclpy
    import rclpy.action
    import rclpy.event_handler  # noqa: F401
    import rclpy.executors

    rclpy.get_rmw_implementation_identifier()  # loads the middleware's library
    for package in _MESSAGE_PACKAGES:
        module = importlib.import_module(f'{package}.msg')
        for name in _MESSAGES.get(package, ()):
            getattr(module, name).__class__.__import_type_support__()
    for name in _SERVICES:
        importlib.import_module(name)
    from rcl_interfaces import srv
    for name in ('DescribeParameters', 'GetParameters', 'GetParameterTypes', 'ListParameters', 'SetParameters',
                 'SetParametersAtomically'):
        getattr(srv, name).__class__.__import_type_support__()

    import helpers.runner.worker  # noqa: F401


def serve(control: socket.socket) -> None:
    """Serve requests until the control socket closes."""
    children: dict[int, str] = {}  # pid -> key
    # A signal wakes the select below; its handler has nothing else to do.
    woken, wake = os.pipe2(os.O_NONBLOCK | os.O_CLOEXEC)
    signal.signal(signal.SIGCHLD, lambda *_: None)
    signal.set_wakeup_fd(wake, warn_on_full_buffer=False)

    def tell(**event) -> None:
        control.sendall(json.dumps(event).encode())

    while True:
        ready, _, _ = select.select([control, woken], [], [])
        if woken in ready:
            os.read(woken, 4096)
        while children:
            pid, status = os.waitpid(-1, os.WNOHANG)
            if pid == 0:
                break
            if key := children.pop(pid, None):
                _kill_group(pid)  # what the program itself has started
                tell(event='ended', key=key, status=status)
        if control not in ready:
            continue
        data, ancillary, _, _ = socket_receive(control)
        if not data:
            break
        request = json.loads(data)
        if request['op'] == 'kill':
            for pid, key in children.items():
                if key == request['key']:
                    _kill_group(pid)
            continue
        channel, output = ancillary
        pid = os.fork()
        if pid == 0:
            control.close()
            os.close(woken)
            signal.set_wakeup_fd(-1)
            os.close(wake)
            signal.signal(signal.SIGCHLD, signal.SIG_DFL)
            die_with_parent()
            _become_program(channel, output)
        os.close(channel)
        os.close(output)
        children[pid] = request['key']
        tell(event='forked', key=request['key'], pid=pid)
    for pid in children:
        _kill_group(pid)


def _kill_group(pid: int) -> None:
    try:
        os.killpg(pid, signal.SIGKILL)
    except ProcessLookupError:
        pass


def socket_receive(control: socket.socket):
    """One request with the file descriptors it carries (the control socket keeps message boundaries)."""
    data, ancillary, flags, address = control.recvmsg(65536, socket.CMSG_SPACE(2 * array.array('i').itemsize))
    descriptors = array.array('i')
    for level, kind, content in ancillary:
        if level == socket.SOL_SOCKET and kind == socket.SCM_RIGHTS:
            descriptors.frombytes(content[: len(content) - len(content) % descriptors.itemsize])
    return data, list(descriptors), flags, address


def _become_program(channel: int, output: int) -> None:
    """In the forked child: make `output` the standard streams and run the worker. Never returns."""
    code = 1
    try:
        os.setsid()  # its own session: a learner's kill(0) reaches only itself
        os.dup2(output, 1)
        os.dup2(output, 2)
        os.close(output)
        from helpers.runner import worker
        code = worker.run(socket.socket(fileno=channel))
    except BaseException:  # noqa: BLE001 - the child must not return into the server's loop
        import traceback
        traceback.print_exc()
    finally:
        try:
            sys.stdout.flush()
            sys.stderr.flush()
        finally:
            os._exit(code)


def main() -> None:
    control = socket.socket(fileno=int(sys.argv[1]))
    die_with_parent()
    _warm_up()
    control.send(b'{"event": "ready"}')
    serve(control)


if __name__ == '__main__':
    main()
