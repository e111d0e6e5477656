"""How the nodes that stand on a robot description begin and end."""

import contextlib
import sys
from collections.abc import Callable

import rclpy
from rclpy.exceptions import InvalidParameterTypeException
from rclpy.executors import ExternalShutdownException, SingleThreadedExecutor
from rclpy.node import Node


class CannotStart(Exception):
    """A node that cannot begin its work; it has said why in its log."""


def run(make_node: Callable[[], Node], args: list[str] | None = None) -> int:
    """
    Make a node and spin it until Ctrl+C, SIGTERM or a shutdown of its context; return the program's exit status.

    An error at the start is one line, not a traceback.
    """
    with contextlib.suppress(KeyboardInterrupt):
        try:
            rclpy.init(args=args)
            executor = SingleThreadedExecutor()  # before the node speaks: a signal in between would break it
            rclpy.spin(make_node(), executor)
        except ExternalShutdownException:
            pass
        except CannotStart:
            return 1
        except InvalidParameterTypeException as error:
            print(error, file=sys.stderr)
            return 1
        except Exception:
            # rclpy's signal handler takes the context away at once; a callback that is about to publish then fails.
            if rclpy.ok():
                raise
        finally:
            rclpy.try_shutdown()
    return 0
