"""`ros2 launch` whose TimerActions wait for almost nothing: what a launch file starts late is there to be seen.

The tests would have to wait for as long as the launch file says, and nobody knows how long that is.
"""

# Takes the place of the command `ros2`. A longer time stays a longer one, so the order is as it was. Timers that launch
# needs to end its programs go on after the system shuts down, and keep their time.
PROGRAM = """\
import sys

if sys.path[:1] == ['']:
    del sys.path[0]  # the folder in which it is launched

from launch import Substitution
from launch.actions import TimerAction
from launch.utilities import normalize_to_list_of_substitutions, perform_substitutions
from ros2cli.cli import main


def hurried(period):
    period = max(float(period), 0.0)
    return 0.05 * period / (1 + period)


class Hurried(Substitution):
    def __init__(self, period):
        super().__init__()
        self.period = normalize_to_list_of_substitutions(period)

    def perform(self, context):
        return str(hurried(perform_substitutions(context, self.period)))


def init(self, *, period, cancel_on_shutdown=True, **others):
    if cancel_on_shutdown is True:
        period = hurried(period) if isinstance(period, (int, float)) else Hurried(period)
    given(self, period=period, cancel_on_shutdown=cancel_on_shutdown, **others)


given, TimerAction.__init__ = TimerAction.__init__, init
sys.argv[0] = 'ros2'
sys.exit(main())
"""
COMMAND = 'python3', '-c', PROGRAM, 'launch'
