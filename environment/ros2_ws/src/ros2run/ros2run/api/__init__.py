"""Find an executable of a package and run it."""

from argparse import Namespace
import os
import signal
import subprocess
from typing import Any, List, Optional

from ros2pkg.api import PackageNotFound, get_executable_paths

ROS2RUN_MSG_PREFIX = '[ros2run]:'


class MultipleExecutables(Exception):
    """A package has several executables of a name, in different folders."""

    def __init__(self, paths: List[str]) -> None:
        """Keep the paths."""
        super().__init__(', '.join(paths))
        self.paths = paths


def get_executable_path(*, package_name: str, executable_name: str) -> Optional[str]:
    """
    Return the path of an executable, or None if the package has none of that name.

    :raises PackageNotFound: if the package is not installed.
    :raises MultipleExecutables: if the package has several.
    """
    paths = [
        path for path in get_executable_paths(package_name=package_name)
        if os.path.basename(path) == executable_name]
    if len(paths) > 1:
        raise MultipleExecutables(paths)
    return paths[0] if paths else None


def run_executable(*, path: str, argv: List[str], prefix: Optional[List[str]] = None) -> int:
    """
    Run an executable to its end and return its exit status.

    Ctrl+C reaches it from the terminal, and it decides what to do; SIGTERM to this process is passed on to it.
    """
    process = subprocess.Popen([*(prefix or []), path, *argv])
    old_handler = signal.signal(signal.SIGTERM, lambda signum, _: process.send_signal(signum))
    try:
        while process.returncode is None:
            try:
                process.wait()
            except KeyboardInterrupt:
                pass
    finally:
        signal.signal(signal.SIGTERM, old_handler)
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

    def __call__(self, prefix: str, parsed_args: Namespace, **_: Any) -> List[str]:
        """Return the names."""
        try:
            paths = get_executable_paths(package_name=getattr(parsed_args, self.package_name_key))
        except PackageNotFound:
            return []
        return [os.path.basename(path) for path in paths]
