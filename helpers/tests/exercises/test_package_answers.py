"""Answers that are packages: what is read of a folder, what is refused, and what is handed in."""

import ast
import os
import zipfile

import nbformat
import pytest

from helpers.exercises import handing_in as submitting
from helpers.exercises import manifest, migration, package_answers, program, result_display
from helpers.programs.workspace import Workspace
from helpers.runner import session
from helpers.runner.learner import Learner
from helpers.runner.verdicts import InvalidProgram
from helpers.tests import small

FOLDER = 'my_ws/src/patrol'
EXERCISE = small.exercise(names=(package_answers.NAME,), folder=FOLDER)
FILES = {'package.xml': '<package/>\n', 'patrol/__init__.py': '', 'patrol/route.py': "SIGN = '\\n'\n# ü\n"}


def make(notebooks, files=None, folder=FOLDER):
    for name, text in (FILES if files is None else files).items():
        path = notebooks / folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(text if isinstance(text, bytes) else text.encode())
    return notebooks / folder


def why(notebooks) -> str:
    """What the learner reads of a package that cannot be used."""
    with pytest.raises((program.InvalidExercise, program.NotAttempted)) as found:
        package_answers.of_folder(EXERCISE, notebooks)
    return str(found.value)


def test_a_package_becomes_a_program_that_holds_it(tmp_path):
    make(tmp_path)
    made = package_answers.of_folder(EXERCISE, tmp_path)
    (cell,) = made.cells
    assert cell['source'].startswith('# Exercise 90.1: a talker\nPACKAGE = {')
    assert ast.literal_eval(ast.parse(cell['source']).body[0].value) == FILES
    learner = Learner.__new__(Learner)
    learner.program = made.as_dict()
    assert learner.files() == FILES


@pytest.mark.parametrize(
    'source',
    ['PACKAGE = {"a": 1}', 'PACKAGE = {"../a": ""}', 'PACKAGE = open("x")', 'OTHER = {}', 'PACKAGE = [', '1 + 1'],
)
def test_a_cell_that_is_no_package_is_not_run(source):
    learner = Learner.__new__(Learner)
    learner.program = {'answer': source}
    with pytest.raises(InvalidProgram):
        learner.files()


def test_what_tools_leave_behind_is_left_out(tmp_path):
    products = (
        'build/x', 'install/x', 'log/x', '.git/x', '.setup.py.swp', 'patrol/__pycache__/x.pyc', 'patrol.egg-info/x',
        '.ipynb_checkpoints/x', 'patrol/old.pyc',
    )  # fmt: skip
    make(tmp_path, {**FILES, **dict.fromkeys(products, b'\0')})
    found = package_answers.read(tmp_path, FOLDER)
    assert {name: content.decode() for name, content in found.files.items()} == FILES
    assert len(found.left_out) == len(products) and 'build/' in found.left_out
    make(tmp_path, {'patrol/log/notes.txt': 'mine'})  # only at the top these are names of the tools
    assert 'patrol/log/notes.txt' in package_answers.read(tmp_path, FOLDER).files


@pytest.mark.parametrize(
    ('name', 'content', 'problem'),
    [
        ('big.txt', b'x' * (package_answers.MAX_FILE + 1), 'big.txt in your package has more than 64 kB'),
        ('picture.png', b'\x89PNG\xff', 'picture.png in your package is no text in UTF-8'),
        ('null.txt', b'a\0b', 'null.txt in your package is no text: it has a null character'),
        ('a file.txt', b'', "called 'a file.txt'. Use letters, digits"),
        ('x\n.txt', b'', 'Use letters, digits'),
        (b'\xff.txt'.decode(errors='surrogateescape'), b'', 'Use letters, digits'),
        ('/'.join(['deep'] * 40), b'', 'at most 120 characters'),
    ],
)
def test_files_that_cannot_be_handed_in(tmp_path, name, content, problem):
    make(tmp_path, {**FILES, name: content})
    assert problem in why(tmp_path)


def test_folders_within_folders(tmp_path, monkeypatch):
    """More of them than Python can follow, and a path that is too long for one call."""
    monkeypatch.chdir(make(tmp_path))
    for _ in range(1500):
        os.mkdir('inner')
        os.chdir('inner')
    try:
        assert 'more than 60 deep' in why(tmp_path)
    finally:  # what removes folders of tests cannot follow them either
        for _ in range(1500):
            os.chdir('..')
            os.rmdir('inner')


def test_too_much(tmp_path):
    top = make(tmp_path)
    for number in range(5):
        (top / f'{number}.txt').write_bytes(b'x' * package_answers.MAX_FILE)
    assert 'more than 256 kB together' in why(tmp_path)
    for number in range(package_answers.MAX_FILES):
        (top / f'{number}.txt').write_text('')
    assert 'Your package has 103 files, more than 100' in why(tmp_path)
    for number in range(package_answers.MAX_ENTRIES):
        (top / f'{number}.txt').write_text('')
    assert 'more than 5000 files' in why(tmp_path)


def test_only_regular_files_are_read(tmp_path):
    """A link is not followed, and a pipe is not waited for."""
    secret = tmp_path / 'secret'
    secret.write_text('secret')
    top = make(tmp_path)
    (top / 'notes.txt').symlink_to(secret)
    assert why(tmp_path) == 'notes.txt in your package is a link. Put the file itself in its place.'
    (top / 'notes.txt').unlink()
    (top / 'folder').symlink_to(tmp_path)
    assert why(tmp_path) == 'folder in your package is a link. Put the file itself in its place.'
    (top / 'folder').unlink()
    os.mkfifo(top / 'pipe')
    assert why(tmp_path) == 'pipe in your package is no regular file. Move it away.'


@pytest.mark.parametrize('part', ['my_ws', 'my_ws/src', FOLDER])
def test_the_folder_itself_is_no_link(tmp_path, part):
    make(tmp_path / 'elsewhere')
    notebooks = tmp_path / 'notebooks'
    (notebooks / part).parent.mkdir(parents=True)
    (notebooks / part).symlink_to(tmp_path / 'elsewhere' / part)
    assert f'{part.rpartition("/")[2]} is a link to another place' in why(notebooks)


def test_a_file_in_place_of_the_folder(tmp_path):
    make(tmp_path, {'patrol': ''}, 'my_ws/src')
    assert why(tmp_path) == 'my_ws/src/patrol is a file. A package is a folder.'


def test_no_package_yet(tmp_path):
    assert why(tmp_path).startswith('There is no package yet: the folder my_ws/src/patrol is not there. Make it in')
    report = session.run([], [EXERCISE], session.Options(folder=tmp_path))
    assert report.exercises[0].verdict == 'not_attempted' and report.exercises[0].score == 0
    assert 'There is no package yet' in result_display.plain(report.exercises)


@pytest.mark.parametrize(
    'place',
    ['my_ws/patrol', 'patrol', 'src/patrol', 'ros2_ws/src/patrol', 'my_ws/src/src/patrol', 'ros2_ws_kept/1/patrol'],
)
def test_a_package_in_the_wrong_place_is_named(tmp_path, place):
    make(tmp_path, folder=place)
    said = why(tmp_path)
    assert f'but there is one in {place}. Move it' in said


@pytest.mark.parametrize('place', ['my_ws/src/patrol', 'my_ws/patrol', 'patrol'])
def test_a_package_in_the_courses_folder_instead_of_the_notebooks_is_named(tmp_path, place):
    make(tmp_path, folder=place)
    (tmp_path / 'notebooks').mkdir()
    assert f'but there is one in ../{place}. Move it' in why(tmp_path / 'notebooks')


def test_packages_of_other_names_are_named(tmp_path):
    make(tmp_path, folder='my_ws/src/first_steps')
    make(tmp_path, folder='my_ws/src/Patrol')
    assert 'There is no package patrol in my_ws/src; there is: Patrol, first_steps. This exercise' in why(tmp_path)


def test_a_reset_never_touches_it(tmp_path):
    """A workspace that a learner has made is refused; what is in one of the lesson's is moved, and found there."""
    make(tmp_path)
    with pytest.raises(FileExistsError, match='not a workspace of this course'):
        Workspace(tmp_path / 'my_ws').reset()
    assert package_answers.of_folder(EXERCISE, tmp_path).cells
    lesson = Workspace(tmp_path / 'ros2_ws')
    lesson.reset()
    os.rename(tmp_path / FOLDER, tmp_path / 'ros2_ws/src/patrol')
    lesson.reset()
    assert 'there is one in ros2_ws_kept/1/patrol' in why(tmp_path)
    assert package_answers.read(tmp_path, 'ros2_ws_kept/1/patrol').files['package.xml'] == b'<package/>\n'


# Handing in


@pytest.mark.parametrize(
    ('member', 'place'),
    [
        ('my_ws/src/patrol/setup.py', (FOLDER, 'setup.py')),
        ('ada/my_ws/src/patrol/a/b.py', (FOLDER, 'a/b.py')),
        ('my_ws/src/patrol/../../../x', (FOLDER, '../../../x')),
        ('my_ws/src/patrol/', None),
        ('my_ws/src/patrol/patrol/__pycache__/route.cpython-311.pyc', None),
        ('my_ws/src/patrol/patrol.egg-info/PKG-INFO', None),
        ('my_ws/src/patrol/build/lib/patrol/route.py', None),
        ('my_ws/src/patrol/patrol/build/x.py', (FOLDER, 'patrol/build/x.py')),
        ('my_ws/src/patrol/.pytest_cache/README.md', None),
        ('my_ws/setup.py', None),
        ('02_workspace_and_packages.ipynb', None),
    ],
)
def test_members_of_a_zip(member, place):
    assert package_answers.place(member) == place


@pytest.fixture
def handing_in(tmp_path, monkeypatch):
    """A course of one exercise with a folder; packs, and returns what was packed and the names in the file."""
    monkeypatch.setattr(manifest, 'load', lambda: {EXERCISE.id: EXERCISE})
    (tmp_path / small.NOTEBOOK).write_bytes(small.notebook('x = 1'))

    def pack(name='x.zip'):
        packed = submitting.pack('ada', tmp_path / name, notebooks_folder=tmp_path)
        with zipfile.ZipFile(packed.path) as archive:
            return packed, archive.namelist()

    return pack


def test_submit_packs_and_lists_the_package(tmp_path, handing_in):
    make(tmp_path, {**FILES, 'build/x': ''})
    packed, names = handing_in()
    assert {name for name in names if '/' in name} == {f'{FOLDER}/{name}' for name in FILES}
    listed = '\n'.join(packed.lists())
    assert 'my_ws/src/patrol: 3 files' in listed and 'patrol/route.py' in listed and 'left out: build/' in listed
    again, _ = handing_in('again.zip')
    assert again.path.read_bytes() == packed.path.read_bytes()


def test_the_rest_is_handed_in_without_a_package_that_cannot_be(tmp_path, handing_in):
    make(tmp_path, {**FILES, 'a file': ''})
    packed, names = handing_in()
    assert names == [small.NOTEBOOK, 'submission.json']
    (warning,) = packed.lists()
    assert warning.startswith(
        "The package of exercise 90.1 is not in the file. A file of your package is called 'a file'"
    )


def test_without_a_package_nothing_is_said(tmp_path, handing_in):
    packed, names = handing_in()
    assert names == [small.NOTEBOOK, 'submission.json'] and packed.lists() == []


def test_what_was_handed_in():
    files = {f'{FOLDER}/{name}': text.encode() for name, text in FILES.items()}
    assert package_answers.of_submission(EXERCISE, {small.NOTEBOOK: b'', **files}).cells
    with pytest.raises(program.NotAttempted, match='No package was handed in'):
        package_answers.of_submission(EXERCISE, {small.NOTEBOOK: b''})
    with pytest.raises(program.InvalidExercise, match='Use letters, digits'):
        package_answers.of_submission(EXERCISE, {**files, f'{FOLDER}/../../x': b''})
    with pytest.raises(program.InvalidExercise, match='the name of the folder of patrol/__init__.py'):
        package_answers.of_submission(EXERCISE, {**files, f'{FOLDER}/patrol': b''})


# A new version of the course


@pytest.fixture
def versions(tmp_path):
    """Migrates from the old folder to the new one; returns what was said of the exercise."""
    for name in ('old', 'new'):
        (tmp_path / name).mkdir()
        cell = nbformat.v4.new_markdown_cell('# Chapter')
        nbformat.write(nbformat.v4.new_notebook(cells=[cell]), tmp_path / name / small.NOTEBOOK)

    def migrate(**options):
        known = {EXERCISE.id: EXERCISE}
        report = migration.migrate(tmp_path / 'old', tmp_path / 'new', known=known, **options)
        (one,) = report.exercises
        return one, report

    return migrate


def test_a_package_goes_into_the_new_version(tmp_path, versions):
    make(tmp_path / 'old', {**FILES, 'build/x': ''})
    said, _ = versions(dry_run=True)
    assert said.said.startswith('carried over: my_ws/src/patrol, 3 files') and not (tmp_path / 'new/my_ws').exists()
    said, report = versions()
    assert not said.lost and report.packages == [tmp_path / 'new' / FOLDER]
    old, new = (package_answers.read(tmp_path / name, FOLDER) for name in ('old', 'new'))
    assert new.files == old.files and not new.left_out
    assert versions()[0].said == 'has this answer already'


def test_another_package_stays(tmp_path, versions):
    make(tmp_path / 'old')
    make(tmp_path / 'new', {'package.xml': 'newer'})
    said, report = versions()
    assert said.lost and 'which stays' in said.said and not report.packages
    assert package_answers.read(tmp_path / 'new', FOLDER).files == {'package.xml': b'newer'}


def test_no_package_in_the_old_version(versions):
    said, report = versions()
    assert said.said.startswith('was not attempted') and not said.lost and not report.packages
