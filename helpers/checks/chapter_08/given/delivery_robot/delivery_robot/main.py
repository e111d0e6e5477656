"""The executable: the node in several threads, because a drive waits while others must be heard."""

import sys

import rclpy
from delivery_robot.robot import DeliveryRobot
from rclpy.executors import ExternalShutdownException, MultiThreadedExecutor


def main():
    # The executor hands a callback out again and again until a thread has begun it (issue 1452 of rclpy). A thread
    # begins when Python changes to it: by default after 5 ms, in which /tf waits and the robot may think it is lost.
    sys.setswitchinterval(0.0002)
    try:
        rclpy.init()
        rclpy.spin(DeliveryRobot(), MultiThreadedExecutor(num_threads=4))
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()
