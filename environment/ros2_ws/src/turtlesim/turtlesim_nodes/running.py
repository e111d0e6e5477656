"""How every node here begins and ends."""

import contextlib
import sys
from collections.abc import Callable
from pathlib import Path

import rclpy
from rclpy._rclpy_pybind11 import RCLError, UnknownROSArgsError
from rclpy.exceptions import InvalidParameterTypeException, InvalidParameterValueException
from rclpy.executors import ExternalShutdownException, SingleThreadedExecutor
from rclpy.node import Node


def run(make_node: Callable[[], Node], args: list[str] | None) -> None:
    """
    Make a node and spin it until Ctrl+C, SIGTERM or a shutdown of its context.

    ROS arguments that cannot be read, and parameters of a wrong type, end the program with their error and status 1.
    """
    with contextlib.suppress(KeyboardInterrupt):
        try:
            rclpy.init(args=args)
        except UnknownROSArgsError as error:  # its text is the list of them
            print(f'{Path(sys.argv[0]).name}: found unknown ROS arguments: {error}', file=sys.stderr)
            raise SystemExit(1) from None
        except RCLError as error:
            print(f'{Path(sys.argv[0]).name}: {error}', file=sys.stderr)
            raise SystemExit(1) from None
        try:
            executor = SingleThreadedExecutor()  # before the node speaks: a signal in between would break it
            rclpy.spin(make_node(), executor)
        except ExternalShutdownException:
            pass
        except (InvalidParameterTypeException, InvalidParameterValueException) as error:
            print(f'{Path(sys.argv[0]).name}: {error}', file=sys.stderr)
            raise SystemExit(1) from None
        except Exception:
            # rclpy's signal handler takes the context away at once; a callback that is about to publish then fails.
            if rclpy.ok():
                raise
        finally:
            with contextlib.suppress(RCLError):  # the signal's handler may shut down at the same moment
                rclpy.try_shutdown()
