"""The one place where text from outside becomes text of a report.

A learner's id, messages, output and file names may hold anything. `visible` makes what has no shape, or what turns text
around, into signs that one can see; pages escape after it (`grading.reports.page`), XML is written by ElementTree.
"""

import re

# Newline and tab stay, and so do the joiners that some scripts and emoji need.
_HIDDEN = re.compile(
    r'[\x00-\x08\x0b-\x1f\x7f-\x9f\u061c\u180e\u200b\u200e\u200f\u2028-\u202e\u2060-\u206f\ufeff'
    r'\ufff9-\ufffb\ufffe\uffff\ud800-\udfff\U000e0000-\U000e007f]'
)


def visible(text: str) -> str:
    """The text with control characters, marks of direction and lone surrogates made visible: ESC becomes ⟨U+001B⟩.

    What is left is valid in HTML, in XML 1.0 and as UTF-8.
    """
    return _HIDDEN.sub(_sign, text)


def line(text: str, limit: int = 200) -> str:
    """The text in one line of at most `limit` characters, for names and titles."""
    text = visible(' '.join(text.split()))
    return text if len(text) <= limit else text[: limit - 1] + '…'


def _sign(match: re.Match) -> str:
    return f'⟨U+{ord(match[0]):04X}⟩'
