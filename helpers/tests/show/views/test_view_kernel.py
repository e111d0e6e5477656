"""A view in a real kernel: what the cell gets, and that nothing remains, however it ends."""

import socket

from helpers.tests.real_kernel import Kernel

BEGIN = """
import helpers, IPython.display
outputs = []
plain = IPython.display.display


def display(content, **more):
    outputs.append(content._repr_mimebundle_())
    handle = plain(content, **more)
    handle.update = lambda content: outputs.append(content._repr_mimebundle_())
    return handle


IPython.display.display = display
"""
VIEW = """
helpers.ros.start()
view = helpers.TfView()
print(view.address.split(':')[2].split('/')[0])
"""


def start(kernel: Kernel) -> int:
    port = int(kernel.ok(VIEW).stdout)
    assert listening(port)
    return port


def listening(port: int) -> bool:
    with socket.socket() as probe:
        return probe.connect_ex(('127.0.0.1', port)) == 0


def test_a_view_leaves_nothing_behind(kernel):
    kernel.ok(BEGIN)
    first = start(kernel)
    second = start(kernel)  # the same cell again: the new view replaces the old one
    assert not listening(first)
    kernel.ok('view.stop()')
    kinds = kernel.value('[list(output)[0] for output in outputs]')
    assert kinds == ['text/html', 'image/svg+xml', 'text/html', 'image/svg+xml'], 'live, and a picture at the end'
    assert not listening(second)
    third = start(kernel)
    kernel.ok('helpers.ros.stop()')
    assert not listening(third) and kernel.value('list(outputs[-1])')[0] == 'image/svg+xml'
    assert 'views' not in kernel.value('[thread.name for thread in __import__("threading").enumerate()]')
    fourth = start(kernel)
    kernel.restart()
    kernel.ok('import helpers')
    assert not listening(fourth)
    fifth = start(kernel)
    kernel.process.kill()
    kernel.process.wait()
    assert not listening(fifth) and kernel.complaints() == ''


BLOCK = """
helpers.ros.start()
with helpers.TfView() as view:
    view.watch(600, at_least=0.1)
print(view.address.split(':')[2].split('/')[0])
"""


def test_after_its_block_a_view_can_be_turned_until_the_next_one_or_the_end_of_ros(kernel):
    kernel.ok(BEGIN)
    first = int(kernel.ok(BLOCK).stdout)  # nobody watches, so the block is short
    assert listening(first) and kernel.value('len(outputs)') == 1, 'the live view stays'
    assert kernel.value('view._node.context.ok() and helpers.kernel.nodes.is_alive(view._node)') is False
    second = int(kernel.ok(BLOCK).stdout)
    kinds = kernel.value('[list(output)[0] for output in outputs]')
    assert kinds == ['text/html', 'image/svg+xml', 'text/html']
    assert listening(second)
    kernel.ok('helpers.ros.stop()')
    assert not listening(second) and kernel.value('list(outputs[-1])')[0] == 'image/svg+xml'
    assert 'views' not in kernel.value('[thread.name for thread in __import__("threading").enumerate()]')
    assert kernel.complaints() == ''
