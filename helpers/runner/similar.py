"""Which of some names is meant by a misspelt one."""

import difflib
from collections.abc import Iterable


def nearest(name: str, there: Iterable[str], least: float = 0.75) -> str:
    """The name that is meant, perhaps: the same in other letters, or a similar one; '' if there is none.

    A class is not meant by a name with a small letter, which would be a variable's.

    :param there: the names that can be meant; those that begin with _ cannot. :param least: how similar it must be,
    from 0 to 1, as `difflib` counts it.
    """
    known = sorted(one for one in there if one[:1] != '_' and one[:1].isupper() == name[:1].isupper())
    plain = {one.replace('_', '').lower(): one for one in known}
    return plain.get(name.replace('_', '').lower()) or next(iter(difflib.get_close_matches(name, known, 1, least)), '')
