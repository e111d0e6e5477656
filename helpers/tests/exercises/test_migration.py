"""A learner's work goes from the notebooks of one version into those of the next, and none of it is lost."""

import json
import os
import shutil
from dataclasses import replace

import nbformat
import pytest

from helpers import paths
from helpers.cli import app
from helpers.exercises import cell_ids, manifest, migration
from helpers.exercises.migration_report import MigrationError

STUB = '# Exercise 3.1: a beacon\ndef beacon():\n    # Your code here.\n    pass'
ANSWER = STUB.replace('    # Your code here.\n    pass', '    return 42')
NAME = '03_topics.ipynb'


def given(text, kind='markdown'):
    return {'id': cell_ids.of_given(kind, text), 'cell_type': kind, 'metadata': {}, 'source': text}


def own(text, identity='0f0f0f0f', kind='code'):
    return {'id': identity, 'cell_type': kind, 'metadata': {}, 'source': text}


def exercise(text=STUB, number='3.1', names=('beacon',), points=10):
    return {
        'id': cell_ids.of_exercise(number),
        'cell_type': 'code',
        'source': text,
        'metadata': {'exercise': {'id': number, 'names': list(names), 'points': points}},
    }


CARD = given('### Exercise 3.1: a beacon\n\nReturn 42.')
TITLE, MIDDLE, END = given('# 3 Topics'), given('print(1)', 'code'), given('The end.')
KNOWN = manifest.Exercise('3.1', 3, NAME, 'a beacon', 10, ('beacon',), 'ex-3-1', manifest.stub_digest(STUB))


class Case:
    """An old and a new version in two folders."""

    def __init__(self, folder):
        self.old, self.new = folder / 'old' / 'notebooks', folder / 'new' / 'notebooks'
        self.old.mkdir(parents=True)
        self.new.mkdir(parents=True)
        self.known = [KNOWN]

    def write(self, folder, cells, name=NAME):
        cells = [dict(cell, outputs=[], execution_count=7) if cell['cell_type'] == 'code' else cell for cell in cells]
        text = nbformat.writes(nbformat.from_dict({'cells': cells, 'metadata': {}, 'nbformat': 4, 'nbformat_minor': 5}))
        (folder / name).write_text(text)

    def migrate(self, old, new, **options):
        self.write(self.old, old)
        self.write(self.new, new)
        return self.again(**options)

    def again(self, **options):
        return migration.migrate(self.old.parent, self.new, known={one.id: one for one in self.known}, **options)

    def cells(self, name=NAME):
        return json.loads((self.new / name).read_text())['cells']

    def sources(self, name=NAME):
        return [''.join(cell['source']) for cell in self.cells(name)]


@pytest.fixture
def case(tmp_path):
    return Case(tmp_path)


def said(report):
    return {one.exercise: one.said for one in report.exercises}


def test_an_answer_and_own_cells_are_carried_over(case):
    report = case.migrate(
        [
            TITLE,
            own('x = 1', 'mine0001'),
            MIDDLE,
            own('y', 'mine0002'),
            own('z', 'mine0003', 'markdown'),
            CARD,
            exercise(ANSWER),
            END,
        ],
        [TITLE, given('New.'), MIDDLE, CARD, exercise(), END],
    )
    assert case.sources() == [
        TITLE['source'],
        'x = 1',
        'New.',
        MIDDLE['source'],
        'y',
        'z',
        CARD['source'],
        ANSWER,
        END['source'],
    ]
    assert said(report) == {'3.1': 'carried over'}
    assert report.own == {NAME: 3}
    assert case.cells()[1]['execution_count'] is None


def test_what_was_there_is_in_the_backup(case):
    report = case.migrate([exercise(ANSWER)], [exercise(), END])
    before = json.loads((report.backup / NAME).read_text())
    assert [cell['source'] for cell in before['cells']] == [STUB.splitlines(keepends=True), ['The end.']]
    assert report.written == [case.new / NAME]


def test_a_dry_run_writes_nothing(case):
    report = case.migrate([exercise(ANSWER)], [exercise()], dry_run=True)
    assert said(report) == {'3.1': 'carried over'}
    assert case.sources() == [STUB] and report.backup is None
    assert [path.name for path in case.new.iterdir()] == [NAME]


def test_a_second_run_changes_nothing(case):
    old = [TITLE, own('x = 1'), exercise(ANSWER), exercise('# Exercise 3.9: gone\n1', '3.9')]
    case.migrate(old, [TITLE, exercise()])
    first = (case.new / NAME).read_bytes()
    report = case.again()
    assert (case.new / NAME).read_bytes() == first
    assert report.backup is None and said(report)['3.1'] == 'has this answer already'


def test_an_untouched_stub_leaves_the_new_one(case):
    newer = STUB.replace('pass', 'return 0')
    case.known = [replace(KNOWN, stub=manifest.stub_digest(newer))]
    checks = case.old.parent / 'helpers' / 'checks'
    checks.mkdir(parents=True)
    (checks / 'exercises.json').write_text(manifest.dumps([KNOWN]))
    report = case.migrate([exercise()], [exercise(newer)])
    assert case.sources() == [newer]
    assert said(report) == {'3.1': 'was not attempted; the new notebook stays as it is'}


def test_what_has_changed_is_said_and_the_new_stub_kept(case):
    newer = STUB.replace('pass', 'return 0').replace('beacon', 'light')
    case.known = [
        replace(KNOWN, title='a light', names=('light', 'beacon'), points=15, stub=manifest.stub_digest(newer))
    ]
    checks = case.old.parent / 'helpers' / 'checks'
    checks.mkdir(parents=True)
    (checks / 'exercises.json').write_text(manifest.dumps([KNOWN]))
    report = case.migrate([CARD, exercise(ANSWER)], [given('### Exercise 3.1: a light'), exercise(newer)])
    assert said(report) == {
        '3.1': 'carried over; changed since: the title, now "a light"; its text: read it again; '
        'points, 10 → 15; it asks for light, beacon, no longer for beacon; what is given, '
        'which stands below your answer as a raw cell'
    }
    _, answer, raw = case.cells()
    assert ''.join(answer['source']) == ANSWER.replace('Exercise 3.1: a beacon', 'Exercise 3.1: a light')
    assert raw['cell_type'] == 'raw' and newer in ''.join(raw['source'])


@pytest.mark.parametrize('listed', [True, False])
def test_an_answer_in_quotes_is_taken_over_as_it_is(case, listed):
    """Such an answer counts as before; what a cell with files looks like stands below it."""
    old = "# Exercise 3.1: a beacon\nbeacon = '''\n# Your code here.\n'''"
    newer = '# Exercise 3.1: a beacon\n%%answer beacon a_ws/a.py\n# Your code here.'
    case.known = [replace(KNOWN, stub=manifest.stub_digest(newer))]
    if listed:
        checks = case.old.parent / 'helpers' / 'checks'
        checks.mkdir(parents=True)
        (checks / 'exercises.json').write_text(manifest.dumps([replace(KNOWN, stub=manifest.stub_digest(old))]))
    else:
        case.known = [replace(case.known[0], earlier=(manifest.stub_digest(old)[:16],))]
    assert said(case.migrate([exercise(old)], [exercise(newer)])) == {
        '3.1': 'was not attempted; the new notebook stays as it is'
    }
    answer = old.replace('# Your code here.', 'print(1)')
    report = case.migrate([exercise(answer)], [exercise(newer)])
    assert said(report)['3.1'] == (
        'carried over; changed since: what is given, which stands below your answer as a raw cell; '
        'files now stand below lines `%%answer NAME FILE`; your answer in quotes counts as before, '
        'but running it does not write the file'
    )
    assert case.sources()[0] == answer and newer in case.sources()[1]


def test_an_answer_with_files_is_taken_over(case):
    given_cell = '# Exercise 3.1: a beacon\n%%answer beacon a_ws/a.py\n# Your code here.'
    case.known = [replace(KNOWN, stub=manifest.stub_digest(given_cell))]
    assert said(case.migrate([exercise(given_cell)], [exercise(given_cell)])) == {
        '3.1': 'was not attempted; the new notebook stays as it is'
    }
    answer = given_cell.replace('# Your code here.', 'print(1)')
    assert said(case.migrate([exercise(answer)], [exercise(given_cell)])) == {'3.1': 'carried over'}
    assert case.sources() == [answer]


def test_an_exercise_that_has_moved_is_found_by_its_title(case):
    moved = replace(KNOWN, id='3.2', cell_id='ex-3-2')
    other = replace(KNOWN, title='new', names=('new',), stub='')
    case.known = [other, moved]
    stub = STUB.replace('3.1', '3.2')
    report = case.migrate([exercise(ANSWER)], [exercise('# Exercise 3.1: new\nnew = 1'), exercise(stub, '3.2')])
    assert said(report) == {'3.2': 'carried over (it was 3.1)'}
    assert case.sources() == ['# Exercise 3.1: new\nnew = 1', ANSWER.replace('3.1', '3.2')]


@pytest.mark.parametrize('known', [[], [replace(KNOWN, title='another', names=('other',))]])
def test_an_answer_without_an_exercise_becomes_a_raw_cell(case, known):
    case.known = known
    report = case.migrate([TITLE, exercise(ANSWER), END], [TITLE, END])
    assert report.exercises[0].lost and 'kept as a raw cell' in report.exercises[0].said
    assert [cell['cell_type'] for cell in case.cells()] == ['markdown', 'raw', 'markdown']
    assert case.sources()[1].endswith(ANSWER)


def test_another_answer_in_the_new_notebook_stays(case):
    better = ANSWER.replace('42', '43')
    report = case.migrate([exercise(ANSWER)], [exercise(better), END])
    assert report.exercises[0].lost and 'has another answer already' in report.exercises[0].said
    assert case.sources()[0] == better and case.sources()[1].endswith(ANSWER)


def test_a_given_cell_that_the_learner_changed_keeps_the_change(case):
    changed = dict(MIDDLE, source='print(2)')
    case.migrate([TITLE, changed], [TITLE, MIDDLE])
    assert case.sources() == [TITLE['source'], 'print(2)']


def test_a_doubled_exercise_is_named(case):
    report = case.migrate([exercise(ANSWER), own(ANSWER)], [exercise()])
    assert report.exercises[0].lost and 'is there 2 times' in report.exercises[0].said
    assert case.sources() == [STUB]


def test_a_cell_that_tries_an_answer_is_one_of_ones_own(case):
    """Although it has the exercise's heading."""
    trial = own('# Exercise 3.1: a beacon\nassert beacon() == 42')
    report = case.migrate([TITLE, exercise(ANSWER), trial], [TITLE, exercise(), END])
    assert not report.exercises[0].lost and report.own == {NAME: 1}
    assert case.sources() == [TITLE['source'], ANSWER, trial['source'], END['source']]


def test_a_notebook_without_ids_gives_its_exercises(case):
    case.write(case.new, [TITLE, exercise()])
    cells = [
        {'cell_type': 'code', 'metadata': {}, 'source': source, 'outputs': [], 'execution_count': None}
        for source in ('mine = 1', ANSWER)
    ]
    (case.old / NAME).write_text(json.dumps({'cells': cells, 'metadata': {}, 'nbformat': 4, 'nbformat_minor': 4}))
    report = case.again()
    assert case.sources() == [TITLE['source'], ANSWER]
    assert 'lost their ids' in report.notes[0]


def test_foreign_ids_make_no_given_cell_a_learners_own(case):
    changed = dict(given('Text that is new in this version.'))
    report = case.migrate(
        [dict(TITLE, id='f1'), dict(MIDDLE, id='f2'), dict(exercise(ANSWER), id='f3')], [TITLE, changed, exercise()]
    )
    assert case.sources() == [TITLE['source'], changed['source'], ANSWER]
    assert 'lost their ids' in report.notes[0]


def test_a_cell_that_was_changed_in_both_is_there_twice(case):
    case.migrate([TITLE, own('x = 1')], [TITLE])
    case.write(case.old, [TITLE, own('x = 2')])
    case.again()
    assert case.sources() == [TITLE['source'], 'x = 1', 'x = 2']
    assert case.again().backup is None


def test_workspaces_are_named(case):
    (case.old / 'ros2_ws').mkdir()
    assert 'ros2_ws in' in case.migrate([TITLE], [TITLE]).notes[0]


@pytest.mark.parametrize('declared', [3, {'points': 'many', 'names': 7}, {'names': [1]}, {'points': 10**400}])
def test_damaged_metadata_do_no_harm(case, declared):
    answer = exercise(ANSWER)
    answer['metadata'] = {'exercise': declared}
    assert said(case.migrate([answer], [exercise()])) == {'3.1': 'carried over'}


def test_declared_names_do_not_change_the_terminal(case):
    answer = exercise(ANSWER, names=('\x1b[2Jbeacon\n', 'b' * 10_000))
    (told,) = said(case.migrate([answer], [exercise()])).values()
    assert '\x1b' not in told and '\n' not in told and len(told) < 3000


def test_a_heading_that_is_no_number_is_no_exercise(case):
    report = case.migrate([TITLE, own(f'# Exercise {"9" * 5000}.1: x'), exercise(ANSWER)], [TITLE, exercise()])
    assert said(report) == {'3.1': 'carried over'} and report.own == {NAME: 1}


def test_broken_pictures_and_letters_leave_a_notebook_that_can_be_read(case):
    """JupyterLab says half a surrogate pair as JSON can; in UTF-8 there is none."""
    case.write(case.new, [exercise()])
    cells = [own('x = "\ud83d"'), dict(own('a picture', 'abcd', 'markdown'), attachments=5)]
    cells = [dict(cell, outputs=[]) if cell['cell_type'] == 'code' else cell for cell in cells]
    data = {'cells': [TITLE, *cells], 'metadata': {}, 'nbformat': 4, 'nbformat_minor': 5}
    (case.old / NAME).write_text(json.dumps(data))
    assert case.again().own == {NAME: 2}
    nbformat.read(case.new / NAME, 4)
    assert 'x = "\ud83d"' in case.sources()


def test_a_chapter_with_another_name_is_the_same_chapter(case):
    case.write(case.old, [TITLE, own('x = 1'), exercise(ANSWER)], '03_old.ipynb')
    case.write(case.new, [TITLE, exercise()])
    assert case.again().own == {NAME: 1}
    assert case.sources() == [TITLE['source'], 'x = 1', ANSWER]


def nested(depth: int) -> list:
    inner: list = []
    for _ in range(depth):
        inner = [inner]
    return inner


@pytest.mark.parametrize(
    ('prepare', 'message'),
    [
        (lambda case: None, 'has no notebooks of the course'),
        (lambda case: (case.old / NAME).write_text('{'), 'is not valid JSON'),
        (lambda case: case.write(case.old, [dict(TITLE, metadata={'a': nested(200)})]), 'nested more than 100 deep'),
        (lambda case: case.write(case.old, [TITLE]), 'get a complete copy'),
    ],
)
def test_what_cannot_be_used_is_named(case, prepare, message):
    prepare(case)
    with pytest.raises(MigrationError, match=message):
        case.again()


def test_the_same_folder_is_refused(case):
    case.write(case.new, [exercise()])
    with pytest.raises(MigrationError, match='this version itself'):
        migration.migrate(case.new, case.new, known={})


def test_every_given_cell_of_the_course_is_known_as_such():
    for path in paths.NOTEBOOKS.glob('[0-9]*.ipynb'):
        for cell in json.loads(path.read_text())['cells']:
            source = ''.join(cell['source'])
            assert 'exercise' in cell['metadata'] or cell_ids.untouched(cell['cell_type'], source, cell['id']), (
                f'{path.name}: {cell["id"]} {source[:60]}'
            )


def test_the_command_migrates_a_real_chapter(tmp_path, capsys):
    old, new = tmp_path / 'old', tmp_path / 'new'
    new.mkdir()
    old.mkdir()
    (path,) = paths.NOTEBOOKS.glob('03_*.ipynb')
    shutil.copy(path, new)
    notebook = json.loads(path.read_text())
    mine = next(cell for cell in notebook['cells'] if cell['id'] == 'ex-3-1')
    answer = mine['source'] = ''.join(mine['source']).replace('# Your code here.', 'self.mine = 1  # mine')
    notebook['cells'].append({'id': 'b0b', 'cell_type': 'markdown', 'metadata': {}, 'source': 'My note.'})
    (old / path.name).write_text(json.dumps(notebook))
    assert app.main(['migrate', str(old), '--notebooks', str(new)]) == 0
    shown = capsys.readouterr().out
    assert '3.1  carried over\n' in shown and '3.2  was not attempted' in shown and '1 cell of your own' in shown
    cells = {cell['id']: ''.join(cell['source']) for cell in json.loads((new / path.name).read_text())['cells']}
    assert cells['ex-3-1'] == answer and cells['b0b'] == 'My note.'
    assert app.main(['migrate', str(tmp_path), '--notebooks', str(new)]) == 2
    assert 'has no notebooks of the course' in capsys.readouterr().err


@pytest.mark.timeout(20)
@pytest.mark.parametrize('kind', ['pipe', 'device', 'link', 'folder', 'large'])
def test_what_is_no_regular_file_is_refused(tmp_path, kind):
    """An old folder may be anybody's: a pipe would wait for ever, a device never end, a link lead elsewhere."""
    case = Case(tmp_path)
    case.write(case.new, [TITLE, CARD, exercise(), END])
    path, elsewhere = case.old / NAME, tmp_path / 'elsewhere.ipynb'
    elsewhere.write_text('{}')
    {
        'pipe': lambda: os.mkfifo(path),
        'device': lambda: path.symlink_to('/dev/zero'),
        'link': lambda: path.symlink_to(elsewhere),
        'folder': path.mkdir,
        'large': lambda: path.write_bytes(b' ' * 11 * 2**20),
    }[kind]()
    refused = 'no regular file|a link to another place|more than 10 MB|Is a directory'
    with pytest.raises(MigrationError, match=refused):
        migration.migrate(case.old, case.new, known={'3.1': KNOWN})
