"""What Python says of a text that it cannot read, and what to type where a sign only looks like the right one."""

import re
import unicodedata

_CODE = re.compile(r'U\+([0-9A-F]{4,6})')
# Signs of input methods, web pages and text programs for which NFKC, Unicode's form of signs that are alike, has no key
# of the keyboard, or not the one that is meant.
_PLAIN = {
    **dict.fromkeys('“”„‟«»″〝〞', '"'),
    **dict.fromkeys('‘’‚‛´′‹›', "'"),
    **dict.fromkeys('‐‑‒–—−', '-'),
    **dict.fromkeys('。', '.'),
    **dict.fromkeys('、', ','),
    **dict.fromkeys('【〔', '['),
    **dict.fromkeys('】〕', ']'),
    '×': '*',
    '÷': '/',
    '²': '**2',
    '³': '**3',
}
_UNSEEN = '\u200b\u200c\u200d\u200e\u200f\u2060\ufeff'


def said(error: SyntaxError) -> str:
    """Python's own words; of a sign that it does not know also which key of the keyboard is meant.

    Who has copied a line from a web page, or types with a Chinese or Japanese input method, sees no difference.
    """
    found = _CODE.search(error.msg)
    if not found:
        return error.msg
    sign = chr(int(found[1], 16))
    if sign in _UNSEEN:
        return f'{error.msg}: this sign has no width. Delete the line, and type it anew'
    plain = _PLAIN.get(sign) or unicodedata.normalize('NFKC', sign)
    if plain == sign or not plain.isascii():
        return error.msg
    return f'{error.msg}: type {"a plain blank" if plain == " " else f"`{plain}`"} in its place'
