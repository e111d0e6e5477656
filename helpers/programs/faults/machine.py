"""A stand-in for another machine: a home folder whose terminals have only what its own ``.bashrc`` sets."""

import os
import shlex
import shutil
import sys
from pathlib import Path

from helpers.programs import terminals
from helpers.programs.english import ENGLISH
from helpers.programs.workspace import Workspace

BASHRC = '.bashrc'
SETUP = 'opt/ros/{distro}/setup.bash'  # of a distribution, below the home
SYSTEM_PATH = '/usr/bin:/bin'
# What a terminal takes over from this process: places and the form of log lines; nothing of ROS.
_KEPT = ('TZ', 'TMPDIR', 'COURSE_DOMAINS_DIR', 'RCUTILS_CONSOLE_OUTPUT_FORMAT')
# No program here communicates beyond this machine, unless a .bashrc says so.
_RANGE = 'export ROS_AUTOMATIC_DISCOVERY_RANGE=${ROS_AUTOMATIC_DISCOVERY_RANGE:-LOCALHOST}\n'


class Machine(Workspace):
    """A folder that is somebody's home: a new terminal of it has the system's PATH, and reads ``.bashrc``."""

    def __init__(self, path, env=None):
        super().__init__(path, env)
        self.system_path = SYSTEM_PATH

    def install(self, distro: str = 'jazzy') -> None:
        """Give it ROS: a setup file in ``opt/ros/DISTRO`` that leads to the installation of the course."""
        self.write(SETUP.format(distro=distro), f'source {shlex.quote(str(ros_setup()))}\n{_RANGE}')

    def install_apart(self, tools: dict[str, str], distro: str = 'jazzy') -> None:
        """Give it ROS, but with some commands in folders of their own, and not beside ``ros2``.

        :param tools: command -> its folder below the home.
        :raises RuntimeError: this machine does not have such a command.
        """
        ros = self.path / 'opt' / 'ros' / distro
        for command in ('ros2', 'python3', *tools):
            target = sys.executable if command == 'python3' else _find(command)
            folder = self.path / tools[command] if command in tools else ros / 'bin'
            folder.mkdir(parents=True, exist_ok=True)
            wrapper = folder / command
            wrapper.write_text(f'#!/bin/sh\nexec {shlex.quote(target)} "$@"\n')
            wrapper.chmod(0o755)
        self.write(
            SETUP.format(distro=distro),
            f'keep=$PATH\nsource {shlex.quote(str(ros_setup()))}\nexport PATH="{ros}/bin:$keep"\n{_RANGE}',
        )
        if any(shutil.which(command, path=SYSTEM_PATH) for command in tools):
            self.system_path = str(self._system_without(set(tools)))

    def _terminal(self, script: str) -> list[str]:
        variables = {name: os.environ[name] for name in _KEPT if name in os.environ}
        variables |= {
            'HOME': str(self.path),
            'PATH': self.system_path,
            'TERM': 'dumb',
            **ENGLISH,
            'PYTHONUNBUFFERED': '1',
            'RCUTILS_COLORIZED_OUTPUT': '0',
            'COLCON_DEFAULTS_FILE': str(self.path / terminals.DEFAULTS),
            **self.env,
        }
        settings = [f'{name}={value}' for name, value in variables.items()]
        return ['env', '-i', *settings, 'bash', '--noprofile', '--norc', '-c', f'source ~/{BASHRC}\n{script}']

    def _system_without(self, commands: set[str]) -> Path:
        """A folder with links to the system's commands, but not to these."""
        folder = self.path / 'usr' / 'bin'
        folder.mkdir(parents=True)
        for file in Path('/usr/bin').iterdir():
            if file.name not in commands:
                (folder / file.name).symlink_to(file)
        return folder


def ros_setup() -> Path:
    """The setup file of the ROS installation that the course uses, its own or a stock one.

    :raises RuntimeError: there is none.
    """
    found = terminals.underlay() or Path('/opt/ros', os.environ.get('ROS_DISTRO', 'jazzy'), 'setup.bash')
    if not found.is_file():
        raise RuntimeError(f'there is no {found}: run ./course doctor in a terminal')
    return found


def _find(command: str) -> str:
    found = shutil.which(command, path=f'{Path(sys.executable).parent}:{ros_setup().parent / "bin"}:{os.defpath}')
    if not found:
        raise RuntimeError(f'there is no {command} on this machine: run ./course doctor in a terminal')
    return found
