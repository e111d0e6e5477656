"""Fork server of the learner's side: imports ROS once, then forks one process per program.

It reads requests from its control socket; each `fork` request carries two file descriptors, the program's JSON
channel and its output pipe. It never runs learner's code itself and never opens a DDS participant, so a fork is
safe and as good as a fresh start. When the control socket closes, it kills what it forked and ends.

    {"op": "fork", "key": k, "limits": {}} + 2 fds   ->  {"event": "forked", "key": k, "pid": p}
    {"op": "kill", "key": k}                         ->  (none)
    {"op": "clear"}                                  ->  {"event": "cleared"}, when nothing of the programs runs
    (a child ended)                                  ->  {"event": "ended", "key": k, "status": wait status, "why": ""}
"""
import array
import json
import os
import select
import signal
import socket
import sys
from contextlib import suppress

from helpers.runner.launch import Limits
from helpers.runner.lifetime import die_with_parent, leave

# What most programs import; the rest is imported by the program itself.
_MESSAGE_PACKAGES = ('std_msgs', 'geometry_msgs', 'sensor_msgs', 'nav_msgs', 'builtin_interfaces', 'rosgraph_msgs',
                     'rcl_interfaces')
_SERVICES = ('example_interfaces.srv', 'std_srvs.srv', 'example_interfaces.action', 'rclpy.action')
# Their C type support is loaded too.
_MESSAGES = {'std_msgs': ('String', 'UInt64', 'Int32', 'Bool', 'Float64', 'Header'), 'rosgraph_msgs': ('Clock',),
             'geometry_msgs': ('Twist', 'Pose', 'PoseStamped'), 'sensor_msgs': ('LaserScan',),
             'nav_msgs': ('OccupancyGrid', 'Odometry'),
             'rcl_interfaces': ('Log', 'ParameterEvent')}

# Slow to import, and only some programs do: the server imports them for the first one, and the others have them.
ON_DEMAND = ('tf2_ros', 'tf_transformations', 'tf2_geometry_msgs', 'tf2_sensor_msgs', 'sensor_msgs_py.point_cloud2')


def warm_up() -> None:
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


def warm_up_for(modules: list[str]) -> None:
    """Import those of `modules` that are in ON_DEMAND."""
    import importlib

    for name in ON_DEMAND:
        if name in modules and name not in sys.modules:
            with suppress(Exception):  # the program's own import will tell
                importlib.import_module(name)


class Programs:
    """How a program's process is made and ended; a sandbox has its own way."""

    patience: float | None = None  # seconds between two looks at what the programs use; None: no look

    def fork(self, limits: Limits, channel: int, output: int) -> int:
        """Start a program's process; returns its pid."""
        pid = os.fork()
        if pid == 0:
            leave_server()
            die_with_parent()
            limits.apply()
            become_program(channel, output)
        return pid

    def kill(self, pid: int) -> None:
        """End a program's process and what it has started."""
        kill_group(pid)

    def ended(self, pid: int) -> None:
        """A program's process has ended: end what it has started."""
        kill_group(pid)

    def clear(self) -> None:
        """End whatever is left of the programs, all of which have ended."""

    def look(self) -> str:
        """End programs that use too much; returns why, or nothing."""
        return ''

    def close(self) -> None:
        """The last call."""


def serve(control: socket.socket, programs: Programs) -> None:
    """Serve requests until the control socket closes."""
    children: dict[int, str] = {}  # pid -> key
    why = ''  # the programs were ended
    # A signal wakes the select below; its handler has nothing else to do.
    woken, wake = os.pipe2(os.O_NONBLOCK | os.O_CLOEXEC)
    signal.signal(signal.SIGCHLD, lambda *_: None)
    signal.set_wakeup_fd(wake, warn_on_full_buffer=False)

    def tell(**event) -> None:
        control.sendall(json.dumps(event).encode())

    while True:
        ready, _, _ = select.select([control, woken], [], [], programs.patience if children else None)
        if woken in ready:
            os.read(woken, 4096)
        if children:
            why = programs.look() or why
        for pid, key in list(children.items()):
            ended, status = os.waitpid(pid, os.WNOHANG)
            if ended:
                del children[pid]
                programs.ended(pid)
                tell(event='ended', key=key, status=status, why=why)
        if control not in ready:
            continue
        data, ancillary, _, _ = socket_receive(control)
        if not data:
            break
        request = json.loads(data)
        if request['op'] == 'kill':
            for pid, key in children.items():
                if key == request['key']:
                    programs.kill(pid)
        elif request['op'] == 'clear':
            for pid in children:
                programs.kill(pid)
            programs.clear()
            why = ''
            tell(event='cleared')
        else:
            channel, output = ancillary
            warm_up_for(request.get('modules', []))
            pid = programs.fork(Limits(**request['limits']), channel, output)
            os.close(channel)
            os.close(output)
            children[pid] = request['key']
            tell(event='forked', key=request['key'], pid=pid)
    for pid in children:
        programs.kill(pid)
    programs.close()


def leave_server() -> None:
    """In a forked child: undo what the server has set for itself."""
    signal.set_wakeup_fd(-1)
    signal.signal(signal.SIGCHLD, signal.SIG_DFL)


def kill_group(pid: int) -> None:
    """Kill a process group, if it is still there."""
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


def become_program(channel: int, output: int) -> None:
    """In the forked child: make `output` the standard streams and run the worker. Never returns."""
    code = 1
    try:
        os.closerange(3, min(channel, output))  # the server's own
        os.closerange(min(channel, output) + 1, max(channel, output))
        os.closerange(max(channel, output) + 1, os.sysconf('SC_OPEN_MAX'))
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
    warm_up()
    control.send(b'{"event": "ready"}')
    serve(control, Programs())
    leave(0)


if __name__ == '__main__':
    main()
