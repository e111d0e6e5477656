"""A small scene graph: named nodes with a shape, a pose and an appearance. It knows neither ROS nor a browser.

A node's name is a path such as ``robot/wheel/visual``. Its pose is relative to the node above it; a node above that was
never mentioned is there, at the identity. Frame names may contain a slash: `part` makes them fit for a path.
All methods may be called from any thread; changes appear together, at the next `TfView` update.
"""

import threading
from dataclasses import dataclass, field

import numpy as np

from helpers.show.views.shapes import Shape

IDENTITY = np.eye(4)
IDENTITY.setflags(write=False)


def part(name: str) -> str:
    """Return a name as one part of a path: its slashes are no separators there."""
    return name.replace('%', '%25').replace('/', '%2F') or '%'


@dataclass(frozen=True)
class Item:
    """One visible shape, with everything above it taken into account."""

    path: str
    shape: Shape
    pose: np.ndarray  #: 4 x 4, in the scene's fixed frame
    opacity: float


@dataclass
class Node:
    """One node, as it was set. Only renderers read it."""

    id: int
    path: str
    shape: Shape | None = None
    pose: np.ndarray = field(default_factory=lambda: IDENTITY)
    visible: bool = True
    opacity: float = 1.0


@dataclass
class Changes:
    """What has happened to a scene since the last look: deletions come first, then the rest."""

    deleted: list[int] = field(default_factory=list)  #: ids of nodes; what is below them is gone, too
    shapes: list[Node] = field(default_factory=list)
    poses: list[Node] = field(default_factory=list)
    appearances: list[Node] = field(default_factory=list)

    def __bool__(self) -> bool:
        return bool(self.deleted or self.shapes or self.poses or self.appearances)


class _Store:
    """The nodes behind a scene and all its parts, and which of them have changed."""

    def __init__(self):
        self.lock = threading.RLock()
        self.nodes: dict[str, Node] = {}
        self.count = 0
        self.deleted: list[int] = []
        self.shapes: dict[str, Node] = {}
        self.poses: dict[str, Node] = {}
        self.appearances: dict[str, Node] = {}

    def node(self, path: str) -> Node:
        node = self.nodes.get(path)
        if node is None:
            if not path or path.startswith('/') or path.endswith('/') or '//' in path:
                raise ValueError(f'a path is a name, or names with single slashes between them, not {path!r}')
            above = path.rpartition('/')[0]
            if above:
                self.node(above)
            self.count += 1
            node = self.nodes[path] = Node(self.count, path)
            self.shapes[path] = node  # makes the node known, even without a shape
        return node


class Scene:
    """A scene, or a part of one (see `below`)."""

    def __init__(self):
        self._store = _Store()
        self._prefix = ''

    def below(self, path: str) -> 'Scene':
        """Return the part of this scene below a path: the same nodes, by shorter names."""
        part_of = object.__new__(Scene)
        part_of._store, part_of._prefix = self._store, f'{self._prefix}{path}/'
        return part_of

    def set(self, path: str, shape: Shape | None) -> None:
        """Give a node a shape (None: no shape); it is made if it is new, with the identity as its pose.

        :raises TypeError: it is no shape.
        """
        if shape is not None and not isinstance(shape, Shape):
            raise TypeError(f'a scene shows shapes (helpers.show.views.shapes), not {type(shape).__name__}')
        with self._store.lock:
            node = self._store.node(self._prefix + path)
            if node.shape is not shape and node.shape != shape:
                node.shape = shape
                self._store.shapes[node.path] = node

    def pose(self, path: str, matrix) -> None:
        """Place a node relative to the one above it.

        :param matrix: 4 x 4, homogeneous; it may scale.
        """
        matrix = np.array(matrix, dtype=float)
        if matrix.shape != (4, 4):
            raise ValueError(f'a pose is a 4 x 4 matrix, not {matrix.shape}')
        with self._store.lock:
            node = self._store.node(self._prefix + path)
            if node.pose.tobytes() != matrix.tobytes():
                node.pose = matrix
                self._store.poses[node.path] = node

    def appearance(self, path: str, *, visible: bool | None = None, opacity: float | None = None) -> None:
        """Show or hide a node, or make it see-through, with all that is below it. None leaves a property as it is.

        :param opacity: 0 to 1; those of the nodes above are multiplied with it.
        """
        with self._store.lock:
            node = self._store.node(self._prefix + path)
            visible = node.visible if visible is None else bool(visible)
            opacity = node.opacity if opacity is None else round(min(1.0, max(0.0, opacity)), 2)
            if (visible, opacity) != (node.visible, node.opacity):
                node.visible, node.opacity = visible, opacity
                self._store.appearances[node.path] = node

    def delete(self, path: str) -> None:
        """Delete a node and all below it; nothing happens if there is none."""
        store, path = self._store, self._prefix + path
        with store.lock:
            gone = store.nodes.get(path)
            if gone is None:
                return
            store.deleted.append(gone.id)
            for name in [name for name in store.nodes if name == path or name.startswith(path + '/')]:
                for kept in (store.nodes, store.shapes, store.poses, store.appearances):
                    kept.pop(name, None)

    def clear(self) -> None:
        """Delete everything of this scene (or part)."""
        with self._store.lock:
            for path in self.paths():
                if '/' not in path:
                    self.delete(path)

    def paths(self) -> list[str]:
        """The nodes, those above before those below."""
        with self._store.lock:
            return [path.removeprefix(self._prefix) for path in self._store.nodes if path.startswith(self._prefix)]

    def __contains__(self, path: str) -> bool:
        return self._prefix + path in self._store.nodes

    def items(self) -> list[Item]:
        """What is to be seen: visible shapes with their pose in the fixed frame and their opacity."""
        found, above = [], {'': (IDENTITY, 1.0, True)}
        with self._store.lock:
            for path, node in self._store.nodes.items():
                pose, opacity, visible = above[path.rpartition('/')[0]]
                here = (pose @ node.pose, opacity * node.opacity, visible and node.visible)
                above[path] = here
                if node.shape is not None and here[2] and here[1] > 0 and path.startswith(self._prefix):
                    found.append(Item(path.removeprefix(self._prefix), node.shape, here[0], here[1]))
        return found

    # For renderers

    def changes(self) -> Changes:
        """Take what has changed since the last call; for the one live renderer of the scene."""
        store = self._store
        with store.lock:
            changes = Changes(
                store.deleted, list(store.shapes.values()), list(store.poses.values()), list(store.appearances.values())
            )
            store.deleted, store.shapes, store.poses, store.appearances = [], {}, {}, {}
        return changes

    def everything(self) -> Changes:
        """The whole scene as changes to an empty one; takes nothing."""
        with self._store.lock:
            nodes = list(self._store.nodes.values())
        return Changes(
            [],
            nodes,
            [node for node in nodes if node.pose is not IDENTITY],
            [node for node in nodes if not node.visible or node.opacity < 1],
        )
