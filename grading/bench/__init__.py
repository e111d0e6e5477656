"""Benchmarks. ``bench_NAME.py``, here or in environment/bench or helpers/bench, is found by ``./course bench``.

Such a module defines ``measure()``, which yields a `Measurement` for each number, or a tuple of the first fields of
one, and says in the first line of its docstring what is measured. Where the course adds something to rclpy, or does
what another program does, too, a figure has a reference: the same task, measured in the same run and in turn, so that
what slows the machine down slows both.
"""

import ast
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

FOLDERS = ('environment/bench', 'helpers/bench', 'grading/bench')


class Measurement(NamedTuple):
    """One number: ``what`` it is of, its ``value`` and ``unit``; and in the same unit the value of a ``reference``."""

    what: str
    value: float
    unit: str
    reference: str = ''  # whose value the next one is; none if empty
    reference_value: float | None = None

    @property
    def ratio(self) -> float | None:
        """How many times the reference's value the course's is."""
        return None if self.reference_value is None else self.value / self.reference_value


def find(root: Path) -> dict[str, Path]:
    """Return the benchmarks below ``root`` by name, in alphabetical order, without importing them."""
    paths = [path for folder in FOLDERS for path in (root / folder).glob('bench_*.py')]
    return dict(sorted((path.stem.removeprefix('bench_'), path) for path in paths))


def title(path: Path) -> str:
    """Return what the benchmark at ``path`` measures.

    :raises SyntaxError: it is no Python.
    """
    return (ast.get_docstring(ast.parse(path.read_text(encoding='utf-8'))) or path.stem).splitlines()[0]


def run(path: Path) -> Iterator[Measurement]:
    """Import and run one benchmark; yields its figures as they are measured.

    :raises RuntimeError: the value of a reference is zero: nothing was measured.
    """
    import importlib.util

    spec = importlib.util.spec_from_file_location(path.stem, path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    for row in module.measure():
        figure = Measurement(*row)
        if figure.reference_value == 0:
            raise RuntimeError(f'{figure.what}: nothing was measured with {figure.reference}')
        yield figure
