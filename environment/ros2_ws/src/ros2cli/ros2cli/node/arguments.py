"""The options about the node; apart from it, so that a help text does not load rclpy."""

import argparse

from ros2cli.node.discovery import LONGEST_TIME


def add_direct_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the options of a command that has a node of its own."""
    parser.add_argument(
        '--spin-time',
        type=float,
        metavar='SPIN_TIME',
        help='Wait exactly this many seconds for discovery. Without it, wait until every DDS participant of this '
        f'machine has been heard and the graph has come to rest, at most {LONGEST_TIME:g} s, or twice as long while '
        'datagrams get lost',
    )
    parser.add_argument('-s', '--use-sim-time', action='store_true', help='Take the time from the topic /clock')


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the options of a command for which stock ros2 may ask its daemon."""
    add_direct_arguments(parser)
    parser.add_argument(
        '--no-daemon', action='store_true', help='Do not use a daemon; there is none here, so this is always so'
    )
