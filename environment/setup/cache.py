"""Built ROS packages that a second copy of the course on this machine takes over, in the user's cache folder.

Each entry is one file, named by the digest of all that the package was made from. It holds what the package installed,
with a marker where the prefix was named. An entry is used only if it and every folder above it are this user's (or the
system's) and nobody else may write to them, and if its content has the digest that it begins with. A group that has
only this user in it, as Debian and Ubuntu give one to each user, is nobody else.
"""

import grp
import hashlib
import io
import os
import pwd
import re
import stat
import tarfile
from collections.abc import Iterable, Mapping
from contextlib import suppress
from pathlib import Path, PurePosixPath

from environment.setup import whole_file
from environment.setup.relocation import replace

LIMIT = 200_000_000  # bytes; a whole set of packages has about 6 MB
_MARKER = b'@@COURSE_PREFIX@@'
_SUFFIX = '.packed'
# Where a path has other characters, or is long, scripts are written in another form: such a copy builds for itself.
_PLAIN = re.compile(r'/[\w./+-]{1,100}')


def folder(environ: Mapping[str, str]) -> Path:
    """Where the entries are, by the XDG base directory specification."""
    base = environ.get('XDG_CACHE_HOME', '')
    home = Path(environ.get('HOME') or os.path.expanduser('~'))
    return (Path(base) if os.path.isabs(base) else home / '.cache') / 'ros2-course'


class Cache:
    """The entries of one folder, for one prefix. Whatever goes wrong with it costs time only: the package is built."""

    def __init__(self, directory: Path, prefix: Path):
        self.directory = directory
        self.prefix = prefix

    def problem(self) -> str:
        """Why the cache is not used; '' if it is. Makes nothing: a folder that is not there will be made by `store`."""
        if not _PLAIN.fullmatch(str(self.prefix)):
            return f'the path {self.prefix} is long, or has a space or another unusual character'
        try:
            there = next(path for path in (self.directory, *self.directory.parents) if path.exists())
            if not (there.is_dir() and os.access(there, os.W_OK | os.X_OK)):
                return f'{there}: not a folder that you may write to'
            opened = _open_to_others(there)
        except OSError as error:
            return f'{self.directory}: {(error.strerror or "not usable").lower()}'
        return f'others may write to {opened}' if opened else ''

    def size(self) -> tuple[int, int]:
        """(number of entries, bytes)."""
        sizes = [path.stat().st_size for path in self._entries()]
        return len(sizes), sum(sizes)

    def fetch(self, key: str) -> list[str] | None:
        """Put the files of an entry into the prefix; returns their paths, relative to it. None if there is no entry."""
        data = self._read(key)
        if data is None:
            return None
        restored = []
        with tarfile.open(fileobj=io.BytesIO(data)) as archive:
            members = archive.getmembers()
            if not all(_harmless(member) for member in members):
                return None
            for member in members:
                self._restore(archive, member)
                restored.append(member.name)
        return restored

    def _restore(self, archive: tarfile.TarFile, member: tarfile.TarInfo) -> None:
        path = self.prefix / member.name
        path.parent.mkdir(parents=True, exist_ok=True)
        if member.issym():
            path.unlink(missing_ok=True)
            path.symlink_to(member.linkname)
            return
        content = archive.extractfile(member).read().replace(_MARKER, os.fsencode(self.prefix))
        path.touch()
        path.chmod(member.mode)
        replace(path, content)

    def store(self, key: str, paths: Iterable[str]) -> bool:
        """Keep the files at `paths`, relative to the prefix; whether that was done. Compiled Python is left out."""
        try:
            data = self._pack([path for path in paths if not path.endswith('.pyc')])
            if data is None:
                return False
            self.directory.mkdir(mode=0o700, parents=True, exist_ok=True)
            whole_file.write(
                self.directory / f'{key}{_SUFFIX}', hashlib.sha256(data).hexdigest().encode() + data, rights=0o600
            )
        except OSError:  # a full disk, say
            return False
        return True

    def _pack(self, paths: list[str]) -> bytes | None:
        """The entry's bytes; None if a file that is no text names the prefix, as it would be wrong elsewhere."""
        here = os.fsencode(self.prefix)
        buffer = io.BytesIO()
        with tarfile.open(fileobj=buffer, mode='w') as archive:
            for name in sorted(paths):
                path = self.prefix / name
                member = archive.gettarinfo(str(path), name)
                member.uid = member.gid = member.mtime = 0
                member.uname = member.gname = ''
                if member.issym():
                    archive.addfile(member)
                    continue
                content = path.read_bytes()
                if here in content and b'\0' in content or _MARKER in content:
                    return None
                content = content.replace(here, _MARKER)
                member.type, member.size = tarfile.REGTYPE, len(content)
                archive.addfile(member, io.BytesIO(content))
        return buffer.getvalue()

    def _read(self, key: str) -> bytes | None:
        """The content of an entry that is whole and nobody else's; its time is set to now, as it was used."""
        try:
            descriptor = os.open(self.directory / f'{key}{_SUFFIX}', os.O_RDONLY | os.O_NOFOLLOW)
        except OSError:
            return None
        with open(descriptor, 'rb') as file:
            facts = os.fstat(descriptor)
            if not stat.S_ISREG(facts.st_mode) or facts.st_uid != os.geteuid() or facts.st_mode & 0o022:
                return None
            whole = file.read()
            with suppress(OSError):
                os.utime(descriptor)
        digest, data = whole[:64], whole[64:]
        return data if hashlib.sha256(data).hexdigest().encode() == digest else None

    def prune(self, limit: int = LIMIT) -> None:
        """Remove what was not used for the longest time, until the rest is within the limit."""
        total = 0
        for path in self._entries():
            with suppress(FileNotFoundError):  # another set-up may be pruning, too
                total += path.stat().st_size
                if total > limit:
                    path.unlink()

    def _entries(self) -> list[Path]:
        """The entries and what interrupted set-ups left, the last used first."""
        found = []
        with suppress(OSError):
            for path in self.directory.iterdir():
                with suppress(FileNotFoundError):
                    found.append((-path.lstat().st_mtime, path))
        return [path for _, path in sorted(found)]


def _harmless(member: tarfile.TarInfo) -> bool:
    """Whether a member is a file, or a link, that lies below the prefix."""
    path = PurePosixPath(member.name)
    return (member.isreg() or member.issym()) and not path.is_absolute() and '..' not in path.parts


def _open_to_others(directory: Path) -> Path | None:
    """The folder on the way to `directory`, itself included, in which another user could exchange something."""
    directory = Path(os.path.realpath(directory))
    for step in (directory, *directory.parents):
        facts = step.stat()
        if facts.st_uid not in (os.geteuid(), 0):
            return step
        sticky = step != directory and facts.st_mode & stat.S_ISVTX  # there only its owner can exchange a folder
        if _others_may_write(facts) and not sticky:
            return step
    return None


def _others_may_write(facts: os.stat_result) -> bool:
    by_group = facts.st_mode & stat.S_IWGRP and not _is_own_group(facts.st_gid)
    return bool(facts.st_mode & stat.S_IWOTH or by_group)


def _is_own_group(gid: int) -> bool:
    """Whether a group has only this user in it: it is the user's first one, has the same name and no other member."""
    try:
        user, group = pwd.getpwuid(os.geteuid()), grp.getgrgid(gid)
    except KeyError:  # a user or a group without a name
        return False
    return user.pw_gid == gid and group.gr_name == user.pw_name and set(group.gr_mem) <= {user.pw_name}
