"""Publish one static transform that the command line describes."""

import re
from dataclasses import dataclass, field
from math import cos, sin
from random import SystemRandom
from string import ascii_letters, digits

import rclpy
from geometry_msgs.msg import TransformStamped
from node_program.running import ros
from rcl_interfaces.msg import ParameterDescriptor
from rclpy.impl.rcutils_logger import RcutilsLogger
from rclpy.node import Node
from rclpy.parameter import Parameter
from tf2_ros.static_transform_broadcaster import StaticTransformBroadcaster

# Stock's program logs through the unnamed root logger until it has a node.
root_logger = RcutilsLogger()

USAGE = """\
usage: static_transform_publisher [--x X] [--y Y] [--z Z] [--qx QX] [--qy QY] [--qz QZ] [--qw QW] [--roll ROLL] \
[--pitch PITCH] [--yaw YAW] --frame-id FRAME_ID --child-frame-id CHILD_FRAME_ID

A command line utility for manually sending a static transform.

If no translation or orientation is provided, the identity transform will be published.

The translation offsets are in meters.

The rotation may be provided with roll, pitch, yaw euler angles in radians, or as a quaternion.

required arguments:
  --frame-id FRAME_ID parent frame
  --child-frame-id CHILD_FRAME_ID child frame id

optional arguments:
  --x X                 x component of translation
  --y Y                 y component of translation
  --z Z                 z component of translation
  --qx QX               x component of quaternion rotation
  --qy QY               y component of quaternion rotation
  --qz QZ               z component of quaternion rotation
  --qw QW               w component of quaternion rotation
  --roll ROLL           roll component Euler rotation
  --pitch PITCH         pitch component Euler rotation
  --yaw YAW             yaw component Euler rotation"""

TRANSLATION = ('x', 'y', 'z')
QUATERNION = ('qx', 'qy', 'qz', 'qw')
EULER = ('roll', 'pitch', 'yaw')
# What the old form gives by position, by the number of arguments.
OLD_FORMS = {8: (*TRANSLATION, 'yaw', 'pitch', 'roll'), 9: (*TRANSLATION, *QUATERNION)}
# As C's strtod, which stock uses: a number at the beginning is enough.
NUMBER = re.compile(r'\s*([+-]?(?:inf(?:inity)?|nan|(?:\d+\.?\d*|\.\d+)(?:e[+-]?\d+)?))', re.IGNORECASE)


class ArgumentsError(Exception):
    """The command line makes no sense; the text is stock's."""


@dataclass
class Arguments:
    """What the command line asks for: metres, and a quaternion x, y, z, w."""

    translation: list = field(default_factory=lambda: [0.0, 0.0, 0.0])
    rotation: list = field(default_factory=lambda: [0.0, 0.0, 0.0, 1.0])
    frame_id: str = ''
    child_frame_id: str = ''
    help: bool = False


def _number(name, text):
    match = NUMBER.match(text)
    if match is None:
        raise ArgumentsError(f'Failed to parse {name} argument as float')
    return float(match[1])


def quaternion_from_rpy(roll, pitch, yaw):
    """Return x, y, z, w of the rotation by roll, then pitch, then yaw about the fixed axes; radians."""
    cr, sr = cos(roll / 2.0), sin(roll / 2.0)
    cp, sp = cos(pitch / 2.0), sin(pitch / 2.0)
    cy, sy = cos(yaw / 2.0), sin(yaw / 2.0)
    return [
        sr * cp * cy - cr * sp * sy,
        cr * sp * cy + sr * cp * sy,
        cr * cp * sy - sr * sp * cy,
        cr * cp * cy + sr * sp * sy,
    ]


def parse(words):
    """
    Return the :class:`Arguments` of a command line without the program's name.

    :raises ArgumentsError: if it makes no sense.
    """
    arguments = Arguments()
    values, positional = {}, []
    frames = {'--frame-id': 'frame_id', '--child-frame-id': 'child_frame_id'}
    numbers = {f'--{name}': name for name in (*TRANSLATION, *QUATERNION, *EULER)}
    saw_frame = False
    remaining = iter(words)
    for word in remaining:
        if word in ('--help', '-h'):
            arguments.help = True
        elif word in frames or word in numbers:
            value = next(remaining, None)
            if value is None:
                raise ArgumentsError(f'Not enough arguments for {word}')
            if word in frames:
                saw_frame = True
                setattr(arguments, frames[word], value)
            else:
                values[numbers[word]] = _number(word, value)
        else:
            positional.append(word)
    if arguments.help:
        return arguments

    saw_translation, saw_quaternion, saw_euler = (
        any(name in values for name in names) for names in (TRANSLATION, QUATERNION, EULER)
    )
    if saw_euler and saw_quaternion:
        raise ArgumentsError('Cannot specify both quaternion and Euler rotations')
    if len(positional) in OLD_FORMS:
        root_logger.warning('Old-style arguments are deprecated; see --help for new-style arguments')
        if saw_frame or saw_translation or saw_quaternion:
            raise ArgumentsError('Cannot specify both new-style (flags) and old-style (arguments)')
        names = OLD_FORMS[len(positional)]
        values = {name: _number(name, word) for name, word in zip(names, positional, strict=False)}
        saw_euler = 'yaw' in values
        arguments.frame_id, arguments.child_frame_id = positional[-2:]
    elif positional:
        raise ArgumentsError('Extra unparsed arguments on command-line')
    arguments.translation = [values.get(name, 0.0) for name in TRANSLATION]
    if saw_euler:
        arguments.rotation = quaternion_from_rpy(*(values.get(name, 0.0) for name in EULER))
    else:
        arguments.rotation = [values.get(name, 1.0 if name == 'qw' else 0.0) for name in QUATERNION]
    if not arguments.frame_id:
        raise ArgumentsError('Frame id must not be empty')
    if not arguments.child_frame_id:
        raise ArgumentsError('Child frame id must not be empty')
    return arguments


class StaticTransformBroadcasterNode(Node):
    """
    A node that sends one static transform when it is made; its read-only parameters say which.

    :raises ValueError: if a frame shall be relative to itself.
    """

    def __init__(self, arguments):
        suffix = ''.join(SystemRandom().choices(digits + ascii_letters, k=16))
        overrides = {'frame_id': arguments.frame_id, 'child_frame_id': arguments.child_frame_id}
        overrides.update(zip(('translation.x', 'translation.y', 'translation.z'), arguments.translation, strict=True))
        overrides.update(zip(('rotation.x', 'rotation.y', 'rotation.z', 'rotation.w'), arguments.rotation, strict=True))
        super().__init__(
            f'static_transform_publisher_{suffix}',
            parameter_overrides=[Parameter(name, value=value) for name, value in overrides.items()],
        )
        read_only = ParameterDescriptor(read_only=True)
        value = {name: self.declare_parameter(name, default, read_only).value for name, default in overrides.items()}
        if value['frame_id'] == value['child_frame_id']:
            self.get_logger().error(
                f"cannot publish static transform from '{value['frame_id']}' to '{value['child_frame_id']}', exiting"
            )
            raise ValueError('child_frame_id cannot equal frame_id')
        message = TransformStamped()
        message.header.stamp = self.get_clock().now().to_msg()
        message.header.frame_id, message.child_frame_id = value['frame_id'], value['child_frame_id']
        translation, rotation = message.transform.translation, message.transform.rotation
        translation.x, translation.y, translation.z = (value[f'translation.{axis}'] for axis in 'xyz')
        rotation.x, rotation.y, rotation.z, rotation.w = (value[f'rotation.{axis}'] for axis in 'xyzw')
        self.broadcaster = StaticTransformBroadcaster(self)
        self.broadcaster.sendTransform(message)


def _quoted(values):
    return ', '.join(f"'{value:f}'" for value in values)


def main():
    """Run the program; return its exit status."""
    with ros() as (words, executor):
        try:
            arguments = parse(words)
        except ArgumentsError as error:
            root_logger.error(f'error parsing command line arguments: {error}')
            print(USAGE)
            return 1
        if arguments.help:
            print(USAGE)
            return 0
        try:
            node = StaticTransformBroadcasterNode(arguments)
        except ValueError:  # it has said why
            return 1
        node.get_logger().info(
            f'Spinning until stopped - publishing transform\n'
            f'translation: ({_quoted(arguments.translation)})\n'
            f'rotation: ({_quoted(arguments.rotation)})\n'
            f"from '{arguments.frame_id}' to '{arguments.child_frame_id}'"
        )
        rclpy.spin(node, executor)
    return 0
