"""Mistakes of a chapter's author."""

from pathlib import Path


class CellError(ValueError):
    """A mistake in a cell. `offset` counts the lines of the cell from 0."""

    def __init__(self, offset: int, problem: str, remedy: str):
        self.offset, self.problem, self.remedy = offset, problem, remedy
        super().__init__(f'{problem}; {remedy}')


class AuthoringError(Exception):
    """A mistake in a chapter's source: where it is, what is wrong, and how to correct it, in one line."""

    def __init__(self, path: Path, line: int | None, problem: str, remedy: str):
        self.path, self.line, self.problem, self.remedy = path, line, problem, remedy
        place = f'{path.parent.name}/{path.name}' + (f':{line}' if line else '')
        super().__init__(f'{place}: {problem}; {remedy}')


class ChapterErrors(Exception):
    """All mistakes found in one go, one line each."""

    def __init__(self, errors: list[AuthoringError]):
        self.errors = errors
        super().__init__('\n'.join(map(str, errors)))
