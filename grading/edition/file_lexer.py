"""Colours a cell with `%%answer NAME FILE` or `%%writefile FILE` by the languages of its files, as JupyterLab does.

What stands above the first of these lines is Python. (For JupyterLab: `helpers/cli/labextensions`, answers.js.)
"""

import re
from collections.abc import Iterator

from pygments.lexer import Lexer
from pygments.lexers import LEXERS, TextLexer, get_lexer_for_filename
from pygments.token import Comment, _TokenType
from pygments.util import ClassNotFound

__all__ = ['FilesLexer']  # as Pygments loads it
NAME = 'files-of-a-cell'  # of the language
_FILE = re.compile(r'^%%(?:answer[ \t]+\w+|writefile(?:[ \t]+-a)?)[ \t]+(\S+)[ \t]*\n?', re.MULTILINE)
_ALIKE = {'urdf': 'xml', 'xacro': 'xml'}  # suffixes that Pygments does not know


def has_files(source: str) -> bool:
    """Whether a cell holds the text of files."""
    return bool(_FILE.search(source))


class FilesLexer(Lexer):
    """A cell's text, in parts: a line that names a file, and below it the file."""

    name = 'Files of a cell'
    aliases = (NAME,)

    def get_tokens_unprocessed(self, text: str) -> Iterator[tuple[int, _TokenType, str]]:
        """The tokens of all parts, with their places in the whole text."""
        begin, path = 0, 'a.py'
        for line in _FILE.finditer(text):
            yield from _tokens(text[begin : line.start()], path, begin)
            yield line.start(), Comment.Preproc, line[0]
            begin, path = line.end(), line[1]
        yield from _tokens(text[begin:], path, begin)


def _tokens(text: str, path: str, begin: int) -> Iterator[tuple[int, _TokenType, str]]:
    name = path.rpartition('/')[2]
    suffix = name.rpartition('.')[2]
    try:
        lexer = get_lexer_for_filename(f'a.{_ALIKE[suffix]}' if suffix in _ALIKE else name)
    except ClassNotFound:  # the definition of a message, say
        lexer = TextLexer()
    for place, token, value in lexer.get_tokens_unprocessed(text):
        yield begin + place, token, value


# nbconvert asks Pygments for a language by its name.
LEXERS['FilesLexer'] = (__name__, FilesLexer.name, FilesLexer.aliases, (), ())
