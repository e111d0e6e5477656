"""Parameter files with other values in them: who changes such a file changes the nodes that get it."""

from collections.abc import Iterator
from typing import Any

import yaml

BLOCK, ALL = 'ros__parameters', '/**'


def with_values(text: str, values: dict[str, Any]) -> str:
    """The text of a parameter file that gives these values to all nodes, and no others; as it is, if it cannot be read.

    They stand in one block for all nodes: there a launch file that gives such a value itself replaces it, whereas it
    would not replace one in the block of a node.
    """
    try:
        content = yaml.safe_load(text)
        if not isinstance(content, dict):
            return text
        for block in _blocks(content, set()):
            for name in values:
                block.pop(name, None)
            block['changed'] = True  # a block without a parameter is an error
        first = {ALL: {BLOCK: {**_block(content.pop(ALL, None)), **values}}}
        return yaml.safe_dump({**first, **content}, sort_keys=False)
    except (yaml.YAMLError, ValueError, RecursionError):
        return text


def _block(content: Any) -> dict:
    """The parameters in the block of a node."""
    found = content.get(BLOCK) if isinstance(content, dict) else None
    return found if isinstance(found, dict) else {}


def _blocks(content: Any, seen: set[int]) -> Iterator[dict]:
    """The parameters of each node that is named, or meant, in a file."""
    if not isinstance(content, dict) or id(content) in seen:
        return
    seen.add(id(content))
    for key, value in content.items():
        if key != BLOCK:
            yield from _blocks(value, seen)
        elif isinstance(value, dict):
            yield value
