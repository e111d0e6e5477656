"""Which ROS the course stands on: the wheels from PyPI, or a stock Jazzy that the user has sourced."""

import re
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

from environment.setup.errors import PreflightError

DISTRO = 'jazzy'


@dataclass(frozen=True)
class Underlay:
    """A stock Jazzy: its prefixes, in the order of AMENT_PREFIX_PATH. No prefixes: the wheels are the underlay."""

    prefixes: tuple[Path, ...] = ()

    @property
    def stock(self) -> bool:
        return bool(self.prefixes)

    def __str__(self) -> str:
        return ':'.join(map(str, self.prefixes)) or 'wheels'

    def provides(self, package: str) -> bool:
        """Whether the stock installation has this ROS package."""
        marker = Path('share/ament_index/resource_index/packages', package)
        return any((prefix / marker).exists() for prefix in self.prefixes)

    def interpreters(self) -> list[str]:
        """Commands for the interpreter that its rclpy was built for, the best first."""
        found = []
        for prefix in self.prefixes:
            # Conda's interpreter lives in the prefix; apt's ROS uses the system's.
            for package in sorted(prefix.glob('lib/python3.*/*-packages/rclpy')):
                name = package.parents[1].name
                found += [str(prefix / 'bin' / name)] if (prefix / 'bin' / name).exists() else []
                found += [f'/usr/bin/{name}', name]
        return list(dict.fromkeys(found))


def _stock(prefix: Path) -> bool:
    # A prefix with pyvenv.cfg is an environment of this course (or its like), not a stock installation.
    return (prefix / 'share').is_dir() and not (prefix / 'pyvenv.cfg').exists()


def find(environ: Mapping[str, str]) -> Underlay:
    """The underlay that this shell's environment asks for.

    Raises PreflightError when another distribution is sourced: its libraries would be mixed with Jazzy's.
    """
    conda = environ.get('CONDA_PREFIX', '')
    listed = [p for p in environ.get('AMENT_PREFIX_PATH', '').split(':') if p]
    prefixes = [Path(p) for p in dict.fromkeys(listed) if _stock(Path(p))]
    distro = environ.get('ROS_DISTRO', '')
    ros1 = [p for p in environ.get('ROS_PACKAGE_PATH', '').split(':') if p and Path(p).is_dir()]
    if distro not in ('', DISTRO) and (prefixes or ros1):
        raise PreflightError(
            f'this terminal has ROS {distro} sourced, the course is for {DISTRO}',
            f'open a terminal without it (look for /opt/ros/{distro} in ~/.bashrc), then run ./course again',
        )
    if conda and Path(conda) not in prefixes and list(Path(conda, 'conda-meta').glob(f'ros-{DISTRO}-rclpy-*.json')):
        prefixes.append(Path(conda))
    if any((p / 'share' / 'rclpy').is_dir() for p in prefixes):
        return Underlay(tuple(prefixes))
    return Underlay()


def parse(text: str) -> Underlay:
    """The underlay that `str` was made from."""
    return Underlay() if text == 'wheels' else Underlay(tuple(Path(p) for p in text.split(':')))


ROS_WHEEL = re.compile(r'ros-')


def without_ros_wheels(lock: str) -> str:
    """The lock without the ROS wheels, for use upon a stock installation."""
    kept, skip = [], False
    for line in lock.splitlines(keepends=True):
        if line[:1].strip() and not line.startswith('#'):
            skip = bool(ROS_WHEEL.match(line))
        if not skip:
            kept.append(line)
    return ''.join(kept)
