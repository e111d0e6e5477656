"""How the tests' process calls pytest."""

import subprocess
import sys

import pytest

from helpers import paths
from helpers.runner import tester

LIST = """
import sys
import pytest
from helpers.runner import tester

listed = []
sys.addaudithook(lambda event, values: event == 'os.scandir' and listed.append(str(values[0])))
pytest.main([*tester.arguments(sys.argv[1:]), '--collect-only'])
print('LISTED', *listed, sep='\\n')
"""


@pytest.mark.parametrize('first', ['a folder', 'a file'])
def test_folders_above_the_tests_are_not_listed(tmp_path, first):
    """One may not be readable, as /home often is not, or hold very many files."""
    visible, hidden = tmp_path / 'course' / 'checks' / 'chapter_90', tmp_path / 'course' / 'exercises' / '90_1'
    for folder in (visible, hidden):
        folder.mkdir(parents=True)
        (folder / 'test_it.py').write_text('def test_it():\n    pass\n')
    done = subprocess.run(
        [sys.executable, '-c', LIST, str(visible / 'test_it.py' if first == 'a file' else visible), str(hidden)],
        cwd=paths.ROOT,
        capture_output=True,
        text=True,
        timeout=60,
    )
    assert '2 tests collected' in done.stdout, done.stdout + done.stderr
    listed = done.stdout.partition('LISTED')[2].split()
    assert str(visible) in listed and str(hidden) in listed
    assert not {str(tmp_path), *map(str, tmp_path.parents)} & set(listed)


def test_without_a_folder_pytest_is_called_all_the_same():
    assert '--confcutdir' not in tester.arguments([])
