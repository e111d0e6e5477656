"""Starts the command line."""

import sys

from helpers.cli.app import main

sys.exit(main())
