"""What in a workspace the lesson has made, and what the learner: a reset keeps what is the learner's."""

import hashlib
import json
import os
import shutil
import stat
from collections.abc import Iterable
from pathlib import Path

from helpers.programs import terminals

_LEDGER = '.made_by_the_lesson.json'  # in a workspace: path below it -> digest
_BY_TOOLS = {'build', 'install', 'log'}  # at the top of a workspace or of its src, and within a package
_NO_WORK = {'__pycache__', '.pytest_cache', '.ipynb_checkpoints'}
_SRC = 'src'
_LARGE = 2**20  # bytes; a recording may have many more, and no lesson writes so much


class Belongings:
    """Tells the two apart by the text of files: one that is not as the lesson left it is the learner's."""

    def __init__(self, workspace: Path):
        self._top, self._ledger = workspace, workspace / _LEDGER

    def note(self, before: dict[str, str], texts: Iterable[str] = ()) -> None:
        """Count as the lesson's what is other than `before`, which `now` gave before the lesson did something.

        :param texts: of the lesson; files that hold one of them are the lesson's, too.
        """
        made, known = self._made(), {_digest(text.encode()) for text in texts}
        made |= {path: digest for path, digest in self.now().items() if before.get(path) != digest or digest in known}
        self._ledger.write_text(json.dumps(made))

    def now(self) -> dict[str, str]:
        """The files of the workspace with their digests, without what tools leave behind."""
        found = {}
        for parent, folders, names in os.walk(self._top):
            place = Path(parent).relative_to(self._top)
            folders[:] = sorted(name for name in folders if not self._of_tools(place, name))
            links = [name for name in folders if (self._top / place / name).is_symlink()]
            for name in sorted([*names, *links]):
                path = place / name
                if path.parts not in ((_LEDGER,), (terminals.DEFAULTS,)) and (seen := _seen(self._top / path)):
                    found[str(path)] = seen
        return found

    def keep(self) -> Path | None:
        """Move what is the learner's into a new folder beside the workspace; its path, None if there is nothing.

        Of `src` that are the packages in which something is the learner's, of the rest the files and folders.
        """
        made = self._made()
        theirs = {_unit(Path(path)) for path, digest in self.now().items() if made.get(path) != digest}
        if not theirs:
            return None
        kept = self._new_shelf()
        for unit in sorted(theirs):
            target = kept / unit.name
            shutil.move(self._top / unit, target if not target.exists() else kept / f'{unit.name}_beside_src')
        return kept

    def keep_files(self, new: dict[str, bytes], texts: Iterable[str] = ()) -> Path | None:
        """Copy into such a folder those files which are the learner's and are about to get another content.

        :param new: what is about to be written, path below the workspace -> content.
        :param texts: of the lesson, as for `note`.
        """
        made, known = self._made(), {_digest(text.encode()) for text in texts}
        theirs = []
        for path, content in new.items():
            seen = _seen(self._top / path)
            if seen and seen not in known | {made.get(path), _digest(content)}:
                theirs.append(path)
        if not theirs:
            return None
        kept = self._new_shelf()
        for path in theirs:
            target = kept / Path(path).relative_to(_SRC if Path(path).parts[0] == _SRC else '')
            target.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(self._top / path, target, follow_symlinks=False)
        return kept

    def hand_over(self, path: str, text: str, texts: Iterable[str] = ()) -> Path | None:
        """Before a cell writes a file: a copy of what the learner had made of it in an editor; None if nothing.

        What the cell writes counts as the lesson's: the cell can write it again.
        """
        kept = self.keep_files({path: text.encode()}, texts)
        self._ledger.write_text(json.dumps(self._made() | {path: _digest(text.encode())}))
        return kept

    @staticmethod
    def _of_tools(place: Path, name: str) -> bool:
        """Whether a folder holds nobody's work. A package may have a folder `log` deeper down."""
        return name in _NO_WORK or name in _BY_TOOLS and len(place.parts) < 3

    def _new_shelf(self) -> Path:
        shelf = self._top.with_name(f'{self._top.name}_kept')
        shelf.mkdir(exist_ok=True)
        number = 1 + max((int(path.name) for path in shelf.iterdir() if path.name.isdecimal()), default=0)
        (shelf / str(number)).mkdir()
        return shelf / str(number)

    def _made(self) -> dict[str, str]:
        try:
            return json.loads(self._ledger.read_text())
        except (OSError, ValueError):  # none yet
            return {}


def _unit(path: Path) -> Path:
    """What is moved as one: a package, or a file or folder beside `src`."""
    return Path(*path.parts[: 2 if path.parts[0] == _SRC else 1])


def _seen(path: Path) -> str:
    """What tells a file from another one: its digest, or where a link leads to; '' if there is no file."""
    try:
        if path.is_symlink():
            return f'-> {os.readlink(path)}'
        state = path.stat()
        if not stat.S_ISREG(state.st_mode):
            return ''
        if state.st_size > _LARGE:
            return f'{state.st_size} bytes of {state.st_mtime_ns}'
        return _digest(path.read_bytes())
    except OSError:  # it has just gone
        return ''


def _digest(content: bytes) -> str:
    """Empty lines at the ends of a file are nobody's work."""
    return hashlib.sha256(content.strip()).hexdigest()


def hand_over(file: Path, text: str, texts: Iterable[str] = ()) -> str:
    """Before a cell writes a file of a workspace: keep what the learner had made of it; where that is now, in words.

    :param file: a path from the notebook's folder on; elsewhere than in a workspace nothing is kept.
    """
    top = Path(file.parts[0] if len(file.parts) > 1 else '')
    if file.is_absolute() or not top.name.endswith('_ws') or not top.is_dir():
        return ''
    kept = Belongings(top.absolute()).hand_over(str(Path(*file.parts[1:])), text, texts)
    return f'You had changed {file} elsewhere than in this cell. That version is kept in {kept}' if kept else ''
