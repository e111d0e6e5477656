"""What has been done already: one small file for each finished step.

A stamp holds the digest of everything that went into the step. A step is fresh when its stamp equals the digest of
today's inputs. A stamp is removed before its step starts and is written, atomically, after it ended: an interruption
at any moment leaves a missing stamp, never a wrong one.
"""

import hashlib
import os
from collections.abc import Iterable
from pathlib import Path

from environment.setup import whole_file


def digest(*parts: str | bytes) -> str:
    """Digest of a sequence of texts; where one ends and the next begins counts."""
    total = hashlib.sha256()
    for part in parts:
        data = part.encode() if isinstance(part, str) else part
        total.update(b'%d:' % len(data))
        total.update(data)
    return total.hexdigest()


IGNORED = {'__pycache__', '.pytest_cache', '.ruff_cache', '.git', 'build', 'install', 'log'}


def source_files(directory: Path, without: frozenset[str] = frozenset()) -> Iterable[Path]:
    """The files below `directory` that count, in a fixed order; `without`: folders directly in it that do not."""
    for parent, directories, files in os.walk(directory):
        directories[:] = sorted(set(directories) - IGNORED - (without if Path(parent) == directory else set()))
        for name in sorted(files):
            if not name.endswith(('.pyc', '~', '.swp')):
                yield Path(parent, name)


def digest_tree(directory: Path, without: frozenset[str] = frozenset()) -> str:
    """Digest of the names, contents and execute bits of the source files below `directory`."""
    parts: list[str | bytes] = []
    for path in source_files(directory, without):
        parts += [str(path.relative_to(directory)), str(os.access(path, os.X_OK)), path.read_bytes()]
    return digest(*parts)


class Stamps:
    """The stamps kept in one directory."""

    def __init__(self, directory: Path):
        self.directory = directory

    def read(self, name: str) -> str:
        """The stamp's text, or '' if there is none."""
        try:
            return (self.directory / name).read_text()
        except (FileNotFoundError, NotADirectoryError):
            return ''

    def write(self, name: str, text: str) -> None:
        self.directory.mkdir(parents=True, exist_ok=True)
        whole_file.write(self.directory / name, text)

    def remove(self, name: str) -> None:
        (self.directory / name).unlink(missing_ok=True)

    def names(self, prefix: str = '') -> list[str]:
        if not self.directory.is_dir():
            return []
        return sorted(p.name for p in self.directory.iterdir() if p.is_file() and p.name.startswith(prefix))
