"""Do the graders judge rightly? Every chapter's solution, unsolved notebook, wrong solutions and alternatives.

Variants of different exercises share a notebook, so that there are as many runs as the richest exercise has variants.
Of a wrong solution's exercise only the tests run that look at the rule that it breaks; all of them, if these are not
enough. Only some answers run, drawn by the seed that pytest prints (COURSE_SAMPLE).
COURSE_ALL_TESTS=1 in the environment leaves nothing out. After a change of one exercise `./course answers 3.1` tries
all of its answers.
"""

import math
import os
import random
import re
from itertools import zip_longest

import pytest

from grading import grading_run, reference, trial, variants
from grading.authoring import chapter as chapters
from grading.submissions import Submission
from helpers import paths
from helpers.exercises import file_answers, manifest, notebooks, program
from helpers.runner import verdicts

pytestmark = [pytest.mark.timeout(600), pytest.mark.early]
ALL_TESTS = bool(os.environ.get('COURSE_ALL_TESTS'))
# By default one answer runs to one of so many exercises, drawn anew each time; a solution is judged as it is.
ONE_OF = {'solutions': 8, 'mutants': 8, 'alternatives': 16}
# Their cells make one robot, and 8.10 and 8.11 are judged with all of it: one wrong answer of them in a notebook.
ROBOT = {'8.5', '8.7', '8.8', '8.9', '8.10', '8.11'}
EXERCISES = manifest.load()
COLUMNS = [ROBOT, *({identity} for identity in EXERCISES if identity not in ROBOT)]
CHAPTERS = {int(path.name[:2]): path for path in chapters.sources(paths.ROOT / 'solutions')}
VARIANTS = {
    'mutants': {identity: variants.mutants(identity) for identity in EXERCISES},
    'alternatives': {identity: variants.alternatives(identity) for identity in EXERCISES},
}

EACH_CHAPTER = pytest.mark.parametrize('number', CHAPTERS, ids='chapter_{}'.format)

ANSWERS = {
    kind: [trial.Answer(identity, variant) for identity, found in by_exercise.items() for variant in found]
    for kind, by_exercise in VARIANTS.items()
}


def layers(kind):
    """The notebooks of all chapters with variants of this kind: the chapter's number, and the variants."""
    return [
        pytest.param(number, together, id=f'chapter_{number}-{index}')
        for number in CHAPTERS
        for index, together in enumerate(_layers(kind, number))
    ]


def _layers(kind, number):
    """Variants of different exercises of a chapter, side by side: one notebook each. Some want one of their own."""
    mine = [answer for answer in ANSWERS[kind] if EXERCISES[answer.exercise].chapter == number]
    if not ALL_TESTS:
        some = [answer for together in COLUMNS for answer in _some(kind, together, mine)]
        mine = some or random.Random(os.environ.get('COURSE_SAMPLE')).sample(mine, 1)
    columns = [
        [answer for answer in mine if answer.exercise in together and not answer.variant.alone] for together in COLUMNS
    ]
    rows = [*zip_longest(*columns), *([answer] for answer in mine if answer.variant.alone)]
    return [[answer for answer in row if answer] for row in rows]


def _some(kind, together, answers):
    """The answer to one of these exercises that runs by default, or none."""
    mine = [answer for answer in answers if answer.exercise in together]
    drawn = random.Random(f'{os.environ.get("COURSE_SAMPLE")} {kind} {min(together)}')
    return [drawn.choice(mine)] if mine and not drawn.randrange(ONE_OF[kind]) else []


def some_exercises(number):
    """The exercises of a chapter whose solutions are judged. All of them meet their visible tests in the notebooks."""
    mine = [exercise.id for exercise in EXERCISES.values() if exercise.chapter == number]
    if ALL_TESTS:
        return set(mine)
    drawn = random.Random(f'{os.environ.get("COURSE_SAMPLE")} solutions {number}')
    return set(drawn.sample(mine, math.ceil(len(mine) / ONE_OF['solutions'])))


def judge(number, cells, only=None, tests=None):
    chosen = [
        exercise
        for exercise in EXERCISES.values()
        if exercise.chapter == number and (only is None or exercise.id in only)
    ]
    report = trial.judge(cells, chosen, tests, processes=2)
    assert not report.log
    return {result.id: result for result in report.exercises}


def _idle(exercise, given):
    """An answer whose nodes have the right names and do nothing, and whose functions and methods return `given`."""
    parts = [f'# Exercise {exercise.id}: nothing', 'from rclpy.node import Node']
    for name in exercise.names:
        node = re.sub(r'(?<!^)(?=[A-Z])', '_', name).lower()
        parts.append(
            f"""
class {name}(Node):
    def __init__(self, *arguments, **options):
        super().__init__({node!r})

    def __getattr__(self, name):
        if name.startswith('_'):
            raise AttributeError(name)
        return lambda *arguments, **options: {given}
"""
            if name[0].isupper()
            else f"""
def {name}(*arguments, **options):
    return {given}
"""
        )
    return '\n'.join(parts)


def faults_by_name(answers, results):
    """In what the results of these answers are not as they must be."""
    return {str(answer): found for answer in answers if (found := answer.faults(results[answer.exercise]))}


@pytest.mark.one_of(4)
@EACH_CHAPTER
def test_solution_gets_full_marks(number):
    for result in judge(number, reference.solved(number), some_exercises(number)).values():
        assert not trial.faults_of_right(result), result.id


@EACH_CHAPTER
def test_unsolved_notebook_gets_nothing_kindly(number):
    path = paths.NOTEBOOKS / f'{CHAPTERS[number].stem}.ipynb'
    work = Submission('ada', path, {path.name: path.read_bytes()})
    mine = tuple(exercise for exercise in EXERCISES.values() if exercise.chapter == number)
    for result in grading_run.judge(work, grading_run.Course(mine)).exercises:
        assert (result.verdict, result.score) == ('not_attempted', 0)
        said = (
            'No package was handed in.' if EXERCISES[result.id].folder else f'Exercise {result.id} is not solved yet.'
        )
        assert result.message.startswith(said)


@pytest.mark.one_of(8)
@pytest.mark.parametrize('given', ['None', '[]'])
@EACH_CHAPTER
def test_who_does_nothing_gets_nothing(number, given):
    """A test that asks for silence, or for None, also asks for something that only a program at work does."""
    idle = {
        identity: _idle(EXERCISES[identity], given)
        for identity in some_exercises(number)
        if not any(name.isupper() for name in EXERCISES[identity].names)  # a file has to be written
    }
    if not idle:
        pytest.skip('all exercises that are drawn ask for files')
    cells = [
        notebooks.NotebookCell(idle[identity], cell.number, cell.id)
        if (identity := program.exercise_id(cell)) in idle
        else cell
        for cell in reference.solved(number)
    ]
    passed = {
        identity: [test.test for test in result.tests if test.passed]
        for identity, result in judge(number, cells, set(idle)).items()
        if result.score != 0
    }
    assert not passed


# By the end of a file's name, a line that changes the file and nothing that matters.
HARMLESS = {'.py': 'UNUSED = 1', '.msg': 'bool unused', '.yaml': 'unused: {ros__parameters: {unused: 1}}'}


def _touched(source):
    """A cell as it was given, with something in it that nobody needs: it counts as attempted."""
    lines = []
    for line in source.split('\n'):
        lines.append(line)
        if line.startswith(file_answers.MAGIC):
            lines += [more for ending, more in HARMLESS.items() if line.endswith(ending)]
    return '\n'.join(lines if file_answers.MAGIC in source else [*lines, HARMLESS['.py']])


@pytest.mark.one_of(4)
@EACH_CHAPTER
def test_who_changes_nothing_that_matters_gets_nothing(number):
    """A test that the given cell passes, too, has the mark `given`."""
    path = paths.NOTEBOOKS / f'{CHAPTERS[number].stem}.ipynb'
    mine = {identity for identity in some_exercises(number) if not EXERCISES[identity].folder}
    cells = [
        notebooks.NotebookCell(_touched(cell.source), cell.number, cell.id)
        if program.exercise_id(cell) in mine
        else cell
        for cell in notebooks.parse(path.read_bytes(), path.name)
    ]
    passed = {
        identity: [test.test for test in result.tests if test.passed and not test.given]
        for identity, result in judge(number, cells, mine).items()
        if result.score != 0 or result.verdict == verdicts.INVALID_SUBMISSION
    }
    assert not passed


@pytest.mark.one_of(2)
@pytest.mark.parametrize('number,mutants', layers('mutants'))
def test_wrong_solutions_are_rejected_with_the_right_words(number, mutants):
    named = {} if ALL_TESTS else {answer.exercise: answer.tests() for answer in mutants}
    results = judge(number, trial.varied(number, mutants), {answer.exercise for answer in mutants}, named)
    doubtful = faults_by_name(mutants, results)
    if named:  # a test may also find a rule broken that its mark leaves to others: then all of them are asked
        answers = [answer for answer in mutants if str(answer) in doubtful]
        doubtful = {str(one): found for one in answers if (found := trial.run(EXERCISES[one.exercise], one).faults)}
    assert not doubtful


@pytest.mark.one_of(4)
@pytest.mark.parametrize('number,alternatives', layers('alternatives'))
def test_alternatives_get_full_marks(number, alternatives):
    results = judge(number, trial.varied(number, alternatives), {answer.exercise for answer in alternatives})
    assert not faults_by_name(alternatives, results)


def test_there_are_enough_of_them():
    """At least four mutants and one alternative per exercise, and no folder without an exercise."""
    for kind, least in (('mutants', 4), ('alternatives', 1)):
        assert all(len(found) >= least for found in VARIANTS[kind].values()), kind
    folders = {path.name for path in variants.FOLDER.iterdir() if path.name != '__pycache__'}
    assert folders == {identity.replace('.', '_') for identity in EXERCISES}


@pytest.mark.one_of(2)
@pytest.mark.parametrize('identity', EXERCISES)
def test_variants_are_cells(identity):
    """Each fits the solution, is recognised as its exercise, and is no stub."""
    for kind in VARIANTS.values():
        for answer in (trial.Answer(identity, variant) for variant in kind[identity]):
            cell = notebooks.NotebookCell(answer.source, 1)
            assert program.exercise_id(cell) == identity, answer
            assert program.build([cell], EXERCISES[identity]).cells, answer
