"""The node: a robot description in, and joint states; transforms out."""

from pathlib import Path

import rclpy
from builtin_interfaces.msg import Time as Stamp
from geometry_msgs.msg import Quaternion, TransformStamped, Vector3
from node_program.running import CannotStart, ros
from rcl_interfaces.msg import SetParametersResult
from rclpy.node import Node
from rclpy.parameter import Parameter
from rclpy.qos import DurabilityPolicy, QoSProfile, qos_profile_sensor_data
from rclpy.qos_overriding_options import QoSOverridingOptions
from rclpy.time import Time
from sensor_msgs.msg import JointState
from std_msgs.msg import String
from tf2_ros import StaticTransformBroadcaster, TransformBroadcaster
from urdf_reader import UrdfError, read

from robot_state_publisher.tree import Transform, Tree


class RobotStatePublisher(Node):
    """
    Publish where the links of a robot are.

    Reads ``joint_states`` (sensor_msgs/JointState, best effort). Publishes ``/tf`` for the joints that move,
    ``/tf_static`` for those that do not, and ``robot_description`` (std_msgs/String, transient local).

    Parameters: ``robot_description`` (the URDF's text), ``publish_frequency`` (at most so many transforms of a joint a
    second, by the stamps; 20 by default), ``frame_prefix``, ``ignore_timestamp``. All can be changed while it runs.

    :param urdf_file: a file to read when the parameter ``robot_description`` is not set, as stock does.
    :raises CannotStart: no robot description, or one that cannot be used; the log says why.
    """

    def __init__(self, urdf_file: str | None = None, **options):
        super().__init__('robot_state_publisher', **options)
        text = self.declare_parameter('robot_description', '').value
        if not text and urdf_file is not None:
            text = self._read_file(urdf_file)
        self.declare_parameter('publish_frequency', 20.0)
        self.declare_parameter('frame_prefix', '')
        self.declare_parameter('ignore_timestamp', False)
        # After the URDF's file and before its check, so that the same check serves a start and a change.
        problem = self._problem('publish_frequency', self._value('publish_frequency')) or self._problem(
            'robot_description', text
        )
        if problem:
            self._cannot_start(problem)
        if text != self._value('robot_description'):
            self.set_parameters([Parameter('robot_description', value=text)])

        self._last_published: dict[str, int] = {}  # by joint; nanoseconds, of the stamps
        self._last_callback = 0
        self._broadcaster = TransformBroadcaster(self)
        self._static_broadcaster = StaticTransformBroadcaster(self)
        self._description = self.create_publisher(
            String, 'robot_description', QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
        )
        self._set_robot(text)
        self.create_subscription(
            JointState,
            'joint_states',
            self._on_joint_state,
            qos_profile_sensor_data,
            qos_overriding_options=QoSOverridingOptions.with_default_policies(),
        )
        self.add_on_set_parameters_callback(self._check)
        self.add_post_set_parameters_callback(self._changed)

    def _value(self, parameter: str):
        return self.get_parameter(parameter).value

    def _cannot_start(self, problem: str) -> None:
        self.get_logger().fatal(problem)
        raise CannotStart(problem)

    def _read_file(self, name: str) -> str:
        self.get_logger().warning(
            f'No parameter robot_description; taking the argument {name!r} for the name of a URDF file. '
            'This form is deprecated: later versions want the parameter.'
        )
        try:
            return Path(name).read_text()
        except (OSError, UnicodeDecodeError) as error:
            return self._cannot_start(f'cannot read the URDF file {name!r}: {getattr(error, "strerror", error)}')

    def _problem(self, parameter: str, value) -> str | None:
        """What is wrong with a value of a parameter; None if nothing is."""
        if parameter == 'robot_description':
            if not value:
                return (
                    'the parameter robot_description is empty: set it to the text of a URDF, '
                    'for example from a launch file'
                )
            try:
                read(value)
            except UrdfError as error:
                return f'bad robot_description: {error}'
        if parameter == 'publish_frequency' and not 0.0 < value <= 1000.0:
            return f'publish_frequency is {value:g}; it must be above 0 and at most 1000'
        return None

    def _check(self, parameters: list[Parameter]) -> SetParametersResult:
        for parameter in parameters:
            problem = self._problem(parameter.name, parameter.value)
            if problem:
                self.get_logger().warning(problem)
                return SetParametersResult(successful=False, reason=problem)
        return SetParametersResult(successful=True)

    def _changed(self, parameters: list[Parameter]) -> None:
        for parameter in parameters:
            if parameter.name == 'robot_description':
                self._set_robot(parameter.value)

    def _set_robot(self, text: str) -> None:
        robot = read(text)
        self._tree = Tree(robot)
        for joint in robot.joints.values():
            if joint.type == 'floating':
                self.get_logger().info(f'Floating joint: no transform from {joint.parent} to {joint.child}')
        self._description.publish(String(data=text))
        self.get_logger().info('Robot initialized')
        fixed = self._messages(self._tree.fixed(), self.get_clock().now().to_msg())
        if fixed:
            self._static_broadcaster.sendTransform(fixed)

    def _on_joint_state(self, state: JointState) -> None:
        if len(state.name) != len(state.position):
            if not state.position:
                self.get_logger().warning(
                    'Robot state publisher ignored a JointState message about joint(s) '
                    f'"{state.name[0]}"(,...) whose position member was empty.'
                )
            else:
                self.get_logger().error('Robot state publisher ignored an invalid JointState message')
            return
        now = self.get_clock().now().nanoseconds
        if now < self._last_callback:
            self.get_logger().warning('Moved backwards in time, re-publishing joint transforms!')
            self._last_published.clear()
        self._last_callback = now
        stamp = Time.from_msg(state.header.stamp).nanoseconds
        interval = int(1000.0 / self._value('publish_frequency')) * 1_000_000  # whole milliseconds, as stock
        last = min((self._last_published.get(name, 0) for name in state.name), default=now)
        if not self._value('ignore_timestamp') and stamp < min(last, now) + interval:
            return
        moving = self._messages(
            self._tree.moving(dict(zip(state.name, state.position, strict=True))), state.header.stamp
        )
        if moving:
            self._broadcaster.sendTransform(moving)
        self._last_published.update(dict.fromkeys(state.name, stamp))

    def _messages(self, transforms: list[Transform], stamp: Stamp) -> list[TransformStamped]:
        prefix, messages = self._value('frame_prefix'), []
        for transform in transforms:
            message = TransformStamped(child_frame_id=prefix + transform.child)
            message.header.frame_id, message.header.stamp = prefix + transform.parent, stamp
            message.transform.translation = Vector3(**dict(zip('xyz', transform.translation, strict=True)))
            message.transform.rotation = Quaternion(**dict(zip('xyzw', transform.rotation, strict=True)))
            messages.append(message)
        return messages


def main() -> None:
    """Run the program."""
    with ros() as (words, executor):
        rclpy.spin(RobotStatePublisher(words[0] if words else None), executor)
