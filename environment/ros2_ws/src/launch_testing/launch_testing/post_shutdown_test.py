"""The mark of cases that run after the end of the launch."""

import unittest
from collections.abc import Callable


def post_shutdown_test() -> Callable[[type[unittest.TestCase]], type[unittest.TestCase]]:
    """
    Let the cases of a class run when all processes have ended.

    :raises TypeError: if it decorates anything but a class of unittest
    """

    def decorate(case: type[unittest.TestCase]) -> type[unittest.TestCase]:
        if not isinstance(case, type) or not issubclass(case, unittest.TestCase):
            raise TypeError('post_shutdown_test can only decorate unittest.TestCase classes')
        case.__post_shutdown_test__ = True
        return case

    return decorate
