"""Steers along a line: turns the readings of five light sensors into a speed."""

from pathlib import Path

import yaml
from ament_index_python.packages import get_package_share_directory
from geometry_msgs.msg import Twist

from line_follower.filters.median import median


def steer(offsets, gains):
    """Return the command for the offsets (m) of the line that were seen last."""
    command = Twist()
    command.linear.x = 0.2  # m/s
    command.angular.z = -gains['kp'] * median(offsets)  # rad/s
    return command


def main():
    share = Path(get_package_share_directory('line_follower'))
    gains = yaml.safe_load((share / 'config' / 'gains.yaml').read_text())
    command = steer([0.1, 9.9, 0.1], gains)
    print(f'forward {command.linear.x:.2f} m/s, turn {command.angular.z:.2f} rad/s')
