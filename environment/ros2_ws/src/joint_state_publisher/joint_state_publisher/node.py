"""The node: a robot description in; positions of its joints out."""

import argparse
from pathlib import Path

import rclpy
from node_program.running import CannotStart, ros
from rcl_interfaces.msg import ParameterDescriptor, ParameterType
from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, QoSProfile
from sensor_msgs.msg import JointState
from std_msgs.msg import String
from urdf_reader import Mimic, UrdfError, read

from joint_state_publisher.joints import Joints, Options

PARAMETERS = {
    'rate': 10,
    'publish_default_positions': True,
    'publish_default_velocities': False,
    'publish_default_efforts': False,
    'use_mimic_tags': True,
    'use_smallest_joint_limits': True,
    'source_list': [],
    'delta': 0.0,
}


class JointStatePublisher(Node):
    """
    Publish ``joint_states`` (sensor_msgs/JointState) for all joints of a robot that move.

    The description comes from a file or from the topic ``robot_description``. Positions are the defaults, or what the
    topics of ``source_list`` say. Parameters, as stock: ``rate`` (Hz), ``publish_default_positions``, ``…_velocities``,
    ``…_efforts``, ``use_mimic_tags``, ``use_smallest_joint_limits``, ``source_list``, ``delta`` (radians or metres that
    every joint moves at each message), ``zeros.JOINT``, ``dependent_joints.JOINT.parent``, ``….factor``, ``….offset``.

    :param urdf_file: the file of the description; None: wait for the topic.
    :raises CannotStart: the file or a parameter cannot be used; the log says why.
    """

    def __init__(self, urdf_file: str | None = None, **options):
        super().__init__('joint_state_publisher', automatically_declare_parameters_from_overrides=True, **options)
        for name, default in PARAMETERS.items():
            if not self.has_parameter(name):
                strings = ParameterDescriptor(type=ParameterType.PARAMETER_STRING_ARRAY) if default == [] else None
                self.declare_parameter(name, default, strings)
        self._joints: Joints | None = None
        self._options = Options(
            *(
                self._value(name)
                for name in (
                    'publish_default_positions',
                    'publish_default_velocities',
                    'publish_default_efforts',
                    'use_mimic_tags',
                    'use_smallest_joint_limits',
                )
            ),
            zeros={name: float(p.value) for name, p in self.get_parameters_by_prefix('zeros').items()},
            dependent=self._dependent(),
        )
        if not isinstance(self._value('rate'), int | float) or not self._value('rate') > 0:
            self._cannot_start(f'rate is {self._value("rate")}; it must be above 0')
        if urdf_file is not None:
            try:
                self._joints = self._read(Path(urdf_file).read_text())
            except (OSError, ValueError) as error:
                self._cannot_start(f'{urdf_file}: {getattr(error, "strerror", None) or error}')
        else:
            self.get_logger().info('Waiting for robot_description to be published on the robot_description topic...')
            self.create_subscription(
                String,
                'robot_description',
                self._on_description,
                QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL),
            )
        for topic in self._value('source_list'):
            self.create_subscription(JointState, topic, self._on_source, 10)
        self._publisher = self.create_publisher(JointState, 'joint_states', 10)
        self.create_timer(1.0 / self._value('rate'), self._publish)

    def _value(self, parameter: str):
        return self.get_parameter(parameter).value

    def _cannot_start(self, problem: str) -> None:
        self.get_logger().fatal(problem)
        raise CannotStart(problem)

    def _dependent(self) -> dict[str, Mimic]:
        """The parameters ``dependent_joints.JOINT.parent`` and so on, by joint."""
        found: dict[str, dict] = {}
        for name, parameter in self.get_parameters_by_prefix('dependent_joints').items():
            joint, _, key = name.rpartition('.')
            if key not in ('parent', 'factor', 'offset') or not joint:
                self._cannot_start(f'dependent_joints.{name}: after the joint comes parent, factor or offset')
            found.setdefault(joint, {})[key] = parameter.value
        for joint, given in found.items():
            if not given.get('parent'):
                self._cannot_start(f'dependent_joints.{joint} has no parent')
        return {
            joint: Mimic(given['parent'], given.get('factor', 1.0), given.get('offset', 0.0))
            for joint, given in found.items()
        }

    def _read(self, text: str) -> Joints:
        return Joints(read(text, nested=True), self._options)  # as upstream, which looks for any <robot>

    def _on_description(self, message: String) -> None:
        try:
            self._joints = self._read(message.data)
        except UrdfError as error:  # an earlier description goes on
            self.get_logger().warning(f'Invalid robot_description given, ignoring: {error}')
        except ValueError as error:
            self.get_logger().error(f'This robot_description cannot be used, ignoring: {error}')

    def _on_source(self, message: JointState) -> None:
        for index, name in enumerate(message.name):
            joint = self._joints.free.get(name) if self._joints else None
            if joint is None:
                continue
            for kind in ('position', 'velocity', 'effort'):
                values = getattr(message, kind)
                if index < len(values):
                    setattr(joint, kind, values[index])

    def _publish(self) -> None:
        if self._joints is None or not self._joints.names:
            return
        if self._value('delta') > 0:
            self._joints.move(self._value('delta'))
        position, velocity, effort = self._joints.state()
        message = JointState(name=self._joints.names, position=position, velocity=velocity, effort=effort)
        message.header.stamp = self.get_clock().now().to_msg()
        self._publisher.publish(message)


def main() -> None:
    """Run the program."""
    parser = argparse.ArgumentParser(prog='joint_state_publisher')
    parser.add_argument('urdf_file', help='URDF file to use', nargs='?', default=None)
    with ros() as (words, executor):
        rclpy.spin(JointStatePublisher(parser.parse_args(words).urdf_file), executor)
