"""``turtle_teleop_key``: drive turtle1 with the keyboard."""

import contextlib
import os
import signal
import sys
import termios
import threading
from collections.abc import Iterator

import rclpy
from geometry_msgs.msg import Twist
from rclpy.action import ActionClient
from rclpy.executors import ExternalShutdownException, SingleThreadedExecutor
from rclpy.signals import SignalHandlerOptions
from turtlesim.action import RotateAbsolute

from turtlesim_nodes.node import TurtlesimNode
from turtlesim_nodes.qos import TOPIC_QOS

HELP = """\
Reading from keyboard
---------------------------
Use arrow keys to move the turtle.
Use G|B|V|C|D|E|R|T keys to rotate to absolute orientations. 'F' to cancel a rotation.
'Q' to quit."""

# The letters stand around F on the keyboard as the headings stand around the turtle (numbers: stock's).
HEADINGS = {'g': 0.0, 't': 0.7854, 'r': 1.5708, 'e': 2.3562, 'd': 3.1416, 'c': -2.3562, 'v': -1.5708, 'b': -0.7854}
ARROWS = {'up': (1.0, 0.0), 'down': (-1.0, 0.0), 'left': (0.0, 1.0), 'right': (0.0, -1.0)}  # linear, angular


class KeyDecoder:
    """Turns the bytes of a terminal into key names: a lower-case letter, or up, down, left, right."""

    _FINALS = {'A': 'up', 'B': 'down', 'C': 'right', 'D': 'left'}

    def __init__(self):
        self._escape = ''

    def feed(self, data: bytes) -> Iterator[str]:
        """Yield the keys that these bytes complete. An arrow key is ESC [ A or, in some terminals, ESC O A."""
        for char in data.decode('latin-1'):
            if char == '\x1b':
                self._escape = char
            elif self._escape == '\x1b' and char in '[O':
                self._escape += char
            elif len(self._escape) == 2:
                self._escape = ''
                if char in self._FINALS:
                    yield self._FINALS[char]
            else:
                self._escape = ''
                yield char.lower()


@contextlib.contextmanager
def raw_terminal(descriptor: int):
    """Deliver keys at once and without echo; the terminal is put back whatever happens. A pipe stays as it is."""
    if not os.isatty(descriptor):
        yield
        return
    cooked = termios.tcgetattr(descriptor)
    raw = termios.tcgetattr(descriptor)
    raw[3] &= ~(termios.ICANON | termios.ECHO)
    termios.tcsetattr(descriptor, termios.TCSANOW, raw)
    try:
        yield
    finally:
        termios.tcsetattr(descriptor, termios.TCSANOW, cooked)


class Teleop(TurtlesimNode):
    """The node ``teleop_turtle``; ``press`` does what a key says."""

    def __init__(self):
        super().__init__('teleop_turtle')
        self._angular_scale = self.declare_parameter('scale_angular', 2.0).value
        self._linear_scale = self.declare_parameter('scale_linear', 2.0).value
        self._twist = self.create_publisher(Twist, 'turtle1/cmd_vel', TOPIC_QOS)
        self._rotate = ActionClient(self, RotateAbsolute, 'turtle1/rotate_absolute')
        self._goal = None

    def press(self, key: str) -> bool:
        """Act on a key; return False if it means to quit."""
        if key in ARROWS:
            linear, angular = ARROWS[key]
            twist = Twist()
            twist.linear.x = self._linear_scale * linear
            twist.angular.z = self._angular_scale * angular
            self._twist.publish(twist)
        elif key in HEADINGS:
            goal = RotateAbsolute.Goal(theta=HEADINGS[key])
            self._rotate.send_goal_async(goal).add_done_callback(self._on_goal_response)
        elif key == 'f' and self._goal is not None:
            self.get_logger().debug('Sending cancel request')
            self._goal.cancel_goal_async()
        return key != 'q'

    def _on_goal_response(self, future) -> None:
        self.get_logger().debug('Goal response received')
        self._goal = future.result()


def read_keys(node: Teleop, descriptor: int) -> None:
    """Pass keys on until Q or the end of the input."""
    decoder = KeyDecoder()
    while data := os.read(descriptor, 64):
        for key in decoder.feed(data):
            if not node.press(key):
                return


def _spin(executor: SingleThreadedExecutor) -> None:
    with contextlib.suppress(ExternalShutdownException):
        executor.spin()


def _interrupt(*_) -> None:
    raise KeyboardInterrupt  # leave through the finally blocks: the terminal must be put back


def main(args=None) -> None:
    """Read keys from standard input until Q, Ctrl+C or its end."""
    descriptor = sys.stdin.fileno()
    # Both on purpose: a shell's background job inherits that SIGINT is ignored.
    signal.signal(signal.SIGINT, _interrupt)
    signal.signal(signal.SIGTERM, _interrupt)
    try:
        # Without rclpy's handlers Ctrl+C interrupts the read below.
        rclpy.init(args=args, signal_handler_options=SignalHandlerOptions.NO)
        node = Teleop()
        executor = SingleThreadedExecutor()
        executor.add_node(node)
        spinner = threading.Thread(target=_spin, args=(executor,))
        spinner.start()
        try:
            with raw_terminal(descriptor):
                print(HELP, flush=True)
                read_keys(node, descriptor)
        finally:
            executor.shutdown()
            spinner.join()
    except KeyboardInterrupt:
        pass
    finally:
        rclpy.try_shutdown()
