"""Says goodbye."""

import sys


def main():
    print('Goodbye,', ' '.join(sys.argv[1:]) or 'robot')
