"""The learner's edition: nothing of the instructor's in it, and it works by itself."""

import os
import re
import shutil
import subprocess
import sys

import pytest

from grading import learners_edition
from helpers import paths

pytestmark = pytest.mark.one_of(2)


@pytest.fixture(scope='module')
def edition(tmp_path_factory):
    """The learner's edition of this checkout."""
    folder = tmp_path_factory.mktemp('edition') / 'course'
    learners_edition.release(folder)
    return folder


def test_what_is_in_it(edition):
    there = {path.name for path in edition.iterdir()}
    assert {'notebooks', 'helpers', 'environment', 'course', 'README.md', 'LICENSE', 'pyproject.toml'} <= there
    assert not there & {'solutions', 'grading', '.ci', '.git', '.venv', 'build'}
    assert list((edition / 'helpers' / 'checks').rglob('test_*.py'))
    assert os.access(edition / 'course', os.X_OK)


def test_scripts_keep_their_line_ends_on_windows(edition, tmp_path):
    """Git for Windows writes those of Windows if nothing says otherwise; WSL then finds no program for `course`."""
    course = tmp_path / 'course'
    course.mkdir()
    for name in ('.gitattributes', 'course', 'README.md'):
        shutil.copy(edition / name, course)
    git = ['git', '-c', 'core.autocrlf=true', '-c', 'user.name=ada', '-c', 'user.email=ada@example.org']
    for command in (['init', '-q'], ['add', '-A'], ['commit', '-q', '-m', 'the course']):
        subprocess.run([*git, *command], cwd=course, check=True)
    subprocess.run([*git, 'clone', '-q', course, tmp_path / 'clone'], check=True)
    assert not [path.name for path in (tmp_path / 'clone').iterdir() if path.is_file() and b'\r' in path.read_bytes()]


def test_no_solution_and_no_hidden_test(edition):
    hidden = [path.read_text() for path in (paths.ROOT / 'grading' / 'exercises').glob('*/hidden.py')]
    assert hidden
    for path in edition.rglob('*'):
        if path.is_file() and path.suffix in ('.py', '.ipynb', '.md', '.json'):
            text = path.read_text()
            assert text not in hidden
            assert path.suffix != '.ipynb' or 'BEGIN SOLUTION' not in text


def test_each_notebook_has_its_figures(edition):
    addresses = {
        notebook.parent / address
        for notebook in (edition / 'notebooks').glob('*.ipynb')
        for address in re.findall(r'\]\(([^)\s]+\.svg)\)', notebook.read_text())
    }
    assert addresses and addresses == set((edition / 'notebooks' / 'figures').iterdir())


@pytest.fixture(scope='module')
def run_there(edition):
    """Runs a function of the edition, by its full name, with arguments."""
    environment = {**os.environ, 'PYTHONPATH': str(edition), 'PYTHONDONTWRITEBYTECODE': '1'}

    def run(function, *arguments):
        module, _, name = function.rpartition('.')
        # Isolated from this checkout, which the environment's own path file would add.
        code = (
            f'import sys; sys.path[:] = [{str(edition)!r}] + [p for p in sys.path if p != {str(paths.ROOT)!r}]; '
            f'from {module} import {name}; sys.exit({name}(sys.argv[1:]))'
        )
        return subprocess.run(
            [sys.executable, '-c', code, *arguments],
            cwd=edition,
            env=environment,
            capture_output=True,
            text=True,
            timeout=250,
        )

    return run


def test_it_works_by_itself(run_there):
    """Commands of the learner's are there, the instructor's are not, and a check runs."""
    text = run_there('helpers.cli.app.main', '--help').stdout
    assert 'check' in text and 'submit' in text and 'grade' not in text and 'release' not in text
    found = run_there('helpers.cli.app.main', 'check', '3.1')
    assert 'Not solved yet' in found.stdout and found.returncode == 1, found.stderr


def test_its_own_tests_pass(edition, run_there):
    """Those that name what only the full course has; and its style."""
    tests = [
        str(path)
        for folder in ('helpers/tests/exercises', 'helpers/tests/cli', 'environment/tests')
        for path in (edition / folder).rglob('test_*.py')
        if re.search(r'grading|INSTRUCTOR|solutions', path.read_text()) and path.name != 'test_documentation.py'
    ]
    assert len(tests) > 2
    # The programs that tests start see this checkout, too.
    few = 'not in_a_kernel and not help_names_every_command'
    found = run_there('pytest.main', '-q', '-p', 'no:cacheprovider', '-k', few, *tests)
    assert found.returncode == 0, found.stdout
    style = subprocess.run(
        [sys.executable, '-m', 'ruff', 'check', '--no-cache', edition], capture_output=True, text=True
    )
    assert style.returncode == 0, style.stdout


def test_refusals(tmp_path):
    (tmp_path / 'x').write_text('')
    with pytest.raises(learners_edition.ReleaseError, match='not empty'):
        learners_edition.release(tmp_path)
    with pytest.raises(learners_edition.ReleaseError, match='no notebooks'):
        learners_edition.release(tmp_path / 'new', tmp_path)


@pytest.mark.parametrize(
    ('name', 'text'),
    [
        ('notebooks/x.ipynb', '# BEGIN SOLUTION'),
        ('helpers/x.py', 'import y\n\n\ndef test_secret(learner):\n    assert 1\n'),
    ],
)
def test_leaks(tmp_path, name, text):
    root = tmp_path / 'course'
    for path, content in (
        ('notebooks/a.ipynb', '{}'),
        (name, text),
        ('grading/exercises/1_1/hidden.py', 'def test_secret(learner):\n    assert 1\n'),
    ):
        (root / path).parent.mkdir(parents=True, exist_ok=True)
        (root / path).write_text(content)
    with pytest.raises(learners_edition.Leak, match=name):
        learners_edition.release(tmp_path / 'new', root)
    assert not (tmp_path / 'new').exists()


def test_a_workspace_beside_the_notebooks_is_left_out(tmp_path):
    """It may hold the solution of an exercise whose answer is a package; a copy without git has no .gitignore."""
    root = tmp_path / 'course'
    for name in (
        'notebooks/a.ipynb',
        'notebooks/my_ws/src/patrol/setup.py',
        'notebooks/ros2_ws_kept/1/x',
        'a_ws/src/b',
    ):
        (root / name).parent.mkdir(parents=True, exist_ok=True)
        (root / name).write_text('{}')
    assert learners_edition.files(root) == ['a_ws/src/b', 'notebooks/a.ipynb']
