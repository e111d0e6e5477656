"""Tries the tests of exercises on answers of which it is known what they are worth: does the judgement fit?

The solution and the alternatives must keep every rule. A mutant must be rejected by a visible and by a hidden test.
Each says which rule is broken: the one that the mutant names, and no other. The learner
reads the expected words.
"""

import os
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field

from grading import sandbox, variants
from grading.authoring import coverage
from grading.course import HIDDEN
from grading.reference import solved
from helpers import paths
from helpers.exercises import manifest, notebooks, program
from helpers.exercises.manifest import Exercise
from helpers.runner import results, session
from helpers.runner.results import ExerciseResult, TestResult

SEED = os.environ.get('COURSE_SEED', 'validity')  # another one tries the tests with other inputs


@dataclass(frozen=True)
class Answer:
    """A mutant or an alternative, with the text that it gives the exercise's cell."""

    exercise: str
    variant: variants.Variant

    def __str__(self):
        return f'{self.exercise} {self.variant.name}'

    @property
    def source(self) -> str:
        return self.variant.applied(variants.solved_cells(paths.ROOT / 'solutions')[self.exercise], self.exercise)

    def tests(self) -> set[str]:
        """The names of the visible and hidden tests that look at the rule which this mutant breaks."""
        assert isinstance(self.variant, variants.Mutant)
        return {test for marks in self._marks() for test in marks.looks.get(self.variant.breaks, ())}

    def _marks(self) -> tuple[coverage.Marks, coverage.Marks]:
        return coverage.marks(manifest.load()[self.exercise], manifest.MANIFEST.parent)

    def faults(self, result: ExerciseResult) -> list[str]:
        """In what the result of this answer is not as it must be."""
        if isinstance(self.variant, variants.Mutant):
            return list(_faults_of_mutant(self.variant, result, self._marks()[0].not_looked_at))
        return faults_of_right(result)


@dataclass
class Trial:
    """One answer, and what became of it."""

    answer: Answer | None  # None: the solution
    result: ExerciseResult
    log: list[str] = field(default_factory=list)
    faults: list[str] = field(default_factory=list)

    @property
    def name(self) -> str:
        return self.answer.variant.name if self.answer else 'the solution'


def answers(exercise: str, names: Iterable[str] = ()) -> list[Answer]:
    """The mutants and alternatives of an exercise; only those called so, if there are names.

    :raises grading.variants.VariantError: their files are wrong, or an edit does not fit the solution.
    :raises LookupError: none has such a name.
    """
    found = [Answer(exercise, one) for one in (*variants.mutants(exercise), *variants.alternatives(exercise))]
    wanted = set(names)
    if unknown := wanted - {answer.variant.name for answer in found}:
        raise LookupError(f'exercise {exercise} has no mutant or alternative {min(unknown)!r}')
    chosen = [answer for answer in found if not wanted or answer.variant.name in wanted]
    solved = variants.solved_cells(paths.ROOT / 'solutions')[exercise] if chosen else ''
    for answer in chosen:
        answer.variant.applied(solved, exercise)
    return chosen


def run(exercise: Exercise, answer: Answer | None, seed: str = SEED) -> Trial:
    """Judge an answer, or the solution, with all tests of its exercise."""
    cells = varied(exercise.chapter, [answer] if answer else [])
    report = judge(cells, [exercise], seed=seed)
    trial = Trial(answer, report.exercises[0], report.log)
    trial.faults = [
        *(f'log: {line}' for line in report.log),
        *(answer.faults(trial.result) if answer else faults_of_right(trial.result)),
    ]
    return trial


def judge(
    cells,
    exercises: Iterable[Exercise],
    tests: Mapping[str, Iterable[str]] | None = None,
    processes: int = 1,
    seed: str = SEED,
) -> session.SessionReport:
    """Run the visible and hidden tests on a notebook's cells, in the sandbox where there is one, as `grade` does."""
    launcher = sandbox.launcher('none' if sandbox.problem() else sandbox.DEFAULT)
    return session.run(
        cells,
        exercises,
        session.Options(hidden=HIDDEN, processes=processes, seed=seed, launcher=launcher, tests=tests or {}),
    )


def varied(number: int, changed: Iterable[Answer]) -> list[notebooks.NotebookCell]:
    """A chapter's solved notebook with these answers in place of the solutions."""
    texts = {answer.exercise: answer.source for answer in changed}
    return [
        notebooks.NotebookCell(texts.get(program.exercise_id(cell) or '', cell.source), cell.number, cell.id)
        for cell in solved(number)
    ]


def told(result: ExerciseResult) -> str:
    """What the learner reads about the tests that did not pass."""
    return '\n'.join(
        [result.message, *(f'{test.message}\n{test.expected}' for test in result.tests if not test.passed)]
    )


def name_of(test: TestResult) -> str:
    """The test's function, with its parameters."""
    return test.test.rpartition('::')[2]


def faults_of_right(result: ExerciseResult) -> list[str]:
    """In what the result of a right answer falls short."""
    if (result.verdict, result.score) != ('passed', result.points):
        return [f'a right answer gets {result.score} of {result.points} points: {told(result).strip()}']
    return [f'the rule {rule.name} is not proved: {rule.why}' for rule in result.rules if rule.state != results.KEPT]


def _faults_of_mutant(mutant: variants.Mutant, result: ExerciseResult, not_looked_at: Iterable[str]) -> Iterator[str]:
    failed = [test for test in result.tests if not test.passed]
    if result.score is None or result.score >= result.points:
        yield 'it gets full marks' if result.score is not None else 'it gets no mark'
        return
    if not mutant.expect:
        yield 'it does not say what the learner must read: expect='
    for fragment in mutant.expect:
        if fragment not in told(result):
            yield f'the learner does not read {fragment!r}, but: {told(result).strip()}'
    rejecting = [test for test in failed if test.rule in (mutant.breaks, *mutant.also)]
    unseen = mutant.breaks in not_looked_at
    for kind in ('hidden',) if unseen else ('visible', 'hidden'):
        if not any(test.hidden is (kind == 'hidden') for test in rejecting):
            names = sorted(
                f'{name_of(test)} ({test.rule or "no rule"})' for test in failed if test.hidden is (kind == 'hidden')
            )
            yield f'no {kind} test says that the rule {mutant.breaks!r} is broken; these reject it: {names}'
    seen = [test.message for test in failed if not test.hidden]
    for fragment in () if unseen else mutant.expect:
        if not any(fragment in message for message in seen):
            yield f'no visible test says {fragment!r}'
    for test in failed:
        if test.rule not in (mutant.breaks, *mutant.also):
            yield f'{name_of(test)} names {test.rule or "no rule"}: {test.message}'
