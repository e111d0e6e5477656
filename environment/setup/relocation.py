"""Repairs the paths of the build machine in what the ROS wheels installed.

The wheels' CMake and shell files name the directories of the machine that built them, so that CMake stops at a missing
include directory. Files are replaced, never written into: the installer may have linked them to its own cache.
"""

import os
import re
import stat
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from environment.setup import whole_file

# The machine's Python, its numpy, and the prefix that the packages were installed into.
_INCLUDE = re.compile(rb'/opt/python/cp3\d+-cp3\d+/include/python3\.\d+')
_NUMPY = re.compile(rb'/opt/python/cp3\d+-cp3\d+/lib/python3\.\d+/site-packages/numpy/_core/include')
_PREFIX = re.compile(rb'/project/build/temp\.[\w.-]+/install')
_FOREIGN = re.compile(rb'/opt/python/cp3|/project/build/')
_SUFFIXES = ('.cmake', '.sh', '.bash', '.zsh', '.dsv', '.ps1')


@dataclass(frozen=True)
class Places:
    """The real directories."""

    prefix: Path
    include: Path
    numpy: Path


def _candidates(prefix: Path) -> Iterator[Path]:
    for parent, _, files in os.walk(prefix / 'share'):
        yield from (Path(parent, name) for name in files if name.endswith(_SUFFIXES))


def repair(places: Places) -> int:
    """Rewrite every file that names the build machine; returns how many. A second call changes nothing.

    Raises RuntimeError when a path of the build machine is left over, as a later CMake error would be obscure.
    """
    changed = 0
    for path in _candidates(places.prefix):
        old = path.read_bytes()
        if not _FOREIGN.search(old):
            continue
        new = _NUMPY.sub(lambda _: os.fsencode(places.numpy), old)
        new = _INCLUDE.sub(lambda _: os.fsencode(places.include), new)
        new = _PREFIX.sub(lambda _: os.fsencode(places.prefix), new)
        if _FOREIGN.search(new):
            raise RuntimeError(f'{path} names a directory of the machine that built it, in a form not known here')
        replace(path, new)
        changed += 1
    for path in places.prefix.glob('share/ament_index/resource_index/parent_prefix_path/*'):
        # The build machine had underlays; this prefix has none.
        if path.read_bytes():
            replace(path, b'')
            changed += 1
    return changed


def link_vendored_programs(prefix: Path) -> None:
    """Put uncrustify, which its wheel installs below opt/, where ament_uncrustify looks for it: on the PATH."""
    program, link = prefix / 'opt' / 'uncrustify_vendor' / 'bin' / 'uncrustify', prefix / 'bin' / 'uncrustify'
    if program.exists() and not link.exists():
        link.symlink_to(os.path.relpath(program, link.parent))


def setup_scripts(prefix: Path) -> list[Path]:
    """colcon's scripts that ask a Python which variables to set."""
    return sorted(prefix.glob('local_setup.*'))


def scripts_ask(prefix: Path, python: Path) -> bool:
    """Whether there is a setup.bash, and whether its Python is the given one."""
    wanted = b'_colcon_python_executable="%s"' % os.fsencode(python)
    try:
        return (prefix / 'setup.bash').is_file() and wanted in (prefix / 'local_setup.bash').read_bytes()
    except FileNotFoundError:
        return False


def let_scripts_ask(prefix: Path, python: Path) -> None:
    """Let the setup scripts ask the base interpreter.

    They set only what is not set yet. The environment's own Python completes its variables as it starts, so that
    under it the scripts would find nothing left to do.
    """
    for path in setup_scripts(prefix):
        old = path.read_bytes()
        new = old.replace(
            b'_colcon_python_executable="%s"' % os.fsencode(prefix / 'bin' / 'python'),
            b'_colcon_python_executable="%s"' % os.fsencode(python),
        )
        if new != old:
            replace(path, new)


def replace(path: Path, content: bytes) -> None:
    """Put a new file in place of `path`, with the same rights; who holds a link to the old one keeps the old one."""
    whole_file.write(path, content, rights=stat.S_IMODE(path.stat().st_mode))
