"""`python environment/setup ARGS`: what the script `course` runs."""

import sys
from os.path import dirname, realpath

if __name__ == '__main__':
    sys.path[0] = dirname(dirname(dirname(realpath(__file__))))
    from environment.setup import interruption

    interruption.ends_at_once()  # before the imports that take longer
    from environment.setup.main import main

    sys.exit(main(sys.argv[1:]))
