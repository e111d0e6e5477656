"""The course's own ROS packages: which there are, which are stale, how they are built."""

import os
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path
from xml.etree import ElementTree

from environment.setup.stamps import digest, digest_tree

# Folders of a package of which nothing is installed: a change in them is no reason to build it anew.
NOT_INSTALLED = frozenset({'test'})


@dataclass(frozen=True)
class SourcePackage:
    name: str
    directory: Path
    needs: frozenset[str]

    @property
    def stamp(self) -> str:
        return f'package.{self.name}'


def discover(sources: Path) -> dict[str, SourcePackage]:
    """The ROS packages below `sources`, by name. Raises ValueError when two share a name."""
    found: dict[str, SourcePackage] = {}
    for parent, directories, files in os.walk(sources):
        if 'COLCON_IGNORE' in files:
            directories.clear()
        elif 'package.xml' in files:
            directories.clear()
            root = ElementTree.parse(Path(parent, 'package.xml')).getroot()
            needs = frozenset(e.text.strip() for e in root if e.tag.endswith('depend') and e.text)
            package = SourcePackage(root.findtext('name', '').strip(), Path(parent), needs)
            if package.name in found:
                raise ValueError(f'two packages are named {package.name}: {found[package.name].directory}, {parent}')
            found[package.name] = package
    return dict(sorted(found.items()))


def keys(packages: dict[str, SourcePackage], foundation: str) -> dict[str, str]:
    """A digest for each package: of its files, of what it stands on, and of the keys of the packages it needs."""
    done: dict[str, str] = {}

    def key(name: str, path: tuple[str, ...]) -> str:
        if name in path:
            raise ValueError('packages need each other in a circle: ' + ' -> '.join([*path, name]))
        if name not in done:
            package = packages[name]
            below = [key(n, (*path, name)) for n in sorted(package.needs & packages.keys())]
            done[name] = digest(foundation, digest_tree(package.directory, NOT_INSTALLED), *below)
        return done[name]

    return {name: key(name, ()) for name in packages}


def succeeded(name: str, build: Path) -> bool:
    """Whether colcon's last build of the package ended well."""
    try:
        return (build / name / 'colcon_build.rc').read_text().strip() == '0'
    except FileNotFoundError:
        return False


# Not `python -m`, for the reason given in `main`.
_BUILDER = (
    'import sys; sys.path[0] = sys.argv.pop(1); from environment.builder.__main__ import main; '
    'sys.exit(main(sys.argv[1:]))'
)


def colcon(layout, selected: Iterable[str], workers: int | None = None) -> list[str]:
    """The command that builds the selected packages into the environment."""
    return [
        str(layout.python), "-c", _BUILDER, str(layout.root),
        "--log-base", str(layout.logs / "colcon"),
        "build",
        "--merge-install",
        "--base-paths", str(layout.sources),
        "--build-base", str(layout.build),
        "--install-base", str(layout.prefix),
        "--packages-select", *selected,
        "--event-handlers", "console_cohesion+", "console_start_end+", "status-", "desktop_notification-",
        # One more than processors: a package that is only copied should not wait for two that are compiled.
        "--parallel-workers", str(workers or len(os.sched_getaffinity(0)) + 1),
        "--cmake-args", "-G", "Ninja", "-DBUILD_TESTING=OFF", f"-DPython3_EXECUTABLE={layout.python}",
        f"-DCMAKE_PROJECT_INCLUDE={layout.cmake_include}",
        "--no-warn-unused-cli",
    ]  # fmt: skip
