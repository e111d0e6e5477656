"""`--only`: which learners and exercises a run grades. `ada`, `ada/3.2`, `*/3.2`, `*`."""

from collections.abc import Iterable
from dataclasses import dataclass


class ChoiceError(Exception):
    """A choice names somebody or something unknown."""


@dataclass(frozen=True)
class Choice:
    """Pairs of learner and exercise, with `*` for all. No pair at all: everything."""

    pairs: tuple[tuple[str, str], ...] = ()

    @classmethod
    def parse(cls, texts: Iterable[str], learners: Iterable[str], exercises: Iterable[str]) -> 'Choice':
        """Read what `--only` was given.

        :raises ChoiceError: a learner or exercise is unknown.
        """
        learners, exercises = set(learners), set(exercises)
        pairs = []
        for text in texts:
            learner, _, exercise = text.partition('/')
            if learner != '*' and learner not in learners:
                raise ChoiceError(f'--only {text}: there is no submission of {learner!r}')
            if exercise not in ('', '*') and exercise not in exercises:
                raise ChoiceError(f'--only {text}: there is no exercise {exercise!r}')
            pairs.append((learner, exercise or '*'))
        return cls(tuple(pairs))

    def __contains__(self, pair: tuple[str, str]) -> bool:
        learner, exercise = pair
        return not self.pairs or any(mine in ('*', learner) and its in ('*', exercise) for mine, its in self.pairs)
