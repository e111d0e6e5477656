"""A private machine: a home folder whose terminals know nothing but what its own ``.bashrc`` sets."""

import os
from pathlib import Path

from helpers import terminals
from helpers.workspace import Workspace

#: What a terminal of it takes over from this process: language and where things may be kept, nothing of ROS.
KEPT = ('LANG', 'LC_ALL', 'TZ', 'TMPDIR', 'COURSE_DOMAINS_DIR')
SYSTEM_PATH = '/usr/bin:/bin'
DOMAIN = 'COURSE_DOMAIN'  # the domain of the notebook, for a .bashrc that does not choose one


class Machine(Workspace):
    """A folder that is the home of somebody: a new terminal of it has the system's PATH and reads ``.bashrc``."""

    def _terminal(self, script: str) -> list[str]:
        variables = {name: os.environ[name] for name in KEPT if name in os.environ}
        variables |= {'HOME': str(self.path), 'PATH': SYSTEM_PATH, 'TERM': 'dumb', 'PYTHONUNBUFFERED': '1',
                      'RCUTILS_COLORIZED_OUTPUT': '0', 'COLCON_DEFAULTS_FILE': str(self.path / terminals.DEFAULTS)}
        for name in ('RCUTILS_CONSOLE_OUTPUT_FORMAT', 'ROS_AUTOMATIC_DISCOVERY_RANGE'):
            if name in os.environ:
                variables[name] = os.environ[name]
        variables |= self.env
        settings = [f'{name}={value}' for name, value in variables.items()]
        return ['env', '-i', *settings, 'bash', '--noprofile', '--norc', '-c', f'source ~/.bashrc\n{script}']


def ros_setup() -> Path:
    """The setup file of the ROS installation that the course uses, its own or a stock one.

    :raises RuntimeError: there is none.
    """
    found = terminals.underlay() or Path('/opt/ros', os.environ.get('ROS_DISTRO', 'jazzy'), 'setup.bash')
    if not found.is_file():
        raise RuntimeError(f'there is no {found}: run ./course doctor in a terminal')
    return found
