"""The journal of executed cells."""

import time

from helpers.kernel import journal


def test_it_is_empty_outside_a_kernel():
    journal.start()
    assert journal.number() == 0 and not journal.in_kernel()


def test_it_notes_earlier_cells_the_importing_one_and_all_later_ones(kernel):
    kernel.ok('earlier = 1')
    kernel.ok('import helpers')
    kernel.ok('from helpers.kernel import journal')
    kernel.run('1 / 0')
    kernel.run('broken(')
    kernel.run('unseen = 2', store_history=False)  # as nbval executes
    assert kernel.value('[cell.source for cell in journal.cells]') == [
        'earlier = 1',
        'import helpers',
        'from helpers.kernel import journal',
        '1 / 0',
        'broken(',
        'unseen = 2',
        '[cell.source for cell in journal.cells]',
    ]


def test_the_importing_cell_is_noted_without_history(kernel):
    kernel.run('import helpers', store_history=False)
    assert kernel.value('[cell.source for cell in helpers.kernel.journal.cells][0]') == 'import helpers'


def test_cell_ids_of_the_front_end(kernel):
    client = kernel.client
    for source, cell_id in (('import helpers', 'first'), ('x = 1', 'ex-3-1'), ('x = 2', 'ex-3-1')):
        message = client.session.msg(
            'execute_request',
            {'code': source, 'silent': False, 'store_history': True, 'user_expressions': {}, 'allow_stdin': False},
            metadata={'cellId': cell_id},
        )
        client.shell_channel.send(message)
        client._recv_reply(message['header']['msg_id'], timeout=60)
    noted = kernel.value('[tuple(cell) for cell in helpers.kernel.journal.cells][:3]')
    assert [cell[:2] for cell in noted] == [('first', 'import helpers'), ('ex-3-1', 'x = 1'), ('ex-3-1', 'x = 2')]
    first, *later = [cell[2] for cell in noted]
    assert first == 0 and time.time() - 60 < later[0] < later[1] < time.time()
    kernel.ok('latest = helpers.kernel.journal.latest')
    assert kernel.value('latest("ex-3-1").source, latest("none")') == ('x = 2', None)
