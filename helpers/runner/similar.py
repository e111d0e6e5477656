"""Which of some names is meant by a misspelt one."""

import difflib
from collections.abc import Iterable

# An answer may hold many long names that are nearly the same, and to compare two of them takes the product of their
# lengths.
MOST_LETTERS = 40
MOST_NAMES = 2000


def nearest(name: str, there: Iterable[str], least: float = 0.75) -> str:
    """The name that is meant, perhaps: the same in other letters, or a similar one; '' if there is none.

    A class is not meant by a name with a small letter, which would be a variable's.

    :param there: the names that can be meant; those that begin with _ cannot, and long ones are not looked at.
    :param least: how similar it must be, from 0 to 1, as `difflib` counts it.
    """
    if not name or len(name) > MOST_LETTERS:
        return ''
    fits = [
        one for one in there if 0 < len(one) <= MOST_LETTERS and one[0] != '_' and one[0].isupper() == name[0].isupper()
    ]
    known = sorted(fits)[:MOST_NAMES]
    plain = {one.replace('_', '').lower(): one for one in known}
    return plain.get(name.replace('_', '').lower()) or next(iter(difflib.get_close_matches(name, known, 1, least)), '')
