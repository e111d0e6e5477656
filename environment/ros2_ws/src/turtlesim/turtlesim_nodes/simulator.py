"""``turtlesim_node``: the world as a ROS node with stock turtlesim's topics, services, action and parameters."""

import contextlib

import rclpy
from geometry_msgs.msg import Twist
from node_program.running import run
from rcl_interfaces.msg import IntegerRange, ParameterDescriptor
from rclpy.action import ActionServer, CancelResponse
from rclpy.clock import Clock, ClockType
from rclpy.exceptions import InvalidTopicNameException
from rclpy.validate_topic_name import validate_topic_name
from std_srvs.srv import Empty
from turtlesim.action import RotateAbsolute
from turtlesim.msg import Color, Pose
from turtlesim.srv import Kill, SetPen, Spawn, TeleportAbsolute, TeleportRelative

from turtlesim_nodes.node import TurtlesimNode
from turtlesim_nodes.qos import TOPIC_QOS
from turtlesim_nodes.window import NoWindowError, Window
from turtlesim_nodes.world import DEFAULT_BACKGROUND, STEP, Rotation, Turtle, World, float32

STEPS_PER_PICTURE = 2  # 31 pictures a second are enough, and leave time for the turtles


class TurtleInterface:
    """The topics, services and the action of one turtle."""

    def __init__(self, node: 'Simulator', turtle: Turtle):
        self._node, self._turtle = node, turtle
        self._goal = None
        self._rotation: Rotation | None = None
        name = turtle.name
        self._pose = node.create_publisher(Pose, f'{name}/pose', TOPIC_QOS)
        self._color = node.create_publisher(Color, f'{name}/color_sensor', TOPIC_QOS)
        self._command = node.create_subscription(Twist, f'{name}/cmd_vel', self._on_command, TOPIC_QOS)
        self._services = [
            node.create_service(SetPen, f'{name}/set_pen', self._on_set_pen),
            node.create_service(TeleportAbsolute, f'{name}/teleport_absolute', self._on_teleport_absolute),
            node.create_service(TeleportRelative, f'{name}/teleport_relative', self._on_teleport_relative),
        ]
        self._rotate = ActionServer(
            node,
            RotateAbsolute,
            f'{name}/rotate_absolute',
            execute_callback=self._finish_aborted,
            handle_accepted_callback=self._on_goal,
            cancel_callback=lambda _: CancelResponse.ACCEPT,
        )

    def destroy(self) -> None:
        """Take everything off the graph; a goal under way is aborted."""
        self._end_goal('abort')
        self._rotate.destroy()
        for service in self._services:
            self._node.destroy_service(service)
        self._node.destroy_subscription(self._command)
        self._node.destroy_publisher(self._pose)
        self._node.destroy_publisher(self._color)

    def before_step(self) -> None:
        """Look whether a client wants its rotation cancelled."""
        if self._goal is not None and self._goal.is_cancel_requested:
            self._node.get_logger().info('Rotation goal canceled')
            self._turtle.end_rotation()
            self._turtle.halt()
            self._end_goal('canceled')

    def after_step(self) -> None:
        """Publish the pose, the colour below and the progress of a rotation."""
        turtle = self._turtle
        self._pose.publish(
            Pose(
                x=float32(turtle.x),
                y=float32(turtle.y),
                theta=float32(turtle.theta),
                linear_velocity=float32(turtle.linear),
                angular_velocity=float32(turtle.angular),
            )
        )
        red, green, blue = turtle.color_below
        self._color.publish(Color(r=red, g=green, b=blue))
        if self._goal is not None:
            self._goal.publish_feedback(RotateAbsolute.Feedback(remaining=float32(self._rotation.remaining)))
            if self._rotation.done:
                self._node.get_logger().info('Rotation goal completed successfully')
                self._end_goal('succeed')

    def _on_command(self, twist: Twist) -> None:
        sideways = twist.linear.y if self._node.get_parameter('holonomic').value else None
        with self._node.reporting_bad_numbers('velocity command'):
            now = self._node.now()
            if self._turtle.command(now, twist.linear.x, twist.angular.z, sideways) is not None:
                self._node.get_logger().warning('Velocity command received during rotation goal. Aborting goal')
                self._end_goal('abort')

    def _on_set_pen(self, request: SetPen.Request, response: SetPen.Response) -> SetPen.Response:
        self._turtle.set_pen((request.r, request.g, request.b), request.width, down=not request.off)
        return response

    def _on_teleport_absolute(self, request, response):
        with self._node.reporting_bad_numbers('teleport_absolute request'):
            self._turtle.teleport_absolute(request.x, request.y, request.theta)
        return response

    def _on_teleport_relative(self, request, response):
        with self._node.reporting_bad_numbers('teleport_relative request'):
            self._turtle.teleport_relative(request.linear, request.angular)
        return response

    def _on_goal(self, goal) -> None:
        if self._goal is not None:
            self._node.get_logger().warning(
                'Rotation goal received before a previous goal finished. Aborting previous goal'
            )
            self._turtle.end_rotation()
            self._end_goal('abort')
        # The goal runs from now on, but nothing may wait for it: a coroutine that waits would make the
        # executor spin without rest. So the state is set here, and the result is sent by _end_goal.
        goal._update_state(rclpy.action.server._rclpy.GoalEvent.EXECUTE)
        self._goal = goal
        with self._node.reporting_bad_numbers('rotate_absolute goal'):
            self._rotation = self._turtle.rotate_to(goal.request.theta)
            return
        self._rotation = None
        self._end_goal('abort')

    def _end_goal(self, how: str) -> None:
        """Send the result of the goal under way: ``how`` is succeed, abort or canceled."""
        goal, rotation = self._goal, self._rotation
        self._goal = self._rotation = None
        if goal is None:
            return
        getattr(goal, how)()
        result = RotateAbsolute.Result(delta=float32(rotation.delta) if rotation else 0.0)
        self._rotate.notify_execute(goal, lambda _: result)

    @staticmethod
    def _finish_aborted(goal) -> RotateAbsolute.Result:
        """Never the way a goal ends here (see ``_end_goal``), but rclpy wants a callback."""
        goal.abort()
        return RotateAbsolute.Result()


class Simulator(TurtlesimNode):
    """The node ``turtlesim``. It opens a window if it can."""

    def __init__(self):
        super().__init__('turtlesim')
        for channel, name, value in zip('rgb', ('Red', 'Green', 'Blue'), DEFAULT_BACKGROUND, strict=True):
            descriptor = ParameterDescriptor(
                description=f'{name} channel of the background color',
                integer_range=[IntegerRange(from_value=0, to_value=255, step=1)],
            )
            self.declare_parameter(f'background_{channel}', value, descriptor)
        holonomic = ParameterDescriptor(description='If true, then turtles will be holonomic')
        self.declare_parameter('holonomic', False, holonomic)
        self.world = World()
        self.add_post_set_parameters_callback(lambda _: self._read_background())
        self._read_background()
        self._interfaces: dict[str, TurtleInterface] = {}
        self._steps = 0
        try:
            self.window = Window(self.world)
        except NoWindowError as reason:
            self.window = None
            self.get_logger().info(f'Running without a window: {reason}')
        self.create_service(Empty, 'clear', self._on_clear)
        self.create_service(Empty, 'reset', self._on_reset)
        self.create_service(Spawn, 'spawn', self._on_spawn)
        self.create_service(Kill, 'kill', self._on_kill)
        self.get_logger().info(f'Starting turtlesim with node name {self.get_fully_qualified_name()}')
        self._add(self.world.spawn())
        # Stock steps by the wall, also when use_sim_time is set.
        self.create_timer(STEP, self._on_timer, clock=Clock(clock_type=ClockType.STEADY_TIME))

    def now(self) -> float:
        """Return the node's time in seconds."""
        return self.get_clock().now().nanoseconds * 1e-9

    @contextlib.contextmanager
    def reporting_bad_numbers(self, what: str):
        """Turn the world's ValueError into a line of the log; the block's effect is left out."""
        try:
            yield
        except ValueError as error:
            self.get_logger().error(f'Ignoring {what}: {error}')

    def _read_background(self) -> None:
        self.world.background = tuple(self.get_parameter(f'background_{channel}').value for channel in 'rgb')

    def _on_timer(self) -> None:
        for interface in list(self._interfaces.values()):
            interface.before_step()
        for bump in self.world.step(self.now()):
            self.get_logger().warning(f'Oh no! I hit the wall! (Clamping from [x={bump.x:f}, y={bump.y:f}])')
        for interface in list(self._interfaces.values()):
            interface.after_step()
        self._steps += 1
        if self.window is not None and self._steps % STEPS_PER_PICTURE == 0:
            self.window.show()
            if self.window.closed:
                self.context.try_shutdown()

    def _add(self, turtle: Turtle) -> None:
        self._interfaces[turtle.name] = TurtleInterface(self, turtle)
        self.get_logger().info(
            f'Spawning turtle [{turtle.name}] at x=[{turtle.x:f}], y=[{turtle.y:f}], theta=[{turtle.theta:f}]'
        )

    def _on_spawn(self, request: Spawn.Request, response: Spawn.Response) -> Spawn.Response:
        try:
            validate_topic_name(f'{request.name or "turtle"}/pose')
            turtle = self.world.spawn(request.x, request.y, request.theta, request.name)
        except (InvalidTopicNameException, ValueError) as error:
            self.get_logger().error(f'Cannot spawn turtle [{request.name}]: {_one_line(error)}')
            return response
        if turtle is None:
            self.get_logger().error(f'A turtle named [{request.name}] already exists')
            return response
        self._add(turtle)
        response.name = turtle.name
        return response

    def _on_kill(self, request: Kill.Request, response: Kill.Response) -> Kill.Response:
        if self.world.kill(request.name) is None:
            self.get_logger().error(f'Tried to kill turtle [{request.name}], which does not exist')
        else:
            self._interfaces.pop(request.name).destroy()
        return response

    def _on_clear(self, _: Empty.Request, response: Empty.Response) -> Empty.Response:
        self.get_logger().info('Clearing turtlesim.')
        self.world.clear()
        return response

    def _on_reset(self, _: Empty.Request, response: Empty.Response) -> Empty.Response:
        self.get_logger().info('Resetting turtlesim.')
        for interface in self._interfaces.values():
            interface.destroy()
        self._interfaces.clear()
        self._add(self.world.reset())
        return response


def _one_line(error: Exception) -> str:
    return str(error).strip().splitlines()[0].rstrip(':')


def main(args=None) -> None:
    """Run the simulator until Ctrl+C, or until its window is closed."""
    run(Simulator, args)
