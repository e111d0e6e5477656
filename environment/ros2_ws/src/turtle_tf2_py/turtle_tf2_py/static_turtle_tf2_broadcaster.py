"""``static_turtle_tf2_broadcaster CHILD X Y Z ROLL PITCH YAW``: a frame that stands still in ``world``."""

import functools
import sys

import rclpy
from node_program.running import run
from rclpy.node import Node
from rclpy.utilities import remove_ros_args
from tf2_ros import StaticTransformBroadcaster

from turtle_tf2_py.transforms import transform


class StaticFramePublisher(Node):
    """Broadcasts one static transform; ``transformation`` is a command line, with the program's name first."""

    def __init__(self, transformation: list[str]):
        super().__init__('static_turtle_tf2_broadcaster')
        self.tf_static_broadcaster = StaticTransformBroadcaster(self)
        child, *numbers = transformation[1:]
        place, turn = tuple(map(float, numbers[:3])), tuple(map(float, numbers[3:]))
        self.tf_static_broadcaster.sendTransform(
            transform(self.get_clock().now().to_msg(), 'world', child, place, turn)
        )


def main() -> None:
    """Run the program; what is wrong with the command line is told, and ends it with the status 1 or 2."""
    logger = rclpy.logging.get_logger('logger')
    arguments = remove_ros_args(sys.argv)
    if len(arguments) != 8:
        logger.info(
            'Invalid number of parameters. Usage: \n'
            '$ ros2 run turtle_tf2_py static_turtle_tf2_broadcaster child_frame_name x y z roll pitch yaw'
        )
        sys.exit(1)
    if arguments[1] == 'world':
        logger.info('Your static turtle name cannot be "world"')
        sys.exit(2)
    try:
        [float(number) for number in arguments[2:]]
    except ValueError as error:
        logger.info(f'x y z roll pitch yaw are numbers: {error}')
        sys.exit(1)
    run(functools.partial(StaticFramePublisher, arguments))
