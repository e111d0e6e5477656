"""Long names in tables: where a line may break inside of them.

In a narrow window a column of a wide table has room for some fifteen letters. A browser breaks a longer name of code at
any letter: the last *r* of `StaticTransformBroadcaster` then stands in a line of its own. The build marks the places
where such a name has parts. What a reader copies has no mark in it.
"""

import re

from grading.authoring.book import prose

LONGEST = 13  # letters of a name that need no mark
_FEWEST = 3  # columns of a table that gets narrow ones
_CELL = re.compile(r'(?<!\\)\|')
_CODE = re.compile(r'(?<!`)`([^`\n]+)`(?!`)')
_HARMLESS = ' ./=(),-:+?\'"'
_PART = re.compile(r'(?<=[_./=(,-])(?=\w)|(?<=[a-z])(?=[A-Z])')


def marked(text: str) -> str:
    """Return the Markdown with such marks (`<wbr>`) in the code of its wide tables."""
    lines = text.split('\n')
    for number, line in list(prose(lines)):
        if line.startswith('|') and len(_CELL.findall(line)) > _FEWEST:
            lines[number] = _CODE.sub(_code, line)
    return '\n'.join(lines)


def _code(span: re.Match) -> str:
    parts = _PART.split(span[1])
    if '|' in span[1] or len(parts) == 1 or max(map(len, re.split(r'[ -]', span[1]))) <= LONGEST:
        return span[0]
    return f'<code>{"<wbr>".join(map(_escaped, parts))}</code>'


def _escaped(text: str) -> str:
    """The text for HTML inside of Markdown: no sign of it means emphasis, a link, a formula or a tag."""
    return ''.join(sign if sign.isalnum() or sign in _HARMLESS else f'&#{ord(sign)};' for sign in text)
