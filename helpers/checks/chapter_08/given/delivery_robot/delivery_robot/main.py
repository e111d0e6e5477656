"""The executable: the node in several threads, because a drive waits while others must be heard."""

import rclpy
from delivery_robot.robot import DeliveryRobot
from rclpy.executors import ExternalShutdownException, MultiThreadedExecutor


def main():
    try:
        rclpy.init()
        rclpy.spin(DeliveryRobot(), MultiThreadedExecutor(num_threads=4))
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()
