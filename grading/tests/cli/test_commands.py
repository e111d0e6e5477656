"""The author's commands, as the command line runs them."""

import io
import json
import os
from pathlib import Path

import pytest
from rich.console import Console

from grading import bench as benchmarks
from grading.cli import grade as grade_command
from grading.tests.authoring.conftest import make_without_kernel, write
from grading.tests.authoring.sources import TINY
from helpers import paths
from helpers.cli import app


@pytest.fixture
def course(tmp_path, monkeypatch):
    """A course of one tiny chapter in place of the real one."""
    from grading.authoring.chapter_build import CourseFolders

    tree = CourseFolders(tmp_path)
    tree.solutions.mkdir()
    tree.notebooks.mkdir()
    write(tree, TINY)
    monkeypatch.setattr(paths, 'ROOT', tmp_path)
    return tree


def test_check_says_what_is_out_of_step(course, capsys):
    assert app.main(['build', '--check']) == 1
    assert 'run ./course build' in capsys.readouterr().out
    make_without_kernel(course)
    assert app.main(['build', '--check']) == 0
    assert capsys.readouterr().out == (
        'checked statements by chapter: 07: 0\n1 chapters are in step with their sources\n'
    )


def test_mistakes_of_the_author_end_with_one(course, capsys):
    write(course, TINY.replace(':points: 10\n', ''))
    assert app.main(['build']) == 1
    assert capsys.readouterr().err.startswith('solutions/07_tiny.md:')


@pytest.mark.parametrize(
    ('argument', 'message'),
    [
        ('08', 'no source of chapter 08 in solutions/; there are: 07'),
        ('seven', "'seven' is no chapter: write its number, such as 03"),
    ],
)
def test_an_unknown_chapter_is_unusable_input(course, capsys, argument, message):
    assert app.main(['build', argument]) == 2
    assert capsys.readouterr().err == f'course: {message}\n'


@pytest.mark.parametrize('argument', ['7', '07', '07_tiny', 'solutions/07_tiny.md'])
def test_a_chapter_may_be_named_as_one_likes(course, argument, capsys):
    make_without_kernel(course)
    assert app.main(['build', argument]) == 0
    assert capsys.readouterr().out == '07_tiny: unchanged\n'


def make_benchmark(root, name, body):
    folder = root / 'helpers' / 'bench'
    folder.mkdir(parents=True, exist_ok=True)
    (folder / f'bench_{name}.py').write_text(f'"""About {name}."""\n\n\ndef measure():\n    {body}\n')


def test_benchmarks_are_found_run_and_written(course, tmp_path, capsys):
    make_benchmark(tmp_path, 'quick', "yield 'a wait', 12.5, 'ms'; yield 'a try', 3.0, 's', 'the other', 4.0")
    make_benchmark(tmp_path, 'broken', "yield 'before', 1.0, 's'; raise OSError('no [clock]')")
    make_benchmark(tmp_path, 'odd', "yield 'nothing', 1.0, 's', 'the other', 0")
    output = tmp_path / 'new' / 'bench.json'
    before = os.environ.get('ROS_DOMAIN_ID')
    assert app.main(['bench', '-o', str(output)]) == 1
    shown = capsys.readouterr()
    assert '[3/3] quick: About quick.' in shown.err and 'a try: 3 s (the other: 4; ratio 0.75)' in shown.err
    assert os.environ.get('ROS_DOMAIN_ID') == before
    table = [[cell.strip() for cell in line.split('│')[1:-1]] for line in shown.out.splitlines() if '│' in line]
    assert [row[:-1] if row[-1] == '' else row for row in table] == [
        ['broken', 'before', '1', 's', '', ''],
        ['', 'failed: OSError: no [clock]', '', '', '', ''],
        ['odd', 'failed: RuntimeError: nothing: nothing was measured with the other', '', '', '', ''],
        ['quick', 'a wait', '12.5', 'ms', '', ''],
        ['', 'a try', '3', 's', 'the other', '4', '0.75'],
    ]
    found = json.loads(output.read_text())
    assert found['results'] == [
        {'benchmark': 'broken', 'what': 'before', 'value': 1.0, 'unit': 's'},
        {'benchmark': 'quick', 'what': 'a wait', 'value': 12.5, 'unit': 'ms'},
        {
            'benchmark': 'quick',
            'what': 'a try',
            'value': 3.0,
            'unit': 's',
            'reference': 'the other',
            'reference_value': 4.0,
            'ratio': 0.75,
        },
    ]
    assert found['benchmarks']['broken']['error'] == 'OSError: no [clock]'
    assert found['benchmarks']['quick']['error'] == ''
    assert {'begin', 'end', 'machine', 'load'} <= set(found)
    assert app.main(['bench', 'quick', '-o', str(output)]) == 0
    assert list(json.loads(output.read_text())['benchmarks']) == ['quick']


def test_a_stopped_run_keeps_what_it_has(course, tmp_path, capsys):
    make_benchmark(tmp_path, 'first', "yield 'a wait', 12.5, 'ms'")
    make_benchmark(tmp_path, 'second', "yield 'begun', 1.0, 's'; raise KeyboardInterrupt")
    output = tmp_path / 'bench.json'
    assert app.main(['bench', 'first', 'second', '-o', str(output)]) == 130
    assert [row['what'] for row in json.loads(output.read_text())['results']] == ['a wait', 'begun']
    shown = capsys.readouterr()
    assert 'failed: stopped' in shown.out and 'the rest was not measured' in shown.err


def test_a_busy_machine_is_told(course, tmp_path, monkeypatch, capsys):
    make_benchmark(tmp_path, 'quick', "yield 'a wait', 12.5, 'ms'")
    for load, told in ((50.0, True), (0.0, False)):
        monkeypatch.setattr(os, 'getloadavg', lambda now=load: (now, now, now))
        assert app.main(['bench', '-o', str(tmp_path / 'bench.json')]) == 0
        assert ('this machine is busy (load 50.0' in capsys.readouterr().err) is told


def test_an_unknown_benchmark_is_unusable_input(course, tmp_path, capsys):
    make_benchmark(tmp_path, 'quick', 'yield')
    assert app.main(['bench', 'nix']) == 2
    assert capsys.readouterr().err == "course: no benchmark 'nix'; there are: quick\n"


def test_the_courses_own_benchmarks_say_what_they_measure():
    found = benchmarks.find(paths.ROOT)
    assert {'command', 'wire'} <= set(found)
    assert all(benchmarks.title(path) for path in found.values())


def test_names_of_what_is_left_out_do_no_harm():
    """An archive of a learner's may hold names that are no text, or that move the cursor of the terminal."""
    screen = io.TextIOWrapper(io.BytesIO(), encoding='utf-8')
    names = ['\udcff.txt', '\x1b[2J\x1b]0;x\x07.txt', 'a\n::error::b.txt', 'x' * 5000]
    grade_command._warn([Path('submissions', name) for name in names], 'bubblewrap', Console(file=screen, width=80))
    screen.flush()
    shown = screen.buffer.getvalue().decode()
    assert '\x1b' not in shown and '\n::error' not in shown and len(shown) < 3000
