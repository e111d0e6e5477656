"""
Texts with substitutions in them: ``$(var name)``, ``$(find-pkg-share $(var package))/launch``.

Inside ``$(…)`` spaces separate a word and its arguments; an argument with spaces is put in quotes. A backslash takes
from the character behind it what it means otherwise.
"""

from __future__ import annotations

import re
from typing import Any

from launch.frontend.expose import instantiate_substitution

_WORD = re.compile(r'[A-Za-z][A-Za-z0-9_-]*')


def replace_escaped_characters(text: str) -> str:
    """Return the text without the backslashes that protect a character."""
    return re.sub(r'\\(.)', r'\1', text)


def parse_substitution(text: str) -> list:
    """
    Return the substitutions that a text consists of.

    :raises ValueError: if it has a fault; the message shows where
    :raises RuntimeError: if a substitution is not known
    """
    from launch.substitutions.text_substitution import TextSubstitution

    return _Reader(text).template('') or [TextSubstitution(text='')]


def parse_if_substitutions(value: Any) -> Any:
    """
    Return a value with the substitutions in its texts; other scalars as they are, lists item by item.

    :raises ValueError: if a list holds values of several types
    """
    if not isinstance(value, list):
        return _parse_scalar(value)
    if len({type(item) for item in value if not _has_substitution(item)}) > 1:
        raise ValueError('The result is a non-uniform list')
    return [_parse_scalar(item) for item in value]


def _has_substitution(value: Any) -> bool:
    return isinstance(_parse_scalar(value), list)


def _parse_scalar(value: Any) -> Any:
    from launch.substitutions.text_substitution import TextSubstitution

    if not isinstance(value, str):
        return value
    parts = parse_substitution(value)
    return parts[0].text if len(parts) == 1 and isinstance(parts[0], TextSubstitution) else parts


class _Reader:
    """Reads one text from left to right."""

    def __init__(self, text: str):
        self._text, self._at = text, 0

    def template(self, end: str, inside: str = '') -> list:
        """
        Read texts and substitutions to one of the characters of ``end``, or to the end of the text.

        :param inside: the quote around; the other one means nothing there
        """
        from launch.substitutions.text_substitution import TextSubstitution

        parts: list = []
        plain = ''
        while self._at < len(self._text) and (char := self._text[self._at]) not in end:
            if char == '\\' and self._at + 1 < len(self._text):
                plain += self._text[self._at + 1]
                self._at += 2
            elif self._text.startswith('$(', self._at):
                parts += [TextSubstitution(text=plain)] if plain else []
                plain = ''
                parts.append(self._substitution(inside))
            else:
                plain += char
                self._at += 1
        return parts + ([TextSubstitution(text=plain)] if plain else [])

    def _substitution(self, inside: str):
        begin = self._at
        self._at += 2
        word = _WORD.match(self._text, self._at)
        if word is None:
            raise self._fault(begin, "expected the name of a substitution behind '$('")
        self._at = word.end()
        arguments = []
        while self._skip_spaces():
            if self._peek() == ')':
                break
            arguments.append(self._argument(begin, inside))
        if self._peek() != ')':
            raise self._fault(begin, "expected a space or ')'" if self._peek() else "this '$(' has no ')'")
        self._at += 1
        return instantiate_substitution(word.group(), arguments)

    def _argument(self, begin: int, inside: str) -> list:
        quote = self._peek()
        if inside or quote not in ('"', "'"):
            return self.template(' \t\n()' + (inside or '"\''), inside)
        self._at += 1
        parts = self.template(quote, quote)
        if self._peek() != quote:
            raise self._fault(begin, f'a quote {quote} is not closed')
        self._at += 1
        from launch.substitutions.text_substitution import TextSubstitution

        return parts or [TextSubstitution(text='')]

    def _skip_spaces(self) -> bool:
        begin = self._at
        while self._peek() and self._peek() in ' \t\n':
            self._at += 1
        return self._at > begin

    def _peek(self) -> str:
        return self._text[self._at : self._at + 1]

    def _fault(self, begin: int, reason: str) -> ValueError:
        return ValueError(f"cannot read the substitution '{self._text[begin:]}' in '{self._text}': {reason}")
