"""`check` and `submit` in a kernel, on the command line, and what they show."""

import dataclasses
import json
import os
import re
import shutil
import time
import zipfile

import nbformat
import pytest
from nbclient import NotebookClient
from typer.testing import CliRunner

from helpers import paths
from helpers.cli import Refusal
from helpers.cli.app import make_app
from helpers.exercises import exercise_check, handing_in, manifest, notebooks, progress_file, result_display
from helpers.kernel.journal import ExecutedCell
from helpers.runner import results, session
from helpers.runner.results import ExerciseResult, TestResult
from helpers.tests import small


def result(verdict='failed', **changes):
    tests = [
        TestResult('a', '90.1', False, 1, 'passed', 'First.\n\nLook.'),
        TestResult(
            'b', '90.1', False, 1, verdict, 'Second.\n\nLook\nthere.', 'It was <3>.\nReally.', 'line 3', 'printed'
        ),
    ]
    return ExerciseResult(
        **{'id': '90.1', 'title': 'a talker', 'points': 10, 'verdict': verdict, 'score': 5.0, 'tests': tests, **changes}
    )


def test_what_a_failure_looks_like():
    assert result_display.plain([result()]).splitlines() == [
        'Exercise 90.1: a talker',
        '  It was <3>.',
        '  Really.',
        '    ✗ Second.',
        '      | line 3',
        '  1 of 2 tests passed: not there yet. The tests are in `helpers/checks/chapter_90/test_90_1.py`.',
    ]
    page = result_display.html([result()])
    assert 'It was &lt;3&gt;.' in page and '<details' in page and 'printed' in page and '<script' not in page
    # A theme decides on the colours of text and ground.
    assert not re.search(r'[^-]color: (black|white|#000|#fff)|background', page)


def rules(*states):
    return [
        results.RuleResult(name, f'The {name} is right.', state, 'no way' * (state == 'not_looked_at'))
        for name, state in zip(('rate', 'text', 'depth'), states, strict=False)
    ]


def test_rules_are_named():
    """The cause comes first, then the rule that it breaks; a general hint only where the test asks for it."""
    work = result(rules=rules('kept', 'broken', 'not_looked_at'))
    work.tests[1].rule = 'text'
    assert result_display.plain([work]).splitlines()[1:] == [
        '  It was <3>.',
        '  Really.',
        '    ✗ text: The text is right.',
        '      | line 3',
        '  Not looked at yet: depth (no way).',
        '  Kept: rate.',
        '  1 of 3 rules are kept: not there yet. The tests are in `helpers/checks/chapter_90/test_90_1.py`.',
    ]
    work.tests[1].hint = True
    assert 'Look there.' in result_display.plain([work]) and 'Look there.' in result_display.html([work])
    done = result('passed', rules=rules('kept', 'kept', 'not_looked_at'))
    assert result_display.plain([done]).splitlines()[1:] == [
        '  Not looked at here: depth (no way).',
        '  Solved: 2 of 3 rules are kept. When your work is graded, they are tried with other values.',
    ]


def test_code_is_set_as_code_and_a_faulty_test_is_no_cross():
    assert result_display.code('Use `a < b`, not <c>.') == 'Use <code>a &lt; b</code>, not &lt;c&gt;.'
    failed, faulty = result().tests[1], result('grader_error').tests[1]
    assert [result_display.mark(test)[0] for test in (failed, faulty)] == ['✗', '?']


def test_the_same_error_is_told_once():
    test = result('learner_crashed').tests[1]
    both = [dataclasses.replace(test, test=name) for name in 'ab']
    for text in (result_display.plain([result(tests=both)]), result_display.html([result(tests=both)])):
        assert text.count('Really.') == text.count('The same as above.') == 1
        assert 'there.' not in text  # what to look at for another reason


def test_what_broke_the_same_rule_in_the_same_way_is_told_once():
    test = dataclasses.replace(result(rules=rules('kept', 'broken', 'kept')).tests[1], rule='text')
    work = result(rules=rules('kept', 'broken', 'kept'), tests=[dataclasses.replace(test, test=name) for name in 'abc'])
    for text in (result_display.plain([work]), result_display.html([work])):
        assert text.count('Really.') == text.count('The text is right.') == 1 and 'The same as above.' not in text


def test_what_of_the_cells_did_not_run_is_told_with_what_failed():
    """It may be the cause; whose answer is right need not know it."""
    for work in (result(rules=rules('kept', 'broken', 'kept')), result()):
        work = dataclasses.replace(work, message='`TABLE` is changed in cell 3.\n`%time` was left out.')
        assert '\n  `TABLE` is changed in cell 3.\n  `%time` was left out.\n' in result_display.plain([work])
        assert '<code>TABLE</code> is changed in cell 3.' in result_display.html([work])
    assert 'left out' not in result_display.plain([dataclasses.replace(result('passed'), message='It was left out.')])


@pytest.mark.parametrize(
    ('exercise', 'text'),
    [
        (result('passed'), 'Solved: 2 of 2 tests passed. When your work is graded, they are tried with other values.'),
        (results.without_tests(small.exercise(), 'not_attempted', ''), 'Not solved yet: write your code'),
        (results.without_tests(small.exercise(), 'invalid_submission', 'Define it.'), 'Define it.'),
        (result('grader_error', score=None), 'The check itself failed, not your code.'),
        (result('timeout'), '1 of 2 tests passed: does not come to an end.'),
        (result('learner_crashed'), '1 of 2 tests passed: stops with an error.'),
        (result('invalid_submission'), '1 of 2 tests passed: cannot be run.'),
    ],
)
def test_summaries(exercise, text):
    assert text in result_display.plain([exercise]) and text in result_display.html([exercise])
    assert result_display.html([exercise]) == result_display.html([exercise])


def test_the_latest_cells_of_a_kernel(monkeypatch):
    """The newest version of each cell, the exercise last; cells without an id are told apart by their text."""
    exercise = small.exercise()
    first = '# Exercise 90.1: a talker\nclass Talker: old'
    second = '# Exercise 90.1: a talker\nclass Talker: new'
    monkeypatch.setattr(
        exercise_check.journal,
        'cells',
        [
            ExecutedCell('i', 'import os'),
            ExecutedCell('x', first),
            ExecutedCell(None, 'A = 1'),
            ExecutedCell('i', 'import sys'),
            ExecutedCell('x', second),
            ExecutedCell(None, 'A = 1'),
            ExecutedCell('y', '# Exercise 90.2: b\nB = 1'),
        ],
    )
    assert [cell.source for cell in exercise_check.executed(exercise)] == [
        'import sys',
        'A = 1',
        '# Exercise 90.2: b\nB = 1',
        second,
    ]
    monkeypatch.setattr(exercise_check.journal, 'cells', [ExecutedCell('i', 'import os')])
    assert exercise_check.executed(exercise) is None


@pytest.mark.parametrize(
    ('cells', 'expected'),
    [
        ([('x', 'class Talker: pass'), ('t', 'X = 1\nTalker()')], ['t', 'x']),  # tried in a cell with the same heading
        ([('t', 'X = 1\nTalker()'), ('x', 'class Talker: pass')], ['t', 'x']),
        ([('x', 'class Talker: pass'), ('x', 'class Talkre: pass')], ['x']),  # the name has got lost
        ([('x', 'class Talker: old'), ('c', 'class Talker: new')], ['c']),  # a copy
        ([('x', 'pass'), ('t', 'Talker()')], ['t']),
    ],
)
def test_cells_with_one_heading(monkeypatch, cells, expected):
    heading = '# Exercise 90.1: a talker\n'
    monkeypatch.setattr(exercise_check.journal, 'cells', [ExecutedCell(name, heading + text) for name, text in cells])
    found = exercise_check.executed(small.exercise())
    assert [cell.id for cell in found] == expected and found[-1].source.endswith(dict(cells)[expected[-1]])


@pytest.mark.parametrize(
    ('rate', 'answer', 'ran', 'verdict', 'expected'),
    [
        (5, 'rate = RATE', 900.0, 'passed', []),
        (6, 'rate = RATE', 900.0, 'passed', ['The cell that defines `RATE` was changed']),
        (6, 'rate = RATE', 1100.0, 'passed', []),  # run after the notebook was saved: the next saving brings it
        (6, 'rate = RATE', 0.0, 'passed', []),
        (6, 'rate = RATE', 900.0, 'failed', []),
        (5, 'rate = 7', 900.0, 'failed', ['The cell of this exercise was changed and saved after you ran it.']),
        (5, 'rate = 7', 900.0, 'passed', ['The cell of this exercise was changed and saved after you ran it.']),
        (5, 'rate = 7', 1100.0, 'failed', []),
    ],
)
def test_a_cell_that_was_edited_and_not_run_is_named(tmp_path, monkeypatch, rate, answer, ran, verdict, expected):
    exercise = small.exercise()
    heading = '# Exercise 90.1: a talker\nclass Talker:\n    '
    sources = {'helper': f'RATE = {rate}', 'answer': heading + answer}
    cells = [nbformat.v4.new_code_cell(source, id=name) for name, source in sources.items()]
    path = tmp_path / exercise.notebook
    nbformat.write(nbformat.v4.new_notebook(cells=cells), path)
    os.utime(path, (1000, 1000))
    monkeypatch.setattr(exercise_check.paths, 'NOTEBOOKS', tmp_path)
    monkeypatch.setattr(manifest, 'load', lambda: {exercise.id: exercise})
    noted = [ExecutedCell('helper', 'RATE = 5', ran), ExecutedCell('answer', heading + 'rate = RATE', ran)]
    monkeypatch.setattr(exercise_check.journal, 'cells', noted)
    said = exercise_check._unlike_saved([result(verdict, tests=[])])
    assert [line.startswith(words) for line, words in zip(said, expected, strict=True)] == [True] * len(expected)


@pytest.mark.parametrize(
    ('here', 'verdict', 'said'),
    [
        ('notebooks/90.ipynb', 'passed', ''),
        ('link/90.ipynb', 'passed', ''),  # the same file
        ('notebooks/90-Copy1.ipynb', 'passed', 'This notebook is 90-Copy1.ipynb, and only 90.ipynb is handed in: copy'),
        ('notebooks/old/90.ipynb', 'passed', f'This notebook is old{os.sep}90.ipynb, and only 90.ipynb is handed in'),
        ('notebooks/90-Copy1.ipynb', 'failed', ''),
        ('notebooks/renamed.ipynb', 'passed', ''),  # not there: it has another name by now
        ('solutions/90.ipynb', 'passed', ''),
    ],
)
def test_a_right_answer_in_another_notebook_is_not_handed_in(tmp_path, monkeypatch, here, verdict, said):
    exercise = dataclasses.replace(small.exercise(), notebook='90.ipynb')
    for name in ('notebooks/90.ipynb', 'notebooks/90-Copy1.ipynb', 'notebooks/old/90.ipynb', 'solutions/90.ipynb'):
        if not name.startswith('solutions') or here.startswith('solutions'):  # the learners' edition has none
            (tmp_path / name).parent.mkdir(exist_ok=True)
            (tmp_path / name).touch()
    (tmp_path / 'link').symlink_to(tmp_path / 'notebooks')
    monkeypatch.setattr(exercise_check.paths, 'ROOT', tmp_path)
    monkeypatch.setattr(exercise_check.paths, 'NOTEBOOKS', tmp_path / 'notebooks')
    monkeypatch.setattr(manifest, 'load', lambda: {exercise.id: exercise})
    monkeypatch.setenv('JPY_SESSION_NAME', str(tmp_path / here))
    told = exercise_check._elsewhere([result(verdict, tests=[])])
    assert [line.startswith(said) for line in told] == [True] * bool(said)


def test_check_never_raises(monkeypatch, capsys):
    exercise_check.check('99.9')
    assert 'there is no exercise' in capsys.readouterr().out
    exercise_check.check(8.10)
    assert 'Write quotes: check("8.1") or check("8.10")' in capsys.readouterr().out
    exercise_check.check(99.9)
    assert "there is no exercise '99.9'; there are 1.1 to 1.4, 2.1 to 2.5, " in capsys.readouterr().out
    exercise_check.check('3.10')
    assert "there is no exercise '3.10'; there are 3.1, 3.2, 3.3, 3.4, 3.5, 3.6. " in capsys.readouterr().out
    monkeypatch.setattr(exercise_check, 'run_tests', lambda exercise_id: print(f'<{exercise_id}>') or 1 / 0)
    for written in (' 3.1 ', '3.1.', '３．１', 3.1):  # noqa: RUF001 - the wide digits of an input method
        exercise_check.check(written)
        assert '<3.1>' in capsys.readouterr().out
    monkeypatch.undo()
    for error, text in ((RuntimeError('boom'), 'The check could not run: boom'), (KeyboardInterrupt(), 'was stopped')):

        def fail(exercise_id, error=error):
            raise error

        monkeypatch.setattr(exercise_check, 'run_tests', fail)
        exercise_check.check('3.1')
        assert text in capsys.readouterr().out


def test_check_inside_of_a_tested_cell_does_nothing(monkeypatch, capsys):
    monkeypatch.setenv('COURSE_RUNNER', '1')
    exercise_check.check('3.1')
    handing_in.submit()
    assert capsys.readouterr().out == ''


@pytest.mark.timeout(300)
def test_check_in_a_kernel():
    """On the first exercise of the course: before its cell has run, unsolved, and wrong."""
    exercise = next(iter(manifest.load().values()))
    heading = f'# Exercise {exercise.id}: {exercise.title}\n'
    cells = ['from helpers import check', f'check("{exercise.id}")', heading + 'x = 1', f'check("{exercise.id}")']
    notebook = nbformat.v4.new_notebook(cells=[nbformat.v4.new_code_cell(source) for source in cells])
    NotebookClient(notebook, kernel_name='python3', timeout=120).execute()
    first, second = (notebook.cells[number].outputs[0].data for number in (1, 3))
    assert 'Run the cell that begins with' in first['text/plain'] and 'Run the cell' in first['text/html']
    assert f'must define `{exercise.names[0]}`' in second['text/plain']


def test_check_command(tmp_path):
    exercise = next(iter(manifest.load().values()))
    run = CliRunner().invoke
    found = run(make_app(), ['check', exercise.id])
    assert found.exit_code == 1 and 'Not solved yet' in found.output  # the learner's notebook of this checkout
    for wrong in (['check', 'three'], ['check', '77'], ['check', exercise.id, '--notebooks', str(tmp_path)]):
        assert isinstance(run(make_app(), wrong).exception, Refusal)


@pytest.mark.timeout(300)
@pytest.mark.parametrize('problem', ['', 'bubblewrap is not installed'])
def test_check_of_others_says_whose_code_runs_and_where(tmp_path, monkeypatch, problem):
    pytest.importorskip('grading', reason="the learner's edition has no instructor's half")
    from grading import sandbox

    exercise = next(iter(manifest.load().values()))
    shutil.copy(paths.NOTEBOOKS / exercise.notebook, tmp_path)
    monkeypatch.setattr(sandbox, 'problem', lambda: problem)
    found = CliRunner().invoke(make_app(), ['check', exercise.id, '--notebooks', str(tmp_path)])
    assert f'The programs in the notebooks of {tmp_path} run' in found.output
    assert ('with your rights' in found.output and problem in found.output) if problem else 'sandbox' in found.output


@pytest.mark.timeout(300)
def test_submit(tmp_path):
    """The packed file holds the notebooks without outputs, and is the same each time."""
    found = CliRunner().invoke(make_app(), ['submit', '--id', 'ada', '-o', str(tmp_path / 'ada.zip')])
    assert found.exit_code == 0 and '0 of' in found.output and 'Not solved yet' in found.output
    assert found.output.index('Packed for ada') < found.output.index('Exercise 1.1') < found.output.index('0 of')
    again = handing_in.pack('ada', tmp_path / 'again.zip')
    assert again.path.read_bytes() == (tmp_path / 'ada.zip').read_bytes()
    with zipfile.ZipFile(again.path) as archive:
        label = json.loads(archive.read('submission.json'))
        saved = max(path.stat().st_mtime for path in paths.NOTEBOOKS.glob('*.ipynb'))
        assert label.pop('saved') == time.strftime('%Y-%m-%dT%H:%M:%SZ', time.gmtime(saved))
        assert label == {'format': 1, 'learner': 'ada'}


@pytest.mark.timeout(300)
def test_submit_names_what_a_check_has_found_solved_and_nobody_has_saved(tmp_path):
    first, second = list(manifest.load().values())[:2]
    shutil.copy(paths.NOTEBOOKS / first.notebook, tmp_path)
    marks = {
        first.id: progress_file.Mark(first.points, first.points, passed=True),
        second.id: progress_file.Mark(second.points, 0.0, passed=False),
    }
    (tmp_path / progress_file.FILE).write_text(
        json.dumps({one: dataclasses.asdict(mark) for one, mark in marks.items()})
    )
    packed = handing_in.pack('ada', tmp_path / 'x.zip', notebooks_folder=tmp_path)
    assert not packed.warnings and [len(results) for results in handing_in.tested(packed)] == [4]
    (said,) = packed.warnings
    assert said.startswith(f'Exercise {first.id}: its last check found it solved') and first.notebook in said


def test_who_stops_the_tests_of_submit_has_the_file(tmp_path, monkeypatch):
    def stop(*_):
        raise KeyboardInterrupt

    monkeypatch.setattr(session, 'run', stop)
    found = CliRunner().invoke(make_app(), ['submit', '--id', 'ada', '-o', str(tmp_path / 'ada.zip')])
    assert 'Packed for ada' in found.output and found.exit_code
    with zipfile.ZipFile(tmp_path / 'ada.zip') as archive:
        assert archive.testzip() is None and 'submission.json' in archive.namelist()


def test_submit_packs_what_grading_can_read(tmp_path):
    """A notebook of an old format, and one with a number that Python itself does not read."""
    old, other, *_ = dict.fromkeys(exercise.notebook for exercise in manifest.load().values())
    cell = {'cell_type': 'code', 'input': 'x = 1', 'language': 'python', 'metadata': {}, 'outputs': []}
    head = {'nbformat': 3, 'nbformat_minor': 0, 'metadata': {'name': ''}}
    (tmp_path / old).write_text(json.dumps({**head, 'worksheets': [{'metadata': {}, 'cells': [cell]}]}))
    (tmp_path / other).write_text('{"nbformat": 4, "metadata": {"x": %s}, "cells": []}' % ('9' * 5000))
    packed = handing_in.pack('ada', tmp_path / 'x.zip', notebooks_folder=tmp_path)
    with zipfile.ZipFile(packed.path) as archive:
        kept = [json.loads(archive.read(name)) for name in archive.namelist() if name.endswith('.ipynb')]
    assert [one['nbformat'] for one in kept] == [4, 4] and kept[0]['cells'][0]['source'] == 'x = 1'


def test_submit_names_answers_in_copies(tmp_path):
    """JupyterLab's *Duplicate* makes notebooks with other names, which nobody grades."""
    exercise = manifest.load()['3.1']
    original = nbformat.read(paths.NOTEBOOKS / exercise.notebook, as_version=4)
    nbformat.write(original, tmp_path / exercise.notebook)
    nbformat.write(original, tmp_path / 'unsolved-Copy1.ipynb')
    (tmp_path / 'broken.ipynb').write_text('{')
    cell = next(cell for cell in original.cells if cell.source.startswith('# Exercise 3.1'))
    cell.source += '\nanswer = 42'
    nbformat.write(original, tmp_path / 'solved-Copy1.ipynb')
    packed = handing_in.pack('ada', tmp_path / 'x.zip', notebooks_folder=tmp_path)
    (said,) = packed.warnings
    assert said.startswith('solved-Copy1.ipynb is not in the file') and 'other cells of 3.1: copy' in said
    nbformat.write(original, tmp_path / exercise.notebook)
    assert not handing_in.pack('ada', tmp_path / 'x.zip', notebooks_folder=tmp_path).warnings


@pytest.mark.parametrize('learner', ['../x', '=1', 'a b', 'ü', '', 'x' * 65])
def test_unusable_ids(tmp_path, monkeypatch, learner):
    monkeypatch.setattr(handing_in, '_login', lambda: 'no good')
    with pytest.raises(handing_in.SubmissionError, match='cannot be an id'):
        handing_in.pack(learner, tmp_path / 'x.zip')
    assert not list(tmp_path.iterdir())


def test_half_a_surrogate_pair_is_handed_in_as_it_is(tmp_path):
    """An emoji that was cut in two would make the whole notebook unreadable, if it were written as UTF-8."""
    name = next(iter(manifest.load().values())).notebook
    (tmp_path / name).write_bytes(small.notebook('x = "\ud83d"'))
    packed = handing_in.pack('ada', tmp_path / 'x.zip', notebooks_folder=tmp_path)
    with zipfile.ZipFile(packed.path) as archive:
        assert 'x = "\ud83d"' in [cell.source for cell in notebooks.parse(archive.read(name), name)]


def test_nothing_to_submit(tmp_path):
    with pytest.raises(handing_in.SubmissionError, match='no notebook of the course'):
        handing_in.pack('ada', tmp_path / 'x.zip', notebooks_folder=tmp_path)
    name = next(iter(manifest.load().values())).notebook
    (tmp_path / name).write_text('{')
    with pytest.raises(handing_in.SubmissionError, match='not valid JSON'):
        handing_in.pack('ada', tmp_path / 'x.zip', notebooks_folder=tmp_path)
    (tmp_path / name).write_bytes(small.notebook('x'))
    with pytest.raises(handing_in.SubmissionError, match='cannot be written'):
        handing_in.pack('ada', tmp_path / name / 'x.zip', notebooks_folder=tmp_path)
