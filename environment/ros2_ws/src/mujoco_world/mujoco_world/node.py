"""The node ``world``: a simulated robot on ROS topics."""

import threading
import time

from geometry_msgs.msg import Twist
from node_program.running import CannotStart, run
from rcl_interfaces.msg import FloatingPointRange, ParameterDescriptor, SetParametersResult
from rclpy.clock import Clock, ClockType
from rclpy.node import Node
from std_srvs.srv import SetBool, Trigger
from visualization_msgs.msg import MarkerArray

from mujoco_world.topics import LATCHED, PERIOD, Topics
from mujoco_world.world import CONTROL_PERIOD, Noise, NoPicturesError, SceneError, UnstableError, UrdfError, World

BURST = 0.015  # s of wall time in which the world goes on without a look at what has come
MOST_BEHIND = 0.25  # s of wall time; what a slow machine is behind more than this is given up


class WorldNode(Node):
    """
    A `World` on topics.

    Publishes ``/clock``, ``odom``, ``/tf`` (map -> odom -> base_footprint), ``joint_states``, ``scan``,
    ``camera_info``, ``image`` (while somebody listens, and if the machine can render), and once the scene as markers on
    ``walls`` (transient local). Reads ``cmd_vel`` (geometry_msgs/Twist).

    Services: ``~/pause`` (std_srvs/SetBool), ``~/step`` (std_srvs/Trigger: goes on by 0.02 s, also while paused), and
    ``~/reset`` (std_srvs/Trigger: the robot back to its start; time goes on).

    Parameters, set at the start: ``robot_description`` (a URDF's text; empty: the course's robot), ``scene``, ``seed``.
    Parameters that can be changed: ``real_time_factor`` (0: as fast as possible), ``range_noise`` and
    ``odometry_noise`` (see `mujoco_world.world.Noise`), ``localization`` (publish map -> odom), ``command_timeout``.

    :param clocked: let time pass by itself; if False, only `step` does.
    :raises CannotStart: the robot or the scene cannot be used; the log says why.
    """

    def __init__(self, clocked: bool = True, **options):
        super().__init__('world', **options)
        text = self._fixed('robot_description', '', "the robot's URDF; empty: mobile_robot_description's")
        scene = self._fixed('scene', 'rooms', 'a scene of mujoco_world, or the path of a YAML file')
        seed = self._fixed('seed', 0, 'of the noise')
        try:
            self.world = World(text or None, scene, seed=seed)
        except (UrdfError, SceneError) as error:
            self.get_logger().fatal(str(error))
            raise CannotStart(str(error)) from None
        laser = self.world.robot.lidar.noise if self.world.robot.lidar else 0.0
        self._number('real_time_factor', 1.0, 'simulated seconds in a second; 0: as many as possible', 1000.0)
        self._number('range_noise', laser, 'standard deviation of a laser range in metres', 10.0)
        self._number('odometry_noise', 0.0, "standard deviation of a wheel's way after one metre, in metres", 10.0)
        self._number('command_timeout', 0.5, 'seconds after which the robot stops without a command; 0: never', 3600.0)
        self.declare_parameter('localization', True, ParameterDescriptor(description='publish map -> odom'))
        self.add_on_set_parameters_callback(self._check)
        self.add_post_set_parameters_callback(lambda _: self._configure())

        self.lock = threading.RLock()  # for whoever uses `world` in another thread
        self.topics = Topics(self.world)
        self.paused = False
        self._told: set[str] = set()  # what was said once
        self._configure()
        self._publishers_of = {
            topic.name: self.create_publisher(topic.type, topic.name, topic.qos) for topic in self.topics.topics
        }
        self._walls = self.create_publisher(MarkerArray, 'walls', LATCHED)
        self._walls.publish(self.topics.markers())
        self.create_subscription(Twist, 'cmd_vel', self._on_command, 10)
        self.create_service(SetBool, '~/pause', self._on_pause)
        self.create_service(Trigger, '~/step', self._on_step)
        self.create_service(Trigger, '~/reset', self._on_reset)
        if clocked:
            # By the wall, also when use_sim_time is set: this node is what makes time.
            self.create_timer(PERIOD, self._on_timer, clock=Clock(clock_type=ClockType.STEADY_TIME))
        self.get_logger().info(
            f'MuJoCo world "{self.world.scene.name}" with the robot "{self.world.robot.description.name}"'
        )

    # Time

    def step(self) -> None:
        """Go on by `PERIOD` and publish what is due then."""
        with self.lock:
            for _ in range(round(PERIOD / CONTROL_PERIOD)):
                try:
                    self.world.step()
                except UnstableError as error:
                    self._say_once(f'{error} The robot is put back to its start.')
                    self.world.reset()
                for topic in self.topics.due():
                    self._publish(topic)

    def restart_clock(self) -> None:
        """Take no notice of the wall time that has gone by."""
        self._then = time.monotonic()
        self._owed = 0.0  # simulated seconds that wall time is ahead

    def _on_timer(self) -> None:
        now = time.monotonic()
        if self.paused:
            self.restart_clock()
        elif not self._factor:
            while time.monotonic() < now + BURST:
                self.step()
        else:
            self._owed = min(self._owed + (now - self._then) * self._factor, MOST_BEHIND * self._factor)
            self._then = now
            while self._owed >= PERIOD and time.monotonic() < now + MOST_BEHIND:
                self.step()
                self._owed -= PERIOD

    def _publish(self, topic) -> None:
        publisher = self._publishers_of[topic.name]
        if topic.name == 'image' and not publisher.get_subscription_count():
            return
        try:
            publisher.publish(topic.make())
        except NoPicturesError as error:
            self._say_once(str(error))

    def _say_once(self, text: str) -> None:
        if text not in self._told:
            self._told.add(text)
            self.get_logger().error(text)

    # What comes

    def _on_command(self, twist: Twist) -> None:
        try:
            with self.lock:
                self.world.drive(twist.linear.x, twist.angular.z)
        except ValueError as error:
            self._say_once(f'ignoring a message on cmd_vel: {error}')

    def _on_pause(self, request: SetBool.Request, response: SetBool.Response) -> SetBool.Response:
        self.paused, response.success = request.data, True
        response.message = f'{"paused" if self.paused else "running"} at {self.world.time:.2f} s'
        return response

    def _on_step(self, request: Trigger.Request, response: Trigger.Response) -> Trigger.Response:
        self.step()
        response.success, response.message = True, f'at {self.world.time:.2f} s'
        return response

    def _on_reset(self, request: Trigger.Request, response: Trigger.Response) -> Trigger.Response:
        with self.lock:
            self.world.reset()
        response.success, response.message = True, 'the robot is at its start'
        return response

    # Parameters

    def _fixed(self, name: str, default, description: str):
        return self.declare_parameter(name, default, ParameterDescriptor(description=description, read_only=True)).value

    def _number(self, name: str, default: float, description: str, largest: float) -> None:
        span = FloatingPointRange(from_value=0.0, to_value=largest)
        self.declare_parameter(name, default, ParameterDescriptor(description=description, floating_point_range=[span]))

    @staticmethod
    def _check(parameters) -> SetParametersResult:
        for parameter in parameters:
            if parameter.value != parameter.value:  # NaN passes every range
                return SetParametersResult(successful=False, reason=f'{parameter.name} must be a number')
        return SetParametersResult(successful=True)

    def _configure(self) -> None:
        def value(name: str):
            return self.get_parameter(name).value

        self._factor = value('real_time_factor')
        self.restart_clock()
        self.world.noise = Noise(value('range_noise'), value('odometry_noise'))
        self.world.command_timeout = value('command_timeout') or None
        self.topics.localization = value('localization')

    def destroy_node(self) -> None:
        """Give back what the camera holds, and leave the graph."""
        self.world.close()
        super().destroy_node()


def main() -> None:
    """Run the node until Ctrl+C."""
    run(WorldNode)
