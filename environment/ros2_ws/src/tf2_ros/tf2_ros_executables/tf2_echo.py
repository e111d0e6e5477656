"""Print the transform between two frames again and again."""

import sys
from math import asin, atan2, cos, degrees, isfinite, pi

import rclpy
from node_program.running import ros
from rclpy.clock import Clock, ClockType
from rclpy.node import Node
from rclpy.time import Time
from tf2_py import TransformException
from tf2_ros.buffer import Buffer
from tf2_ros.transform_listener import TransformListener

from tf2_ros_executables.static_transform_publisher import NUMBER

USAGE = (
    'Usage: tf2_echo source_frame target_frame [echo_rate]\n\n'
    'This will echo the transform from the coordinate frame of the source_frame\n'
    'to the coordinate frame of the target_frame. \n'
    'Note: This is the transform to get data from target_frame into the source_frame.\n'
    'Default echo rate is 1 if echo_rate is not given.'
)


def matrix_of(rotation):
    """Return the rows of the rotation matrix of a quaternion message of any length but zero."""
    x, y, z, w = rotation.x, rotation.y, rotation.z, rotation.w
    s = 2.0 / (x * x + y * y + z * z + w * w)
    return (
        (1.0 - s * (y * y + z * z), s * (x * y - w * z), s * (x * z + w * y)),
        (s * (x * y + w * z), 1.0 - s * (x * x + z * z), s * (y * z - w * x)),
        (s * (x * z - w * y), s * (y * z + w * x), 1.0 - s * (x * x + y * y)),
    )


def roll_pitch_yaw_of(matrix):
    """Return the angles, in radians, about the fixed axes x, y, z; yaw is 0 where it cannot be told from roll."""
    (m00, _, _), (m10, _, _), (m20, m21, m22) = matrix
    if abs(m20) >= 1.0:
        return atan2(m21, m22), pi / 2.0 if m20 < 0.0 else -pi / 2.0, 0.0
    pitch = -asin(m20)
    c = cos(pitch)
    return atan2(m21 / c, m22 / c), pitch, atan2(m10 / c, m00 / c)


def describe(transform):
    """Return the lines that say where and how a `TransformStamped` is, as stock's tf2_echo."""

    def row(values):
        return ', '.join(f'{value:.3f}' for value in values)

    def columns(values):
        return ''.join(f' {value:6.3f}' for value in values)

    stamp, translation, rotation = transform.header.stamp, transform.transform.translation, transform.transform.rotation
    matrix = matrix_of(rotation)
    angles = roll_pitch_yaw_of(matrix)
    position = translation.x, translation.y, translation.z
    return '\n'.join(
        [
            f'At time {stamp.sec}.{stamp.nanosec}',  # stock does not pad the nanoseconds either
            f'- Translation: [{row(position)}]',
            f'- Rotation: in Quaternion [{row((rotation.x, rotation.y, rotation.z, rotation.w))}]',
            f'- Rotation: in RPY (radian) [{row(angles)}]',
            f'- Rotation: in RPY (degree) [{row(map(degrees, angles))}]',
            '- Matrix:',
            *(columns((*matrix[i], position[i])) for i in range(3)),
            columns((0.0, 0.0, 0.0, 1.0)),
        ]
    )


class Echo(Node):
    """Prints the transform that takes data from the target frame into the source frame, `rate` times a second."""

    def __init__(self, source_frame, target_frame, rate):
        super().__init__('tf2_echo')
        self.frames = source_frame, target_frame
        self.found = False
        self.buffer = Buffer()  # without the node: it need not answer `tf2_frames`
        self.listener = TransformListener(self.buffer, self)
        self.create_timer(1.0 / rate, self.tick, clock=Clock(clock_type=ClockType.STEADY_TIME))
        self.tick()

    def tick(self):
        """Print the transform, or, as long as there never was one, what it is waiting for."""
        source, target = self.frames
        if not self.found:
            self.found, why_not = self.buffer.can_transform(source, target, Time(), return_debug_tuple=True)
            if not self.found:
                self.get_logger().info(
                    f'Waiting for transform {source} ->  {target}: {why_not}', throttle_duration_sec=1.0
                )
                return
        try:
            print(describe(self.buffer.lookup_transform(source, target, Time())), flush=True)
        except TransformException as error:
            print(
                f'Failure at {self.get_clock().now().nanoseconds / 1e9:.3f}\n'
                f'Exception thrown:{error}\n'
                f'The current list of frames is:\n{self.buffer.all_frames_as_string()}',
                flush=True,
            )


def main():
    """Run the program; return its exit status."""
    with ros() as (words, executor):
        if len(words) not in (2, 3):
            print(USAGE)
            return 1
        rate = 1.0
        if len(words) == 3:
            number = NUMBER.match(words[2])
            if number is None or number.end() != len(words[2]):
                print(f"Failed to convert rate argument '{words[2]}' to a floating-point number", file=sys.stderr)
                return 2 if number is None else 3
            rate = float(number[1])
            if not (isfinite(rate) and rate > 0.0):
                print('rate must be greater than 0', file=sys.stderr)
                return 1
        rclpy.spin(Echo(*words[:2], rate), executor)
    return 0
