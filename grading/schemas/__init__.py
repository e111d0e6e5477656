"""JSON Schemas (draft 2020-12) of what the grader writes; the tests validate every file against them."""

import json
from collections.abc import Callable
from functools import cache
from pathlib import Path

FOLDER = Path(__file__).resolve().parent


def load(name: str) -> dict:
    """The schema called `name`: result, gradescope or summary."""
    return json.loads((FOLDER / f'{name}.schema.json').read_text(encoding='utf-8'))


@cache
def check(name: str) -> Callable[[object], object]:
    """A function that raises ValueError for a value which is not as this schema says, in some milliseconds."""
    import fastjsonschema  # as nbformat does

    return fastjsonschema.compile(load(name))
