"""Cells that hold files: what they are as a program, what the kernel does with them, and which mistakes are shown."""

from dataclasses import replace

import pytest

from helpers.exercises import definitions, file_answers, file_syntax, manifest, program
from helpers.exercises.notebooks import NotebookCell
from helpers.tests import small

YAML = "/**:\n  ros__parameters:\n    name: 'C:\\x'\n"
PYTHON = "text = '''a\nb'''\n"
CELL = f"""# Exercise 90.1: files
import re

%%answer CONFIG ws/config/a.yaml

{YAML}

%%answer CODE ws/a.py
{PYTHON}"""
QUOTED = f'# Exercise 90.1: files\nimport re\n\nCONFIG = {YAML!r}\nCODE = {PYTHON!r}\n'


def test_each_file_is_assigned_to_its_name():
    names: dict = {}
    exec(file_answers.as_python(CELL), names)
    assert (names['CONFIG'], names['CODE']) == (YAML, PYTHON)
    assert file_answers.files(CELL) == [('CONFIG', 'ws/config/a.yaml', YAML, 6), ('CODE', 'ws/a.py', PYTHON, 12)]


def test_lines_keep_their_numbers():
    cell = f'{CELL}\n\n%%answer LAST b.txt\nend'
    made = file_answers.as_python(cell).split('\n')
    assert len(made) == len(cell.split('\n'))
    assert [number for number, line in enumerate(made, 1) if ' = ' in line] == [4, 11, 16]


@pytest.mark.parametrize(
    'cell',
    ['x = 1\n', "x = '%%answer'\n", '%%bash\n%%answer A b.py\n', '  %%answer A b.py\n', '%%answers A b.py\n', ''],
)
def test_other_cells_stay_as_they_are(cell):
    assert file_answers.as_python(cell) == cell


@pytest.mark.parametrize('text', ['', '\n \n', '\0', '\\', '\'\'\'\n"""', '\x0c', 'é 😀', '\ud800'])
def test_any_text_is_a_file(text):
    names: dict = {}
    exec(file_answers.as_python(f'%%answer A b.txt\n{text}'), names)
    assert names['A'] == (f'{text}\n' if text.strip(' \n') else '')


def test_both_forms_are_the_same_program():
    assert manifest.stub_digest(CELL) == manifest.stub_digest(QUOTED)
    made = [program.build([NotebookCell(cell, 1)], _exercise('CONFIG', 'CODE')) for cell in (CELL, QUOTED)]
    found: list[dict] = [{}, {}]
    for one, names in zip(made, found, strict=True):
        exec(one.cells[-1]['source'], names)
    assert {found[0][name] == found[1][name] for name in ('CONFIG', 'CODE')} == {True}
    assert definitions.names_in(CELL) == definitions.names_in(QUOTED) == {'re', 'CONFIG', 'CODE'}


def test_a_stub_in_quotes_of_an_earlier_version_is_not_attempted():
    exercise = replace(_exercise('CONFIG', 'CODE'), stub='0' * 64, earlier=(manifest.stub_digest(QUOTED)[:16],))
    with pytest.raises(program.NotAttempted):
        program.build([NotebookCell(QUOTED, 1)], exercise)
    assert program.build([NotebookCell(QUOTED.replace('name', 'rate'), 1)], exercise).cells


def test_a_file_is_a_constant_for_later_exercises():
    texts = [text.strip() for _, text in definitions.of_cell(NotebookCell(CELL, 1))]
    assert texts == ['import re', f'CONFIG = {YAML!r}', f'CODE = {PYTHON!r}']
    assert definitions.of_cell(NotebookCell('%%bash\nA = 1', 1)) == ()


@pytest.mark.parametrize(
    ('source', 'message'),
    [
        ('%%answer CONFIG\ntext', r'line 2: `%%answer CONFIG` must be `%%answer NAME FILE`'),
        ('import re\n%%answer\ntext', r'line 3: `%%answer` must be'),
        ('def f(:\n%%answer CONFIG a.yaml\n%YAML', r'line 2: Python cannot read `def f\(:`'),
        ('%%answer CODE a.py\nx', 'must define `CONFIG`; it defines `CODE`'),
    ],
)
def test_what_is_wrong_is_told_with_the_line_of_the_cell(source, message):
    with pytest.raises(program.InvalidExercise, match=message):
        program.build([NotebookCell(f'# Exercise 90.1: files\n{source}', 1)], _exercise('CONFIG'))


@pytest.mark.parametrize('text', [PYTHON, YAML])
def test_a_line_that_was_deleted_is_told(text):
    with pytest.raises(
        program.InvalidExercise, match='stands below a line `%%answer CONFIG FILE`. If you have deleted'
    ):
        program.build([NotebookCell(f'# Exercise 90.1: files\n{text}', 1)], _exercise('CONFIG'))
    for cell, name in (('CONFIG = [', 'CONFIG'), ('def f(:', 'find'), ('%%answer OTHER a.py\n1', 'CONFIG')):
        with pytest.raises(program.InvalidExercise) as found:
            program.build([NotebookCell(f'# Exercise 90.1: files\n{cell}', 1)], _exercise(name))
        assert 'stands below a line' not in str(found.value)


def _exercise(*names):
    return manifest.Exercise('90.1', 90, small.NOTEBOOK, 'files', 10, names, 'ex-90-1', '')


def test_the_kernel_keeps_and_writes_the_files(kernel, tmp_path):
    kernel.ok('import helpers')
    (tmp_path / 'ws').mkdir()
    done = kernel.ok(CELL)
    assert (done.stdout, done.stderr) == ('Written: ws/config/a.yaml\nWritten: ws/a.py\n', '')
    assert kernel.value('CONFIG, CODE, re.escape("a")') == (YAML, PYTHON, 'a')
    assert ((tmp_path / 'ws/config/a.yaml').read_text(), (tmp_path / 'ws/a.py').read_text()) == (YAML, PYTHON)
    assert kernel.value('__import__("helpers").cell_text("90.1")') == CELL.strip()


def test_without_the_workspace_the_text_is_kept(kernel, tmp_path):
    kernel.ok('import helpers')
    done = kernel.ok(CELL)
    assert done.stdout.splitlines()[1] == 'Not written, as there is no folder ws beside this notebook yet: ws/a.py'
    assert kernel.value('CODE') == PYTHON and not (tmp_path / 'ws').exists()
    (tmp_path / 'b.py').mkdir()
    assert kernel.ok('%%answer CODE b.py\n1').stdout == 'Not written: b.py (Is a directory)\n'


@pytest.mark.parametrize('line', ['%%answer A a_ws/src/p/a.py', '%%writefile a_ws/src/p/a.py'])
def test_what_somebody_has_changed_in_an_editor_is_kept(kernel, tmp_path, line):
    """A cell overwrites its file; what it has itself written before is no change."""
    kernel.ok('import helpers')
    file = tmp_path / 'a_ws/src/p/a.py'
    file.parent.mkdir(parents=True)
    for text in ('x = 1\n', 'x = 2\n'):
        assert 'kept' not in kernel.ok(f'{line}\n{text}').stdout
    kernel.restart()
    kernel.ok('import helpers')
    assert 'kept' not in kernel.ok(f'{line}\nx = 3\n').stdout
    file.write_text('x = "my idea"\n')
    said = kernel.ok(f'{line}\nx = 4\n').stdout
    assert f'That version is kept in {tmp_path}/a_ws_kept/1' in said
    assert file.read_text() == 'x = 4\n'
    assert (tmp_path / 'a_ws_kept/1/p/a.py').read_text() == 'x = "my idea"\n'


def test_a_mistake_is_shown_and_nothing_is_lost(kernel, tmp_path):
    kernel.ok('import helpers')
    wrong = 'import re\n\ndef f()\n    pass\n'
    done = kernel.ok(f'# Exercise 90.1: files\n%%answer A a.py\n{wrong}\n%%answer B b.xml\n<a>\n</b>')
    assert done.stderr.startswith(
        "a.py, line 3: expected ':'\n    def f()\n           ^\nb.xml, line 2: mismatched tag\n"
    )
    assert kernel.value('A, B') == (wrong, '<a>\n</b>\n')
    assert (tmp_path / 'a.py').read_text() == wrong


@pytest.mark.parametrize('said', ['', 'A', '1 a.py', 'A /tmp/a.py', 'A ../a.py'])
def test_a_line_that_cannot_be_followed_is_refused(kernel, tmp_path, said):
    kernel.ok('import helpers')
    done = kernel.run(f'# Exercise 90.1: files\n%%answer {said}\ntext')
    assert done.stderr.startswith('UsageError: ')
    assert 'NAME FILE' in done.stderr or 'below the folder of this notebook' in done.stderr
    assert not (tmp_path / 'a.py').exists() and not (tmp_path.parent / 'a.py').exists()


@pytest.mark.parametrize(
    ('path', 'text', 'line', 'said'),
    [
        ('a.py', 'x = 1\nreturn x\n', 2, "'return' outside function"),
        ('a.xml', '<a>\n  <b>\n</a>\n', 3, 'mismatched tag'),
        ('a.yaml', 'a:\n  b: c: d\n', 2, 'mapping values are not allowed here'),
        ('a.yaml', 'a:\n\tb: 1\n', 2, 'cannot start any token'),
        ('a.cfg', 'x=1\n', 1, 'a section such as [install] must come first'),
        ('a.cfg', '[a]\nx=1\nx=2\n', 3, 'already exists'),
        ('a.py', '\0', 0, 'null bytes'),
        ('a.py', "setup(name='a'，version='1')\n", 1, '(U+FF0C): type `,` in its place'),
        ('A.msg', 'uint8 FULL=100\nuint8 full=100\n', 2, '`full` is no name of a constant'),
        ('A.msg', '# charge\nuint8 FULL 100\n', 2, '`FULL` is no name of a field'),
        ('A.msg', 'std_msgs/msg/Header header\n', 1, 'written `std_msgs/Header`, without `/msg/`'),
        ('A.msg', '\nfloat33[] speeds\n', 2, 'there is no type `float33[]`'),
        ('A.msg', 'int32\n', 1, 'a type and a name'),
        ('A.msg', 'uint8 a 300\n', 1, "value '300' can not be converted to type 'uint8'"),
        ('A.msg', 'uint8 a\nbool a\n', 2, '`a` is there twice'),
        ('A.msg', 'uint8 a\n---\nuint8 a\n', 0, 'a .msg file has no `---`'),
        ('A.srv', 'uint8 a\n', 0, 'a .srv file has 1 line `---` (request, response), and here are 0'),
        ('A.srv', 'uint8 a\n--- \n', 2, 'not even a blank'),
        ('A.srv', 'uint8 a\n----\n', 2, '`---` is three hyphens'),
        ('A.action', 'uint8 a\n---\nuint8 a\n', 0, '2 lines `---` (goal, result, feedback), and here are 1'),
        ('CMakeLists.txt', 'project(a)\nfind_package(b\nament_package()\n', 2, '`(` is not closed'),
        ('CMakeLists.txt', 'project(a))\n', 1, 'not `)`'),
        ('CMakeLists.txt', 'project(a)\n\nament_package\n', 3, '`ament_package(…)`'),
        ('CMakeLists.txt', 'project a\n', 1, 'not `a`'),
        ('CMakeLists.txt', 'set(a "b)\n', 1, 'has no second one'),
    ],
)
def test_mistakes_have_their_line(path, text, line, said):
    found = file_syntax.mistake(path, text)
    assert found and found.line == line and said in found.said
    assert file_syntax.shown(path, text, found).startswith(f'{path}, line {line}: ' if line else f'{path}: ')


@pytest.mark.parametrize(
    ('path', 'text'),
    [
        ('a.py', '# Your code here.\n'),
        ('a.py', '"\\d"\n'),
        ('a.yaml', '# Your code here.\n'),
        ('A.msg', '# nothing yet\n'),
        ('A.srv', '# Your code here.\n'),
        (
            'A.msg',
            'uint8 FULL=100  # %\nstd_msgs/Header header\nstring<=5[3] names ["a", "b", "c"]\nother_pkg/Part[] a\n',
        ),
        ('A.srv', '---\n'),
        ('A.action', 'int32 a 1\n---\nint32 a\n---\nint32 a\n'),
        ('CMakeLists.txt', '# (\nif(A AND (NOT B))\n  set(x "a)\\"b" [[ ) ]] ${y})  # (\nendif()\n#[[ ( ]]\n'),
        ('a.txt', '('),
        ('a.cfg', ''),
    ],
)
def test_what_can_be_read_has_no_mistake(path, text):
    assert file_syntax.mistake(path, text) is None
