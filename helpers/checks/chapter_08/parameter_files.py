"""Parameter files with other values in them, and the values that a program got besides its file."""

import re
from collections.abc import Container, Iterable, Iterator
from typing import Any

import yaml

from helpers.exercises import file_syntax
from helpers.runner.stand_ins import Start

BLOCK, ALL = 'ros__parameters', '/**'
_OPTIONS = '-p', '--param'


def with_values(text: str, values: dict[str, Any]) -> str:
    """The text of a parameter file that gives these values to all nodes, and no others; as it is, if it cannot be read.

    They stand in one block for all nodes: there a launch file that gives such a value itself replaces it, whereas it
    would not replace one in the block of a node.
    """
    content = _content(text)
    if not isinstance(content, dict):
        return text
    for block in _blocks(content, set()):
        for name in values:
            block.pop(name, None)
        block['changed'] = True  # a block without a parameter is an error
    first = {ALL: {BLOCK: {**_block(content.pop(ALL, None)), **values}}}
    try:
        return yaml.safe_dump({**first, **content}, sort_keys=False)
    except (yaml.YAMLError, RecursionError):
        return text


def given_besides(starts: Iterable[Start], text: str, allowed: Container[str] = ()) -> dict[str, Any]:
    """The parameters that programs were started with besides the file with this text, whatever comes first or last.

    Not among them are those that are `allowed`. A launch file hands its own values over as another file, or as words
    `-p`.
    """
    file, found = _content(text), dict[str, Any]()
    for start in starts:
        for other in map(_content, start.files.values()):
            if other != file:
                for block in _blocks(other, set()):
                    found |= block
        for option, word in zip(start.arguments, start.arguments[1:], strict=False):
            name, between, value = word.partition(':=')
            if option in _OPTIONS and between:
                found[name.rpartition(':')[2]] = value
    return {name: value for name, value in found.items() if name not in allowed}


def why_unreadable(text: str) -> str:
    """Why ROS cannot read a parameter file, for a message; what to look at, if that is not known."""
    if found := file_syntax.mistake('parameters.yaml', text):
        line = text.split('\n')[found.line - 1].strip() if found.line else ''
        before = ' In the line before, is there a space behind the colon?' if 'mapping values' in found.said else ''
        return (f'Line {found.line}, `{line:.100}`: {found.said}.' if line else f'{found.said}.') + before
    for event in _events(text):
        if isinstance(event, yaml.events.AliasEvent) or getattr(event, 'anchor', None):
            return (
                f'Line {event.start_mark.line + 1} has an anchor (&) or an alias (*). YAML knows them, the parameter '
                'files of ROS do not: write the values twice.'
            )
    content = _content(text)
    if glued := next(_glued(content), ''):
        return f'`{glued:.100}`: a space is missing behind the colon.'
    for name, block in content.items() if isinstance(content, dict) else ():
        if name == BLOCK:
            return f'`{BLOCK}` stands below the name of a node, two spaces further to the right.'
        if isinstance(block, dict) and any(str(below).startswith('/') for below in block):
            below = next(str(below) for below in block if str(below).startswith('/'))
            return f'Below `{name}` stands `{below}`, and together they are {name}/{below}: leave out its first slash.'
        if not any(_blocks({name: block}, set())):
            return f'Below `{name}` there is no block `{BLOCK}`, with two underscores, that holds parameters.'
    for name in _names(content):
        parts = name.removeprefix('/').split('/')
        if bad := [part for part in parts if part not in ('*', '**') and not (part.isascii() and part.isidentifier())]:
            return (
                f'`{name:.100}` is no name of a node, because of `{bad[0]:.100}`: each part between slashes is a name '
                'of letters, digits and _ that begins with no digit, or `*` or `**` alone.'
            )
    return f'Look at the indentation, and at the two underscores of {BLOCK}.'


def shown(values: dict) -> str:
    """Parameters with their values, for messages."""
    return ', '.join(f'{name} = {value!r}' for name, value in values.items())


def _glued(content: Any, depth: int = 0) -> Iterator[str]:
    """The texts that stand where names and values should: `rate:20.0` is one word for YAML."""
    if isinstance(content, str) and re.match(r'\S+:\S', content):
        yield content.split()[0]
    elif isinstance(content, dict) and depth < 10:
        for key, value in content.items():
            if key == BLOCK or not isinstance(value, str):
                yield from _glued(str(key) if value is None else value, depth + 1)


def _names(content: Any, above: str = '', depth: int = 0) -> Iterator[str]:
    """The names of nodes that have a block, with the namespaces above them."""
    for key, value in content.items() if isinstance(content, dict) and depth < 10 else ():
        if key == BLOCK:
            yield above
        else:
            yield from _names(value, f'{above}/{key}' if above else str(key), depth + 1)


def _events(text: str) -> list:
    """What the parser sees in a YAML file; nothing if it cannot be read."""
    try:
        return list(yaml.parse(text))
    except Exception:  # as below
        return []


def _content(text: str) -> Any:
    """What stands in a YAML file; None if it cannot be read."""
    try:
        return yaml.safe_load(text)
    except Exception:  # the parser raises many types, as for a date that there is not, or for `!!bool maybe`
        return None


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
