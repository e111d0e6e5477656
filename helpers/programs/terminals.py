"""How a command is run as in a new terminal with ROS: for `Workspace` in a notebook, and for the tests of exercises."""

import json
import shlex
import shutil
import sys
from pathlib import Path

from helpers import paths

INTERFACES = paths.ROOT / 'environment' / 'ros2_ws' / 'cmake' / 'python_interfaces.cmake'
DEFAULTS = 'colcon_defaults.yaml'  # in a workspace; the variable COLCON_DEFAULTS_FILE names it


def underlay() -> Path | None:
    """The setup file of the ROS installation that this Python belongs to; None where it is sourced from elsewhere."""
    found = Path(sys.prefix, 'setup.bash')
    return found if found.is_file() else None


def shell(script: str) -> list[str]:
    """The command that runs a script in bash after sourcing the ROS installation."""
    setup = underlay()
    return ['bash', '-c', f'source {shlex.quote(str(setup))}\n{script}' if setup else script]


def colcon_defaults() -> str:
    """The text of a file of colcon's default options, in YAML: this Python, Ninja if it is there, Python interfaces."""
    cmake = [f'-DPython3_EXECUTABLE={sys.executable}', f'-DCMAKE_PROJECT_INCLUDE={INTERFACES}']
    if shutil.which('ninja') or Path(sys.prefix, 'bin', 'ninja').is_file():
        cmake += ['-G', 'Ninja']
    options = ''.join(f'    - {json.dumps(option)}\n' for option in cmake)
    return f'build:\n  cmake-args:\n{options}'
