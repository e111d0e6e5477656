"""What the tests of tf2 share: a ROS domain of their own, nodes in it, and tf2's programs as processes."""

import os
import threading
from contextlib import ExitStack
from pathlib import Path

import pytest
import rclpy
from ament_index_python.packages import get_package_prefix
from rclpy.executors import SingleThreadedExecutor
from rclpy.task import Future

from helpers.kernel.domains import claim
from helpers.programs.processes import background

TIMEOUT = 30.0  # seconds; generous, because the machine may be busy


class Domain:
    """A ROS domain that nobody else uses: nodes of this process, and programs in other processes."""

    def __init__(self, number, stack):
        self.number = number
        self._stack = stack
        self.context = rclpy.Context()
        rclpy.init(context=self.context, domain_id=number)
        stack.callback(rclpy.try_shutdown, context=self.context)

    def node(self, name='node', **options):
        """Return a new node."""
        node = rclpy.create_node(name, context=self.context, **options)
        self._stack.callback(node.destroy_node)
        return node

    def spin(self, *nodes, executor=SingleThreadedExecutor):
        """Spin nodes in a thread until the test ends; return the executor."""
        executor = executor(context=self.context)
        for node in nodes:
            executor.add_node(node)

        stop = Future()
        thread = threading.Thread(target=executor.spin_until_future_complete, args=[stop])
        thread.start()
        # Undone from the last to the first: a shutdown would pull the ground from under a running callback.
        self._stack.callback(executor.shutdown)
        self._stack.callback(thread.join, TIMEOUT)
        self._stack.callback(stop.set_result, None)
        return executor

    def start(self, argv):
        """Start a command in this domain; it ends with the test."""
        environment = {
            'ROS_DOMAIN_ID': str(self.number),
            'RCUTILS_CONSOLE_OUTPUT_FORMAT': '[{severity}] [{name}]: {message}',
            'RCUTILS_COLORIZED_OUTPUT': '0',
        }
        return self._stack.enter_context(background([str(word) for word in argv], env=environment))

    def program(self, package, name, *words):
        """Start a program of a ROS package, as `ros2 run` does."""
        return self.start([Path(get_package_prefix(package), 'lib', package, name), *words])


@pytest.fixture
def domain():
    """A :class:`Domain` for one test."""
    with ExitStack() as stack:
        yield Domain(stack.enter_context(claim()), stack)


@pytest.fixture
def logged(capfd):
    """A function that returns what was written to the process's stderr, where ROS logs, since it was last called."""
    os.environ.setdefault('RCUTILS_CONSOLE_OUTPUT_FORMAT', '[{severity}] [{name}]: {message}')
    return lambda: capfd.readouterr().err
