"""The course's own ROS packages: which there are, which are stale, what to remove before a rebuild."""

import os
import shutil
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path
from xml.etree import ElementTree

from environment.setup.stamps import digest, digest_tree


@dataclass(frozen=True)
class Package:
    name: str
    directory: Path
    needs: frozenset[str]

    @property
    def stamp(self) -> str:
        return f'package.{self.name}'


def discover(sources: Path) -> dict[str, Package]:
    """The ROS packages below `sources`, by name. Raises ValueError when two share a name."""
    found: dict[str, Package] = {}
    for parent, directories, files in os.walk(sources):
        if 'COLCON_IGNORE' in files:
            directories.clear()
        elif 'package.xml' in files:
            directories.clear()
            root = ElementTree.parse(Path(parent, 'package.xml')).getroot()
            needs = frozenset(e.text.strip() for e in root if e.tag.endswith('depend') and e.text)
            package = Package(root.findtext('name', '').strip(), Path(parent), needs)
            if package.name in found:
                raise ValueError(f'two packages are named {package.name}: {found[package.name].directory}, {parent}')
            found[package.name] = package
    return dict(sorted(found.items()))


def keys(packages: dict[str, Package], foundation: str) -> dict[str, str]:
    """A digest for each package: of its files, of what it stands on, and of the keys of the packages it needs."""
    done: dict[str, str] = {}

    def key(name: str, path: tuple[str, ...]) -> str:
        if name in path:
            raise ValueError('packages need each other in a circle: ' + ' -> '.join([*path, name]))
        if name not in done:
            package = packages[name]
            below = [key(n, (*path, name)) for n in sorted(package.needs & packages.keys())]
            done[name] = digest(foundation, digest_tree(package.directory), *below)
        return done[name]

    return {name: key(name, ()) for name in packages}


def uninstall(name: str, build: Path, prefix: Path) -> None:
    """Remove what the last build of a package installed, so that a file it no longer has does not stay behind."""
    manifests = (build / name / 'install_manifest.txt', build / name / 'install.log')
    listed = [line for m in manifests if m.is_file() for line in m.read_text().splitlines() if line.strip()]
    ours = [path for path in map(Path, listed) if path.is_absolute() and prefix in path.parents]
    directories = {parent for path in ours for parent in path.parents}
    for path in ours:
        if path.is_dir() and not path.is_symlink():  # setup.py lists a directory where it had no file for it
            directories.add(path)
        else:
            path.unlink(missing_ok=True)
    for directory in sorted(directories, key=lambda d: -len(d.parts)):
        if prefix in directory.parents and directory.is_dir() and not any(directory.iterdir()):
            directory.rmdir()


def forget(name: str, build: Path, prefix: Path) -> None:
    """Remove a package whose sources are gone."""
    uninstall(name, build, prefix)
    shutil.rmtree(build / name, ignore_errors=True)
    shutil.rmtree(prefix / 'share' / name, ignore_errors=True)
    (prefix / 'share' / 'colcon-core' / 'packages' / name).unlink(missing_ok=True)


def succeeded(name: str, build: Path) -> bool:
    """Whether colcon's last build of the package ended well."""
    try:
        return (build / name / 'colcon_build.rc').read_text().strip() == '0'
    except FileNotFoundError:
        return False


def colcon(layout, selected: Iterable[str], workers: int | None = None) -> list[str]:
    """The command that builds the selected packages into the environment."""
    return [
        str(layout.prefix / "bin" / "colcon"),
        "--log-base", str(layout.logs / "colcon"),
        "build",
        "--merge-install",
        "--base-paths", str(layout.sources),
        "--build-base", str(layout.build),
        "--install-base", str(layout.prefix),
        "--packages-select", *selected,
        "--event-handlers", "console_cohesion+", "console_start_end+", "status-", "desktop_notification-",
        *(["--parallel-workers", str(workers)] if workers else []),
        "--cmake-args", "-G", "Ninja", "-DBUILD_TESTING=OFF", f"-DPython3_EXECUTABLE={layout.python}",
        f"-DCMAKE_PROJECT_INCLUDE={layout.cmake_include}",
        "--no-warn-unused-cli",
    ]  # fmt: skip
