"""`TfView`: the frames of the running system, and displays beside them, in the output of a cell."""

import math
import os
import threading
import time
from contextlib import contextmanager
from pathlib import Path

from helpers.kernel import journal, nodes, ros
from helpers.kernel.spinning import spinning
from helpers.kernel.waiting import spin_for
from helpers.show import inline_svg
from helpers.show.views import picture
from helpers.show.views.display import Display
from helpers.show.views.frame_tree import Tree
from helpers.show.views.live_view import LiveRenderer
from helpers.show.views.recording import VARIABLE, Recording
from helpers.show.views.scene import Scene, part
from helpers.show.views.tf_display import MOVES, STATIC, TF

RATE = 30.0  # updates a second, at most
NODE = '_tf_view'
_LOOK = 0.1  # s between two looks at whether a browser shows it
_FIRST = 0.4  # s, the longest wait for the first frames
_SETTLED = 2  # updates in which no frame is added
_UPDATE = 1.0  # s, the longest wait for the end of an update: a display that hangs must not hang who asks
_views: list['TfView'] = []


class ViewPicture:
    """A still picture of a view, as Jupyter shows it.

    :param scene: the name of the page that replays the view (see `recording`); it goes into the output's metadata.
    """

    def __init__(self, svg: str, text: str, scene: str | None = None):
        self.svg, self._text, self._scene = svg, text, scene

    def _repr_mimebundle_(self, include=None, exclude=None):
        data = inline_svg.still(self.svg, self._text)
        return (data, {'scene': self._scene}) if self._scene else data

    def __repr__(self) -> str:
        return self._text


class _Live(ViewPicture):
    """The same, but a page that can reach the server shows the live view instead."""

    def __init__(self, svg: str, text: str, html: str):
        super().__init__(svg, text)
        self._html = html

    def _repr_mimebundle_(self, include=None, exclude=None) -> dict[str, str]:
        return {'text/html': self._html, 'text/plain': self._text}


class TfView:
    """Watch the frames on /tf and /tf_static in 3-D, and what the given displays show.

    ::

        with TfView() as view:
            wait_for(lambda: 'moon' in view.frames)

        view = TfView(RobotModel(), LaserScan('/scan'), fixed_frame='odom')     # goes on after the cell …
        view.stop()                                                            # … until stop() or helpers.ros.stop()

    Axes are x red, y green, z blue. A line with an arrow head leads from each frame to its parent: solid for moving
    frames, dashed for static ones. Frames that come late appear; a moving frame that is not broadcast any more fades,
    and is gone after `frame_timeout`. The slider below goes back in time, as `rewind` does.

    It is a node of this process (``/_tf_view``) that spins in the background. After its block it shows what was last
    and can still be turned; a view in a later cell, `stop` or helpers.ros.stop() puts a still picture in its place.

    :param displays: what to show beside the frames, see `helpers.show.views`.
    :param fixed_frame: the frame that stands still; None: the root of the largest tree.
    :param focus: a frame that the camera follows; None: everything is in the picture.
    :param span: how much around that frame is in the picture, in m.
    :param frames: show the frames themselves.
    :param trails: names of frames that leave a line behind.
    :param axis_length: of the frames' axes in m; None: what suits.
    :param frame_timeout: seconds.
    :param height: in pixels.
    :param live: open the live view; None: in a notebook.
    :raises RuntimeError: ROS is not started.
    """

    def __init__(
        self,
        *displays: Display,
        fixed_frame: str | None = None,
        focus: str | None = None,
        span: float = 2.0,
        frames: bool = True,
        trails=(),
        axis_length: float | None = None,
        frame_timeout: float = 10.0,
        height: int = 420,
        live: bool | None = None,
    ):
        import rclpy
        from tf2_ros import Buffer

        if not rclpy.ok():
            raise RuntimeError('ROS is not started: run helpers.ros.start() first')
        for display in displays:
            if not isinstance(display, Display):
                raise TypeError(f'TfView shows displays such as RobotModel(), not {type(display).__name__}')
        for other in _views.copy():
            if other._made_in < journal.number():
                other.stop()
        self.scene = Scene()  #: what is shown; for displays of your own
        self.buffer = Buffer()  #: the tf2_ros.Buffer with what has been heard; it does not change during time travel
        self.displays = displays
        self.focus, self.span = focus, span
        self._made_in = journal.number()
        self._height, self._frames = height, frames
        self._chosen = fixed_frame or ''
        self._fixed_frame = self._chosen
        self._past: float | None = None  # s before `_latest`; None: live
        self._moment = 0  # ns, 0: live
        self._latest = 0
        self._begun = threading.Event()  # set once there are frames, and no new ones have come for some updates
        self._count = self._same = 0
        self._wanted = None  # what `at` or `rewind` asks of the next update
        self._updating = threading.RLock()  # held by an update, and by those who tell what it found
        self._tf = TF(frame_timeout, axis_length, trails, on_top=bool(displays))
        self._live: LiveRenderer | None = None
        self._recording: Recording | None = None
        self._output = None
        self._last: dict | None = None  # what the page shows beside the scene once the block has ended
        self._node = rclpy.create_node(_free_name(), enable_rosout=False, start_parameter_services=False)
        try:
            self._tf.start(self._node, self.buffer, self.scene.below('TF'))
            self.scene.appearance('TF', visible=frames)
            self._parts = _names(displays)
            for name, display in self._parts.items():
                display.start(self._node, self.buffer, self.scene.below(name))
            if live or (live is None and journal.in_kernel()):
                self._open()
        except BaseException:
            nodes.destroy(self._node)
            raise
        self._node.create_timer(1 / RATE, self._update)
        _views.append(self)
        self._spinning = spinning(self._node)
        self._show()

    # What is there

    @property
    def frames(self) -> list[str]:
        """The frames that are known now, parents before children."""
        with self._between_updates():
            return self._tf.tree.frames

    @property
    def problems(self) -> list[str]:
        """What is wrong with the tree or a display, one sentence each; also shown in the view."""
        with self._between_updates():
            return self._problems()

    def _problems(self) -> list[str]:
        found = self._tf.status().splitlines()
        return found + [
            f'{name}: {line}' for name, display in self._parts.items() for line in display.status().splitlines()
        ]

    @property
    def fixed_frame(self) -> str:
        """The frame that stands still; '' while there is none. Assign another, or None for the automatic choice."""
        with self._between_updates():
            return self._fixed_frame

    @fixed_frame.setter
    def fixed_frame(self, frame: str | None) -> None:
        self._chosen = frame or ''

    @property
    def address(self) -> str | None:
        """The live view's page, as a browser on this machine opens it; None if there is none."""
        return self._live.address if self._live is not None else None

    # Time travel

    def at(self, when=None) -> None:
        """Show everything at a time of the last ten seconds; None goes back to now.

        :param when: an rclpy Time, or a stamp from a message.
        """
        self._wanted = ('at', 0 if when is None else _nanoseconds(when))

    def rewind(self, seconds: float) -> None:
        """Show everything so many seconds before the latest transform; 0 goes back to now."""
        self._wanted = ('rewind', float(seconds))

    @property
    def past(self) -> float | None:
        """How many seconds before the latest transform is shown; None: now."""
        return self._past

    def picture(self) -> ViewPicture:
        """Return a still picture of what the view shows."""
        with self._between_updates():
            return ViewPicture(self._svg(), str(self))

    def watch(self, seconds: float = 8.0, at_least: float = 1.0) -> None:
        """Go on for so many seconds while a browser shows the view; else (in a test, say) for `at_least` seconds."""
        end = time.monotonic() + seconds
        spin_for(at_least)
        while self._live is not None and self._live.watched and time.monotonic() < end:
            spin_for(min(_LOOK, max(0.0, end - time.monotonic())))

    def stop(self) -> None:
        """Stop watching; a still picture stays. Idempotent."""
        if self not in _views:
            return
        _views.remove(self)
        try:
            self._end()
        finally:
            live, self._live = self._live, None
            if live is not None:
                live.close()
            scene = self._recording.write(Path(os.environ[VARIABLE])) if self._recording is not None else None
            if self._output is not None:
                self._output.update(ViewPicture(self._svg(), str(self), scene))

    def _end(self) -> None:
        """Stop listening: the scene stays as it is. Idempotent."""
        if self._last is not None:
            return
        self._spinning.let_go(self._node)
        try:
            if self._node.context.ok():
                self._update()
                if self._recording is not None:
                    self._recording.update(final=True)
            self._last = {**self._state(), 'ended': True}
        finally:  # a display that a learner has written may raise
            self._last = self._last or {}
            for display in (self._tf, *self._parts.values()):
                display.stop()
            nodes.destroy(self._node)

    def __enter__(self) -> 'TfView':
        return self

    def __exit__(self, kind, error, tb) -> None:
        if self._live is None or not journal.in_kernel() or self not in _views:
            self.stop()
            return
        self._end()
        self._live.update(final=True)

    def __repr__(self) -> str:
        with self._between_updates():
            tree, problems = self._tf.tree, self._problems()
        lines = []
        for root, members in tree.trees.items():
            lines.append(root)
            depth = {root: 0}
            for frame in _depth_first(tree, members):
                depth[frame] = depth[tree.links[frame].parent] + 1
                lines.append(f'{"  " * depth[frame]}{frame}{" (static)" if tree.links[frame].static else ""}')
        return '\n'.join(lines + problems) or 'no frame so far'

    def _repr_mimebundle_(self, include=None, exclude=None) -> dict[str, str]:
        return {'text/plain': repr(self)}

    # At work

    @contextmanager
    def _between_updates(self):
        """Let no update begin, once the running one has ended: frames, problems and scene are of one moment."""
        waited = self._updating.acquire(timeout=_UPDATE)
        try:
            yield
        finally:
            if waited:
                self._updating.release()

    def _update(self) -> None:
        """Bring the scene up to date and send it; in the thread that spins."""
        with self._between_updates():
            self._update_scene()

    def _update_scene(self) -> None:
        from rclpy.time import Time

        self._tf.look()
        self._choose_time()
        frame = self._chosen or self._tf.tree.best_root()
        if frame != self._fixed_frame:
            self._fixed_frame = frame
            self._tf.forget_trails()
        moment = Time(nanoseconds=self._moment)
        for display in (self._tf, *self._parts.values()):
            display.refresh(self._fixed_frame, moment)
        for renderer in (self._live, self._recording):
            if renderer is not None:
                renderer.update()
        if not self._begun.is_set():
            count = len(self._tf.poses)
            self._same = self._same + 1 if count and count == self._count else 0
            self._count = count
            if self._same == _SETTLED:
                self._begun.set()

    def _choose_time(self) -> None:
        wanted, self._wanted = self._wanted, None
        if wanted is None:
            return
        kind, value = wanted
        if self._past is None:
            self._latest = self._tf.listener.latest
        if not value or not self._latest:
            self._past, self._moment = None, 0
            self._tf.listener.hold(False)
            return
        self._tf.listener.hold(True)
        self._past = (self._latest - value) / 1e9 if kind == 'at' else value
        self._moment = max(1, self._latest - round(self._past * 1e9))

    def _state(self) -> dict:
        return self._last or {
            'fixed_frame': self._fixed_frame,
            'chosen': self._chosen,
            'frames': sorted(self._tf.tree.frames),
            'problems': self._problems(),  # the server's thread asks, too: it does not wait for an update
            'past': self._past,
            'history': 10.0,
            'span': self.span,
            'focus': f'TF/frames/{part(self.focus)}' if self.focus else None,
        }

    def _on_message(self, content: dict) -> None:
        """The page's controls; in the server's thread."""
        if isinstance(frame := content.get('fixed_frame'), str):
            self.fixed_frame = frame
        if isinstance(past := content.get('past'), (int, float)) and math.isfinite(past):
            self.rewind(max(0.0, past))

    def _open(self) -> None:
        if os.environ.get(VARIABLE) and journal.in_kernel():
            self._recording = Recording(self.scene, self._state)
            return
        try:
            self._live = LiveRenderer(self.scene, self._state, self._on_message, lambda: self.picture().svg)
        except OSError:  # no port: the picture remains
            self._live = None

    def _show(self) -> None:
        if not journal.in_kernel():
            return
        from IPython.display import display

        # If the view is never stopped, this picture is what the notebook saves: it should show some frames.
        self._begun.wait(_FIRST)
        content = self.picture()
        if self._live is not None:
            content = _Live(content.svg, str(self), self._live.html(content.svg, self._height))
        self._output = display(content, display_id=True)

    def _svg(self) -> str:
        caption = f'fixed frame: {self._fixed_frame}' if self._fixed_frame else ''
        if self._past is not None:
            caption += f' · {self._past:.2f} s before the latest'
        kinds = {link.static for link in self._tf.tree.links.values()} if self._frames else ()
        legend = [kind for kind in (('moves', MOVES, False), ('static', STATIC, True)) if kind[2] in kinds]
        pose = self._tf.poses.get(self.focus)
        around = None if pose is None else (pose[:3, 3], self.span)
        return picture.svg(self.scene, caption, self._problems(), legend, around, height=self._height)


def _names(displays) -> dict[str, Display]:
    """Each display with a name of its own: LaserScan, LaserScan 2, …"""
    named: dict[str, Display] = {}
    for display in displays:
        name, number = display.name, 1
        while name in named or name == 'TF':
            number += 1
            name = f'{display.name} {number}'
        named[name] = display
    return named


def _free_name() -> str:
    taken = {view._node.get_name() for view in _views if view._last is None}
    number = next(number for number in range(1, len(taken) + 2) if _numbered(number) not in taken)
    return _numbered(number)


def _numbered(number: int) -> str:
    return NODE if number == 1 else f'{NODE}_{number}'


def _nanoseconds(when) -> int:
    return when.nanoseconds if hasattr(when, 'nanoseconds') else when.sec * 1_000_000_000 + when.nanosec


def _depth_first(tree: Tree, members):
    """The frames below a root, each followed by those below it."""
    children: dict[str, list[str]] = {}
    for frame in members[1:]:
        children.setdefault(tree.links[frame].parent, []).append(frame)
    waiting = list(reversed(children.get(members[0], [])))
    while waiting:
        frame = waiting.pop()
        yield frame
        waiting += reversed(children.get(frame, []))


def _on_destroy(node) -> None:
    for view in _views.copy():
        if view._node is node and view._last is None:
            view.stop()


def _on_stop() -> None:
    for view in _views.copy():
        view.stop()


nodes.before_destroy.append(_on_destroy)
ros.before_stop.append(_on_stop)
