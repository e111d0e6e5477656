"""A notebook's workspace: what it shows, what it removes, and what it leaves alone."""

import sys

import pytest

from helpers import Workspace
from helpers.kernel import journal
from helpers.kernel.journal import ExecutedCell
from helpers.programs import workspace
from helpers.programs.workspace import BuildError


@pytest.fixture
def ws(tmp_path):
    made = Workspace(tmp_path / 'ros2_ws')
    made.reset()
    return made


def test_commands_are_shown_with_their_output(ws, capsys):
    ws.run("cd src\npwd; echo 'to stderr' >&2\nfalse")
    assert capsys.readouterr().out.splitlines() == [
        '$ cd src',
        "$ pwd; echo 'to stderr' >&2",
        str(ws.path / 'src'),
        'to stderr',
        '$ false',
        '[exit status 1]',
    ]


def test_each_run_is_a_new_terminal_with_ros(ws, capsys):
    ws.run('export WORD=hello')
    ws.run('echo ${WORD-nothing}; ros2 pkg prefix rclpy')
    out = capsys.readouterr().out.splitlines()
    assert 'nothing' in out and '[exit status' not in out[-1]


def test_reset_makes_it_new(ws):
    ws.write('src/p/a.py', '\nprint(1)\n')
    assert (ws.path / 'src/p/a.py').read_text() == 'print(1)\n'
    ws.reset()
    assert [path.name for path in ws.path.iterdir() if path.is_dir()] == ['src']
    assert not any((ws.path / 'src').iterdir())


def test_reset_keeps_what_the_learner_made(ws, capsys):
    ws.write('src/given/a.py', '')
    ws.write('src/changed/a.py', '')
    ws.run('mkdir src/of_a_command && touch src/of_a_command/a.py src/given/b.py')
    (ws.path / 'src/changed/a.py').write_text('my idea')
    (ws.path / 'src/mine').mkdir()
    (ws.path / 'src/mine/setup.py').write_text('mine')
    ws.run('true')  # does not make it the lesson's
    capsys.readouterr()
    ws.reset()
    kept = ws.path.with_name('ros2_ws_kept') / '1'
    assert capsys.readouterr().out == f'What you made or changed in ros2_ws is kept: changed, mine, now in {kept}\n'
    assert (kept / 'mine/setup.py').read_text() == 'mine' and (kept / 'changed/a.py').read_text() == 'my idea'
    assert not any((ws.path / 'src').iterdir())
    ws.write('src/given/a.py', '')
    (ws.path / 'src/given/__pycache__').mkdir()
    (ws.path / 'src/given/__pycache__/a.pyc').touch()
    ws.reset()
    assert capsys.readouterr().out == '' and not kept.with_name('2').exists()
    (ws.path / 'src/note.txt').write_text('to do')
    ws.reset()
    assert (kept.with_name('2') / 'note.txt').read_text() == 'to do'


def test_reset_keeps_what_stands_beside_src(ws, capsys):
    ws.write('params.yaml', 'a: 1')
    for folder in ('build/p', 'install/p', 'log/latest_build', 'src/p/build', 'src/log'):
        (ws.path / folder).mkdir(parents=True)
        (ws.path / folder / 'made_by_a_tool').touch()
    ws.reset()
    assert capsys.readouterr().out == '' and not ws.path.with_name('ros2_ws_kept').exists()
    for recording in ('drive', 'src/drive'):
        (ws.path / recording).mkdir()
        (ws.path / recording / 'metadata.yaml').write_text(recording)
    (ws.path / 'drive' / 'drive_0.mcap').write_bytes(bytes(2**20 + 1))
    (ws.path / 'src/p/p/log').mkdir(parents=True)
    (ws.path / 'src/p/p/log/notes.txt').write_text('only at the top this is a name of the tools')
    (ws.path / 'src/linked').symlink_to(ws.path)
    ws.reset()
    kept = ws.path.with_name('ros2_ws_kept') / '1'
    assert sorted(path.name for path in kept.iterdir()) == ['drive', 'drive_beside_src', 'linked', 'p']
    assert {path.read_text() for path in kept.glob('*/metadata.yaml')} == {'drive', 'src/drive'}
    assert len(list(kept.glob('*/drive_0.mcap'))) == 1 and (kept / 'linked').is_symlink()
    assert (kept / 'p/p/log/notes.txt').is_file()
    assert [path.name for path in ws.path.iterdir() if path.is_dir()] == ['src']


def test_what_comes_while_a_command_runs_that_writes_nothing_is_the_learners(ws, capsys):
    """Somebody saves a file in an editor while colcon builds."""
    ws.write('src/p/a.py', '')
    ws.run("python3 -c \"from pathlib import Path; Path('src/p/a.py').write_text('my idea')\"")
    ws.reset()
    assert 'is kept: p,' in capsys.readouterr().out


@pytest.mark.parametrize(
    ('cell', 'mine'), [('ex-2-1', False), (None, False), ('0f8fad5b-d9cb-469f-a165-70867728950e', True)]
)
def test_what_a_cell_of_the_learners_own_has_made_is_kept(ws, capsys, monkeypatch, cell, mine):
    monkeypatch.setattr(journal, 'cells', [journal.ExecutedCell(cell, "ws.run('cd src\nros2 pkg create mine')")])
    ws.run('mkdir src/mine; touch src/mine/package.xml')
    ws.write('note.txt', 'to do')
    capsys.readouterr()
    ws.reset()
    assert ('is kept: mine, note.txt,' in capsys.readouterr().out) is mine


def test_before_the_lesson_overwrites_a_changed_file_a_copy_is_kept(ws, tmp_path, capsys):
    (tmp_path / 'p').mkdir()
    for name in ('a.py', 'b.py', 'c.py'):
        (tmp_path / 'p' / name).write_text('given')
    ws.add(tmp_path / 'p')
    ws.write('src/p/a.py', 'the lesson, later')
    (ws.path / 'src/p/b.py').write_text('my idea')
    (ws.path / 'src/p/mine.py').write_text('mine')
    assert capsys.readouterr().out == ''
    ws.add(tmp_path / 'p')
    kept = ws.path.with_name('ros2_ws_kept') / '1'
    assert capsys.readouterr().out == f'What you had changed in ros2_ws is kept: p/b.py, a copy is now in {kept}\n'
    assert (kept / 'p/b.py').read_text() == 'my idea' and (ws.path / 'src/p/b.py').read_text() == 'given'
    assert (ws.path / 'src/p/mine.py').read_text() == 'mine'
    (ws.path / 'src/p/c.py').write_text('another idea')
    ws.write('src/p/c.py', 'the lesson')
    assert (kept.with_name('2') / 'p/c.py').read_text() == 'another idea'


@pytest.mark.parametrize('line', ['%%writefile ros2_ws/src/p/a.py', '# Exercise 2.9: a\n%%answer A ros2_ws/src/p/a.py'])
def test_what_a_cell_has_written_is_the_lessons(ws, capsys, monkeypatch, line):
    cells = [journal.ExecutedCell(None, f'{line}\nprint(1)\n')]
    monkeypatch.setattr(journal, 'cells', cells)
    for text, mine in (('print(1)\n', False), ('print(2)\n', True)):
        ws.write('src/p/b.py', '')
        (ws.path / 'src/p/a.py').write_text(text)
        ws.run('true')
        capsys.readouterr()
        ws.reset()
        assert ('is kept: p,' in capsys.readouterr().out) is mine


def test_a_file_that_two_cells_have_written_is_the_lessons(ws, capsys, monkeypatch):
    texts = '%%writefile ros2_ws/src/p/a.py\nprint(1)', '%%writefile -a ros2_ws/src/p/a.py\n\nprint(2)'
    monkeypatch.setattr(journal, 'cells', [journal.ExecutedCell(None, text) for text in texts])
    ws.write('src/p/b.py', '')
    (ws.path / 'src/p/a.py').write_text('print(1)\n\nprint(2)\n')
    ws.run('true')
    ws.reset()
    assert 'is kept' not in capsys.readouterr().out


def test_a_folder_of_somebody_else_is_left_alone(tmp_path):
    (tmp_path / 'thesis.txt').write_text('three years')
    with pytest.raises(FileExistsError, match='move it away'):
        Workspace(tmp_path).reset()
    assert (tmp_path / 'thesis.txt').read_text() == 'three years'


def test_nothing_is_written_outside(ws):
    with pytest.raises(ValueError, match='not inside'):
        ws.write('../elsewhere', '')


def test_without_reset_there_is_one_clear_line(tmp_path):
    with pytest.raises(FileNotFoundError, match='reset'):
        Workspace(tmp_path / 'none').run('ls')


@pytest.mark.parametrize('first', ['write', 'add'])
def test_what_is_run_before_reset_makes_a_workspace_that_reset_takes(tmp_path, first):
    """As by somebody who begins in the middle of a chapter, and then goes back to its beginning."""
    ws = Workspace(tmp_path / 'early_ws')
    if first == 'write':
        ws.write('src/demo/a.py', 'x = 1\n')
    else:
        (tmp_path / 'demo').mkdir()
        (tmp_path / 'demo/a.py').write_text('x = 1\n')
        ws.add(tmp_path / 'demo')
    assert (ws.path / 'src/demo/a.py').read_text() == 'x = 1\n'
    ws.run('test -d src')
    ws.reset()
    assert not (ws.path / 'src/demo').exists()


def test_a_folder_that_is_not_there_yet_is_told(ws):
    with pytest.raises(FileNotFoundError, match='install yet: run the cells above that make it'):
        ws.tree('install')


def test_a_package_is_copied_into_one_of_its_name(ws, tmp_path):
    (tmp_path / 'p' / '__pycache__').mkdir(parents=True)
    (tmp_path / 'p' / 'new').touch()
    ws.write('src/p/old', '')
    ws.add(tmp_path / 'p')
    assert sorted(path.name for path in (ws.path / 'src/p').iterdir()) == ['new', 'old']
    with pytest.raises(FileNotFoundError, match='no package'):
        ws.add(tmp_path / 'q')


def test_a_failed_build_shows_its_log_and_raises(ws, capsys):
    ws.write(
        'src/p/package.xml',
        '<package format="3"><name>p</name><version>0.0.0</version><description>p'
        '</description><maintainer email="you@example.com">You</maintainer><license>Apache-2.0</license>'
        '<export><build_type>ament_cmake</build_type></export></package>',
    )
    ws.write(
        'src/p/CMakeLists.txt',
        'cmake_minimum_required(VERSION 3.16)\nproject(p NONE)\nmessage("so far")\n'
        'message(STATUS "on stdout")\nmessage(FATAL_ERROR "no further")\n',
    )
    with pytest.raises(BuildError):
        ws.build('--packages-select p')
    out = capsys.readouterr().out
    assert 'no further' in out and 'log/latest_build/p/stdout.log ends so:' in out and '-- on stdout' in out


def test_tree(ws, capsys):
    ws.write('src/p/a.py', '')
    (ws.path / 'src/link').symlink_to('p')
    ws.tree()
    assert capsys.readouterr().out == ('ros2_ws/\n└── src/\n    ├── link -> p\n    └── p/\n        └── a.py\n')


def test_messages_call_a_started_program_by_its_last_line(ws):
    begun = ws.start('cd src\nexec echo three words')
    with pytest.raises(RuntimeError, match="^echo three words ended with status 0 before it printed 'four'"):
        begun.wait_for_output('four', timeout=30)


@pytest.mark.parametrize('front_end', ['JupyterLab', 'nbval'])
def test_a_command_that_is_silent_for_long_is_told_what_it_may_wait_for(ws, capsys, monkeypatch, front_end):
    """The line goes when the command prints again. nbval, which names no cell, compares outputs: there is none."""
    shown = []

    class Line:
        def show(self, line):
            shown.append(line)
            (ws.path / 'go').touch()

        def end(self):
            shown.append('')

    monkeypatch.setattr(workspace, '_LineBelow', Line)
    monkeypatch.setattr(workspace, '_SILENCE', 0.3)
    cell = ExecutedCell('an-id' if front_end == 'JupyterLab' else None, 'ws.run(…)')
    monkeypatch.setattr(journal, 'cells', [cell])
    wait = 'until [ -e go ]; do sleep 0.05; done' if front_end == 'JupyterLab' else 'sleep 0.8'
    ws.run(f'{wait}\necho came')
    assert capsys.readouterr().out.endswith('$ echo came\ncame\n')
    said = [line for line in shown if line]
    if front_end == 'nbval':
        assert not said
    else:
        assert 'stop it (■), and run the cell that starts that program' in said[0]
        assert shown.index(said[0]) < len(shown) - 1 and shown[-1] == ''


def test_after_the_stop_button_no_further_line_is_run(kernel, tmp_path):
    program = (
        'import os, time\ntry:\n    os.write(1, b"ready\\n"); time.sleep(600)\nexcept KeyboardInterrupt:\n    pass\n'
    )
    (tmp_path / 'polite.py').write_text(program)
    kernel.ok(f'from helpers import Workspace\nws = Workspace({str(tmp_path / "ws")!r})\nws.reset()')
    script = f'{sys.executable} {tmp_path / "polite.py"}\ntouch went_on'
    assert kernel.run(f'ws.run({script!r})', interrupt_at='ready').error == 'KeyboardInterrupt'
    assert not (tmp_path / 'ws' / 'went_on').exists()
