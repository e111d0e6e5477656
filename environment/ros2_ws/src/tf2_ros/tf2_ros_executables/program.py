"""What the programs have in common: start ROS, spin until interrupted, stop; and say errors without a traceback."""

import os
import sys
from contextlib import contextmanager
from pathlib import Path

import rclpy
from rclpy.executors import ExternalShutdownException, SingleThreadedExecutor
from rclpy.impl.rcutils_logger import RcutilsLogger
from rclpy.utilities import remove_ros_args

# Stock's programs log through the unnamed root logger until they have a node.
root_logger = RcutilsLogger()


@contextmanager
def ros(argv):
    """
    Start ROS for a `with` block; its value is `argv` without ROS arguments, and an executor.

    Interruption ends the block quietly. An error (ROS arguments that cannot be parsed, a parameter of the wrong type)
    ends the program with one line and status 1.
    """
    executor = None
    try:
        rclpy.init(args=argv)
        # Before the program says anything: an executor cannot be made any more once it was interrupted.
        executor = SingleThreadedExecutor()
        yield remove_ros_args(args=argv), executor
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    except BrokenPipeError:  # the reader has had enough, as in `tf2_echo a b | head`; Python flushes once more
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
    except Exception as error:
        interrupted = executor is not None and not rclpy.ok()
        if not interrupted:
            print(f'{Path(argv[0]).name}: {error}', file=sys.stderr)
            raise SystemExit(1) from None
    finally:
        rclpy.try_shutdown()


def spin(node, executor):
    """Spin the node until interrupted or shut down."""
    try:
        executor.add_node(node)
        executor.spin()
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        executor.remove_node(node)
        node.destroy_node()
