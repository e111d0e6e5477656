"""`%%writefile -a FILE`: a cell that is run again does not append its part a second time.

IPython's own magic appends at each run. So a program in parts would have a part twice after its cell was run again.
"""

from pathlib import Path

from helpers.kernel import journal

_MAGIC = '%%writefile'


def register() -> None:
    """Let `%%writefile -a` of this process's IPython know the parts that are there already; idempotent."""
    shell = journal.shell()
    if shell is None or getattr(shell.find_cell_magic('writefile'), 'knows_parts', False):
        return
    plain = shell.find_cell_magic('writefile')

    def writefile(line: str, cell: str) -> None:
        if not _replaced(line, cell):
            said = _kept(line, cell)
            _write(plain, line, cell)
            if said:
                print(said)

    writefile.__doc__ = plain.__doc__
    writefile.knows_parts = True  # type: ignore[attr-defined]
    shell.register_magic_function(writefile, 'cell', 'writefile')


def with_part(text: str, part: str, before: str | None) -> str:
    """The text of a file after a cell has appended `part`. `before`: what the same cell appended at its last run."""
    if before and (begin := _find(text, before)) >= 0:
        return text[:begin] + part + text[begin + len(before) :]
    return text if _find(text, part) >= 0 else text + part


def written() -> dict[str, str]:
    """By file: what cells of this kernel have written by `%%writefile`, one after the other."""
    texts: dict[str, str] = {}
    last: dict[tuple, str] = {}
    for cell in journal.cells:
        if named := _named(cell.source):
            file, appends, part = named
            before = last.get((cell.id, file)) if cell.id else None
            texts[file] = with_part(texts.get(file, ''), part, before) if appends else part
            last[cell.id, file] = part
    return texts


def _replaced(line: str, part: str) -> bool:
    """Write the file and say so, if this is a part that it has already, or an edited one; else return False."""
    words = line.split()
    file = Path(words[-1].strip('\'"')).expanduser() if words else Path()
    if not {'-a', '--append'} & set(words[:-1]) or not file.is_file():
        return False
    text = file.read_text(encoding='utf-8')
    before = _before(words[-1])
    if not any(known and _find(text, known) >= 0 for known in (before, part)):
        return False
    new = with_part(text, part, before)
    if new == text:
        print(f'Already in {file}: not appended again')
    else:
        file.write_text(new, encoding='utf-8')
        print(f'Changed in {file}: what this cell appended before')
    return True


def _write(plain, line: str, cell: str) -> None:
    try:
        plain(line, cell)
    except FileNotFoundError as error:
        folder = Path(error.filename or '').parent
        raise FileNotFoundError(f'there is no folder {folder} yet: run the cells above that make it') from None


def _kept(line: str, text: str) -> str:
    """Before a cell writes all of a file: where the version is kept that the learner has made of it, in words."""
    from helpers.programs import belongings

    words = line.split()
    if not words or {'-a', '--append'} & set(words[:-1]):
        return ''
    return belongings.hand_over(Path(words[-1].strip('\'"')), text, written().values())


def _before(file: str) -> str | None:
    """What the running cell appended to this file at its last run; None if the front end sends no ids of cells."""
    running = journal.cells[-1].id if journal.cells else None
    for cell in reversed(journal.cells[:-1]):
        if running and cell.id == running:
            named = _named(cell.source)
            return named[2] if named and named[:2] == (file, True) else None
    return None


def _named(source: str) -> tuple[str, bool, str] | None:
    """File, whether it is appended to, and text of a cell `%%writefile`; None of another cell."""
    first, _, text = source.lstrip().partition('\n')
    words = first.split()
    if words[:1] != [_MAGIC] or len(words) < 2:
        return None
    return words[-1], bool({'-a', '--append'} & set(words[1:-1])), text if text.endswith('\n') else f'{text}\n'


def _find(text: str, part: str) -> int:
    """Where whole lines begin that are `part`; -1 if nowhere."""
    if not part.strip():
        return -1
    return f'\n{text}'.find(f'\n{part}')
