"""The plain command of nbval, without options of ours."""

import os
import re
import subprocess
import sys

import nbformat
import pytest

from grading.authoring import execution, repeated
from helpers import paths


@pytest.mark.one_of(2)
@pytest.mark.timeout(180)
@pytest.mark.parametrize('workers', [[], ['-n2']], ids=['one process', 'two workers'])
def test_the_plain_command_of_nbval_compares_as_the_build_does(tmp_path, workers):
    """``pytest --nbval -n 2 solutions``: an instructor who knows nbval needs no options of ours."""
    cells = [
        ('x = 41', None),
        ('x += 1;', None),
        ('x;', None),
        ('print("Finished in 3.2s")', 'Finished in 9.7s\n'),
        ('print("Finished <<< greeter [3.2s]")', 'Finished <<< greeter [… s]\n'),
        ('x', 'print: 42'),
        ('import os\nprint([os.environ[name] for name in ("LC_ALL", "LANGUAGE")])', "['C.UTF-8', '']\n"),
    ]
    nodes = []
    for number, (source, printed) in enumerate(cells):
        cell = nbformat.v4.new_code_cell(source, id=f'cell-{number}', execution_count=number)
        if printed:
            cell.outputs = [nbformat.v4.new_output('stream', name='stdout', text=printed)]
        nodes.append(cell)
    path = tmp_path / 'plain.ipynb'
    nbformat.write(nbformat.v4.new_notebook(cells=nodes), path)
    command = [sys.executable, '-m', 'pytest', '-q', '--nbval', *workers, '-p', 'conftest', '--color=no', str(path)]
    chinese = {**os.environ, 'LC_ALL': 'zh_CN.UTF-8', 'LANGUAGE': 'zh_CN:zh'}
    done = subprocess.run(command, cwd=paths.ROOT, env=chinese, capture_output=True, text=True, timeout=170)
    failed = re.findall(r'^FAILED .*::(\S+)', done.stdout, re.MULTILINE)
    assert failed == ['cell-3', 'cell-5'], done.stdout + done.stderr  # another text, and a value in place of a text


@pytest.mark.timeout(180)
@pytest.mark.parametrize('workers', [[], ['-n2']], ids=['one process', 'two workers'])
def test_what_takes_longest_comes_first(tmp_path, workers):
    """Chapter 4 twice takes longer than chapter 7, and that longer than chapter 1 with the most cells of all."""
    cells = {'01_a': 5, '04_b': 2, '07_c': 1, 'other': 6}
    sources = []
    for name, count in cells.items():
        sources.append(tmp_path / 'solutions' / f'{name}.ipynb')
        sources[-1].parent.mkdir(exist_ok=True)
        code = [nbformat.v4.new_code_cell('pass', id=f'cell-{number}') for number in range(count)]
        nbformat.write(nbformat.v4.new_notebook(cells=code), sources[-1])
    copies = repeated.write(
        sources, tmp_path / 'copies', lambda path: repeated.TWICE if path.stem == '04_b' else repeated.ONCE
    )
    command = [sys.executable, '-m', 'pytest', '-v', *workers, '-p', 'conftest', '--color=no', '-s']
    command += [*repeated.nbval_arguments(execution.kernel_name()), *map(str, copies)]
    done = subprocess.run(command, cwd=paths.ROOT, capture_output=True, text=True, timeout=170)
    assert done.returncode == 0, done.stdout + done.stderr
    if not workers:
        order = dict.fromkeys(re.findall(r'(\w+)(?:\.|::)ipynb::', done.stdout))
        assert list(order) == ['04_b', '07_c', '01_a', 'other'], done.stdout
    else:  # whichever is faster, each of the two begins with one of the first two
        done_by = re.findall(r'\[(gw\d)\] .*?(\w+)(?:\.|::)ipynb::', done.stdout)
        first = dict(reversed(done_by))
        assert set(first.values()) == {'04_b', '07_c'}, done.stdout
