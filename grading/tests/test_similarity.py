"""Near-duplicates: disguised copies are found, independent and short answers are not."""

import functools
import json
import re
from itertools import combinations

import pytest

from grading import reader, similarity, variants
from helpers import paths
from helpers.exercises import manifest
from helpers.tests import small

DEEP = 12  # texts in texts
EXERCISES = list(manifest.load().values())
STUBS = similarity.stubs_of(EXERCISES)


@functools.cache
def answers() -> dict[str, dict[str, str]]:
    """The right answers of the course, by exercise and author: the solution's and the alternatives."""
    solutions = {path.name: path.read_bytes() for path in (paths.ROOT / 'solutions').glob('*.ipynb')}
    found = {exercise: {'solution': text} for exercise, text in similarity.cells_of(solutions, EXERCISES).items()}
    solved = variants.solved_cells(paths.ROOT / 'solutions')
    for exercise, texts in found.items():
        texts |= {
            one.name: one.applied(solved[exercise], exercise)
            for one in variants.alternatives(exercise)
            if one.source is not None
        }  # an edit of the solution is a copy of the rest
    return found


def disguise(source: str) -> str:
    """A copy with other names, comments, texts, numbers and layout, and with annotations."""
    own = sorted({'count', 'reading', 'message', *re.findall(r'self\.(\w+) =', source)})
    for number, name in enumerate(own):
        source = re.sub(rf'\b{name}\b(?!=)', f'thing_{number}', source)
    source = re.sub(r"'[^'\n]*'", "'another text'", source)
    source = re.sub(r'^(\s*)(def .*)$', r'\1# my own idea\n\1\2', source, flags=re.MULTILINE)
    return source.replace('(self):', '(self) -> None:\n        """Mine."""', 1).replace('\n\n', '\n\n\n# and so on\n')


def pairs(*sources: str, exercise: str = '3.6', stub: str | None = None) -> list[similarity.Pair]:
    given = {exercise: STUBS[exercise] if stub is None else similarity.fingerprints(stub)}
    return similarity.find(
        {f'l{number:03}': {exercise: similarity.fingerprints(source)} for number, source in enumerate(sources)}, given
    )


@pytest.mark.parametrize('exercise', ['3.3', '3.4', '3.6'])
def test_a_disguised_copy_is_found(exercise):
    source = answers()[exercise]['solution']
    copy = disguise(source)
    assert copy != source
    others = [text for author, text in answers()[exercise].items() if author != 'solution']
    (pair,) = pairs(source, copy, *others, exercise=exercise)
    assert (pair.first, pair.second) == ('l000', 'l001') and pair.share >= similarity.ALIKE


STATEMENT = re.compile(r'^( {8})(?=self\.|if |for |return|[a-z_]+ = )', re.MULTILINE)  # in the body of a method


@pytest.mark.parametrize(
    'change',
    [
        lambda text: STATEMENT.sub(r'\1assert True\n\1', text),
        lambda text: STATEMENT.sub(r'\1_1 = 3\n\1', text),
        lambda text: STATEMENT.sub(r"\1print(end='')\n\1", text),
        lambda text: STATEMENT.sub(r'\1if True:\n\1    pass\n\1', text),
        lambda text: re.sub(r'\b(\d+)\b', r'int(\1)', text),
        lambda text: 'from std_msgs.msg import Float64 as Mine\n' + re.sub(r'\bFloat64\b', 'Mine', text),
    ],
    ids=['assertions', 'names', 'prints', 'branches', 'calls', 'imports'],
)
def test_what_does_nothing_hides_no_copy(change):
    source = answers()['3.6']['solution']
    assert change(source) != source and pairs(source, change(source))


IDLE = [
    '[]',
    'self',
    '0 < 1',
    'lambda: self.x()',
    "f'{self}'",
    'print(self)',
    "self.get_logger().debug('')",
    '_1 = []',
    '_1 = self',
    '_1, _2 = 1, (2, len([]))',
    '_1: int = 0',
    '_1: int',
    '_1 = 0; _2 = _1; _2 += _1',
    'self.unused = []',
    'assert self is not None',
    'if 0: self.x()',
    'if not True or 1 > 2: self.x()',
    'if self: pass',
    'while False: self.x()',
    'while True: break',
    'for _1 in (): self.x()',
    'for _1 in [1, 2]: pass',
    'with suppress(OSError): pass',
    'import os, sys as _1',
    'global _1',
    'del []',
    'class _1: x = 1',
    'if True: _1 = 0',
]


@pytest.mark.parametrize('idle', IDLE)
def test_a_statement_that_does_nothing_hides_no_copy(idle):
    source = answers()['3.6']['solution']
    copy = STATEMENT.sub(lambda match: f'{match[1]}{idle}\n{match[1]}', source)
    assert compile(copy, '3.6', 'exec') and copy.count(idle) > 5
    assert pairs(source, copy)


@pytest.mark.parametrize(
    ('pattern', 'by'),
    [
        (r'^( +)(self\.count = 0)$', r'\1\2\n\1return' + r'\n\1self.x(1, 2).y(3)' * 9),
        (r'^( +)(self\..*[^:,(])$', r'\1def unused():\n\1    self.x()\n\1\2'),
    ],
    ids=['behind-return', 'functions'],
)
def test_code_that_is_never_reached_hides_no_copy(pattern, by):
    source = answers()['3.6']['solution']
    copy = re.sub(pattern, by, source, flags=re.MULTILINE)
    assert copy != source and compile(copy, '3.6', 'exec') and pairs(source, copy)


def as_notebook(*cells: str) -> dict[str, bytes]:
    return {'03_nodes_and_topics.ipynb': small.notebook(*cells)}


def test_an_answer_in_several_cells_is_found():
    """A note with the heading, a try, a class above the answer, an answer over two cells: as grading takes them."""
    heading, body = answers()['3.6']['solution'].split('\n', 1)
    whole = as_notebook(f'{heading}\n{body}')
    copies = [
        as_notebook(f'{heading}\n{body}', f'{heading}\n# a note'),
        as_notebook(f'{heading}\n{body}', f'{heading}\nprint(1)'),
        as_notebook(body.replace('RateMonitor', 'Mine'), f'{heading}\nclass RateMonitor(Mine):\n    pass'),
        as_notebook(f'{heading}\nimport math', body),
    ]
    exercise = [one for one in EXERCISES if one.id == '3.6']
    for copy in copies:
        prints = [similarity.fingerprints(similarity.cells_of(files, exercise)['3.6']) for files in (whole, copy)]
        assert similarity.find(dict(enumerate({'3.6': marks} for marks in prints)), STUBS), copy


def test_given_cells_and_other_answers_do_not_count():
    given = [cell.source for cell in similarity._code((paths.NOTEBOOKS / '03_nodes_and_topics.ipynb').read_bytes())]
    cells = ['# Exercise 3.6: x\nclass RateMonitor(Beacon):\n    pass', answers()['3.1']['solution'], *given[:12]]
    exercise = [one for one in EXERCISES if one.id == '3.6']
    assert similarity.cells_of(as_notebook(*cells), exercise)['3.6'].strip() == cells[0]


def test_moved_and_extended_parts_are_found():
    source = answers()['3.6']['solution']
    assert pairs(source, 'import math\n\n\ndef unused(x):\n    return [x + 1 for _ in range(3)]\n\n\n' + source)


def test_right_answers_are_not_reported():
    """Not even by one author, who changes only what matters in an alternative."""
    for exercise, texts in answers().items():
        assert not pairs(*texts.values(), exercise=exercise), exercise


def test_independent_answers_share_little():
    """Those of chapter 3 were written one without the other."""
    independent = {exercise: texts for exercise, texts in answers().items() if exercise.startswith('3.')}
    assert len(independent) >= 6
    for exercise, texts in independent.items():
        for first, second in combinations(texts, 2):
            own = [similarity.fingerprints(texts[name]) - STUBS[exercise] for name in (first, second)]
            assert len(own[0] & own[1]) <= 0.5 * max(1, min(map(len, own))), (exercise, first, second)


def test_short_answers_and_stubs_say_nothing():
    assert not pairs(small.TALKER, small.TALKER, stub=small.STUB)
    assert not similarity.find({f'l{number}': {'3.6': STUBS['3.6']} for number in range(3)}, STUBS)
    assert not pairs('nonsense(', 'nonsense(', stub='')
    assert not pairs('(' * 5000, '(' * 5000, stub='')


def test_what_many_wrote_is_the_usual_answer():
    usual = answers()['3.6']['solution']
    assert not pairs(*[usual] * 20)
    found = pairs(*[usual] * 20, *[answers()['3.6']['helper_object']] * 2)
    assert [(pair.first, pair.second) for pair in found] == [('l020', 'l021')]


def test_large_classes():
    """300 learners and all exercises: every learner's answer differs, two copied. The work is bounded, not timed."""
    usual = answers()['3.6']['solution']
    mixed = [
        usual
        + '\n'.join(
            f'\n\ndef own_{n}(a):\n    return {"+" if number >> n & 1 else "-"}a * {number}.5 // a' for n in range(9)
        )
        for number in range(300)
    ]
    own = answers()['3.6']['nanoseconds']
    found = pairs(*mixed, own, disguise(own))
    assert ('l300', 'l301') in {(pair.first, pair.second) for pair in found}


YAML = """\
/**:
  ros__parameters:
    rate: 20.0
    max_linear: 0.4
    mode: "careful"
    limits: [0.1, 0.2, 0.3]
    frames: {base: base_link, laser: laser_frame, camera: camera_frame}
""" + ''.join(
    f'robot{n}:\n  {kind}:\n    ros__parameters: {{slow_{n}: 0.1, fast_{kind}: 0.9, behind: true}}\n'
    for n, kind in enumerate(('governor', 'camera', 'laser', 'arm', 'map', 'wheel'))
)
TEXTS = {
    'YAML': YAML,
    'XML': '<robot name="r">\n'
    + ''.join(
        f'  <link name="{name}"><visual><geometry><{shape}/></geometry></visual>\n'
        for name, shape in zip('abcdefgh', ('box', 'sphere') * 4, strict=True)
    ),
    'CMake': '\n'.join(
        f'{word}({"REQUIRED" if n % 2 else "DEPENDS"} {word}_thing part_{word}_{n})'
        for n, word in enumerate(
            (
                'find_package',
                'install',
                'ament_export',
                'rosidl_generate',
                'add_library',
                'target_link',
                'enable_testing',
                'project',
                'include',
                'macro',
            )
            * 3
        )
    ),
}


@pytest.mark.parametrize('kind', ['Python', *TEXTS])
@pytest.mark.parametrize('form', ['ANSWER = {!r}', 'exec({!r})', 'def make():\n    return {!r}'])
def test_answers_that_are_texts_are_looked_into(kind, form):
    """A copy of a text, with other numbers and comments, is found; two texts that have nothing in common are not."""
    text = answers()['3.6']['solution'] if kind == 'Python' else TEXTS[kind]
    copy = '# my own idea\n' + re.sub(r'\b\d\.\d', '0.77', text)
    (pair,) = pairs(form.format(text), form.format(copy), stub='')
    assert (pair.first, pair.second) == ('l000', 'l001')
    other = TEXTS['XML' if kind == 'YAML' else 'YAML']
    assert not pairs(form.format(text), form.format(other), stub='')


def test_texts_within_texts_do_not_hide_an_answer():
    """So many that what looks into them comes to its end: the rest of the cell is compared all the same."""
    text = 'x\ny'
    for _ in range(6):
        text = f'x = {text!r}{" + 1" * 250}\ny'
    answer = answers()['3.6']['solution']
    assert pairs(answer, f'{disguise(answer)}\n{text}')


def test_texts_within_texts_are_looked_into_once(monkeypatch):
    """A copy that takes too long to be compared would be no copy."""
    read = []

    def tree(text):
        read.append(text)
        assert len(read) <= 2 * DEEP, 'texts in texts are looked into again and again'
        return syntax_tree(text)

    syntax_tree = similarity.cell_python.syntax_tree
    monkeypatch.setattr(similarity.cell_python, 'syntax_tree', tree)
    text = 'x = 1\ny = 2\n'
    for _ in range(DEEP):
        text = f'exec({text!r})\nz = 1\n'
    similarity.fingerprints(text)
    assert len(read) > DEEP


def test_what_takes_too_much_costs_its_own_exercise_and_is_told(monkeypatch):
    exercises = [small.exercise(number) for number in range(1, 6)]
    asked = []

    def ask(task, files, some):
        asked.append([one.id for one in some])
        if len(some) > 1 or some[0].id in hard:
            raise reader.TooMuch('x')
        return {some[0].id: [1, 2]}, []

    monkeypatch.setattr(reader, 'ask', ask)
    hard = {'90.2'}
    found = similarity.of_submission({}, exercises)
    assert found == {'90.2': None, **{one: [1, 2] for one in ('90.1', '90.3', '90.4', '90.5')}}
    (note,) = similarity.not_compared({'ada': found, 'bob': {'90.1': []}})
    assert note['learner'] == 'ada' and note['text'].startswith('90.2: it takes too much')
    assert similarity.find({'ada': found, 'bob': found}, {}) == []
    hard = {one.id for one in exercises}
    asked.clear()
    assert set(similarity.of_submission({}, exercises).values()) == {None}
    assert len(asked) == 1 + similarity.MOST_TOO_MUCH


FORMS = {
    'long-number': lambda book: json.dumps({**book, 'x': 7}).replace('"x": 7', f'"x": {"9" * 5000}'),
    'nan': lambda book: json.dumps({**book, 'x': float('nan')}),
    'bom': lambda book: '\ufeff' + json.dumps(book),
    'format-3': lambda book: json.dumps({
        'nbformat': 3, 'nbformat_minor': 0, 'metadata': {'name': ''},
        'worksheets': [{'metadata': {}, 'cells': [
            {'cell_type': 'code', 'language': 'python', 'metadata': {}, 'outputs': [], 'input': cell['source']}
            for cell in book['cells']
        ]}],
    }),
}  # fmt: skip


@pytest.mark.parametrize('form', FORMS)
def test_what_can_be_graded_is_compared(form):
    """However the notebook is written."""
    exercise = [one for one in EXERCISES if one.id == '3.6']
    files = as_notebook(answers()['3.6']['solution'])
    ((name, data),) = files.items()
    other = {name: FORMS[form](json.loads(data)).encode()}
    assert similarity.cells_of(other, exercise) == similarity.cells_of(files, exercise) != {}


def test_a_cell_without_its_heading_is_the_exercises(tmp_path):
    """By its id, as in grading."""
    exercise = small.exercise()
    book = json.loads(small.notebook('a = 1'))
    book['cells'][0]['id'] = exercise.cell_id
    assert similarity.cells_of({small.NOTEBOOK: json.dumps(book).encode()}, [exercise]) == {'90.1': 'a = 1'}


def test_what_was_given_does_not_count_in_texts():
    assert not pairs(*[f'ANSWER = {YAML!r}'] * 2, stub=f'ANSWER = {YAML!r}')


def test_a_package_counts_with_what_the_learner_wrote_in_it():
    exercise = small.exercise(names=('PACKAGE',), folder='my_ws/src/patrol')
    files = {
        'patrol/route.py': 'x = 1', 'setup.py': 'setup()', 'test/test_flake8.py': 'y', 'LICENSE': 'long', 'a.txt': 'z',
    }  # fmt: skip
    handed_in = {f'my_ws/src/patrol/{name}': text.encode() for name, text in files.items()}
    handed_in['my_ws/src/patrol/other.ipynb'] = small.notebook('# Exercise 90.2: b\nb = 2')
    assert similarity.cells_of(handed_in, [exercise, small.exercise(2)]) == {
        '90.1': "# Exercise 90.1: a talker\nPACKAGE = {\n    'patrol/route.py': 'x = 1',\n}\n"
    }


def test_cells_of_a_submission():
    other = small.exercise(2)
    files = {
        small.NOTEBOOK: small.notebook('x = 1', '# Exercise 90.1: a talker\na = 1', '# Exercise 90.2: b\nb = 2'),
        'copy.ipynb': small.notebook('# Exercise 90.2: b\nb = 3'),
        'broken.ipynb': b'{',
        'deep.ipynb': b'[' * 99999,
        'odd.ipynb': json.dumps({'cells': [{'cell_type': 'code'}]}).encode(),
    }
    first, second = '# Exercise 90.1: a talker\na = 1', '# Exercise 90.2: b\nb = 2'
    assert similarity.cells_of(files, [small.exercise(), other]) == {'90.1': first, '90.2': second}
    doubled = {'a.ipynb': files[small.NOTEBOOK], 'copy.ipynb': files['copy.ipynb']}
    assert similarity.cells_of(doubled, [small.exercise(), other]) == {'90.1': first}
    assert similarity.stubs_of([small.exercise()]) == {}
    assert set(STUBS) == {exercise.id for exercise in EXERCISES}
    assert paths.NOTEBOOKS.is_dir()
