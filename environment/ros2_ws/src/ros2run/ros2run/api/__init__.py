"""Find an executable of a package and run it."""

import os
import signal
import subprocess
from argparse import Namespace
from typing import Any

from ros2pkg.api import PackageNotFound, get_executable_paths

ROS2RUN_MSG_PREFIX = '[ros2run]:'


class MultipleExecutables(Exception):
    """A package has several executables of a name, in different folders."""

    def __init__(self, paths: list[str]) -> None:
        """Keep the paths."""
        super().__init__(', '.join(paths))
        self.paths = paths


def get_executable_path(*, package_name: str, executable_name: str) -> str | None:
    """
    Return the path of an executable, or None if the package has none of that name.

    :raises PackageNotFound: if the package is not installed.
    :raises MultipleExecutables: if the package has several.
    """
    paths = [
        path for path in get_executable_paths(package_name=package_name) if os.path.basename(path) == executable_name
    ]
    if len(paths) > 1:
        raise MultipleExecutables(paths)
    return paths[0] if paths else None


def run_executable(*, path: str, argv: list[str], prefix: list[str] | None = None) -> int:
    """
    Run an executable to its end and return its exit status.

    Ctrl+C reaches it from the terminal, and it decides what to do; SIGTERM to this process is passed on to it.
    """
    process = None

    def pass_on(signum: int, _: Any) -> None:
        if process is not None:
            process.send_signal(signum)

    # Before the program starts, so that no signal finds it running and this process not prepared. A handler that does
    # nothing, unlike SIG_IGN, is not inherited.
    old_interrupt = signal.signal(signal.SIGINT, lambda *_: None)
    old_end = signal.signal(signal.SIGTERM, pass_on)
    try:
        process = subprocess.Popen([*(prefix or []), path, *argv])
        process.wait()
    finally:
        signal.signal(signal.SIGINT, old_interrupt)
        signal.signal(signal.SIGTERM, old_end)
    if -process.returncode in signal.valid_signals():
        print(ROS2RUN_MSG_PREFIX, signal.strsignal(-process.returncode))
    elif process.returncode:
        print(ROS2RUN_MSG_PREFIX, f'Process exited with failure {process.returncode}')
    return process.returncode


class ExecutableNameCompleter:
    """Completes the executables of the package that the command line names."""

    def __init__(self, *, package_name_key: str) -> None:
        """Remember which argument names the package."""
        self.package_name_key = package_name_key

    def __call__(self, prefix: str, parsed_args: Namespace, **_: Any) -> list[str]:
        """Return the names."""
        try:
            paths = get_executable_paths(package_name=getattr(parsed_args, self.package_name_key))
        except PackageNotFound:
            return []
        return [os.path.basename(path) for path in paths]
