"""Reads notebooks that are not trusted: with limits on their size, and one type of error for all that is wrong."""

import json
import os
import stat
from dataclasses import dataclass
from pathlib import Path

MAX_BYTES = 10 * 2**20
MAX_CELLS = 2000
MAX_SOURCE = 200_000  # characters of one cell
MAX_CODE = 1_000_000  # characters of all cells of code


class InvalidSubmission(Exception):
    """What was handed in cannot be read or graded; the message says what is wrong and what to do."""


@dataclass(frozen=True)
class NotebookCell:
    """One cell of code, as the learner saved or executed it."""

    source: str
    number: int  # counted from 1 over all cells of the notebook; 0 where there is no notebook
    id: str | None = None
    tags: tuple[str, ...] = ()

    @property
    def label(self) -> str:
        """How a message names the cell: an exercise by its heading, another one by its number."""
        first = self.source.lstrip().partition('\n')[0].strip()
        if first.startswith('# Exercise'):
            return first.removeprefix('# ').partition(':')[0][:40]
        return f'cell {self.number}' if self.number else f'the cell "{first[:40]}"'


def read(path: Path) -> list[NotebookCell]:
    """Return the code cells of the notebook at ``path``.

    :raises InvalidSubmission: it is missing, no regular file, too big, or no notebook of format 4.
    """
    return parse(read_bytes(path), path.name)


def read_bytes(path: Path) -> bytes:
    """The bytes of a notebook's file, which is read once and within bounds.

    :raises InvalidSubmission: it is missing, no regular file, or too big.
    """
    try:
        # Without waiting for somebody at the other end of a pipe.
        with open(os.open(path, os.O_RDONLY | getattr(os, 'O_NONBLOCK', 0)), 'rb') as file:
            if not stat.S_ISREG(os.fstat(file.fileno()).st_mode):
                raise InvalidSubmission(f'{path.name} is no regular file.')
            size = os.fstat(file.fileno()).st_size
            if size > MAX_BYTES:
                raise InvalidSubmission(
                    f'{path.name} has {size / 2**20:.0f} MB, more than {MAX_BYTES // 2**20} MB: '
                    'clear its outputs and save it again.'
                )
            return file.read(MAX_BYTES + 1)
    except OSError as error:
        raise InvalidSubmission(f'{path.name} cannot be read: {error.strerror}.') from None


def parse(data: bytes, name: str) -> list[NotebookCell]:
    """Return the code cells of a notebook's text. ``name`` stands for it in messages.

    :raises InvalidSubmission: it is too big, or no notebook of format 4.
    """
    if len(data) > MAX_BYTES:
        raise InvalidSubmission(f'{name} is larger than {MAX_BYTES // 2**20} MB: clear its outputs and save it again.')
    notebook = document(data, name)
    if not isinstance(notebook, dict) or not isinstance(notebook.get('cells'), list):
        raise InvalidSubmission(f'{name} is not a notebook: it has no list of cells. Save it with JupyterLab again.')
    if notebook.get('nbformat') != 4:
        raise InvalidSubmission(
            f'{name} has the notebook format {str(notebook.get("nbformat"))[:20]}, not 4: '
            'save it with a current JupyterLab.'
        )
    if len(notebook['cells']) > MAX_CELLS:
        raise InvalidSubmission(f'{name} has {len(notebook["cells"])} cells, more than {MAX_CELLS}.')
    _validate(notebook, name)
    cells = []
    for number, cell in enumerate(notebook['cells'], 1):
        if cell['cell_type'] == 'code':
            source = cell['source'] if isinstance(cell['source'], str) else ''.join(cell['source'])
            cells.append(NotebookCell(_text(source, name, number), number, cell.get('id'), _tags(cell)))
    if sum(len(cell.source) for cell in cells) > MAX_CODE:
        raise InvalidSubmission(f'{name} has more than {MAX_CODE} characters of code.')
    return cells


def _tags(cell: dict) -> tuple[str, ...]:
    metadata = cell.get('metadata')
    tags = metadata.get('tags') if isinstance(metadata, dict) else None
    return tuple(tag for tag in tags if isinstance(tag, str)) if isinstance(tags, list) else ()


def whole_number(text: str) -> int:
    """A number in a notebook's JSON. Python reads none of thousands of digits; no cell needs one."""
    return int(text) if len(text) < 1000 else 0


def _json(data: bytes, name: str):
    if data[:3] == b'\xef\xbb\xbf':
        data = data[3:]
    if not data.strip():
        raise InvalidSubmission(f'{name} is empty: save the notebook and try again.')
    if data.count(b'[') + data.count(b'{') > 1_000_000:
        raise InvalidSubmission(f'{name} is too complex to be a notebook.')
    try:
        # Outputs may have NaN in them, which Python writes and JSON does not know. They are not read.
        return json.loads(data.decode('utf-8'), parse_constant=lambda text: None, parse_int=whole_number)
    except UnicodeDecodeError:
        raise InvalidSubmission(f'{name} is not UTF-8 text: save it with JupyterLab again.') from None
    except RecursionError:
        raise InvalidSubmission(f'{name} is nested too deeply to be a notebook.') from None
    except ValueError as error:
        where = f' (line {error.lineno})' if isinstance(error, json.JSONDecodeError) else ''
        raise InvalidSubmission(f'{name} is not valid JSON{where}: it is damaged or cut off. Save it again.') from None


def document(data: bytes, name: str):
    """The JSON value of a notebook's text, one of format 3 in format 4.

    :raises InvalidSubmission: it is no JSON.
    """
    return _current(_json(data, name))


def _current(notebook):
    """A notebook of format 3 in format 4; another one, and one that cannot be converted, as it is."""
    if isinstance(notebook, dict) and notebook.get('nbformat') == 3 and notebook.get('worksheets'):
        import nbformat

        try:
            return json.loads(json.dumps(nbformat.convert(nbformat.from_dict(notebook), 4)))
        except Exception:  # noqa: BLE001 - nbformat raises many types; the caller says what is wrong
            pass
    return notebook


def _validate(notebook: dict, name: str) -> None:
    """Check the form of all but the outputs, which are not read."""
    import nbformat  # here, as it takes longer than all else that a server of the runner imports

    bare: dict = {'nbformat': 4, 'nbformat_minor': 5, 'metadata': {}, 'cells': []}
    for number, cell in enumerate(notebook['cells'], 1):
        if not isinstance(cell, dict):
            raise InvalidSubmission(f'{name}: cell {number} is not a cell. Save the notebook with JupyterLab again.')
        kept = {key: cell[key] for key in ('cell_type', 'source') if key in cell}
        kept |= {'id': f'c{number}', 'metadata': {}}
        if cell.get('cell_type') == 'code':
            kept |= {'execution_count': None, 'outputs': []}
        bare['cells'].append(kept)
        identity = cell.get('id')
        if identity is not None and not isinstance(identity, str):
            raise InvalidSubmission(f'{name}: cell {number} has an id that is not a text.')
    try:
        nbformat.validate(nbformat.from_dict(bare))
    except Exception as error:  # noqa: BLE001 - nbformat raises many types; all mean the same here
        path = list(getattr(error, 'absolute_path', ()))
        cell = f' (cell {path[1] + 1})' if len(path) > 1 and isinstance(path[1], int) else ''
        raise InvalidSubmission(f'{name} is not a valid notebook{cell}: save it with JupyterLab again.') from None


def _text(source: str, name: str, number: int) -> str:
    if len(source) > MAX_SOURCE:
        raise InvalidSubmission(f'{name}: cell {number} has {len(source)} characters, more than {MAX_SOURCE}.')
    return source.removeprefix('\ufeff').replace('\r\n', '\n').replace('\r', '\n')  # as editors show it
