"""A timer that fires once, made anew each time or used again, while another one fires every two seconds."""

from node_program.running import run
from rclpy.node import Node
from rclpy.timer import Timer

PERIOD, DELAY = 2.0, 1.0  # s
ROUNDS = 3  # of the periodic timer, in the first of which the other one begins


class _Timers(Node):
    def __init__(self, name: str) -> None:
        super().__init__(name)
        self._round = 0
        self._once: Timer | None = None
        self.create_timer(PERIOD, self._on_period)

    def _on_period(self) -> None:
        self.get_logger().info('in periodic_timer callback')
        begins = self._round % ROUNDS == 0
        self._round += 1
        self.get_logger().info(f'  {"" if begins else "not "}resetting one off timer')
        if begins:
            self.begin()

    def begin(self) -> None:
        """Let the timer fire once from now."""
        raise NotImplementedError

    def on_once(self) -> None:
        """Stop the timer."""
        self.get_logger().info('in one_off_timer callback')
        self._once.cancel()


class OneOffTimer(_Timers):
    """Makes a timer each time."""

    def __init__(self) -> None:
        """Begin with the periodic timer alone."""
        super().__init__('one_off_timer')

    def begin(self) -> None:
        """Let a new timer fire."""
        if self._once is not None:
            self.destroy_timer(self._once)
        self._once = self.create_timer(DELAY, self.on_once)


class ReuseTimer(_Timers):
    """Has one timer, and starts it again."""

    def __init__(self) -> None:
        """Make both timers."""
        super().__init__('reuse_timer')
        self._once = self.create_timer(DELAY, self.on_once, autostart=False)

    def begin(self) -> None:
        """Let the timer fire again."""
        self._once.reset()


def one_off_timer(args: list[str] | None = None) -> None:
    """Run the node that makes timers."""
    run(OneOffTimer, args)


def reuse_timer(args: list[str] | None = None) -> None:
    """Run the node that uses one timer again."""
    run(ReuseTimer, args)
