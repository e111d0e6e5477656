"""Find and load plug-ins: entry points of installed Python packages."""

import sys
from functools import cache
from importlib import metadata
from typing import Any

# The group of entry points that name groups: a package whose plug-ins other packages extend is in it.
EXTENSION_POINT_GROUP_NAME = 'ros2cli.extension_point'


@cache
def _all_entry_points() -> metadata.EntryPoints:
    """Those of every installed package, read once: that is hundreds of files, and one command asks for two groups."""
    return metadata.entry_points()


def get_entry_points(group_name: str) -> dict[str, metadata.EntryPoint]:
    """Return the entry points of a group by name; of two with one name the first on sys.path wins."""
    found: dict[str, metadata.EntryPoint] = {}
    for entry_point in _all_entry_points().select(group=group_name):
        found.setdefault(entry_point.name, entry_point)
    return found


def get_all_entry_points() -> dict[str, dict[str, tuple[metadata.Distribution, metadata.EntryPoint]]]:
    """Return (distribution, entry point) by group and name, for each group that is an extension point."""
    found: dict[str, dict[str, tuple[metadata.Distribution, metadata.EntryPoint]]] = {}
    for group in get_entry_points(EXTENSION_POINT_GROUP_NAME):
        for name, entry_point in get_entry_points(group).items():
            # Those of an installed distribution always know it.
            found.setdefault(group, {})[name] = (entry_point.dist, entry_point)  # type: ignore[assignment]
    return found


def load_entry_point(entry_point: metadata.EntryPoint) -> Any | None:
    """Return an instance of the plug-in with its NAME set, or None after saying on stderr why it cannot be had."""
    try:
        extension = entry_point.load()()
    except Exception as e:  # one broken plug-in must not take the others down
        print(f"Failed to load entry point '{entry_point.name}': {e}", file=sys.stderr)
        return None
    extension.NAME = entry_point.name
    return extension


def get_first_line_doc(extension: Any) -> str:
    """Return the first line of a plug-in's docstring without the full stop."""
    doc = (extension.__doc__ or '').strip()
    return doc.splitlines()[0].rstrip('.') if doc else ''
