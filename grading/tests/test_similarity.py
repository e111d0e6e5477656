"""Near-duplicates: disguised copies are found, independent and short answers are not."""

import json
import re
from itertools import combinations
from pathlib import Path

import pytest

from grading import similarity
from grading.tests import small
from helpers import paths
from helpers.exercises import manifest

EXERCISES = list(manifest.load().values())
STUBS = similarity.stubs_of(EXERCISES)


def answers() -> dict[str, dict[str, str]]:
    """The right answers of the course, by exercise and author: the solution's and the alternatives."""
    solutions = {path.name: path.read_bytes() for path in (paths.ROOT / 'solutions').glob('*.ipynb')}
    found = {exercise: {'solution': text} for exercise, text in similarity.cells_of(solutions, EXERCISES).items()}
    for path in sorted((paths.ROOT / 'grading' / 'alternatives').rglob('*.py')):
        number = re.match(r'(\d+)_(\d+)_', path.name)
        found.get(f'{number[1]}.{number[2]}', {})[path.stem] = path.read_text()
    return found


ANSWERS = answers()


def disguise(source: str) -> str:
    """A copy with other names, comments, texts, numbers and layout, and with annotations."""
    own = sorted({'count', 'reading', 'message', *re.findall(r'self\.(\w+) =', source)})
    for number, name in enumerate(own):
        source = re.sub(rf'\b{name}\b(?!=)', f'thing_{number}', source)
    source = re.sub(r"'[^'\n]*'", "'another text'", source)
    source = re.sub(r'^(\s*)(def .*)$', r'\1# my own idea\n\1\2', source, flags=re.MULTILINE)
    return source.replace('(self):', '(self) -> None:\n        """Mine."""', 1).replace('\n\n', '\n\n\n# and so on\n')


def pairs(*sources: str, exercise: str = '3.6', stub: str | None = None) -> list[similarity.Pair]:
    given = {exercise: STUBS[exercise] if stub is None else stub}
    return similarity.find({f'l{number:03}': {exercise: source} for number, source in enumerate(sources)}, given)


@pytest.mark.parametrize('exercise', ['3.3', '3.4', '3.6'])
def test_a_disguised_copy_is_found(exercise):
    source = ANSWERS[exercise]['solution']
    copy = disguise(source)
    assert copy != source
    others = [text for author, text in ANSWERS[exercise].items() if author != 'solution']
    pair, = pairs(source, copy, *others, exercise=exercise)
    assert (pair.first, pair.second) == ('l000', 'l001') and pair.share >= similarity.ALIKE


def test_moved_and_extended_parts_are_found():
    source = ANSWERS['3.6']['solution']
    assert pairs(source, 'import math\n\n\ndef unused(x):\n    return [x + 1 for _ in range(3)]\n\n\n' + source)


def test_right_answers_are_not_reported():
    """Not even by one author, who changes only what matters in an alternative."""
    for exercise, texts in ANSWERS.items():
        assert not pairs(*texts.values(), exercise=exercise), exercise


def test_independent_answers_share_little():
    """Those of chapter 3 were written one without the other."""
    independent = {exercise: texts for exercise, texts in ANSWERS.items() if exercise.startswith('3.')}
    assert len(independent) >= 6
    for exercise, texts in independent.items():
        for first, second in combinations(texts, 2):
            own = [similarity.fingerprints(texts[name]) - similarity.fingerprints(STUBS[exercise])
                   for name in (first, second)]
            assert len(own[0] & own[1]) <= 0.5 * max(1, min(map(len, own))), (exercise, first, second)


def test_short_answers_and_stubs_say_nothing():
    assert not pairs(small.TALKER, small.TALKER, stub=small.STUB)
    assert not pairs(*[STUBS['3.6']] * 3)
    assert not pairs('nonsense(', 'nonsense(', stub='')
    assert not pairs('(' * 5000, '(' * 5000, stub='')


def test_what_many_wrote_is_the_usual_answer():
    usual = ANSWERS['3.6']['solution']
    assert not pairs(*[usual] * 20)
    found = pairs(*[usual] * 20, *[ANSWERS['3.6']['3_6_helper_object']] * 2)
    assert [(pair.first, pair.second) for pair in found] == [('l020', 'l021')]


def test_large_classes():
    """300 learners and all exercises: every learner's answer differs, two copied. The work is bounded, not timed."""
    usual = ANSWERS['3.6']['solution']
    mixed = [usual + '\n'.join(f'\n\ndef own_{n}(a):\n    return {"+" if number >> n & 1 else "-"}a * {number}.5 // a'
                               for n in range(9)) for number in range(300)]
    own = ANSWERS['3.6']['3_6_nanoseconds']
    found = pairs(*mixed, own, disguise(own))
    assert ('l300', 'l301') in {(pair.first, pair.second) for pair in found}


def test_cells_of_a_submission():
    other = small.exercise(2)
    files = {small.NOTEBOOK: small.notebook('x = 1', '# Exercise 90.1: a talker\na = 1', '# Exercise 90.2: b\nb = 2'),
             'copy.ipynb': small.notebook('# Exercise 90.2: b\nb = 3'), 'broken.ipynb': b'{',
             'deep.ipynb': b'[' * 99999, 'odd.ipynb': json.dumps({'cells': [{'cell_type': 'code'}]}).encode()}
    assert similarity.cells_of(files, [small.exercise(), other]) == {'90.1': '# Exercise 90.1: a talker\na = 1'}
    assert similarity.stubs_of([small.exercise()]) == {}
    assert set(STUBS) == {exercise.id for exercise in EXERCISES}
    assert Path(paths.NOTEBOOKS).is_dir()
