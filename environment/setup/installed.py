"""What each of the course's own ROS packages has installed into the prefix: all that its removal needs to know."""

import os
from collections.abc import Iterable
from pathlib import Path

_LISTS = ('install_manifest.txt', 'install.log')  # CMake's and setuptools'


class Installed:
    """A list of paths, relative to the prefix, for each package."""

    def __init__(self, directory: Path, prefix: Path):
        self.directory = directory
        self.prefix = prefix

    def read(self, name: str) -> list[str]:
        """The files of a package; empty if none are known."""
        try:
            return (self.directory / name).read_text().splitlines()
        except FileNotFoundError:
            return []

    def write(self, name: str, paths: Iterable[str]) -> None:
        self.directory.mkdir(parents=True, exist_ok=True)
        (self.directory / name).write_text(''.join(f'{path}\n' for path in sorted(set(paths))))

    def of_build(self, name: str, build: Path) -> list[str]:
        """The files that the build of a package in the folder `build` installed, by its own lists, and colcon's."""
        listed = [
            line
            for file in (build / part for part in _LISTS)
            if file.is_file()
            for line in file.read_text().splitlines()
            if line.strip()
        ]
        paths = [Path(line) for line in listed]
        share = self.prefix / 'share' / name
        paths += [*share.glob('package.*'), *share.glob('hook/*'), self.prefix / 'share/colcon-core/packages' / name]
        found: set[str] = set()
        for path in paths:
            if path.is_dir() and not path.is_symlink():  # setup.py lists some of its folders
                found.update(self._files_below(path))
            elif path.is_absolute() and self.prefix in path.parents and os.path.lexists(path):
                found.add(str(path.relative_to(self.prefix)))
        return sorted(found)

    def _files_below(self, folder: Path) -> list[str]:
        if folder.suffix not in ('.egg-info', '.dist-info') or self.prefix not in folder.parents:
            return []
        return [str(path.relative_to(self.prefix)) for path in folder.rglob('*') if path.is_file()]

    def uninstall(self, name: str) -> None:
        """Remove the files of a package, and the folders that are empty then."""
        folders = set()
        for path in (self.prefix / line for line in self.read(name)):
            if path.is_dir() and not path.is_symlink():
                continue
            path.unlink(missing_ok=True)
            if path.suffix == '.py':
                for compiled in (path.parent / '__pycache__').glob(f'{path.stem}.*.pyc'):
                    compiled.unlink(missing_ok=True)
                folders.add(path.parent / '__pycache__')
            folders.update(path.parents)
        for folder in sorted(folders, key=lambda folder: -len(folder.parts)):
            if self.prefix in folder.parents and folder.is_dir() and not any(folder.iterdir()):
                folder.rmdir()
        (self.directory / name).unlink(missing_ok=True)

    def names(self) -> list[str]:
        """The packages that are known to be installed."""
        return sorted(path.name for path in self.directory.iterdir()) if self.directory.is_dir() else []
