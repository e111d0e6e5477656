"""The ways to a ROS 2 Jazzy, and what each would still need on this machine.

Standard library only. `routes(root)` looks at everything; a `Route` is a list of steps, each a `Fact` of
`environment.setup.facts` with the command that does it. Nothing is changed, and nothing is asked of the network.
"""

import os
import platform
import shutil
import subprocess
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, replace
from pathlib import Path

from environment.setup import facts
from environment.setup.facts import Fact
from environment.setup.layout import Layout
from environment.setup.underlay import DISTRO

UBUNTU = '24.04'  # the Ubuntu that Jazzy's packages are made for
_ARCHITECTURES = {'x86_64': 'amd64', 'aarch64': 'arm64'}
_KEYS = 'https://github.com/ros-infrastructure/ros-apt-source/releases'
Which = Callable[[str], str | None]


@dataclass(frozen=True)
class Route:
    """One way to ROS; `steps` in the order in which they are done."""

    name: str
    steps: tuple[Fact, ...]

    @property
    def possible(self) -> bool:
        """Whether nothing stands in the way that no command can change."""
        return all(step.ok or step.remedy for step in self.steps)

    @property
    def ready(self) -> bool:
        """Whether nothing is left to do."""
        return all(step.ok for step in self.steps)

    @property
    def missing(self) -> tuple[Fact, ...]:
        """The steps that are left to do."""
        return tuple(step for step in self.steps if not step.ok)


def routes(root: Path, environ: Mapping[str, str] = os.environ) -> Iterator[Route]:
    """Each way to ROS 2, as it is on this machine now."""
    layout = Layout(root)
    yield apt()
    yield container(environ)
    yield conda(environ)
    packages = facts.overlay(layout, environ)
    packages = replace(packages, text='built') if packages.ok else packages  # their names would fill the page
    yield Route("this course's own prefix", (facts.python(layout), facts.compiler(environ), facts.disk(root), packages))


def apt(system: Path = Path('/'), machine: str = platform.machine()) -> Route:
    """Debian packages on Ubuntu; `system` is the root of the file system to look at."""
    steps = [_ubuntu(system), _architecture(machine)]
    if not all(step.ok for step in steps):
        return Route('apt packages', tuple(steps))
    key = bool(list((system / 'usr/share/keyrings').glob('ros*archive-keyring*')))
    sources = [
        path
        for path in (system / 'etc/apt/sources.list.d').glob('*')
        if path.suffix in ('.list', '.sources') and '/ros2/ubuntu' in path.read_text(errors='replace')
    ]
    installed = system / 'opt/ros' / DISTRO
    tools = system / 'usr/bin/colcon'
    steps += [
        Fact(
            'key of packages.ros.org',
            key,
            'installed' if key else 'missing',
            f'install the package ros2-apt-source, from {_KEYS}',
        ),
        Fact(
            'apt source',
            bool(sources),
            ', '.join(path.name for path in sources) or 'missing',
            'comes with ros2-apt-source; then: sudo apt update',
        ),
        Fact(
            f'ros-{DISTRO}-desktop',
            (installed / 'setup.bash').is_file(),
            str(installed) if installed.is_dir() else 'missing',
            f'sudo apt install ros-{DISTRO}-desktop',
        ),
        Fact(
            'ros-dev-tools',
            tools.exists(),
            'installed' if tools.exists() else 'missing',
            'sudo apt install ros-dev-tools',
        ),
    ]
    return Route('apt packages', tuple(steps))


def container(environ: Mapping[str, str], which: Which = shutil.which, attempt=subprocess.run) -> Route:
    """An image with ROS inside, run by Docker or Podman."""
    engine = next((name for name in ('docker', 'podman') if which(name)), None)
    if engine is None:
        step = Fact('Docker or Podman', False, 'missing', 'sudo apt install podman')
        return Route('container', (step,))
    steps = [Fact('Docker or Podman', True, engine)]
    try:
        trial = attempt(
            [engine, 'image', 'ls', '--format', '{{.Repository}}:{{.Tag}}'],
            env=dict(environ),
            capture_output=True,
            text=True,
            timeout=10,
            check=False,
        )
        answers, images = trial.returncode == 0, trial.stdout.split()
    except (OSError, subprocess.TimeoutExpired):
        answers, images = False, []
    steps.append(
        Fact(
            'it answers',
            answers,
            'yes' if answers else 'no',
            f'start it, and let your user use it (see: {engine} info)',
        )
    )
    if answers:
        found = [image for image in images if f'ros:{DISTRO}' in image]
        steps.append(
            Fact(
                'an image', bool(found), ', '.join(found) or 'none yet', f'{engine} pull docker.io/library/ros:{DISTRO}'
            )
        )
    return Route('container', tuple(steps))


def conda(environ: Mapping[str, str], which: Which = shutil.which) -> Route:
    """RoboStack's conda packages."""
    tool = next((name for name in ('pixi', 'micromamba', 'mamba', 'conda') if which(name)), None)
    steps = [Fact('pixi, micromamba or conda', tool is not None, tool or 'missing', 'see https://pixi.sh')]
    prefix = environ.get('CONDA_PREFIX', '')
    found = bool(prefix) and any(Path(prefix, 'conda-meta').glob(f'ros-{DISTRO}-rclpy-*.json'))
    steps.append(
        Fact(
            f'an environment with ros-{DISTRO}-desktop',
            found,
            prefix if found else 'none is active',
            f'make one from the channels robostack-{DISTRO} and conda-forge, and activate it',
        )
    )
    return Route('conda (RoboStack)', tuple(steps))


def _ubuntu(system: Path) -> Fact:
    name, version = _release(system)
    text = f'{name} {version}'.strip() or 'unknown system'
    # No remedy: a system is not changed for a course. Another way is.
    return Fact(f'Ubuntu {UBUNTU}', (name, version) == ('Ubuntu', UBUNTU), text)


def _architecture(machine: str) -> Fact:
    return Fact('amd64 or arm64', machine in _ARCHITECTURES, _ARCHITECTURES.get(machine, machine))


def _release(system: Path) -> tuple[str, str]:
    """(name, version) from os-release; empty where it says nothing."""
    try:
        lines = (system / 'etc/os-release').read_text().splitlines()
    except OSError:
        return '', ''
    values = {key: value.strip('"\'') for key, _, value in (line.partition('=') for line in lines)}
    return values.get('NAME', ''), values.get('VERSION_ID', '')
