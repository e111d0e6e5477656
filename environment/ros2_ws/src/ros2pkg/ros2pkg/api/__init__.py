"""Installed packages and their executables, from the ament index."""

import os
from pathlib import Path
from typing import Any


class PackageNotFound(Exception):
    """No package of that name is installed."""

    def __init__(self, package_name: str) -> None:
        """Keep the name."""
        super().__init__(package_name)
        self.package_name = package_name


def get_package_names() -> list[str]:
    """Return the names of all packages."""
    from ament_index_python import get_packages_with_prefixes

    return sorted(get_packages_with_prefixes())


def get_prefix_path(package_name: str) -> str | None:
    """Return where a package is installed, or None."""
    from ament_index_python import PackageNotFoundError, get_package_prefix

    try:
        return get_package_prefix(package_name)
    except (PackageNotFoundError, ValueError):
        return None


def get_executable_paths(*, package_name: str) -> list[str]:
    """
    Return the executables of a package: what may be executed below `lib/<package>`.

    :raises PackageNotFound: if it is not installed.
    """
    prefix = get_prefix_path(package_name)
    if prefix is None:
        raise PackageNotFound(package_name)
    found = []
    for folder, folders, files in os.walk(Path(prefix, 'lib', package_name)):
        folders[:] = sorted(name for name in folders if not name.startswith('.'))
        found.extend(os.path.join(folder, name) for name in sorted(files))
    return [path for path in found if os.access(path, os.X_OK)]


def package_name_completer(**_: Any) -> list[str]:
    """Return the names of all packages."""
    return get_package_names()
