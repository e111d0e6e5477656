"""`python environment/setup ARGS`: what the script `course` runs."""

import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]

if __name__ == '__main__':
    sys.path[0] = str(ROOT)
    from environment.setup.main import main

    sys.exit(main(sys.argv[1:]))
