"""The ROS node of a launch: it listens and asks for the actions that need one."""

from __future__ import annotations

import os
import threading

from launch.launch_context import LaunchContext

_KEY = 'launch_ros_adapter'


class ROSAdapter:
    """`node`, named ``launch_ros_PID``, spun by `executor` in a thread of its own from making it to ``shutdown``."""

    def __init__(self):
        # Only now: a launch without such actions shall not wait for rclpy.
        import rclpy
        from rclpy.executors import SingleThreadedExecutor

        self.context = rclpy.Context()
        rclpy.init(args=[], context=self.context)
        self.node = rclpy.create_node(f'launch_ros_{os.getpid()}', context=self.context)
        self.executor = SingleThreadedExecutor(context=self.context)
        self.executor.add_node(self.node)
        self._stopping = False
        self._thread = threading.Thread(target=self._spin, name='launch_ros', daemon=True)
        self._thread.start()

    def _spin(self) -> None:
        while not self._stopping:
            self.executor.spin_once(timeout_sec=1.0)

    def shutdown(self) -> None:
        """Leave the graph."""
        self._stopping = True
        self.executor.wake()
        self._thread.join()
        self.executor.shutdown()
        self.node.destroy_node()
        self.context.try_shutdown()


def get_ros_node(context: LaunchContext):
    """Return the launch's node; the first call makes it, and it is gone when the launch has ended."""
    return get_ros_adapter(context).node


def get_ros_adapter(context: LaunchContext) -> ROSAdapter:
    """Return what has the launch's node, its executor and its context, for actions of one's own."""
    adapter = context.get_locals_as_dict().get(_KEY)
    if adapter is None:
        adapter = ROSAdapter()
        context.extend_globals({_KEY: adapter})
        context.call_at_end(lambda: _end(context))
    return adapter


def _end(context: LaunchContext) -> None:
    context.get_locals_as_dict()[_KEY].shutdown()
    context.extend_globals({_KEY: None})
