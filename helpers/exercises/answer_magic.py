"""What the kernel does with a cell of `file_answers`: it keeps each text under its name, and writes each file.

IPython takes a cell magic only in a cell's first line, where an exercise has its heading. So the cell is rewritten
before IPython reads it: each file becomes a call of the magic `%%answer`.
"""

import sys
from pathlib import Path, PurePosixPath

from helpers.exercises import file_answers
from helpers.kernel import journal


def register() -> None:
    """Let the cells of this process's IPython hold files from now on; idempotent."""
    shell = journal.shell()
    if shell is None or _as_calls in shell.input_transformers_cleanup:
        return
    shell.input_transformers_cleanup.append(_as_calls)
    shell.register_magic_function(answer, 'cell', 'answer')


def answer(line: str, cell: str) -> None:
    """Keep the cell's text under a name, and write it into a file: `%%answer NAME FILE`.

    FILE begins at the notebook's folder. A mistake that `file_syntax` finds is shown; the file is written all the same.
    """
    from IPython.core.error import UsageError

    named = file_answers.arguments(line.strip())
    if named is None or not named[0].isidentifier():
        raise UsageError(f'Write `{file_answers.USAGE}`: the name that the check asks for, and where the file goes.')
    name, path = named
    place = PurePosixPath(path)
    if place.is_absolute() or '..' in place.parts:
        raise UsageError(f'{path} must be below the folder of this notebook.')
    shell = journal.shell()
    shell.user_ns[name] = cell
    print(_write(place, cell))
    from helpers.exercises import file_syntax

    if found := file_syntax.mistake(path, cell):
        print(file_syntax.shown(path, cell, found), file=sys.stderr)


def _as_calls(lines: list[str]) -> list[str]:
    """An input transformer of IPython: the lines of a cell, each file as a call of the magic."""
    source = file_answers.rewritten(
        ''.join(lines), lambda said, text, line: f"get_ipython().run_cell_magic('answer', {said!r}, {text!r})"
    )
    return source.splitlines(keepends=True)


def _write(place: PurePosixPath, text: str) -> str:
    """Write a file into a workspace that is there, and say so."""
    file, top = Path(place), Path(place.parts[0])
    if len(place.parts) > 1 and not top.is_dir():
        return f'Not written, as there is no folder {top} beside this notebook yet: {place}'
    from helpers.programs import belongings

    try:
        file.parent.mkdir(parents=True, exist_ok=True)
        kept = belongings.hand_over(file, text)
        file.write_text(text, encoding='utf-8')
    except (OSError, ValueError) as error:
        return f'Not written: {place} ({getattr(error, "strerror", None) or error})'
    return '\n'.join(filter(None, [f'Written: {place}', kept]))
