"""Says hello."""

import sys


def main():
    print('Hello,', ' '.join(sys.argv[1:]) or 'robot')
