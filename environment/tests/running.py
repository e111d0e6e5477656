"""Fixtures for tests of ROS programs: a ROS domain of their own, processes that never stay, a node to talk to them."""

import os
import pty
import select
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
import rclpy
from ament_index_python.packages import get_package_prefix
from rclpy.action import ActionClient
from rclpy.executors import SingleThreadedExecutor
from rclpy.node import Node

from helpers.kernel import domains
from helpers.programs.processes import BackgroundProcess, background

ROS2 = str(Path(sys.executable).with_name('ros2'))
PATIENCE = 30.0  # seconds for what takes well below one on an idle machine


def program(package: str, name: str) -> str:
    """Return the path of a package's program."""
    return str(Path(get_package_prefix(package), 'lib', package, name))


@pytest.fixture
def domain(monkeypatch, tmp_path) -> Iterator[int]:
    """A ROS domain that no other test has; child processes get it, and write their logs to the test's directory."""
    with domains.claim() as number:
        monkeypatch.setenv('ROS_DOMAIN_ID', str(number))
        monkeypatch.setenv('ROS_LOG_DIR', str(tmp_path / 'ros_log'))
        monkeypatch.setenv('PYTHONDONTWRITEBYTECODE', '1')
        yield number


@pytest.fixture
def start(domain) -> Iterator[Callable[..., BackgroundProcess]]:
    """Start programs that end with the test: ``start('ros2', 'launch', …)``."""
    processes: list[BackgroundProcess] = []

    def start_one(*argv: str, **kwargs) -> BackgroundProcess:
        processes.append(background(list(argv), **kwargs))
        return processes[-1]

    yield start_one
    for process in reversed(processes):
        process.stop(timeout=PATIENCE)


def ended(process: BackgroundProcess) -> tuple[int, str]:
    """Wait for a program to end by itself; return its exit status and what it printed."""
    process._popen.wait(PATIENCE)
    process._reader.join(PATIENCE)
    return process.returncode, process.output


class Peer:
    """A node of the test's own, spun only while the test waits."""

    def __init__(self, domain_id: int):
        self._context = rclpy.Context()
        rclpy.init(context=self._context, domain_id=domain_id)
        self.node = Node('tester', context=self._context)
        self._executor = SingleThreadedExecutor(context=self._context)
        self._executor.add_node(self.node)

    def until(self, condition: Callable[[], object], what: str, timeout: float = PATIENCE):
        """Spin until the condition is true, and return its value; fail with what was awaited."""
        end = time.monotonic() + timeout
        while not (value := condition()):
            if time.monotonic() > end:
                pytest.fail(f'waited {timeout:g} s in vain: {what}')
            self._executor.spin_once(timeout_sec=0.1)
        return value

    def result(self, future, what: str):
        """Spin until a future is done; return its result."""
        self.until(future.done, what)
        return future.result()

    def call(self, kind, service: str, /, **fields):
        """Call a service and return the answer."""
        client = self.node.create_client(kind, service)
        self.until(client.service_is_ready, f'service {service}')
        return self.result(client.call_async(kind.Request(**fields)), f'answer of {service}')

    def listen(self, kind, topic: str) -> list:
        """Return a list that the messages of a topic go to."""
        messages: list = []
        self.node.create_subscription(kind, topic, messages.append, 200)
        self.until(lambda: self.node.count_publishers(topic), f'a publisher of {topic}')
        return messages

    def listen_status(self, action: str) -> Callable[[], list[int]]:
        """Return a function that gives the states of an action's goals, as last published."""
        from action_msgs.msg import GoalStatusArray
        from rclpy.qos import qos_profile_action_status_default

        latest: list[GoalStatusArray] = []
        topic = f'{action}/_action/status'
        self.node.create_subscription(GoalStatusArray, topic, latest.append, qos_profile_action_status_default)
        return lambda: [status.status for status in latest[-1].status_list] if latest else []

    def publisher(self, kind, topic: str):
        """Return a publisher that a reader is connected to."""
        publisher = self.node.create_publisher(kind, topic, 10)
        self.until(publisher.get_subscription_count, f'a reader of {topic}')
        return publisher

    def close(self) -> None:
        """Leave the graph."""
        self._executor.shutdown()
        for waitable in list(self.node.waitables):
            if isinstance(waitable, ActionClient):  # destroy_node leaves it, and with it the node in the graph
                waitable.destroy()
        self.node.destroy_node()
        self._context.try_shutdown()


@pytest.fixture
def peer(domain) -> Iterator[Peer]:
    """A node of the test's own in its domain."""
    one = Peer(domain)
    yield one
    one.close()


class Terminal:
    """A program on a terminal of its own, as if a person sat before it."""

    def __init__(self, argv: list[str]):
        self._master, slave = pty.openpty()
        self.slave = slave
        self._process = subprocess.Popen(
            argv, stdin=slave, stdout=slave, stderr=slave, start_new_session=True, preexec_fn=_take_terminal
        )
        self.text = ''

    def press(self, keys: str) -> None:
        """Type keys; ``'\\x03'`` is Ctrl+C."""
        os.write(self._master, keys.encode())

    def read_until(self, text: str, timeout: float = PATIENCE) -> None:
        """Read what the program writes until a text has come."""
        end = time.monotonic() + timeout
        while text not in self.text:
            if not select.select([self._master], [], [], max(0.0, end - time.monotonic()))[0]:
                pytest.fail(f'waited {timeout:g} s in vain for {text!r}; got {self.text!r}')
            self.text += os.read(self._master, 65536).decode().replace('\r\n', '\n')

    def wait(self, timeout: float = PATIENCE) -> int:
        """Wait for the end of the program, reading on; return its exit status."""
        end = time.monotonic() + timeout
        while self._process.poll() is None:
            if time.monotonic() > end:
                pytest.fail(f'the program did not end in {timeout:g} s; it wrote {self.text!r}')
            self._drain(0.05)
        while self._drain(0.0):
            pass
        return self._process.returncode

    def _drain(self, timeout: float) -> bool:
        if not select.select([self._master], [], [], timeout)[0]:
            return False
        self.text += os.read(self._master, 65536).decode().replace('\r\n', '\n')
        return True

    def close(self) -> None:
        """End the program, if need be with SIGKILL."""
        if self._process.poll() is None:
            os.killpg(self._process.pid, signal.SIGKILL)
            self._process.wait()
        os.close(self._master)
        os.close(self.slave)


def _take_terminal() -> None:
    import fcntl
    import termios

    fcntl.ioctl(0, termios.TIOCSCTTY, 0)


@pytest.fixture
def terminal(domain) -> Iterator[Callable[..., Terminal]]:
    """Start programs on terminals of their own: ``terminal('ros2', 'launch', …)``."""
    terminals: list[Terminal] = []

    def start_one(*argv: str) -> Terminal:
        terminals.append(Terminal(list(argv)))
        return terminals[-1]

    yield start_one
    for one in terminals:
        one.close()
