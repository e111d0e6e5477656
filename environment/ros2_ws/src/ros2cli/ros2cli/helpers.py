"""Small things that several commands need."""

import sys
import time
from argparse import ArgumentTypeError
from collections.abc import Callable
from typing import Any


def unsigned_int(text: str) -> int:
    """Convert an argument to an integer of at least 0, for argparse."""
    return _number(text, int, lambda value: value >= 0, 'value must be non-negative integer')


def positive_int(text: str) -> int:
    """Convert an argument to an integer above 0, for argparse."""
    return _number(text, int, lambda value: value > 0, 'value must be a positive integer')


def positive_float(text: str) -> float:
    """Convert an argument to a number above 0, for argparse."""
    return _number(text, float, lambda value: value > 0, 'value must be positive')


def _number(text: str, convert: Callable[[str], Any], check: Callable[[Any], bool], message: str) -> Any:
    try:
        value = convert(text)
    except ValueError:
        raise ArgumentTypeError(message) from None
    if not check(value):
        raise ArgumentTypeError(message)
    return value


def collect_stdin() -> str:
    """Return everything from standard input."""
    return sys.stdin.read()


def wait_for(predicate: Callable[[], bool], timeout: float, period: float = 0.05) -> bool:
    """Ask until the answer is yes, for at most `timeout` seconds; return the last answer."""
    deadline = time.monotonic() + timeout
    while not predicate():
        if time.monotonic() >= deadline:
            return False
        time.sleep(period)
    return True


def parse_yaml_dictionary(text: str, not_a_dictionary: str) -> dict[str, Any]:
    """
    Parse the values on a command line, or what a list of completions shows: in quotes, with ^J for line ends.

    :param not_a_dictionary: what to say if the text is YAML, but no dictionary.
    :raises RuntimeError: with one line that says what is wrong.
    """
    import yaml

    if text.startswith("'") and text.endswith("^J'"):
        text = text[1:-1].replace('^J', '\n')
    try:
        values = yaml.safe_load(text)
    except yaml.YAMLError as e:
        problem = getattr(e, 'problem', None) or 'cannot be parsed'
        mark = getattr(e, 'problem_mark', None)
        where = f' (line {mark.line + 1}, column {mark.column + 1})' if mark else ''
        raise RuntimeError(f'The passed value is not valid YAML: {problem}{where}') from None
    if not isinstance(values, dict):
        raise RuntimeError(not_a_dictionary)
    return values
