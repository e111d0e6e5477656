"""The tree of frames as a flat picture with numbers: what ``ros2 run tf2_tools view_frames`` shows, in a notebook.

Read from left to right: a line leads from each parent to its child. Beside a child stands what its transform is: static
or moving, how often it comes, how old the latest one is, how much history there is, and who broadcasts it.
"""

import time
from dataclasses import dataclass
from html import escape

import yaml

from helpers.show import dark_page, inline_svg
from helpers.show.views.frame_tree import FrameLink, FrameListener, Tree
from helpers.show.views.tf_display import MOVES, STATIC

_ROW, _INDENT, _BOX, _FONT = 30, 24, 22, 'system-ui, -apple-system, "Segoe UI", sans-serif'
_COLUMNS = (('', 60), ('rate', 68), ('age', 72), ('history', 68), ('broadcaster', 0))
_STATIC_RATE = 10_000.0  # what a buffer says of the single sample of a static transform
_LONGEST_AGE = 86_400.0  # s; more means that the stamps are of another clock
_PATIENCE = 1.0  # s, the longest wait for /clock, and for the names of nodes
_DARK = {  # on a dark page
    '#21252f': '#e6e9ee',
    '#fbfcfd': '#181b20',
    '#cfd3da': '#4a515c',
    '#f1f4f7': '#22272e',
    '#fff': '#22272e',
    '#394150': '#cdd3db',
    '#59606e': '#aab3bf',
    '#6b7280': '#aab3bf',
    '#b3261e': '#ff9d93',
}
_WIDEST = 900  # px, as much as a cell on a laptop has; JupyterLab cuts off the rest


@dataclass
class Row:
    """One transform."""

    child: str
    parent: str
    static: bool
    rate: float  #: 1/s, mean over the history; 0 if static
    stamp: float  #: of the latest one, s
    history: float  #: between the oldest and the latest one, s
    broadcaster: str


class FramesDiagram:
    """The frames in a buffer, as a picture and as text.

    :param buffer: a ``tf2_ros.Buffer``, or what has its ``all_frames_as_yaml``.
    :param now: seconds; None: no ages.
    :param broadcasters: names of nodes on /tf and on /tf_static, for transforms whose sender is not known: tf2 in
        Python does not tell it.
    :param problems: lines in red; None: what is wrong with the tree as far as the buffer tells.
    """

    def __init__(self, buffer, now: float | None = None, broadcasters=((), ()), problems=None):
        self.now = now
        # `[]` is an empty buffer's answer; and a frame's name may look like a number to YAML.
        data = {str(frame): entry for frame, entry in dict(yaml.safe_load(buffer.all_frames_as_yaml())).items()}
        self.rows = [_row(child, entry, broadcasters) for child, entry in data.items()]
        self._links = {row.child: FrameLink(row.child, row.parent, row.static) for row in self.rows}
        self.tree = Tree(self._links)
        self.problems = self.tree.problems(self.tree.best_root()) if problems is None else list(problems)

    @property
    def other_clock(self) -> bool:
        """Whether the latest stamp is so far from now that it must be of another clock."""
        stamps = [row.stamp for row in self.rows if not row.static]
        return bool(stamps) and self.now is not None and abs(self.now - max(stamps)) > _LONGEST_AGE

    def _lines(self) -> list[tuple[int, str, Row | None]]:
        """Depth, frame and transform, parents before children; frames in loops come last."""
        rows = {row.child: row for row in self.rows}
        children: dict[str, list[str]] = {}
        for row in self.rows:
            children.setdefault(row.parent, []).append(row.child)
        found, seen = [], set()

        def add(frame: str) -> None:
            waiting = [(0, frame)]
            while waiting:
                depth, name = waiting.pop()
                if name in seen:
                    continue
                seen.add(name)
                found.append((depth, name, rows.get(name)))
                waiting += [(depth + 1, child) for child in reversed(children.get(name, []))]

        for frame in [*self.tree.roots, *self.tree.looped]:
            add(frame)
        return found

    def _cells(self, row: Row | None) -> list[str]:
        if row is None:
            return ['root', '', '', '', '']
        if row.static:
            return ['static', '', '', '', row.broadcaster]
        age = '' if self.now is None else _age(self.now - row.stamp)
        rate = f'{row.rate:.1f} Hz' if row.history > 0 else 'once'
        return ['moves', rate, age, f'{row.history:.1f} s', row.broadcaster]

    def svg(self) -> str:
        """Return the picture."""
        lines = self._lines()
        names = max([8.5 * len(frame) + 24 + _INDENT * depth for depth, frame, _ in lines], default=150)
        starts = [names + 22]
        for _, width in _COLUMNS[:-1]:
            starts.append(starts[-1] + width)
        longest = max([len(self._cells(row)[-1]) for _, _, row in lines] + [11])
        top = 34 + 18 * len(self.problems)
        problems = max([7.5 * len(text) + 24 for text in self.problems], default=0)
        width, height = max(starts[-1] + 7.5 * longest + 20, problems), top + _ROW * max(1, len(lines)) + 6
        scale = min(1.0, _WIDEST / width)
        parts = [
            f'<text x="12" y="{20 + 18 * number}" fill="#b3261e">{escape(text)}</text>'
            for number, text in enumerate(self.problems)
        ]
        parts += [
            f'<text x="{x}" y="{top - 12}" fill="#6b7280" font-size="12">{title}</text>'
            for x, (title, _) in zip(starts, _COLUMNS, strict=True)
        ]
        places = {}
        for number, (depth, frame, row) in enumerate(lines):
            x, y = 14 + _INDENT * depth, top + _ROW * (number + 0.5)
            places[frame] = (x, y)
            parts += self._row(frame, row, x, y, starts, places, number % 2 == 1, width)
        if not lines:
            parts.append(
                f'<text x="14" y="{top + 18}" fill="#59606e">no frame: nothing came on /tf and /tf_static</text>'
            )
        ground = f'<rect width="{width:.0f}" height="{height:.0f}" rx="6" fill="#fbfcfd" stroke="#cfd3da"/>'
        drawing = '\n'.join(('<g fill="#21252f">', ground, *parts, '</g>'))
        return '\n'.join(
            (
                f'<svg xmlns="http://www.w3.org/2000/svg" width="{width * scale:.0f}" height="{height * scale:.0f}" '
                f'viewBox="0 0 {width:.0f} {height:.0f}" style="max-width:100%;height:auto" class="frames-diagram" '
                f'font-family=\'{_FONT}\' font-size="13">',
                f'<style>{dark_page.rules(drawing, _DARK, ".frames-diagram")}</style>',
                drawing,
                '</svg>',
            )
        )

    def _row(self, frame, row, x, y, starts, places, shaded, width) -> list[str]:
        colour = '#21252f' if row is None else _hex(STATIC if row.static else MOVES)
        dash = ' stroke-dasharray="4 3"' if row is not None and row.static else ''
        parts = []
        if shaded:
            parts.append(f'<rect x="1" y="{y - _ROW / 2}" width="{width - 2:.0f}" height="{_ROW}" fill="#f1f4f7"/>')
        if row is not None and row.parent in places and row.parent != frame:
            px, py = places[row.parent]
            parts.append(
                f'<path d="M{px + 12} {py + _BOX / 2}V{y - 8}q0 8 8 8H{x - 5}" fill="none" stroke="{colour}" '
                f'stroke-width="1.8"{dash}/><path d="M{x - 7} {y - 4}l7 4l-7 4z" fill="{colour}"/>'
            )
        bold = row is None or not row.static
        weight = ' font-weight="600"' if bold else ''
        wide = (8.7 if bold else 7.8) * len(frame) + 18
        parts.append(
            f'<rect x="{x}" y="{y - _BOX / 2}" width="{wide:.0f}" height="{_BOX}" rx="5" '
            f'fill="#fff" stroke="{colour}"{dash}/>'
            f'<text x="{x + 8}" y="{y + 4.5}"{weight}>{escape(frame)}</text>'
        )
        parts += [
            f'<text x="{start}" y="{y + 4.5}" fill="{colour if number == 0 else "#394150"}">{escape(text)}</text>'
            for number, (start, text) in enumerate(zip(starts, self._cells(row), strict=True))
            if text
        ]
        return parts

    def __repr__(self) -> str:
        lines = [
            f'{"  " * depth}{frame}' + ''.join(f', {cell}' for cell in self._cells(row) if cell)
            for depth, frame, row in self._lines()
        ]
        return '\n'.join([*self.problems, *lines]) or 'no frame'

    def _repr_mimebundle_(self, include=None, exclude=None) -> dict[str, str]:
        return inline_svg.still(self.svg(), repr(self))


def show_frames(buffer=None, duration: float = 2.0) -> FramesDiagram:
    """Listen to /tf and /tf_static for a while, and return the tree of frames for Jupyter to show.

    :param buffer: a ``tf2_ros.Buffer`` of yours, or a `TfView`: shows what it knows, and does not listen.
    :param duration: seconds to listen; slower transforms than one in this time may be missed.
    :raises RuntimeError: ROS is not started, and no buffer is given.
    """
    import rclpy
    from tf2_ros import Buffer

    from helpers import spin_for

    problems = getattr(buffer, 'problems', None)
    mine = getattr(buffer, 'buffer', buffer)
    if not rclpy.ok():
        if mine is not None:
            return FramesDiagram(mine, problems=problems)
        raise RuntimeError('ROS is not started: run helpers.ros.start() first')
    node = rclpy.create_node('_show_frames', enable_rosout=False, start_parameter_services=False)
    try:
        clock = _Clock(node)
        if mine is None:
            mine = Buffer()
            listener = FrameListener(mine, node)
            spin_for(duration, node)
            listener.unregister()
            tree = Tree(listener.links)
            problems = tree.problems(tree.best_root())
        broadcasters = _broadcasters(node)
        diagram = FramesDiagram(mine, clock.now(), broadcasters, problems)
        diagram.now = clock.now()  # later than all stamps that it has read: no age is negative
        if diagram.other_clock and node.count_publishers('/clock'):
            clock.wait()
            diagram.now = clock.now()
        return diagram
    finally:
        node.destroy_node()


class _Clock:
    """The time of the stamps: that of /clock where somebody publishes it, else this machine's."""

    def __init__(self, node):
        from rclpy.qos import qos_profile_sensor_data
        from rosgraph_msgs.msg import Clock

        self._node, self._seconds = node, None
        node.create_subscription(Clock, '/clock', self._take, qos_profile_sensor_data)

    def _take(self, message) -> None:
        self._seconds = message.clock.sec + 1e-9 * message.clock.nanosec

    def wait(self) -> None:
        """Wait for the first message, but not long: a simulation may stand still."""
        from helpers import spin_for

        deadline = time.monotonic() + _PATIENCE
        while self._seconds is None and time.monotonic() < deadline:
            spin_for(0.05, self._node)

    def now(self) -> float:
        """Seconds."""
        return self._node.get_clock().now().nanoseconds / 1e9 if self._seconds is None else self._seconds


def _broadcasters(node) -> tuple[list[str], list[str]]:
    """The nodes that publish on /tf, and on /tf_static. One whose name does not come in time is left out."""
    from helpers import spin_for
    from helpers.kernel.nodes import UNKNOWN

    deadline = time.monotonic() + _PATIENCE
    while True:
        found = [node.get_publishers_info_by_topic(topic) for topic in ('/tf', '/tf_static')]
        named = [
            {f'{info.node_namespace.rstrip("/")}/{info.node_name}' for info in infos if info.node_name != UNKNOWN}
            for infos in found
        ]
        if time.monotonic() >= deadline or all(info.node_name != UNKNOWN for infos in found for info in infos):
            return sorted(named[0]), sorted(named[1])
        spin_for(0.05, node)


def _row(child: str, entry: dict, broadcasters) -> Row:
    static = entry['rate'] == _STATIC_RATE and entry['most_recent_transform'] == 0.0
    sender = str(entry['broadcaster'])
    if sender in ('default_authority', 'no recorded authority', 'Authority undetectable'):
        sender = ' or '.join(broadcasters[1 if static else 0])
    return Row(
        child,
        str(entry['parent']),
        static,
        0.0 if static else entry['rate'],
        entry['most_recent_transform'],
        entry['buffer_length'],
        sender,
    )


def _age(seconds: float) -> str:
    if abs(seconds) > _LONGEST_AGE:
        return 'other clock'
    return f'{1000 * seconds:.0f} ms' if abs(seconds) < 1 else f'{seconds:.1f} s'


def _hex(colour) -> str:
    return '#' + ''.join(f'{round(255 * value):02x}' for value in colour)
