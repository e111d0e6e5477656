"""Reports the battery."""

import sys


def report():
    print('The battery of', ' '.join(sys.argv[1:]) or 'the robot', 'is full')


def main():
    print('battery.py tests itself')
