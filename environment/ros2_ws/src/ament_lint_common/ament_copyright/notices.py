"""Writes copyright notices: what `--add-missing` and `--add-copyright-year` do."""

import itertools
import re
from pathlib import Path

from ament_copyright.licenses import COPYRIGHT, License, find_copyrights, leading_comment, with_notice

_FIRST_LINES = re.compile(r'\ufeff?(?:(?:#!|(?:#|//)[^\n]*coding[:=])[^\n]*(?:\n|$))*')


def add_missing(files: list[str], holder: str, license_: License, of_repository: dict[str, str], verbose: bool) -> None:
    """
    Write a notice into each source file without one, and the files that a repository lacks.

    Each changed file is printed behind ``*``, each new one behind ``+``; with `verbose` the others, too.

    :param of_repository: the texts of the files that a repository has to have, by their names
    """
    header = with_notice(license_.file_headers[0], holder)
    if verbose:
        print('Adding the following copyright / license header or repository level files:')
        print(''.join(f'+ {line}\n' for line in header.splitlines()))
    for file in map(Path, files):
        text = file.read_text(encoding='utf-8') if file.exists() else None
        new = of_repository.get(file.name)
        if text is None and new is not None:
            _write('+', file, new)
        elif text and new is None and not find_copyrights(leading_comment(text)):
            _write('*', file, with_header(text, header, '#' if file.suffix in ('.py', '.cmake') else '//'))
        elif verbose:
            print(f'  {file}')


def with_header(text: str, header: str, mark: str) -> str:
    """Return a source text with a header as comments, behind the lines for the system and for the coding."""
    first = _FIRST_LINES.match(text)[0]
    comment = ''.join(f'{mark} {line}'.rstrip() + '\n' for line in header.splitlines())
    gap = '\n' if first.strip('\ufeff') else ''
    rest = text[len(first) :].lstrip('\r\n')
    return f'{first}{gap}{comment}\n{rest}' if rest else f'{first}{gap}{comment}'


def add_years(files: list[str], years: list[int], verbose: bool) -> None:
    """Put years into the first notice of each file that has one; what is printed is that of `add_missing`."""
    for file in map(Path, files):
        text = file.read_text(encoding='utf-8') if file.exists() else ''
        found = COPYRIGHT.search(text) if find_copyrights(leading_comment(text)) else None
        if found is None:
            continue
        listed = _listed(found[1])
        if listed.issuperset(years):
            if verbose:
                print(f'  {file}')
            continue
        _write('*', file, text[: found.start(1)] + _spelled(listed.union(years)) + text[found.end(1) :])


def _write(sign: str, file: Path, text: str) -> None:
    print(f'{sign} {file}')
    file.write_text(text, encoding='utf-8')


def _listed(text: str) -> set[int]:
    ends = [[int(year) for year in part.split('-')] for part in re.sub(r'\s', '', text).split(',')]
    return {year for begin, *end in ends for year in range(begin, (end[0] if end else begin) + 1)}


def _spelled(years: set[int]) -> str:
    runs = itertools.groupby(enumerate(sorted(years)), lambda pair: pair[1] - pair[0])
    spans = [[year for _, year in run] for _, run in runs]
    return ', '.join(str(span[0]) if len(span) == 1 else f'{span[0]}-{span[-1]}' for span in spans)
