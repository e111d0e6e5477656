"""How the nodes that stand on a robot description begin and end."""

import contextlib
import sys
from collections.abc import Callable
from pathlib import Path

import rclpy
from rclpy._rclpy_pybind11 import RCLError
from rclpy.exceptions import InvalidParameterTypeException, InvalidParameterValueException
from rclpy.executors import ExternalShutdownException, SingleThreadedExecutor
from rclpy.node import Node
from rclpy.utilities import remove_ros_args


class CannotStart(Exception):
    """A node that cannot begin its work; it has said why in its log."""


def run(make_node: Callable[[list[str]], Node]) -> int:
    """
    Make a node and spin it until Ctrl+C, SIGTERM or a shutdown of its context; return the program's exit status.

    An error at the start is one line, not a traceback.

    :param make_node: takes the program's arguments without its name and without ROS arguments.
    """
    with contextlib.suppress(KeyboardInterrupt):
        try:
            rclpy.init(args=sys.argv)
            arguments = remove_ros_args(args=sys.argv)[1:]
        except Exception as error:  # rclpy has no public class for it
            print(f'{Path(sys.argv[0]).name}: {_arguments_problem(str(error))}', file=sys.stderr)
            return 1
        try:
            executor = SingleThreadedExecutor()  # before the node speaks: a signal in between would break it
            rclpy.spin(make_node(arguments), executor)
        except ExternalShutdownException:
            pass
        except CannotStart:
            return 1
        except (InvalidParameterTypeException, InvalidParameterValueException) as error:
            print(f'{Path(sys.argv[0]).name}: {error}', file=sys.stderr)
            return 1
        except Exception:
            # rclpy's signal handler takes the context away at once; a callback that is about to publish then fails.
            if rclpy.ok():
                raise
        finally:
            with contextlib.suppress(RCLError):  # the signal's handler may shut down at the same moment
                rclpy.try_shutdown()
    return 0


def _arguments_problem(text: str) -> str:
    """rcl's text on ROS arguments, in one line."""
    if 'robot_description:=' in text:  # a colon in a comment is enough
        return (
            'the value of -p robot_description:=… is not YAML, as parameters on a command line must be; '
            'give the name of the file as an argument, or set the parameter in a launch file'
        )
    return text.splitlines()[0]
