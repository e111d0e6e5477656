"""A test's own node that watches a system which a command has started: it asks over DDS, outside of that system.

What a launched program says of itself is worth nothing; what others find when they look for it, and ask it, is.
"""

import re
import secrets
import time
from collections.abc import Callable

from rcl_interfaces.srv import GetParameters
from rclpy.executors import SingleThreadedExecutor
from rclpy.node import Node
from rclpy.parameter import parameter_value_to_python

from helpers.kernel.nodes import UNKNOWN
from helpers.runner.fork_client import Task

_LAUNCH = re.compile(r'/launch_ros_\d+')  # ros2 launch's own node
_STARTED = re.compile(r'^\[INFO\] \[([^]\n]*)-\d+\]: process started with pid', re.MULTILINE)
LATE = 5.0  # s after its first nodes in which a launch may start another one
_GONE = re.compile(r'^\[(?:INFO|ERROR)\] \[[^]\n]*\]: process has (?:died|finished)', re.MULTILINE)


def processes(log: str) -> list[str]:
    """The names of the processes that a `ros2 launch` with this output has started, in their order."""
    return _STARTED.findall(log)


def running(log: str) -> int:
    """How many processes of a `ros2 launch` with this output have started, and have not ended."""
    return len(processes(log)) - len(_GONE.findall(log))


class Observer:
    """A node in the domain of a test's program; use it in a `with` block."""

    def __init__(self, learner):
        self.node = Node(
            f'_{secrets.token_hex(6)}',
            context=learner.context,
            start_parameter_services=False,
            enable_rosout=False,
            use_global_arguments=False,
        )
        self._own = self.node.get_fully_qualified_name(), learner.node.get_fully_qualified_name()
        self._executor = SingleThreadedExecutor(context=learner.context)
        self._executor.add_node(self.node)

    def until(self, condition: Callable[[], object], timeout: float, task: Task | None = None) -> bool:
        """Spin until `condition()` is true. False after `timeout` seconds of wall time, or when `task` has ended."""
        deadline = time.monotonic() + timeout
        while not condition():
            if time.monotonic() > deadline or task is not None and task.wait(0) is not None:
                return bool(condition())
            self._executor.spin_once(timeout_sec=0.02)
        return True

    def nodes(self) -> list[str]:
        """The full names of the system's nodes, sorted; a name that two have is there twice.

        Also those whose names begin with `_`, which ROS does not list: only the tests' own nodes are left out.
        """
        found = [
            f'{namespace.rstrip("/")}/{name}'
            for name, namespace in self.node.get_node_names_and_namespaces()
            if name != UNKNOWN
        ]
        for name in self._own:
            if name in found:
                found.remove(name)
        return sorted(name for name in found if not _LAUNCH.fullmatch(name))

    def all_there(self, task: Task, timeout: float, more: Callable[[], int] = lambda: 0, wanted: int = 1) -> list[str]:
        """The nodes, when as many are there as processes of a `ros2 launch` are still running; or those of now.

        :param more: how many of these processes have no node, as is known.
        :param wanted: how many a right launch starts; if it has started fewer, `LATE` seconds are left for the others,
            which may stand in a TimerAction.
        """

        def count() -> int:
            return len(self.nodes()) + more()

        def arrived() -> bool:
            log = task.output
            return bool(processes(log)) and count() >= running(log)

        self.until(arrived, timeout, task)
        self.until(lambda: arrived() and count() >= wanted, LATE, task)
        return self.nodes()

    def parameters(self, node: str, names: list[str], timeout: float = 20.0) -> dict:
        """A node's values of these parameters; empty if it does not answer."""
        client = self.node.create_client(GetParameters, f'{node}/get_parameters')
        try:
            if not self.until(client.service_is_ready, timeout):
                return {}
            answer = client.call_async(GetParameters.Request(names=names))
            if not self.until(answer.done, timeout):
                return {}
            return dict(zip(names, map(parameter_value_to_python, answer.result().values), strict=False))
        finally:
            self.node.destroy_client(client)

    def topics(self, node: str, kind: str, msg_type: str) -> list[str]:
        """The topics of a type that a node has; `kind`: publisher or subscriber."""
        ask = getattr(self.node, f'get_{kind}_names_and_types_by_node')
        namespace, _, name = node.rpartition('/')
        try:
            return sorted(topic for topic, types in ask(name, namespace or '/') if msg_type in types)
        except Exception:  # noqa: BLE001 - the node has gone
            return []

    def __enter__(self) -> 'Observer':
        return self

    def __exit__(self, kind, error, tb) -> None:
        self._executor.shutdown(timeout_sec=1)
        self.node.destroy_node()
