"""What nbval finds in the repeated notebooks, run as ``./course test`` runs them: all the planted faults in one run."""

import subprocess
import sys
from pathlib import Path
from xml.etree import ElementTree

import nbformat
import pytest

from grading.authoring import execution, repeated
from helpers import paths

pytestmark = pytest.mark.timeout(300)  # five kernels, on a machine that may be busy

GOOD = """import rclpy
rclpy.init()
node = rclpy.create_node('good')
print(node.get_name())
node.destroy_node()
rclpy.shutdown()"""
THREAD = """import threading
threading.Thread(target=threading.Event().wait, name='waiter', daemon=True).start()"""
NOTEBOOKS = {  # name: cells, as (source, output on record; None: never executed)
    'good': [(GOOD, 'good\n')],
    'unsolved': [('print(1)', None)],
    'quiet': [('6 * 7;', ''), ('%%bash\necho hello', 'hello\n')],
    'faulty': [
        ('print(42)', '41\n'),
        ('1 / 0', ''),
        ("assert 'seen' not in globals()\nseen = 1", ''),
        ("count = globals().get('count', 0) + 1\nprint(count)", '1\n'),
    ],
    'leaves': [
        ("import rclpy\nrclpy.try_shutdown(); rclpy.init()\nnode = rclpy.create_node('forgotten')", ''),
        ('context = rclpy.Context()\ncontext.init()', ''),
        (THREAD, ''),
        ('import subprocess\nchild = subprocess.Popen(["sleep", "97"])', ''),
    ],
}


def notebook(cells):
    """A notebook of code cells that looks as if it had been executed, where an output is given."""
    nodes = [
        {
            'cell_type': 'code',
            'id': f'cell-{number}',
            'metadata': {},
            'source': source,
            'execution_count': None if text is None else number,
            'outputs': [{'output_type': 'stream', 'name': 'stdout', 'text': text}] if text else [],
        }
        for number, (source, text) in enumerate(cells)
    ]
    return nbformat.from_dict({'cells': nodes, 'metadata': {}, 'nbformat': 4, 'nbformat_minor': 5})


@pytest.fixture(scope='module')
def results(tmp_path_factory):
    """For each notebook: the ids of its tests, and the messages of those that failed."""
    folder = tmp_path_factory.mktemp('nbval')
    files = []
    for name, cells in NOTEBOOKS.items():
        path = folder / 'solutions' / f'{name}.ipynb'
        path.parent.mkdir(exist_ok=True)
        nbformat.write(notebook(cells), path)
        files.append(path)
    copies = repeated.write(files, folder / 'build')
    report = folder / 'report.xml'
    command = [
        sys.executable,
        '-m',
        'pytest',
        '-q',
        '-n2',
        f'--junitxml={report}',
        '--color=no',
        *repeated.nbval_arguments(execution.kernel_name(), 30),
        *map(str, copies),
    ]
    # Inside of the course's folder pytest would find conftest.py; here the plugin is named.
    done = subprocess.run([*command, '-p', 'conftest'], cwd=paths.ROOT, capture_output=True, text=True, timeout=280)
    assert report.exists(), done.stdout + done.stderr
    found = {name: {} for name in NOTEBOOKS}
    for case in ElementTree.parse(report).getroot().iter('testcase'):
        name = case.get('classname').split('.')[-2]
        failure = case.find('failure')
        found[name][case.get('name')] = None if failure is None else (failure.text or failure.get('message'))
    return found


def failures(results, name):
    """The failed tests of one notebook."""
    return {test: message for test, message in results[name].items() if message is not None}


def test_a_semicolon_hides_a_value_and_ipythons_own_thread_is_none_of_ours(results):
    assert len(results['quiet']) == 6
    assert failures(results, 'quiet') == {}


@pytest.mark.parametrize('name', ['good', 'unsolved'])
def test_a_good_notebook_passes_both_runs(results, name):
    assert list(results[name]) == ['note', 'cell-0-first', 'cell-0-second', 'leftovers']
    assert failures(results, name) == {}


def test_a_fault_is_found_in_both_runs_or_in_the_second(results):
    both, second = ('cell-0', 'cell-1'), ('cell-2', 'cell-3')  # a wrong output, an error; an error, another output
    assert set(failures(results, 'faulty')) == {
        *(f'{cell}-first' for cell in both),
        *(f'{cell}-second' for cell in both + second),
    }


def test_what_is_left_over_is_named(results):
    text = failures(results, 'leaves')['leftovers']
    for message in (
        'a valid rclpy context with node forgotten',
        'a valid rclpy context with no node',
        'thread waiter',
        'process sleep 97',
    ):
        assert message in text


def test_a_file_that_is_no_notebook_is_named(tmp_path):
    (tmp_path / 'odd.ipynb').write_text('{')
    with pytest.raises(ValueError, match='odd.ipynb is no notebook'):
        repeated.write([tmp_path / 'odd.ipynb'], tmp_path / 'out')


def test_what_takes_long_runs_once_in_a_solved_notebook_that_runs_twice_and_never_in_another_one():
    def skipped(text, runs=('first', 'second'), executed=None):
        long = notebook([('print(1)', text)])
        long.cells[0].metadata['tags'] = ['nbval-skip', 'other']
        long.cells[0].execution_count = executed
        cells = repeated.repeated(long, paths.ROOT, runs).cells
        return {cell.id: 'nbval-skip' in cell.metadata.tags for cell in cells if cell.id.startswith('cell-')}

    assert skipped('1\n') == {'cell-0-first': False, 'cell-0-second': True}
    assert skipped('1\n', ('first',)) == {'cell-0-first': True}
    assert skipped(None) == {'cell-0-first': True, 'cell-0-second': True}  # never executed
    assert skipped(None, executed=3) == {'cell-0-first': False, 'cell-0-second': True}  # it says nothing


def test_a_sample_runs_each_solved_notebook_and_draws_a_second_run_or_a_learners_notebook():
    found = [Path(folder, f'{number:02}.ipynb') for folder in ('solutions', 'notebooks') for number in range(1, 9)]
    solved, learners = found[:8], found[8:]
    seen_twice, seen_unsolved, drawn = set(), set(), 0
    for seed in map(str, range(200)):
        runs = repeated.sample(found, seed)
        twice = {path.stem for path in solved if runs(path) == ('first', 'second')}
        unsolved = {path.stem for path in learners if runs(path) == ('first',)}
        assert len(twice) + len(unsolved) <= 1
        drawn += len(twice) + len(unsolved)
        assert all(runs(path) for path in solved)
        seen_twice |= twice
        seen_unsolved |= unsolved
    assert seen_twice == seen_unsolved == {path.stem for path in found}
    assert 70 < drawn < 130  # in about half of the samples
    assert {repeated.all_twice(path) for path in solved} == {('first', 'second')}
    assert {repeated.all_twice(path) for path in learners} == {('first',)}


def test_a_notebook_that_is_not_drawn_is_not_written(tmp_path):
    source = tmp_path / 'notebooks' / '01.ipynb'
    source.parent.mkdir()
    nbformat.write(nbformat.v4.new_notebook(), source)
    assert repeated.write([source], tmp_path / 'out', lambda path: ()) == []
    assert repeated.write([source], tmp_path / 'out', lambda path: ('first',)) == [tmp_path / 'out/notebooks/01.ipynb']
