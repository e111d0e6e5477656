"""Files that are written in parts: a cell that is run again does not append its part a second time."""

import pytest

from helpers.exercises import file_parts
from helpers.kernel import journal

FIRST = '%%writefile a.py\nimport re\n'
SECOND = '%%writefile -a a.py\n\ndef f():\n    return 1\n'
THIRD = '%%writefile -a a.py\n\nf()\n'
WHOLE = 'import re\n\ndef f():\n    return 1\n\nf()\n'


def _run(kernel, cell_id, source):
    kernel.client.session.adapt_version = 0
    message = kernel.client.session.msg(
        'execute_request',
        {'code': source, 'silent': False, 'store_history': True, 'user_expressions': {}, 'allow_stdin': False},
        metadata={'cellId': cell_id},
    )
    kernel.client.shell_channel.send(message)
    assert kernel.client.get_shell_msg(timeout=60)['content']['status'] == 'ok'


def test_each_cell_twice_in_a_row_writes_each_part_once(kernel, tmp_path):
    kernel.ok('import helpers')
    said = [kernel.ok(cell).stdout for cell in (FIRST, SECOND, SECOND, THIRD, THIRD, SECOND)]
    assert (tmp_path / 'a.py').read_text() == WHOLE
    again = 'Already in a.py: not appended again\n'
    assert said == ['Writing a.py\n', 'Appending to a.py\n', again, 'Appending to a.py\n', again, again]


def test_all_cells_again_write_the_same_file(kernel, tmp_path):
    kernel.ok('import helpers')
    for cell in (FIRST, SECOND, THIRD) * 2:
        kernel.ok(cell)
    assert (tmp_path / 'a.py').read_text() == WHOLE


def test_after_a_restart_the_part_is_known_too(kernel, tmp_path):
    (tmp_path / 'a.py').write_text(WHOLE)
    kernel.ok('import helpers')
    kernel.ok(SECOND)
    assert (tmp_path / 'a.py').read_text() == WHOLE


def test_a_folder_that_is_not_there_yet_is_told(kernel):
    kernel.ok('import helpers')
    done = kernel.run('%%writefile some_ws/src/a.py\nx = 1\n')
    told = 'there is no folder some_ws/src yet: run the cells above that make it'
    assert (done.error, done.message) == ('FileNotFoundError', told)


def test_an_edited_cell_replaces_what_it_appended_before(kernel, tmp_path):
    kernel.ok('import helpers')
    for cell_id, source in (
        ('one', FIRST),
        ('two', SECOND),
        ('three', THIRD),
        ('two', SECOND.replace('return 1', 'return 12')),
        ('two', '%%writefile -a a.py\n\ndef f():\n'),
    ):
        _run(kernel, cell_id, source)
    assert (tmp_path / 'a.py').read_text() == 'import re\n\ndef f():\n\nf()\n'
    texts = kernel.value('__import__("helpers.exercises.file_parts").exercises.file_parts.written()')
    assert texts == {'a.py': 'import re\n\ndef f():\n\nf()\n'}


@pytest.mark.parametrize('line', ['-a b.py', 'a.py', '-a'])
def test_anything_else_is_ipythons_own(kernel, tmp_path, line):
    (tmp_path / 'a.py').write_text(WHOLE)
    kernel.ok('import helpers')
    done = kernel.run(f'%%writefile {line}\nf()\n')
    assert ('UsageError' in done.stderr) == (line == '-a')
    assert (tmp_path / 'a.py').read_text() == ('f()\n' if line == 'a.py' else WHOLE)
    assert (tmp_path / 'b.py').is_file() == (line == '-a b.py')


@pytest.mark.parametrize('part', ['', '\n', 'eturn 1\n'])
def test_only_whole_lines_are_a_part_that_is_there(part):
    assert file_parts.with_part(WHOLE, part, None) == WHOLE + part


def test_what_cells_have_written_is_told_without_doubles(monkeypatch):
    cells = [journal.ExecutedCell(None, source) for source in (FIRST, SECOND, SECOND, 'x = 1', THIRD, THIRD)]
    monkeypatch.setattr(journal, 'cells', cells)
    assert file_parts.written() == {'a.py': WHOLE}
