"""`show_graph` and `GraphView`: the graph in the output of a cell."""

import itertools
import time

from helpers.kernel.executors import refuse_in_callback
from helpers.kernel.spinning import spinning
from helpers.show.graph.drawing import GraphPicture
from helpers.show.graph.model import Graph
from helpers.show.graph.participants import all_heard
from helpers.show.graph.reading import read

_LOOK = 0.25  # s between two looks at the graph
_STILL = 0.3  # s without a change, and without a program that is not known yet, after which the graph is taken as whole
_numbers = itertools.count(1)
_views: list['GraphView'] = []


def show_graph(namespace: str = '/', parameters: bool = False, hidden: bool = False, timeout: float = 5.0) -> None:
    """Show the nodes of this domain, and what they are connected by, as it is now.

    Arrows lead from publishers and clients to subscriptions and servers. What does not fit is red, and said in words.
    A node that asks needs a moment to hear of others: the picture is taken when it has known all programs of this
    machine for 0.3 s, and the graph has not changed meanwhile.

    :param namespace: only what stands in it, and what that is connected with.
    :param parameters: also what every node has: the services for parameters, /rosout, /parameter_events and /clock.
    :param hidden: also names that begin with an underscore, such as the parts of an action.
    :param timeout: seconds after which the picture is taken in any case.
    :raises RuntimeError: ROS is not started.
    """
    from IPython.display import display

    refuse_in_callback('show_graph()')
    node = _node(f'_show_graph_{next(_numbers)}')
    try:
        graph = _settled(lambda: read(node, namespace, parameters, hidden), lambda: all_heard(node), timeout)
    finally:
        node.destroy_node()
    display(GraphPicture(graph))


class GraphView:
    """Watch the graph of this domain in the output of this cell.

    ::

        view = GraphView()      # goes on after the cell, until stop() or helpers.ros.stop()
        view.stop()

        with GraphView() as view:
            wait_for(lambda: '/listener' in view.graph.nodes)

    It is a node of this process (``/_graph_view``) that spins in the background and looks four times a second. A
    second view, in another cell, replaces the first one. When it stops, the last picture stays.

    :param namespace: only what stands in it, and what that is connected with.
    :param parameters: also what every node has: the services for parameters, /rosout, /parameter_events and /clock.
    :param hidden: also names that begin with an underscore, such as the parts of an action.
    :raises RuntimeError: ROS is not started.
    """

    def __init__(self, namespace: str = '/', parameters: bool = False, hidden: bool = False):
        self._arguments = namespace, parameters, hidden
        self._handle = None
        for other in _views.copy():
            other.stop()
        self._node = _node('_graph_view')
        self._node.create_timer(_LOOK, self._look)
        self.graph: Graph = read(self._node, *self._arguments)  #: the latest one
        self._spinning = spinning(self._node)
        _views.append(self)
        self._show()

    @property
    def problems(self) -> list[str]:
        """What does not fit now, in words."""
        return [problem.text for problem in self.graph.problems]

    def stop(self) -> None:
        """Stop watching; the last picture stays. Idempotent."""
        if self in _views:
            _views.remove(self)
            self._spinning.stop()

    def __enter__(self) -> 'GraphView':
        return self

    def __exit__(self, kind, error, tb) -> None:
        if self in _views and kind is None:
            self._look()  # one more look, for what the block has just changed
        self.stop()

    def __repr__(self) -> str:
        return str(GraphPicture(self.graph))

    def _look(self) -> None:
        graph = read(self._node, *self._arguments)
        if graph.key != self.graph.key:
            self.graph = graph
            if self._handle is not None:
                self._handle.update(GraphPicture(graph))

    def _show(self) -> None:
        from IPython import get_ipython
        from IPython.display import display

        if get_ipython() is not None:
            self._handle = display(GraphPicture(self.graph), display_id=True)


def _node(name: str):
    import rclpy

    if not rclpy.ok():
        raise RuntimeError('ROS is not started: run helpers.ros.start() first')
    return rclpy.create_node(name, enable_rosout=False, start_parameter_services=False)


def _settled(look, complete, timeout: float) -> Graph:
    """What `look()` returns when for a while it has been the same and `complete()` true; after `timeout` s as it is."""
    deadline = time.monotonic() + timeout
    graph, since = look(), time.monotonic()
    while time.monotonic() < min(deadline, since + _STILL):
        time.sleep(0.03)  # a bounded poll: there is no event for a graph that does not change
        fresh = look()
        if fresh.key != graph.key or not complete():
            graph, since = fresh, time.monotonic()
    return graph
