"""What in a workspace's `src` the lesson has made, and what the learner: a reset keeps what is the learner's."""

import hashlib
import json
import shutil
from collections.abc import Iterable
from pathlib import Path

_LEDGER = '.made_by_the_lesson.json'  # in a workspace: path below src -> digest
_NO_WORK = {'__pycache__', '.pytest_cache', '.ipynb_checkpoints', 'build', 'install', 'log'}


class Belongings:
    """Tells the two apart by the text of files: one that is not as the lesson left it is the learner's."""

    def __init__(self, workspace: Path):
        self._src, self._ledger = workspace / 'src', workspace / _LEDGER

    def note(self, before: dict[str, str], texts: Iterable[str] = ()) -> None:
        """Count as the lesson's what is other than `before`, which `now` gave before the lesson did something.

        :param texts: of the lesson; files that hold one of them are the lesson's, too.
        """
        made, known = self._made(), {_digest(text.encode()) for text in texts}
        made |= {path: digest for path, digest in self.now().items() if before.get(path) != digest or digest in known}
        self._ledger.write_text(json.dumps(made))

    def now(self) -> dict[str, str]:
        """The files below src with their digests, without what tools leave behind."""
        found = {}
        for path in sorted(self._src.rglob('*')):
            inside = path.relative_to(self._src)
            if path.is_file() and not path.is_symlink() and not _NO_WORK.intersection(inside.parts):
                found[str(inside)] = _digest(path.read_bytes())
        return found

    def keep(self) -> Path | None:
        """Move the packages in which something is the learner's into a new folder beside the workspace; its path."""
        made = self._made()
        theirs = {Path(path).parts[0] for path, digest in self.now().items() if made.get(path) != digest}
        if not theirs:
            return None
        shelf = self._src.parent.with_name(f'{self._src.parent.name}_kept')
        shelf.mkdir(exist_ok=True)
        number = 1 + max((int(path.name) for path in shelf.iterdir() if path.name.isdecimal()), default=0)
        kept = shelf / str(number)
        kept.mkdir()
        for name in sorted(theirs):
            shutil.move(self._src / name, kept / name)
        return kept

    def _made(self) -> dict[str, str]:
        try:
            return json.loads(self._ledger.read_text())
        except (OSError, ValueError):  # none yet
            return {}


def _digest(content: bytes) -> str:
    """Empty lines at the ends of a file are nobody's work."""
    return hashlib.sha256(content.strip()).hexdigest()
