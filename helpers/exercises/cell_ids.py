"""Ids of the cells that the course gives.

They come from a cell's own text. So an edit elsewhere does not change them, and a notebook alone tells which of its
cells are still as they were given.
"""

import hashlib

_MOST = 20  # cells with the same text in one notebook


def of_exercise(exercise: str) -> str:
    """Return the id of the cell of an exercise: 'ex-3-2' for '3.2'."""
    return 'ex-' + exercise.replace('.', '-')


def of_given(kind: str, source: str, occurrence: int = 1) -> str:
    """Return the id of the `occurrence`-th cell with this text; `kind` is 'code' or 'markdown'."""
    return hashlib.sha256(f'{occurrence}\n{kind}\n{source}'.encode(errors='surrogatepass')).hexdigest()[:8]


def untouched(kind: str, source: str, identity: str) -> bool:
    """Tell if a cell with this id still has the text with which it was given."""
    return any(of_given(kind, source, number) == identity for number in range(1, _MOST))
