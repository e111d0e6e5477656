"""What the set-up needs of a machine, checked before it starts; what is missing is told in one line with a remedy."""

import locale
import os
import platform
import shutil
import subprocess
import tempfile
from collections.abc import Mapping
from pathlib import Path

from environment.setup.errors import PreflightError
from environment.setup.underlay import Underlay

OLDEST_GLIBC = (2, 28)  # the wheels are manylinux_2_28
SPACE_NEEDED = 2_000_000_000  # bytes: the environment and its build tree, with some to spare
ROBOSTACK = (
    "use RoboStack's conda packages: conda create -n jazzy -c conda-forge -c robostack-jazzy "
    'ros-jazzy-ros-base compilers && conda activate jazzy, then run ./course again'
)


def check_platform(system: str | None = None, machine: str | None = None, libc: tuple[str, str] | None = None) -> None:
    """Raise PreflightError unless the ROS wheels run here: Linux, x86-64, glibc 2.28 or newer."""
    system, machine = system or platform.system(), machine or platform.machine()
    if system != 'Linux' or machine not in ('x86_64', 'AMD64'):
        raise PreflightError(f'PyPI has ROS for x86-64 Linux only, this is {machine} {system}', ROBOSTACK)
    name, version = libc or platform.libc_ver()
    if name != 'glibc' or tuple(int(n) for n in version.split('.')[:2]) < OLDEST_GLIBC:
        has = f'{name} {version}'.strip() or 'another C library'
        raise PreflightError(f'the ROS wheels need glibc 2.28 or newer, this system has {has}', ROBOSTACK)


def check_compiler(environ: Mapping[str, str]) -> None:
    """Raise PreflightError unless C and C++ compile and link."""
    path = environ.get('PATH', os.defpath)
    for variable, names, suffix, language, text in (
        ('CC', ('cc', 'gcc', 'clang'), 'c', 'C', '#include <stdio.h>\nint main(void){return 0;}\n'),
        ('CXX', ('c++', 'g++', 'clang++'), 'cpp', 'C++', '#include <string>\nint main(){return 0;}\n'),
    ):
        names = (environ[variable].split()[0],) if environ.get(variable) else names
        command = next(filter(None, (shutil.which(name, path=path) for name in names)), None)
        remedy = 'run: sudo apt install g++'
        if command is None:
            raise PreflightError(f'no {language} compiler ({", ".join(names)}) on PATH', remedy)
        with tempfile.TemporaryDirectory() as scratch:
            source = Path(scratch, f'probe.{suffix}')
            source.write_text(text)
            trial = subprocess.run(
                [command, source.name, '-o', 'probe'],
                cwd=scratch,
                env=dict(environ),
                capture_output=True,
                text=True,
                check=False,
            )
        if trial.returncode:
            reason = next((line for line in trial.stderr.splitlines() if 'error' in line), '').strip()[:120]
            raise PreflightError(f'the {language} compiler {command} does not work ({reason})', remedy)


def check_space(directory: Path, needed: int = SPACE_NEEDED) -> None:
    """Raise PreflightError unless `directory` has room for `needed` bytes."""
    free = shutil.disk_usage(directory).free
    if free < needed:
        raise PreflightError(
            f'no room: {directory} has {free / 1e9:.1f} GB free, the course needs {needed / 1e9:.1f} GB',
            f'free some space (see: df -h {directory}), or move the course to a larger disk',
        )


def check_path(root: Path, underlay: Underlay, encoding: str | None = None) -> None:
    """Raise PreflightError unless the tools of ROS can work in a folder with this path.

    They hand paths to shells without quotes (ament_cmake_python) and to linkers between commas (CMake), and write them
    into the first lines of scripts, which the kernel ends at a space.

    `encoding` is that of the terminal's locale.
    """
    encoding = encoding or locale.nl_langinfo(locale.CODESET)
    if not os.fsencode(root).isascii() and encoding != 'UTF-8':
        raise PreflightError(
            f'the path of this folder has letters that this terminal does not know: its locale is {encoding}',
            'run: export LC_ALL=C.UTF-8, then ./course again',
        )
    bad = next((char for char in str(root) if not _usual(char, underlay.stock)), None)
    if bad is not None:
        name = 'a space' if bad == ' ' else repr(bad)
        path = os.fsencode(root).decode(errors='backslashreplace')
        raise PreflightError(
            f'the path of this folder has {name}, and the tools of ROS cannot work with that: {path}',
            'move or rename the folder (letters, digits and - _ . + are fine), then run ./course again',
        )


def _usual(char: str, stock: bool) -> bool:
    """A stock rosidl_adapter reads the paths of interfaces as ASCII; `backports` mends that of the wheels."""
    if char.isascii():
        return char.isalnum() or char in '/._-+@~'
    return char.isprintable() and not char.isspace() and not stock


def check_writable(root: Path) -> None:
    """Raise PreflightError unless the checkout can be written to."""
    if not os.access(root, os.W_OK) or not os.access(root / 'environment', os.W_OK):
        raise PreflightError(f'{root} is not writable for you', f'run: sudo chown -R $(id -un) {root}')


def check_file_system(root: Path) -> None:
    """Raise PreflightError unless a virtual environment and built packages can be in this folder.

    They need links and programs. FAT and exFAT have no links, nor have most folders that a virtual machine shares with
    its host; disks are sometimes mounted without the right to start programs.
    """
    remedy = 'copy the course to a folder in your home on this machine, then run ./course there'
    if os.statvfs(root).f_flag & os.ST_NOEXEC:
        raise PreflightError(f'the disk of {root} is mounted so that no program on it can be started (noexec)', remedy)
    with tempfile.TemporaryDirectory(dir=root, prefix='.probe-') as folder:
        try:
            os.symlink('nothing', Path(folder, 'link'))
        except OSError as error:
            reason = error.strerror.lower()
            raise PreflightError(f'the disk of {root} does not take symbolic links ({reason})', remedy) from None


def check(root: Path, environ: Mapping[str, str], underlay: Underlay, needed: int = SPACE_NEEDED) -> None:
    """All of them, the cheap ones first."""
    if not underlay.stock:
        check_platform()
    check_path(root, underlay)
    check_writable(root)
    check_file_system(root)
    check_space(root, needed)
    check_compiler(environ)
