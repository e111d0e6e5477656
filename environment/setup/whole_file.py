"""Files that are written as a whole or not at all. Standard library only."""

import os
import threading
from contextlib import suppress
from pathlib import Path

TEMPORARY = '.part'  # the end of the name of a file that is not whole yet


def write(path: Path, content: str | bytes, *, rights: int | None = None, sync: bool = False) -> None:
    """Write a file so that a full disk, or the end of the process, leaves the old one.

    Who holds a link to the old file keeps the old one.

    :param content: of a text, half a surrogate pair, which no file can hold, becomes a question mark.
    :param rights: of the new file; the usual ones of a new file if not given.
    :param sync: wait until it is on the disk, so that it outlives the machine's end, too.
    :raises OSError: it cannot be written; nothing is left of it.
    """
    data = content.encode('utf-8', 'replace') if isinstance(content, str) else content
    temporary = path.with_name(f'.{path.name}.{os.getpid()}.{threading.get_native_id()}{TEMPORARY}')
    try:
        with open(temporary, 'wb') as file:
            file.write(data)
            file.flush()
            if sync:
                os.fsync(file.fileno())
        if rights is not None:
            temporary.chmod(rights)
        temporary.replace(path)
    except BaseException as error:
        with suppress(OSError):
            temporary.unlink()
        if isinstance(error, OSError):
            error.filename = str(path)
        raise


def update(path: Path, text: str, *, sync: bool = False) -> None:
    """`write` a file, in a folder that is made if need be, unless it has this text already."""
    with suppress(OSError):
        if path.read_bytes() == text.encode('utf-8', 'replace'):
            return
    path.parent.mkdir(parents=True, exist_ok=True)
    write(path, text, sync=sync)
