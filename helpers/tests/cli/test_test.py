"""``./course test``: it goes on after a failure, counts honestly and ends with the right status."""

import contextlib
import os

import pytest
import typer

from helpers import paths
from helpers.cli import test as command


@pytest.fixture(autouse=True)
def quick_start(monkeypatch):
    """The runs of pytest here load no plugin but xdist, whose options they are given: it saves most of their time."""
    monkeypatch.setenv('PYTEST_DISABLE_PLUGIN_AUTOLOAD', '1')
    monkeypatch.setenv('PYTEST_PLUGINS', 'xdist.plugin')


def plan(monkeypatch, *steps):
    """Let the command run these steps, and compile nothing for them."""
    monkeypatch.setattr(command, '_compiling', contextlib.nullcontext)
    monkeypatch.setattr(command, '_plan', lambda: [lambda scratch, step=step: [step] for step in steps])


def run(arguments=None):
    with pytest.raises(typer.Exit) as end:
        command.test(arguments)
    return end.value.exit_code


def test_all_steps_run_and_one_failure_decides(monkeypatch, capsys):
    two = command.Step('two', passed=1, failed=1)
    plan(monkeypatch, command.Step('one', passed=3), two, command.Step('three', passed=2))
    assert run() == 1
    lines = capsys.readouterr().out.splitlines()
    assert [line.split()[0] for line in lines[-5:-2]] == ['passed', 'FAILED', 'passed']
    assert lines[-2] == '0 unstable'
    assert lines[-1].startswith('6 passed, 1 failed, 0 skipped in ')


def test_success_is_zero(monkeypatch):
    plan(monkeypatch, command.Step('one', passed=3))
    assert run() == 0


def test_all_that_runs_keeps_what_it_has_compiled_and_speaks_english(monkeypatch):
    monkeypatch.setenv('PYTHONDONTWRITEBYTECODE', '1')
    monkeypatch.setenv('LC_ALL', 'zh_CN.UTF-8')
    monkeypatch.setenv('LANGUAGE', 'zh_CN:zh')
    seen = []
    plan(monkeypatch)
    monkeypatch.setattr(
        command, '_plan', lambda: [lambda scratch: seen.append(dict(os.environ)) or [command.Step('one', passed=1)]]
    )
    assert run() == 0
    assert 'PYTHONDONTWRITEBYTECODE' not in seen[0]
    assert (seen[0]['LC_ALL'], seen[0]['LANGUAGE']) == ('C.UTF-8', '')


def test_pytest_is_counted(tmp_path, capfd):
    sample = tmp_path / 'test_sample.py'
    sample.write_text(
        'import pytest\n\ndef test_a(): pass\n\ndef test_b(): assert 0\n'
        '\ndef test_c(): pytest.skip("no")\n'
        '\n@pytest.fixture\ndef broken(): raise OSError\n\ndef test_d(broken): pass\n'
    )
    step = command._pytest('sample', tmp_path, ['-q', '-p', 'no:cacheprovider', str(sample)])
    assert (step.passed, step.failed, step.skipped) == (1, 2, 1)
    assert command._summary([step, step], 2.0) == 1
    assert 'skipped: 2 tests: no\n' in capfd.readouterr().out


@pytest.mark.parametrize('text', ['', 'import nothing_of_this_name\n', 'def broken(:\n'])
def test_a_run_without_tests_is_a_failure(tmp_path, capfd, text):
    sample = tmp_path / 'test_sample.py'
    sample.write_text(text)
    step = command._pytest('sample', tmp_path, ['-q', '-p', 'no:cacheprovider', str(sample)])
    assert (step.passed, step.failed) == (0, 1)


def test_a_failing_command_is_one_failure(capfd):
    assert command._command('bad', ['-c', 'raise SystemExit(3)']).failed == 1
    assert command._command('good', ['-c', '']).passed == 1


def test_with_arguments_only_pytest_runs(monkeypatch, tmp_path, capfd):
    monkeypatch.setattr(command, '_plan', lambda: pytest.fail('the plan ran'))
    sample = tmp_path / 'test_sample.py'
    sample.write_text('def test_a(): pass\n\ndef test_b(): assert 0\n')
    chosen = [str(sample), '-p', 'no:cacheprovider', '-k']
    assert run([*chosen, 'test_a']) == 0
    assert run([*chosen, 'test_b']) == 1
    assert run([*chosen, 'nothing']) == 2


def test_what_failed_beside_others_has_to_pass_alone_and_is_named(monkeypatch, tmp_path, capfd):
    sample = tmp_path / 'test_sample.py'
    sample.write_text(
        'from pathlib import Path\n\ndef test_good(): pass\n\ndef test_broken(): assert 0\n'
        '\ndef test_starved():\n    mark = Path(__file__).with_name("once")\n'
        '    once, _ = mark.exists(), mark.touch()\n    assert once\n'
    )
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(command, '_workers', lambda: 0)
    monkeypatch.setenv('PYTEST_ADDOPTS', f'--rootdir={tmp_path} {sample}')
    (step,) = command._tests(tmp_path)
    assert (step.passed, step.failed) == (2, 1)
    assert step.unstable == ['test_sample.test_starved'] and step.failures == ['test_sample.test_broken']
    plan(monkeypatch, step)
    assert run() == 1
    assert 'unstable: test_sample.test_starved failed beside other tests and passed alone' in capfd.readouterr().out


def test_what_did_not_come_to_run_again_has_failed():
    step = command.Step('tests', passed=5, failed=2, failures=['sample.first', 'sample.second'])
    again = command.Step('again', passed=1, failed=1, failures=['sample'], succeeded={'sample.second'})
    after = command._after(step, again, 6)
    assert (after.failures, after.unstable, after.failed) == (['sample.first'], ['sample.second'], 1)


@pytest.mark.one_of(2)
def test_a_notebook_of_which_a_cell_failed_beside_others_has_to_pass_alone(monkeypatch, tmp_path, capfd):
    pytest.importorskip('grading', reason="the learner's edition has no instructor's half")
    import nbformat

    from grading.authoring import execution, repeated

    starved = "from pathlib import Path\nmark = Path('once')\nonce, _ = mark.exists(), mark.touch()\nassert once"
    copies = []
    for folder, source in (('solutions', starved), ('notebooks', 'assert 0'), ('notebooks', '1')):
        path = tmp_path / folder / f'{len(copies):02}_chapter.ipynb'
        path.parent.mkdir(exist_ok=True)
        cells = [nbformat.v4.new_code_cell(source, id='only')]
        nbformat.write(nbformat.v4.new_notebook(cells=cells), path)
        copies.append(path)
    for name in ('PYTEST_DISABLE_PLUGIN_AUTOLOAD', 'PYTEST_PLUGINS'):
        monkeypatch.delenv(name)
    monkeypatch.chdir(tmp_path)
    plugin = ['-p', 'grading.authoring.nbval_plugin', f'--rootdir={tmp_path}']
    arguments = [*repeated.nbval_arguments(execution.kernel_name()), *plugin]
    quick = tmp_path / 'test_quick.py'
    quick.write_text('def test_a(): pass\n')
    other = command.Run('quick', ['-p', 'no:cacheprovider', str(quick)], 1, lambda step: [])
    first, step = command._side_by_side([other, command._run_of_notebooks(copies, arguments, 2)], tmp_path)
    assert (first.name, first.passed, first.failed) == ('quick', 1, 0)
    assert (step.passed, step.failed) == (2, 1)
    assert ['01_chapter' in name for name in step.failures] == [True]
    assert ['00_chapter' in name for name in step.unstable] == [True]


def test_many_failures_are_no_accident(monkeypatch, tmp_path, capfd):
    sample = tmp_path / 'test_sample.py'
    sample.write_text(
        f'import pytest\n\n@pytest.mark.parametrize("n", range({command.FEW + 1}))\ndef test_bad(n): assert 0\n'
    )
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(command, '_workers', lambda: 0)
    monkeypatch.setenv('PYTEST_ADDOPTS', f'--rootdir={tmp_path} {sample}')
    (step,) = command._tests(tmp_path)
    assert step.failed == command.FEW + 1
    assert 'one at a time' not in capfd.readouterr().out


def test_the_learners_edition_leaves_out_what_it_lacks(monkeypatch):
    pytest.importorskip('grading', reason="the learner's edition has no instructor's half")
    names = [step.__name__ for step in command._plan()]
    assert names == ['_texts_and_types', '_tests_and_notebooks']
    monkeypatch.setattr(command, 'find_spec', lambda name: None)
    assert [step.__name__ for step in command._plan()] == ['_texts', '_tests']


def test_notebooks_that_are_not_there_are_a_failure(monkeypatch, tmp_path, capsys):
    pytest.importorskip('grading', reason="the learner's edition has no instructor's half")
    monkeypatch.setattr(paths, 'ROOT', tmp_path)
    monkeypatch.setattr(paths, 'NOTEBOOKS', tmp_path / 'notebooks')
    monkeypatch.setattr(command, '_tests', lambda scratch: [command.Step('unit tests', passed=1)])
    assert [step.failed for step in command._tests_and_notebooks(tmp_path)] == [0, 1]
    assert 'run ./course build' in capsys.readouterr().out
