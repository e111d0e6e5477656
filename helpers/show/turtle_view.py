"""The world of turtlesim as a picture in a notebook: live while the simulator runs, still afterwards.

`TurtleView` follows the simulator of any process by its poses; it needs no window and no screen. Its arrows drive the
turtle.
"""

import random
import sys
import time

from helpers.kernel import journal, nodes
from helpers.kernel.spinning import spinning
from helpers.kernel.waiting import spin_for
from helpers.paths import ROOT

try:
    import turtlesim_nodes  # noqa: F401
except ModuleNotFoundError:  # stock turtlesim is a C++ program: the simulation and its drawing come from our source
    sys.path.append(str(ROOT / 'environment' / 'ros2_ws' / 'src' / 'turtlesim'))
from turtlesim_nodes.world import STEP, World

from helpers.show import inline_svg, turtle_drawing
from helpers.show.widgets import WidgetOutput

__all__ = ['STEP', 'TurtlePicture', 'TurtleView', 'World', 'show_turtle']
RATE = 10.0  # pictures a second, at most
_POSE = 'turtlesim/msg/Pose'
_LOOK = 0.25  # s between two looks at the graph
_LATE = 2.0  # s; a command that nobody has heard by then is forgotten
_SIZE = 340  # px
_views: list['TurtleView'] = []


class TurtlePicture:
    """A turtlesim world as Jupyter shows it: an SVG, and a line of text for each turtle.

    :param goal: a place to mark, (x, y) in m.
    """

    def __init__(self, world: World, size: int = _SIZE, goal: tuple[float, float] | None = None):
        self._world, self._size, self.goal = world, size, goal

    def svg(self) -> str:
        """Return the picture as it is now."""
        return turtle_drawing.draw(self._world, self._size, self.goal)

    def _repr_mimebundle_(self, include=None, exclude=None) -> dict[str, str]:
        return inline_svg.still(self.svg(), str(self))

    def __str__(self) -> str:
        turtles = (self._world.turtles[name] for name in sorted(self._world.turtles))
        return '\n'.join(map(turtle_drawing.describe, turtles)) or 'no turtle'

    __repr__ = __str__


def show_turtle(world: World, size: int = _SIZE, goal: tuple[float, float] | None = None) -> None:
    """Show a world as it is now.

    :param world: a ``turtlesim_nodes.world.World``.
    :param size: width of the picture in pixels.
    :param goal: a place to mark, (x, y) in m.
    """
    from IPython.display import display

    display(TurtlePicture(world, size, goal))


class TurtleView:
    """Watch the turtles of the running simulator in the output of this cell.

    ::

        with TurtleView() as view:
            wait_for(lambda: view.pose() and view.pose().x > 7)

        view = TurtleView()     # goes on after the cell, until stop() or helpers.ros.stop()
        view.stop()

    It is a node of this process (``/_turtle_view``) that spins in the background, and follows every topic
    ``…/pose`` of type turtlesim/msg/Pose in its domain. It sees poses only, not the pens: all lines have one colour. A
    second view, in another cell, replaces the first one.

    While the view is live, its arrow buttons drive a turtle, and so do the arrow keys while the view has the focus:
    each press publishes a geometry_msgs/Twist on the turtle's ``cmd_vel``. A front end that knows no widgets shows a
    still picture without arrows.

    :param size: width of the picture in pixels.
    :param goal: a place to mark, (x, y) in m; the attribute `goal` can be assigned later, too.
    :param drive: the name of the turtle that the arrows drive.
    :raises RuntimeError: ROS is not started.
    """

    def __init__(self, size: int = _SIZE, goal: tuple[float, float] | None = None, drive: str = 'turtle1'):
        import rclpy

        if not rclpy.ok():
            raise RuntimeError('ROS is not started: run helpers.ros.start() first')
        self._world = World(random_source=random.Random(0))  # the same colours in every run
        self._picture = TurtlePicture(self._world, size, goal)
        self._driven, self._publisher = drive, None
        self._command: tuple[float, object] | None = None  # until when it is worth something, and the message
        self._poses: dict[str, object] = {}
        self._subscriptions: dict[str, object] = {}
        self._output: WidgetOutput | None = None
        self._changed = False
        for other in _views.copy():
            other.stop()
        self._node = rclpy.create_node('_turtle_view', enable_rosout=False, start_parameter_services=False)
        self._node.create_timer(_LOOK, self._look)
        self._node.create_timer(1 / RATE, self._update)
        self._look()
        self._spinning = spinning(self._node)
        _views.append(self)
        self._show()

    def pose(self, name: str = 'turtle1'):
        """Return the latest ``turtlesim.msg.Pose`` of a turtle; None while nothing has come."""
        return self._poses.get(name)

    @property
    def turtles(self) -> list[str]:
        """The names of the turtles that have been seen."""
        return sorted(self._poses)

    @property
    def goal(self) -> tuple[float, float] | None:
        """The place that is marked, (x, y) in m."""
        return self._picture.goal

    @goal.setter
    def goal(self, place: tuple[float, float] | None) -> None:
        self._picture.goal = place
        self._changed = True

    def clear(self) -> None:
        """Forget the lines drawn so far, as turtlesim's service ``clear`` does."""
        self._world.clear()
        self._changed = True

    def watch(self, seconds: float = 8.0, at_least: float = 1.0) -> None:
        """Go on for so many seconds if a browser shows the view; else (in a test, say) for `at_least` seconds."""
        end = time.monotonic() + seconds
        spin_for(at_least)
        if self._output is not None and self._output.widget.shown:
            spin_for(max(0.0, end - time.monotonic()))

    def stop(self) -> None:
        """Stop watching; the last picture stays. Idempotent."""
        if self in _views:
            _views.remove(self)
            self._spinning.let_go(self._node)
            nodes.destroy(self._node)
            if self._output is not None:
                self._output.close(self._picture)

    def __enter__(self) -> 'TurtleView':
        return self

    def __exit__(self, kind, error, tb) -> None:
        self.stop()

    def __repr__(self) -> str:
        return str(self._picture)

    def _look(self) -> None:
        """Subscribe to the turtles that are new, and let go of those whose simulator has ended."""
        from turtlesim.msg import Pose

        there = {
            topic
            for topic, types in self._node.get_topic_names_and_types()
            if _POSE in types and topic.endswith('/pose') and self._node.count_publishers(topic)
        }
        for topic in there - self._subscriptions.keys():
            name = _turtle(topic)
            self._world.kill(name)  # the turtle of an earlier simulator: no line leads from it to the new one
            self._subscriptions[topic] = self._node.create_subscription(
                Pose, topic, lambda pose, name=name: self._on_pose(name, pose), 10
            )
        for topic in self._subscriptions.keys() - there:
            self._node.destroy_subscription(self._subscriptions.pop(topic))
            self._poses.pop(_turtle(topic), None)

    def _on_pose(self, name: str, pose) -> None:
        before = self._poses.get(name)
        self._poses[name] = pose
        if before == pose:
            return
        turtle = self._world.turtles.get(name)
        if turtle is None:
            self._world.spawn(pose.x, pose.y, pose.theta, name)
        else:
            turtle.teleport_absolute(pose.x, pose.y, pose.theta)
            turtle.step(self._world, now=0.0)
        self._changed = True

    def _show(self) -> None:
        if journal.in_kernel():
            from helpers.show.turtle_pad import TurtlePad

            self._output = WidgetOutput(TurtlePad(self._picture.svg(), self._drive), self._picture)

    def _update(self) -> None:
        if self._changed and self._output is not None:
            self._changed = False
            self._output.widget.picture = self._picture.svg()
        self._send()

    def _drive(self, linear: float, angular: float) -> None:
        """Keep a command for the turtle, which the next update sends; in the thread of the browser's messages."""
        from geometry_msgs.msg import Twist

        command = Twist()
        command.linear.x, command.angular.z = linear, angular
        self._command = time.monotonic() + _LATE, command

    def _send(self) -> None:
        """Send the command as soon as somebody listens. While no arrow is pressed the graph has no publisher of it."""
        from geometry_msgs.msg import Twist

        if self._command is None:
            return
        if self._publisher is None:
            self._publisher = self._node.create_publisher(Twist, f'/{self._driven}/cmd_vel', 10)
        until, command = self._command
        if self._publisher.get_subscription_count():
            self._command = None
            self._publisher.publish(command)
        elif time.monotonic() > until:
            self._command = None


def _turtle(topic: str) -> str:
    """``/turtle1/pose`` -> ``turtle1``; in a namespace ``/sim2/turtle1/pose`` -> ``sim2/turtle1``."""
    return topic.removesuffix('/pose').strip('/')


def _on_destroy(node) -> None:
    for view in _views.copy():
        if view._node is node:
            view.stop()


nodes.before_destroy.append(_on_destroy)
