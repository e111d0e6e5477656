"""What the learner's tests notice, of exercises 8.4, 8.6 and 8.11: right programs pass, wrong ones of each kind fail.

`planted` runs the tests with each program. Here it is said how many they noticed, by kind.
"""

import re
from dataclasses import dataclass, field

from helpers.checks.chapter_08.planted import ENDED, OWN, Subject, TestsOutcome, judge
from helpers.runner import about, expect


@dataclass(frozen=True)
class Kind:
    """Wrong programs of one kind: `rule` of the card, what they do in `words`, and name → text of each."""

    rule: str
    words: str
    programs: dict = field(hash=False)


@dataclass(frozen=True)
class Planted:
    """All programs that are run at once, so that one run tells all.

    `right` and `nothing`: name → text; a name says what is special. Programs in `nothing` do nothing.
    `rule`: that of the card for right programs. `told`: these programs are no secret, so the learner may read what
    the tests say of them.
    """

    subject: Subject
    rule: str
    right: dict = field(hash=False)
    nothing: dict = field(hash=False)
    kinds: tuple[Kind, ...] = ()
    told: bool = False

    def outcomes(self, learner) -> dict[str, TestsOutcome]:
        """How the learner's tests end with each program; with some only, if they do not pass with a right one."""
        wrong = {name: text for kind in self.kinds for name, text in kind.programs.items()}
        with about(self.rule):
            return judge(learner, self.right, {**self.nothing, **wrong}, self.subject, told=self.told)

    def accepts(self, learner) -> None:
        """Fail unless the tests pass with each right program, and with one that does nothing not."""
        outcomes = self.outcomes(learner)
        self._right(outcomes)
        expect(
            any(outcomes[name].status == 1 for name in self.nothing),
            f'Your tests pass with every {self.subject.what}, whatever it does: they assert nothing.',
            self.rule,
        )

    def rejects(self, learner, rule: str) -> None:
        """Fail unless the tests notice each wrong program of the kind with this rule."""
        outcomes, what = self.outcomes(learner), self.subject.what
        self._right(outcomes)
        kind = next(kind for kind in self.kinds if kind.rule == rule)
        missed = [name for name in kind.programs if outcomes[name].status == 0]
        stuck = [name for name in kind.programs if outcomes[name].status == ENDED]
        expect(
            not stuck,
            f'With a {what} {stuck and stuck[0]}, your tests do not end. Give each wait and each loop a bound.',
            rule,
        )
        every = [name for one in self.kinds for name in one.programs]
        seen, count = sum(outcomes[name].status == 1 for name in every), len(kind.programs)
        of_these = 'none' if len(missed) == count else str(count - len(missed))
        expect(
            not missed,
            f'Your tests notice {seen} of {len(every)} wrong {what}s: {of_these} of the {count} {kind.words}. They '
            f'all pass with a {what} {missed and missed[0]}.',
            rule,
        )

    def _advice(self, reason: str) -> str:
        """What to do about tests that fail with a right program; `reason`: what pytest said, if it may be told."""
        asked = f'sk for nothing that is not in the {self.subject.said}.'
        if self.subject.ros:
            return f'Wait for what must come, and a{asked}'
        if re.search(r': ValueError\b', reason):
            return f'If it is to be raised, the call stands within `with pytest.raises(ValueError):`. A{asked}'
        compared = ' == ' in reason and '±' not in reason and 'approx(' not in reason
        return f'Compare computed numbers with pytest.approx, and a{asked}' if compared or not reason else f'A{asked}'

    def _right(self, outcomes: dict[str, TestsOutcome]) -> None:
        """Fail unless the tests pass with each right program."""
        what, said = self.subject.what, self.subject.said
        for name in (name for name in self.right if name in outcomes):  # after one that fails no other one is run
            outcome = outcomes[name]
            expect(
                outcome.status != ENDED,
                f'Your tests did not end in {self.subject.limit:g} s with a right '
                f'{what} ({name}). Give each wait and each loop a bound.',
                self.rule,
            )
            missing = outcome.missing_name if self.told else ''
            saw = f' This failed: {outcome.reason}.' if self.told and outcome.reason else ''
            expect(
                outcome.status == 0 or name != OWN,
                f'A test of yours fails with your own {what}.{saw} '
                + (missing or f'Is the {what} wrong, or the test?'),
                self.rule,
            )
            why = missing or self._advice(outcome.reason if self.told else '')
            expect(
                outcome.status == 0,
                f'A test of yours fails with a {what} that does what its {said} says ({name}).{saw} {why}',
                self.rule,
            )
