"""Several launches of one test."""

from __future__ import annotations

import functools
from collections.abc import Callable, Iterable


def parametrize(argnames: str | Iterable[str], argvalues: Iterable) -> Callable[[Callable], Callable]:
    """
    Launch and test once for each value; the function that describes the launch gets it, and so does each test.

    :param argnames: the names of the arguments, with commas between them or as a list
    :param argvalues: one value for each launch, or one tuple if there are several names
    """
    names = [name.strip() for name in argnames.split(',')] if isinstance(argnames, str) else list(argnames)

    def decorate(test_description: Callable) -> Callable:
        @functools.wraps(test_description)
        def launches():
            for values in argvalues:
                given = dict(zip(names, [values] if len(names) == 1 else values, strict=True))
                bound = functools.partial(test_description, **given)
                functools.update_wrapper(bound, test_description)
                yield bound, given

        launches.__parametrized__ = True
        return launches

    return decorate
