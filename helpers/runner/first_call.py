"""The first right call of a learner's function, which must have the same result after all others.

A default argument that is a list or a dictionary, a variable outside of the function, or a table that the function
itself changes: then the first calls are right, and later ones are wrong, each in another way. What is said of such a
call alone leads astray. So a test asks again what was answered rightly before.
"""

from helpers.runner.verdicts import about, expect


class FirstCall:
    """Notes a function's first result, and asks for it once more when a later one is wrong."""

    def __init__(self, learner, function: str, rule: str):
        """`rule`: the one that is broken where the function remembers its calls."""
        self._learner, self._function, self._rule = learner, function, rule
        self._call: tuple | None = None

    def note(self, result, *args) -> None:
        """A right result, with the arguments."""
        if self._call is None:
            self._call = result, args

    def check_again(self) -> None:
        """The first call has the same result as before, if there was one."""
        if self._call is None:
            return
        result, args = self._call
        with about(self._rule):
            again = self._learner.call(self._function, *args)
        shown = ', '.join(map(repr, args))
        changed = self._learner.changed(self._function, defaults=True)
        why = f'changes its argument `{changed[0]}`' if changed else 'remembers earlier calls'
        remedy = (
            'work with a copy' if self._learner.changed(self._function) else 'make lists and dictionaries inside of it'
        )
        expect(
            again == result,
            f'{self._function} {why}: {self._function}({shown}) first gave {result!r}, and later, asked the same, '
            f'{again!r}. A default argument, and what is outside of the function, is the same object in all calls: '
            f'{remedy}.',
            self._rule,
        )

    def check_unchanged(self) -> None:
        """No call has changed what was given to it."""
        changed = self._learner.changed(self._function)
        expect(
            not changed,
            f'{self._function} changes `{changed and changed[0]}`, which is given to it and belongs to somebody else: '
            'nothing may be put into it, taken out or sorted there. Work with a copy.',
            self._rule,
        )
