"""Every rclpy node of this process, so that a cell run again replaces its node instead of adding a second one.

rclpy has no list of the nodes of a process. `track` therefore wraps ``Node.__init__``: each new node is put into a weak
set. It also wraps ``Node.destroy_node``, so that a background executor lets go of a node before its parts disappear.

Only in a kernel a second thing happens: *before* a node is created, a living node of the same name (namespace and
context) that an **earlier cell run** made is destroyed. So ``talker = Talker()`` can be run again and again, also
without spinning, and the graph shows one ``/talker``. Two nodes of one name made in one cell stay two, as ROS has it;
a plain Python process never replaces anything.
"""

import functools
import sys
from collections.abc import Callable
from contextlib import suppress
from weakref import WeakKeyDictionary, WeakSet

from helpers.kernel import journal
from helpers.kernel.callback_errors import say

UNKNOWN = '_NODE_NAME_UNKNOWN_'  # rmw's name for the node of an endpoint whose node is not known yet

# Called with a node that is about to be destroyed: a background executor lets go of it first.
before_destroy: list[Callable] = []

_made_in: WeakKeyDictionary = WeakKeyDictionary()  # node -> number of the cell run that made it
_doomed: WeakSet = WeakSet()  # nodes whose destruction has begun


def track() -> None:
    """Begin to track nodes; idempotent."""
    from rclpy.node import Node
    from rclpy.utilities import get_default_context

    plain, plain_destroy_node = Node.__init__, Node.destroy_node
    if hasattr(plain, 'tracks_nodes'):
        return

    @functools.wraps(plain)
    def __init__(self, node_name, *args, context=None, namespace=None, **kwargs):
        context = get_default_context() if context is None else context
        _replace(_join(namespace, node_name), context)
        plain(self, node_name, *args, context=context, namespace=namespace, **kwargs)
        _made_in[self] = journal.number()
        _replace(full_name(self), context, but=self)  # a remapping may have given it another name

    @functools.wraps(plain_destroy_node)
    def destroy_node(self):
        _doomed.add(self)
        for let_go in before_destroy:
            let_go(self)
        plain_destroy_node(self)
        _destroy_state_machine(self)

    __init__.tracks_nodes = True
    Node.__init__, Node.destroy_node = __init__, destroy_node


def living(context=None) -> list:
    """Return the nodes that are not destroyed, oldest first; with ``context``, only those of that context."""
    nodes = [node for node in _made_in.copy() if is_alive(node)]
    return [node for node in nodes if context is None or node.context is context]


def is_alive(node) -> bool:
    """Tell whether the node has not been destroyed."""
    from rclpy.exceptions import InvalidHandle

    try:
        with node.handle:
            return True
    except InvalidHandle:
        return False


def is_doomed(node) -> bool:
    """Tell whether the destruction of the node has begun, or is over."""
    return node in _doomed or not is_alive(node)


def full_name(node) -> str:
    """Return namespace and name, such as ``/robot/talker``. The node must be alive."""
    return _join(node.get_namespace(), node.get_name())


def destroy(node) -> None:
    """Destroy a node, once; a background executor lets go of it before."""
    for let_go in before_destroy:  # before a destroy_node() of the learner's own begins
        let_go(node)
    if not is_alive(node):
        return
    destroy_actions(node)
    try:
        node.destroy_node()
    except Exception as error:  # an error in a learner's own destroy_node() must not keep the node in the graph
        say(f'destroy_node() of {type(node).__name__} raised {type(error).__name__}: {error}\n')
        from rclpy.node import Node

        if is_alive(node):
            Node.destroy_node(node)


def destroy_actions(node) -> None:
    """Destroy a node's action clients and servers, which else keep it in the graph until they are collected."""
    from rclpy.action import ActionClient, ActionServer

    for waitable in list(node.waitables):
        if isinstance(waitable, (ActionClient, ActionServer)):
            waitable.destroy()


def _destroy_state_machine(node) -> None:
    """Destroy what rclpy's LifecycleNode.destroy_node() leaves, which keeps the node in the graph until collection."""
    from rclpy.exceptions import InvalidHandle

    lifecycle = sys.modules.get('rclpy.lifecycle')
    if lifecycle is not None and isinstance(node, lifecycle.LifecycleNodeMixin):
        with suppress(InvalidHandle):  # it is destroyed already
            node._state_machine.destroy_when_not_in_use()


def _replace(name: str, context, but=None) -> None:
    """In a kernel, destroy the nodes of this name that earlier cell runs made."""
    run = journal.number()
    if not run:
        return
    for node in living(context):
        if node is but or not is_alive(node):  # the end of one node may be that of others
            continue
        if _made_in.get(node, run) < run and full_name(node) == name:
            destroy(node)


def _join(namespace: str | None, name: str) -> str:
    return f'/{(namespace or "").strip("/")}/{name}'.replace('//', '/')
