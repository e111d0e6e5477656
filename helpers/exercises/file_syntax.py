"""Whether a file can be read by what it is for: Python, XML, YAML, settings (.cfg), interfaces and CMakeLists.txt."""

import configparser
import warnings
from collections.abc import Callable
from pathlib import PurePosixPath
from typing import NamedTuple
from xml.etree import ElementTree

import yaml

from helpers.exercises import cmake_syntax, interface_syntax, syntax_words


class Mistake(NamedTuple):
    """Why a file cannot be read, and where."""

    said: str
    line: int = 0  # from 1; 0 if that is not known
    column: int = 0  # from 1; 0 if that is not known


def mistake(path: str, text: str) -> Mistake | None:
    """The first mistake in the text of a file; None if there is none, or if nothing here reads such files."""
    file = PurePosixPath(path)
    reads = _READERS.get(file.suffix)
    try:
        if file.suffix in interface_syntax.PARTS:
            return _placed(interface_syntax.mistake(path, text))
        if file.name == 'CMakeLists.txt':
            return _placed(cmake_syntax.mistake(text))
        return reads(text) if reads else None
    except (ValueError, RecursionError, MemoryError) as error:  # null bytes, very deep nesting
        return Mistake(str(error) or type(error).__name__)


def shown(path: str, text: str, found: Mistake) -> str:
    """A mistake as Python shows one: the file, the line's number, the line, and a sign below the place."""
    lines = [f'{path}{f", line {found.line}" if found.line else ""}: {found.said}']
    there = text.split('\n')[found.line - 1 : found.line] if found.line else []
    if there and there[0].strip():
        lines.append(f'    {there[0]}')
        if found.column:
            lines.append(' ' * (3 + found.column) + '^')
    return '\n'.join(lines)


def _placed(found: tuple[str, int] | None) -> Mistake | None:
    return Mistake(*found) if found else None


def _python(text: str) -> Mistake | None:
    try:
        with warnings.catch_warnings():
            warnings.simplefilter('ignore')  # of what is allowed, if odd
            compile(text, '<file>', 'exec', dont_inherit=True)
    except SyntaxError as error:
        return Mistake(syntax_words.said(error), error.lineno or 0, error.offset or 0)
    return None


def _xml(text: str) -> Mistake | None:
    try:
        ElementTree.fromstring(text)
    except ElementTree.ParseError as error:
        line, column = error.position
        return Mistake(str(error).partition(': line')[0], line, column + 1)
    return None


def _yaml(text: str) -> Mistake | None:
    try:
        for _ in yaml.compose_all(text, Loader=yaml.SafeLoader):
            pass
    except yaml.MarkedYAMLError as error:
        mark = error.problem_mark or error.context_mark
        said = error.problem or error.context or 'this is no YAML'
        return Mistake(said, mark.line + 1, mark.column + 1) if mark else Mistake(said)
    except yaml.YAMLError as error:
        return Mistake(' '.join(str(error).split()))
    return None


def _settings(text: str) -> Mistake | None:
    try:
        configparser.ConfigParser(interpolation=None).read_string(text)
    except configparser.MissingSectionHeaderError as error:
        return Mistake('a section such as [install] must come first', error.lineno)
    except configparser.ParsingError as error:
        return Mistake('this is neither a section nor a setting', error.errors[0][0] if error.errors else 0)
    except configparser.Error as error:  # a section or a setting that is there twice
        said = error.message.partition(']: ')[2] or error.message
        return Mistake(said, getattr(error, 'lineno', None) or 0)
    return None


_READERS: dict[str, Callable[[str], Mistake | None]] = {
    '.py': _python,
    '.xml': _xml,
    '.urdf': _xml,
    '.yaml': _yaml,
    '.yml': _yaml,
    '.cfg': _settings,
}
