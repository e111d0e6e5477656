"""TfView with real broadcasters: frames come, move, go stale and go; the past; the picture that stays."""

import re
import threading
from types import SimpleNamespace

import numpy as np
import pytest
import rclpy
from geometry_msgs.msg import TransformStamped
from rclpy.time import Time
from tf2_ros import Buffer, StaticTransformBroadcaster, TransformBroadcaster

from helpers import TfView, show_frames, spin_for, wait_for
from helpers.kernel.ros import nodes
from helpers.show.views import Display, frames_diagram
from helpers.show.views.frames_diagram import FramesDiagram
from helpers.show.views.shapes import Axes, Label, Line, Sphere


class Sender:
    """A node that sends transforms when told to."""

    def __init__(self):
        self.node = rclpy.create_node('sender')
        self._moving = TransformBroadcaster(self.node)
        self._static = StaticTransformBroadcaster(self.node)

    def send(self, parent: str, child: str, x: float = 1.0, at: float | None = None, static: bool = False) -> None:
        message = TransformStamped(child_frame_id=child)
        message.header.frame_id = parent
        now = self.node.get_clock().now() if at is None else Time(nanoseconds=round(at * 1e9))
        message.header.stamp = now.to_msg()
        message.transform.translation.x, message.transform.rotation.w = x, 1.0
        (self._static if static else self._moving).sendTransform(message)

    def wait_for_listener(self) -> None:
        wait_for(lambda: self.node.count_subscribers('/tf') and self.node.count_subscribers('/tf_static'), timeout=30)


@pytest.fixture
def sender(ros):
    return Sender()


def seen(view, kind) -> dict:
    return {item.path: item for item in view.scene.items() if isinstance(item.shape, kind)}


def place(view, frame: str):
    item = seen(view, Axes).get(f'TF/frames/{frame}/axes')
    return None if item is None else item.pose[:3, 3].round(6).tolist()


def test_frames_come_and_move_and_the_fixed_frame_can_be_chosen(sender):
    with TfView() as view:
        sender.wait_for_listener()
        sender.send('base', 'laser', 0.5, static=True)
        sender.send('odom', 'base')
        wait_for(lambda: place(view, 'laser') == [1.5, 0, 0], timeout=30)
        assert view.fixed_frame == 'odom' and view.frames == ['odom', 'base', 'laser'] and view.problems == []
        labels = {item.shape.text: item.shape.bold for item in seen(view, Label).values()}
        assert labels == {'odom': True, 'base': True, 'laser': False}, 'what moves is bold'
        lines = {path: (len(item.shape.points), item.shape.dashed) for path, item in seen(view, Line).items()}
        assert lines == {'TF/links/moving': (2, False), 'TF/links/static': (2, True)}
        sender.send('map', 'odom', 10.0)  # a late one becomes the root
        wait_for(lambda: place(view, 'laser') == [11.5, 0, 0], timeout=30)
        assert view.fixed_frame == 'map'
        view.fixed_frame = 'base'
        wait_for(lambda: place(view, 'map') == [-11, 0, 0], timeout=30)
        view.fixed_frame = 'nowhere'
        unknown = ['tf2 knows no frame [nowhere]: only what stands in it can be shown']
        wait_for(lambda: view.problems == unknown, timeout=30)
        assert seen(view, Axes) == {}
        view.fixed_frame = None
        wait_for(lambda: place(view, 'base') == [11, 0, 0], timeout=30)
        assert repr(view).splitlines() == ['map', '  odom', '    base', '      laser (static)']
        sender.send('somewhere', 'else')
        wait_for(lambda: view.problems, timeout=30)
        assert view.problems == ['no transform from [somewhere], [else] to [map]: separate trees']


def test_a_stale_frame_fades_and_goes_with_what_hangs_on_it(sender, monkeypatch):
    from helpers.show.views import frame_tree, tf_display

    clock = [1000.0]
    for module in (frame_tree, tf_display):
        monkeypatch.setattr(module, 'monotonic', lambda: clock[0])
    view = TfView(frame_timeout=3.0)
    view._spinning.let_go(view._node)  # updates only when told, at times that are told
    sender.wait_for_listener()
    sender.send('map', 'dead')
    sender.send('map', 'alive')
    sender.send('dead', 'its_lamp', static=True)
    while len(view._tf.listener.links) < 3:
        rclpy.spin_once(view._node, timeout_sec=10.0)

    def opacity(age: float) -> float:
        clock[0] = 1000.0 + age
        view._tf.listener.links['alive'].arrival = clock[0]
        view._update()
        item = seen(view, Axes).get('TF/frames/dead/axes')
        return 0.0 if item is None else item.opacity

    steps = [opacity(age) for age in (0.0, 0.9, 1.2, 2.0, 2.9, 3.1)]
    assert steps[:2] == [1.0, 1.0] and steps == sorted(steps, reverse=True) and 0 < steps[4] < 0.3 and steps[5] == 0
    assert view.frames == ['map', 'alive'] and view.problems == []
    view.stop()


def test_while_simulated_time_stands_still_nothing_fades(sender, monkeypatch):
    from rosgraph_msgs.msg import Clock

    from helpers.show.views import tf_display

    sender.node.create_publisher(Clock, '/clock', 1)
    with TfView(frame_timeout=3.0) as view:
        sender.wait_for_listener()
        wait_for(lambda: view._node.count_publishers('/clock'), timeout=30)
        sender.send('map', 'base', at=5.0)
        sender.send('map', 'late', at=5.0)
        wait_for(lambda: len(view.frames) == 3, timeout=30)
        now = tf_display.monotonic()
        monkeypatch.setattr(tf_display, 'monotonic', lambda: now + 100.0)
        sender.send('map', 'late', 7.0, at=5.5)
        wait_for(lambda: place(view, 'late') == [7, 0, 0], timeout=30)
        assert {item.opacity for item in seen(view, Axes).values()} == {1.0}
        sender.send('map', 'late', at=9.0)
        wait_for(lambda: view.frames == ['map', 'late'], timeout=30)


def test_the_past(sender):
    with TfView(trails=['moon']) as view:
        sender.wait_for_listener()
        for number in range(5):
            sender.send('planet', 'moon', float(number), at=100.0 + number)
        wait_for(lambda: place(view, 'moon') == [4, 0, 0], timeout=30)
        view.rewind(1.5)
        wait_for(lambda: place(view, 'moon') == [2.5, 0, 0], timeout=30)
        assert view.past == 1.5
        sender.send('planet', 'moon', 50.0, at=112.0)  # would push the past out of the buffer
        view.at(Time(seconds=101))
        wait_for(lambda: place(view, 'moon') == [1, 0, 0], timeout=30)
        assert '3.00 s before the latest' in view.picture().svg
        view.at(Time(seconds=50))
        wait_for(lambda: view.problems == ['not known at this time: moon'], timeout=30)
        view.at()
        wait_for(lambda: place(view, 'moon') == [50, 0, 0], timeout=30)
        assert view.past is None
        [trail] = [item for path, item in seen(view, Line).items() if 'trails' in path]
        assert trail.shape.points[-1].tolist() == [50, 0, 0]


def test_a_simulation_that_begins_anew_does_not_leave_the_old_times(sender):
    with TfView() as view:
        sender.wait_for_listener()
        sender.send('map', 'base', 1.0, at=500.0)
        wait_for(lambda: place(view, 'base') == [1, 0, 0], timeout=30)
        sender.send('map', 'base', 2.0, at=1.0)
        wait_for(lambda: place(view, 'base') == [2, 0, 0], timeout=30)
        assert view.buffer.lookup_transform('map', 'base', Time()).transform.translation.x == 2.0


class Ball(Display):
    """A display for tests."""

    updates = 0

    def on_start(self):
        self.scene.set('ball', Sphere(0.1))

    def update(self, fixed_frame, time):
        self.updates += 1
        pose = self.transform(fixed_frame, 'base', time) if fixed_frame else None
        self.scene.appearance('ball', visible=pose is not None)
        if pose is not None:
            self.scene.pose('ball', pose)


def test_displays_have_their_own_part_and_tell_their_problems(sender):
    first, second = Ball(), Ball()
    with TfView(first, second, fixed_frame='map') as view:
        sender.wait_for_listener()
        wait_for(lambda: 'Ball 2: no transform from [base] to [map]' in view.problems, timeout=30)
        assert seen(view, Sphere) == {}
        sender.send('map', 'base', 3.0)
        wait_for(lambda: len(seen(view, Sphere)) == 2, timeout=30)
        assert list(seen(view, Sphere)) == ['Ball/ball', 'Ball 2/ball']
        assert all(item.pose[0, 3] == 3.0 for item in seen(view, Sphere).values())
        with pytest.raises(RuntimeError, match='in a view already'):
            TfView(first)
    assert first.node is None and view.problems == []
    assert '>base</text>' in view.picture().svg
    assert not [node for node in nodes.living() if 'tf_view' in node.get_name()]


class Held(Display):
    """Its update with the fixed frame map does not end before it is told to."""

    def __init__(self):
        super().__init__()
        self.at_it, self.go_on = threading.Event(), threading.Event()

    def update(self, fixed_frame, time):
        if fixed_frame == 'map':
            self.at_it.set()
            self.go_on.wait(60)


@pytest.mark.parametrize('patience', [30.0, 0.05])
def test_what_a_view_tells_is_of_one_moment_unless_a_display_hangs(sender, monkeypatch, patience):
    from helpers.show.views import tf_view

    held, told = Held(), {}
    with TfView(held, fixed_frame='nowhere') as view:
        sender.wait_for_listener()
        sender.send('map', 'base')
        wait_for(lambda: view.frames and view.problems and 'nowhere' in view.picture().svg, timeout=30)
        monkeypatch.setattr(tf_view, '_UPDATE', patience)
        view.fixed_frame = 'map'
        assert held.at_it.wait(30) and place(view, 'base'), 'half of the update is done'
        ways = {
            'problems': lambda: view.problems,
            'fixed frame': lambda: view.fixed_frame,
            'text': lambda: repr(view).splitlines(),
            'picture': lambda: 'nowhere' in view.picture().svg,
        }
        readers = [threading.Thread(target=lambda way=way: told.update({way: ways[way]()})) for way in ways]
        for reader in readers:
            reader.start()
        for reader in readers:
            reader.join(30 if patience < 1 else 0.05)
        assert len(told) == (4 if patience < 1 else 0)
        held.go_on.set()
        for reader in readers:
            reader.join(30)
    if patience > 1:
        assert told == {'problems': [], 'fixed frame': 'map', 'text': ['map', '  base'], 'picture': False}


class Broken(Display):
    def update(self, fixed_frame, time):
        raise ZeroDivisionError('of a display')


def test_a_display_that_raises_is_heard_of_and_leaves_nothing(ros):
    from helpers import CallbackError

    view = TfView(Broken(), live=True)
    with pytest.raises(CallbackError, match='of a display'):
        wait_for(lambda: False, timeout=30)
    with pytest.raises(ZeroDivisionError):
        view.stop()
    assert not nodes.is_alive(view._node) and view.address is None


def test_the_camera_can_follow_a_frame(sender):
    with TfView(focus='base', span=0.5, live=True) as view:
        sender.wait_for_listener()
        sender.send('map', 'base', 100.0)
        sender.send('base', 'laser', 0.1, static=True)
        wait_for(lambda: len(view.frames) == 3, timeout=30)
        wait_for(lambda: place(view, 'laser'), timeout=30)
        assert '>laser</text>' in view.picture().svg and '>map</text>' not in view.picture().svg
        state = view._state()
        assert state['focus'] in view.scene and state['span'] == 0.5
        view.focus = None
        assert '>map</text>' in view.picture().svg


def test_a_view_ends_with_ros_and_needs_it(ros):
    with pytest.raises(TypeError, match='not str'):
        TfView('/scan')
    view, other = TfView(live=True), TfView()
    assert view._node.get_name() != other._node.get_name() and view.address
    ros.stop()
    assert not nodes.is_alive(view._node) and view.address is None
    view.stop()
    assert repr(view) == 'no frame so far'
    with pytest.raises(RuntimeError, match='helpers.ros.start'):
        TfView()
    with pytest.raises(RuntimeError, match='helpers.ros.start'):
        show_frames()


def test_the_flat_tree(sender):
    with TfView() as view:
        sender.wait_for_listener()
        sender.send('base', 'lamp', static=True)
        for number in range(5):
            sender.send('map', 'base', at=100.0 + 0.1 * number)
        last = Time(nanoseconds=100_400_000_000)
        wait_for(lambda: len(view.frames) == 3 and view.buffer.can_transform('map', 'base', last), timeout=30)
        diagram = show_frames(view)
        rows = {row.child: row for row in diagram.rows}
        assert rows['lamp'].static and rows['lamp'].parent == 'base' and not rows['base'].static
        assert rows['base'].rate == pytest.approx(12.5) and rows['base'].history == pytest.approx(0.4)
        assert rows['base'].broadcaster == rows['lamp'].broadcaster == '/sender'
        then = FramesDiagram(view.buffer, now=100.5)
        assert repr(then).splitlines()[:2] == ['map, root', '  base, moves, 12.5 Hz, 100 ms, 0.4 s']
        assert 'other clock' in repr(diagram) and '>lamp</text>' in diagram.svg()
        sender.send('lamp', 'map', at=101.0)
        wait_for(lambda: view.problems, timeout=30)
        loop = show_frames(view)
        assert repr(loop).startswith('a loop: ') and '>map</text>' in loop.svg()


def test_no_age_is_negative_though_transforms_come_while_the_diagram_is_made(sender, monkeypatch):
    buffer = Buffer()

    def meanwhile(node):
        message = TransformStamped(child_frame_id='base')
        message.header.frame_id, message.transform.rotation.w = 'map', 1.0
        message.header.stamp = node.get_clock().now().to_msg()
        buffer.set_transform(message, 'me')
        return [], []

    monkeypatch.setattr(frames_diagram, '_broadcasters', meanwhile)
    diagram = show_frames(buffer)
    (row,) = [row for row in diagram.rows if not row.static]
    assert 0 <= diagram.now - row.stamp < 10


def test_the_flat_tree_of_a_buffer_alone():
    buffer = Buffer()
    for parent, child in (('a', 'b'), ('b', 'c'), ('c', 'a'), ('x', 'y')):
        message = TransformStamped(child_frame_id=child)
        message.header.frame_id, message.header.stamp.sec, message.transform.rotation.w = parent, 1, 1.0
        buffer.set_transform(message, f'from_{parent}')
    diagram = show_frames(buffer)
    assert diagram.problems == ['a loop: b → a → c → b'] and '>a loop: b → a → c → b</text>' in diagram.svg()
    assert repr(diagram).splitlines()[1:3] == ['x, root', '  y, moves, once, 0.0 s, from_x']


def test_a_wide_flat_tree_is_made_smaller():
    buffer = Buffer()
    for number in range(12):
        message = TransformStamped(child_frame_id=f'a_frame_with_a_rather_long_name_{number + 1}')
        message.header.frame_id = f'a_frame_with_a_rather_long_name_{number}'
        message.transform.rotation.w = 1.0
        buffer.set_transform_static(message, 'somebody')
    size = re.match(r'<svg [^>]*width="(\d+)" height="(\d+)" viewBox="0 0 (\d+) (\d+)"', FramesDiagram(buffer).svg())
    width, height, whole_width, whole_height = map(int, size.groups())
    assert width == 900 < whole_width and height / whole_height == pytest.approx(width / whole_width, abs=0.01)


def test_a_broadcaster_without_a_name_is_left_out(monkeypatch):
    from helpers.show.views import frames_diagram

    class Graph:
        def get_publishers_info_by_topic(self, topic):
            return [
                SimpleNamespace(node_namespace='/', node_name='camera'),
                SimpleNamespace(node_namespace='_NODE_NAMESPACE_UNKNOWN_', node_name=nodes.UNKNOWN),
            ]

    monkeypatch.setattr(frames_diagram, '_PATIENCE', 0.0)
    assert frames_diagram._broadcasters(Graph()) == (['/camera'], ['/camera'])


def test_ages_are_by_simulated_time_where_there_is_some(sender):
    from builtin_interfaces.msg import Time as Stamp
    from rosgraph_msgs.msg import Clock

    from helpers import spinning

    publisher = sender.node.create_publisher(Clock, '/clock', 1)
    sender.node.create_timer(0.02, lambda: publisher.publish(Clock(clock=Stamp(sec=12))))
    buffer = Buffer()
    message = TransformStamped(child_frame_id='base')
    message.header.frame_id, message.header.stamp.sec, message.transform.rotation.w = 'map', 10, 1.0
    buffer.set_transform(message, 'me')
    with spinning(sender.node):
        node = rclpy.create_node('other')
        wait_for(lambda: node.count_publishers('/clock'), timeout=30)
        assert repr(show_frames(buffer)) == 'map, root\n  base, moves, once, 2.0 s, 0.0 s, me'


def test_the_flat_tree_listens_by_itself(sender):
    sender.node.create_timer(0.02, lambda: sender.send('map', 'base'))
    sender.send('base', 'lamp', static=True)
    from helpers import spinning

    with spinning(sender.node):
        diagram = show_frames(duration=1.0)
    assert {row.child: row.static for row in diagram.rows} == {'base': False, 'lamp': True}
    assert 'root' in repr(diagram) and not [node for node in nodes.living() if 'show_frames' in node.get_name()]
    assert repr(show_frames(duration=0.05)) == 'no frame'


def test_poses_agree_with_the_buffer(sender):
    """By composition, as the live view does, and by the buffer's look-ups, as the past does."""
    with TfView() as view:
        sender.wait_for_listener()
        for number, (parent, child) in enumerate((('a', 'b'), ('b', 'c'), ('a', 'd'), ('d', 'e')), start=1):
            sender.send(parent, child, float(number), at=7.0)
        wait_for(lambda: len(view.frames) == 5, timeout=30)
        for fixed in 'ace':
            live = view._tf.tree.poses(fixed)
            past = view._tf.tree.poses_at(fixed, view.buffer, Time(seconds=7))
            assert live.keys() == past.keys()
            for frame, pose in live.items():
                np.testing.assert_allclose(pose, past[frame], atol=1e-12)
    spin_for(0.0)
