"""Benchmarks. ``bench_NAME.py``, here or in environment/bench or helpers/bench, is found by ``./course bench``.

Such a module defines ``measure()``, which yields (what, value, unit) triples, and says in the first line of its
docstring what is measured. Where there is a peer, `against` makes the rows.
"""

import ast
from collections.abc import Iterator
from pathlib import Path

FOLDERS = ('environment/bench', 'helpers/bench', 'grading/bench')


def find(root: Path) -> dict[str, Path]:
    """Return the benchmarks below ``root`` by name, in alphabetical order, without importing them."""
    paths = [path for folder in FOLDERS for path in (root / folder).glob('bench_*.py')]
    return dict(sorted((path.stem.removeprefix('bench_'), path) for path in paths))


def title(path: Path) -> str:
    """Return what the benchmark at ``path`` measures."""
    return (ast.get_docstring(ast.parse(path.read_text(encoding='utf-8'))) or path.stem).splitlines()[0]


def run(path: Path) -> Iterator[tuple[str, float, str]]:
    """Import and run one benchmark; yields its rows as they are measured."""
    import importlib.util

    spec = importlib.util.spec_from_file_location(path.stem, path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    for what, value, unit in module.measure():
        yield str(what), float(value), str(unit)


def against(what: str, ours: float, peer: str, theirs: float, unit: str) -> Iterator[tuple[str, float, str]]:
    """Yield the rows of a figure, of the same figure of a peer, and how many times the peer's ours is.

    :raises RuntimeError: the peer's is zero.
    """
    if not theirs:
        raise RuntimeError(f'{what}: nothing was measured with {peer}')
    yield what, ours, unit
    yield f'{what}: {peer}', theirs, unit
    yield f'{what}: course / {peer}', ours / theirs, '×'
