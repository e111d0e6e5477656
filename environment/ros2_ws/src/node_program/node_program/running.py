"""How every program here begins, spins its node and ends."""

import contextlib
import os
import re
import sys
from collections.abc import Callable, Iterator
from pathlib import Path

import rclpy
from rclpy._rclpy_pybind11 import RCLError, UnknownROSArgsError
from rclpy.exceptions import InvalidParameterTypeException, InvalidParameterValueException
from rclpy.executors import ExternalShutdownException, SingleThreadedExecutor
from rclpy.node import Node
from rclpy.utilities import remove_ros_args

PARAMETER = re.compile(r"-p ([^\s:']+):=")


class CannotStart(Exception):
    """A node that cannot begin its work; it has said why in its log."""


@contextlib.contextmanager
def ros(args: list[str] | None = None) -> Iterator[tuple[list[str], SingleThreadedExecutor]]:
    """
    Start ROS for a `with` block, and stop it behind the block.

    Its value is the command line without the program's name and without ROS arguments, and an executor. Ctrl+C,
    SIGTERM and a shutdown of the context leave the block, and the program ends with status 0. It ends with status 1 and
    one line where ROS arguments or the value of a parameter cannot be used, and where a node says CannotStart.

    :param args: the command line with the program's name; None for the process's own.
    """
    args = sys.argv if args is None else args
    with contextlib.suppress(KeyboardInterrupt):
        try:
            rclpy.init(args=args)
            words = remove_ros_args(args=args)[1:]
        except UnknownROSArgsError as error:  # its text is the list of them
            _give_up(f'found unknown ROS arguments: {error}')
        except RCLError as error:
            _give_up(_arguments_problem(str(error)))
        try:
            # Before a node speaks: whoever hears it may send a signal, and after that no executor can be made.
            yield words, SingleThreadedExecutor()
        except ExternalShutdownException:
            pass
        except CannotStart:
            raise SystemExit(1) from None
        except (InvalidParameterTypeException, InvalidParameterValueException) as error:
            _give_up(str(error))
        except BrokenPipeError:  # the reader has had enough, as in `… | head`; Python writes once more at its end
            os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        except Exception:
            # A signal takes the context away at once; a callback that is about to publish then fails.
            if rclpy.ok():
                raise
        finally:
            with contextlib.suppress(RCLError):  # the signal's handler may shut down at the same moment
                rclpy.try_shutdown()


def run(make_node: Callable[[], Node], args: list[str] | None = None) -> None:
    """Make a node and spin it until a signal or a shutdown comes; how a program ends is told at :func:`ros`."""
    with ros(args) as (_, executor):
        rclpy.spin(make_node(), executor)


def _give_up(problem: str) -> None:
    print(f'{Path(sys.argv[0]).name}: {problem}', file=sys.stderr)
    raise SystemExit(1)


def _arguments_problem(text: str) -> str:
    """rcl's text on ROS arguments, in one line."""
    parameter = PARAMETER.search(text)
    if parameter:  # a text with a colon and a blank is enough
        return (
            f'the value of -p {parameter[1]}:=… is not YAML, as parameters on a command line must be; '
            'put it into a parameter file or a launch file'
        )
    return re.sub(r', at \S+:\d+', '', text.removeprefix('failed to initialize rcl: ').splitlines()[0])
