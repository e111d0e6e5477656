"""root's part: what makes sandboxes runs as an ordinary user, also when root grades.

A sandbox that root makes is none: its files under /proc/sys stay writable for what root's number owns. So root starts
this module, which gets itself a mount namespace of its own, makes the needed trees readable there if they lie in a
private folder such as /root, becomes an ordinary user for good, and then runs the command.

    python -m grading.sandbox.unprivileged TREE… -- COMMAND…
"""

import os
import pwd
import stat
import sys
from collections.abc import Iterable
from pathlib import Path

from grading.sandbox import namespaces

ACCOUNTS = ('course-grader', 'nobody')  # the first that exists


def command(words: list[str], trees: Iterable[Path]) -> list[str]:
    """The command that runs `words` as an ordinary user who can read `trees`."""
    if os.geteuid() != 0:
        return words
    return [sys.executable, '-m', 'grading.sandbox.unprivileged', *map(str, trees), '--', *words]


def closed_above(path: Path) -> Path | None:
    """The topmost folder above `path` that others cannot enter."""
    for folder in reversed(path.parents):
        if not folder.stat().st_mode & stat.S_IXOTH:
            return folder
    return None


def open_up(trees: list[Path]) -> None:
    """Make trees reachable for everyone: in place of each closed folder comes an empty one that holds only them."""
    hidden: dict[Path, list[Path]] = {}
    parts = [part for tree in dict.fromkeys(trees) for part in _open_parts(tree)]
    for tree in parts:
        if closed := closed_above(tree):
            hidden.setdefault(closed, []).append(tree)
    if not hidden:
        return
    namespaces.unshare(namespaces.NEWNS)
    namespaces.mount(None, '/', None, namespaces.MS_REC | namespaces.MS_PRIVATE)
    for folder, wanted in hidden.items():
        held = [(tree, os.open(tree, os.O_PATH)) for tree in sorted(wanted)]  # the folder's mount will cover them
        namespaces.mount('tmpfs', str(folder), 'tmpfs', namespaces.MS_NOSUID | namespaces.MS_NODEV, 'mode=0755,size=1m')
        for tree, descriptor in held:
            tree.mkdir(parents=True, exist_ok=True)
            namespaces.mount(f'/proc/self/fd/{descriptor}', str(tree), None, namespaces.MS_BIND | namespaces.MS_REC)
            os.close(descriptor)


def _open_parts(tree: Path) -> list[Path]:
    """The tree, or the folders in it if it is itself closed, as a folder made by mktemp is."""
    readable = stat.S_IROTH | stat.S_IXOTH
    if tree.stat().st_mode & readable == readable:
        return [tree]
    return [entry for entry in tree.iterdir() if entry.is_dir()]


def account() -> pwd.struct_passwd:
    """The user to become. Raises SystemExit if there is none."""
    for name in ACCOUNTS:
        try:
            return pwd.getpwnam(name)
        except KeyError:
            pass
    raise SystemExit(f'no user to grade as: run: useradd --system {ACCOUNTS[0]}')


def main() -> None:
    divide = sys.argv.index('--')
    user = account()
    open_up([Path(tree) for tree in sys.argv[1:divide]])
    os.setgroups([])
    os.setresgid(user.pw_gid, user.pw_gid, user.pw_gid)
    os.setresuid(user.pw_uid, user.pw_uid, user.pw_uid)
    words = sys.argv[divide + 1 :]
    os.execv(words[0], words)


if __name__ == '__main__':
    main()
