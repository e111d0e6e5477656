"""Do the graders judge rightly? Every chapter's solution, unsolved notebook, wrong solutions and alternatives.

Variants of different exercises share a notebook, so that there are as many runs as the richest exercise has variants.
Of a wrong solution's exercise only the test that must reject it runs, and the one that says the expected words where
that is another. Only some wrong answers to each exercise run, and no alternatives. So the whole suite keeps within its
time; after each change of an exercise or of its tests run this file with COURSE_ALL_TESTS=1 in the environment, which
leaves nothing out.
"""

import os
import re
from dataclasses import dataclass
from itertools import zip_longest
from pathlib import Path

import pytest

from grading import grade, sandbox
from grading.authoring import chapter as chapters
from grading.authoring import notebooks as authored
from grading.submissions import Submission
from helpers import paths
from helpers.exercises import manifest, notebooks, program
from helpers.runner import session

pytestmark = pytest.mark.timeout(600)
SEED = os.environ.get('COURSE_SEED', 'validity')  # another one tries the tests with other inputs
ALL_TESTS = bool(os.environ.get('COURSE_ALL_TESTS'))
SOME = 3  # so many wrong answers of each exercise run by default, the first by name,
SOME_ALONE = 1  # or so many, where each needs a notebook of its own
EXERCISES = manifest.load()
CHAPTERS = {chapters.read(path).number: path for path in chapters.sources(paths.ROOT / 'solutions')}
VARIANTS = {kind: sorted((paths.ROOT / 'grading' / kind).glob('chapter_*/*.py'))
            for kind in ('mutants', 'alternatives')}


@dataclass(frozen=True)
class Variant:
    """A text for an exercise's cell.

    A mutant says what the learner must read (`# expect:`), which hidden test rejects it (`# rejected by:`), and which
    test says those words if that is another (`# told by:`). A line `# alone: REASON` gives a variant a notebook of its
    own: its exercise uses the answers of others, which must be right then.
    """

    name: str
    exercise: str
    source: str
    expected: tuple[str, ...]
    rejected_by: str
    told_by: tuple[str, ...]
    alone: bool

    @classmethod
    def read(cls, path: Path) -> 'Variant':
        text = path.read_text()
        chapter, number, _ = path.stem.split('_', 2)
        source = re.sub(r'^# (expect|rejected by|told by|alone):.*\n', '', text, flags=re.MULTILINE)
        return cls(path.stem, f'{chapter}.{number}', source, tuple(re.findall(r'^# expect: (.+)$', text, re.MULTILINE)),
                   ''.join(re.findall(r'^# rejected by: (.+)$', text, re.MULTILINE)),
                   tuple(re.findall(r'^# told by: (.+)$', text, re.MULTILINE)),
                   bool(re.search(r'^# alone: ', text, re.MULTILINE)))


def layers(kind, number):
    """Variants of different exercises of a chapter, side by side: one notebook each. Some want one of their own."""
    mine = [variant for path in VARIANTS[kind] if (variant := Variant.read(path)).exercise.startswith(f'{number}.')]
    if kind == 'mutants' and not ALL_TESTS:
        mine = [variant for identity in EXERCISES for variant in _some(identity, mine)]
    columns = [[variant for variant in mine if variant.exercise == identity and not variant.alone]
               for identity in EXERCISES]
    rows = [*zip_longest(*columns), *([variant] for variant in mine if variant.alone)]
    return [pytest.param([variant for variant in row if variant], id=str(index)) for index, row in enumerate(rows)]


def _some(identity, variants):
    """The wrong answers to an exercise that run by default."""
    mine = [variant for variant in variants if variant.exercise == identity]
    return mine[:SOME_ALONE if any(variant.alone for variant in mine) else SOME]


def solved(number):
    text = authored.dumps(authored.solved(chapters.read(CHAPTERS[number])))
    return notebooks.parse(text.encode(), CHAPTERS[number].name)


def judge(number, cells, only=None, tests=None):
    chosen = [exercise for exercise in EXERCISES.values() if exercise.chapter == number
              and (only is None or exercise.id in only)]
    launcher = sandbox.launcher('none' if sandbox.problem() else sandbox.DEFAULT)  # as grade does, where it can
    report = session.run(cells, chosen, session.Options(hidden=grade.HIDDEN, processes=2, seed=SEED, launcher=launcher,
                                                        tests=tests or {}))
    assert not report.log
    return {result.id: result for result in report.exercises}


def varied(number, variants):
    """The solved notebook with the variants in place of their exercises."""
    cells = solved(number)
    texts = {variant.exercise: variant.source for variant in variants}
    return [notebooks.Cell(texts.get(program.exercise_id(cell), cell.source), cell.number, cell.id) for cell in cells]


def told(result):
    """What the learner reads about the tests that did not pass."""
    return '\n'.join([result.message, *(f'{test.message}\n{test.expected}' for test in result.tests
                                        if not test.passed)])


class Validity:
    """What holds of every chapter."""

    number: int

    def test_solution_gets_full_marks(self):
        for result in judge(self.number, solved(self.number)).values():
            assert (result.verdict, result.score) == ('passed', result.points), told(result)

    def test_unsolved_notebook_gets_nothing_kindly(self):
        path = paths.NOTEBOOKS / f'{CHAPTERS[self.number].stem}.ipynb'
        work = Submission('ada', path, {path.name: path.read_bytes()})
        mine = tuple(exercise for exercise in EXERCISES.values() if exercise.chapter == self.number)
        for result in grade.judge(work, grade.Course(mine)).exercises:
            assert (result.verdict, result.score) == ('not_attempted', 0)
            assert result.message == f'Exercise {result.id} is not solved yet.'

    def test_wrong_solutions_are_rejected_with_the_right_words(self, mutants):
        named = {variant.exercise: (variant.rejected_by, *variant.told_by) for variant in mutants}
        results = judge(self.number, varied(self.number, mutants), named.keys(), {} if ALL_TESTS else named)
        for variant in mutants:
            result = results[variant.exercise]
            assert variant.expected, f'{variant.name} has no line "# expect: …"'
            assert result.score is not None and result.score < result.points, f'{variant.name} gets full marks'
            rejecting = {test.test.rpartition('::')[2] for test in result.tests if test.hidden and not test.passed}
            assert variant.rejected_by in rejecting, (variant.name, rejecting)
            for fragment in variant.expected:
                assert fragment in told(result), (variant.name, told(result))

    @pytest.mark.thorough
    def test_alternatives_get_full_marks(self, alternatives):
        results = judge(self.number, varied(self.number, alternatives), {variant.exercise for variant in alternatives})
        for variant in alternatives:
            result = results[variant.exercise]
            assert (result.verdict, result.score) == ('passed', result.points), (variant.name, told(result))


# A class for each chapter: pytest-xdist's loadscope gives each to a process of its own.
class TestChapter01(Validity):
    number = 1


class TestChapter02(Validity):
    number = 2


class TestChapter03(Validity):
    number = 3


class TestChapter04(Validity):
    number = 4


class TestChapter05(Validity):
    number = 5


class TestChapter06(Validity):
    number = 6


class TestChapter07(Validity):
    number = 7


class TestChapter08(Validity):
    number = 8


def pytest_generate_tests(metafunc):
    for kind in VARIANTS:
        if kind in metafunc.fixturenames:
            metafunc.parametrize(kind, layers(kind, metafunc.cls.number))


def test_every_chapter_has_its_class():
    assert {one.number for one in Validity.__subclasses__()} == set(CHAPTERS)


def test_there_are_enough_of_them():
    """At least four mutants and one alternative per exercise, and none without an exercise."""
    for kind, least in (('mutants', 4), ('alternatives', 1)):
        exercises = [Variant.read(path).exercise for path in VARIANTS[kind]]
        assert set(exercises) == set(EXERCISES)
        assert all(exercises.count(identity) >= least for identity in EXERCISES), kind


@pytest.mark.parametrize('path', VARIANTS['mutants'] + VARIANTS['alternatives'], ids=lambda path: path.stem)
def test_variants_are_cells(path):
    """Each is recognised as the exercise that its file's name says, and is no stub."""
    variant = Variant.read(path)
    cell = notebooks.Cell(variant.source.lstrip('\n'), 1)
    assert program.exercise_id(cell) == variant.exercise
    assert program.build([cell], EXERCISES[variant.exercise]).cells
