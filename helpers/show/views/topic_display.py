"""Bases of the displays that show the messages of one topic: what is missing is said, and when a message is shown."""

import time
from bisect import bisect_right
from collections import deque

import numpy as np

from helpers.show.views import poses
from helpers.show.views.display import Display, no_transform

_LOOK = 1.0  # s between two looks at the graph while nothing comes
_SILENT = 2.0  # s without a message after which the QoS of the publishers is looked at again
_PATIENCE = 0.5  # s that a message may wait for the transforms of its time
_BACK = 60  # messages that are tried, from the newest on: on a busy machine transforms come a second later
_HISTORY = 10_000_000_000  # ns of messages that are kept for time travel, as long as the tf buffer


class TopicDisplay(Display):
    """A display of one topic.

    :param topic: its name.
    :param qos: QoS or depth of the subscription; None: as in RViz, see `default_qos`. With None, a display also
        asks for TRANSIENT_LOCAL where all publishers offer it: then it shows what was sent before it started.
    """

    def __init__(self, topic: str, qos=None):
        super().__init__()
        self.topic, self.qos = topic, qos
        self._wanted = self._subscription = None
        self._topic_name = topic
        self._arrival: float | None = None  # of the last message, `time.monotonic()`
        self._looked = 0.0
        self._silence = ''

    def message_type(self) -> type:
        """The class of the messages; imported only when it is needed."""
        raise NotImplementedError

    def take(self, message) -> None:
        """Take a message; subclasses write it."""
        raise NotImplementedError

    @staticmethod
    def default_qos():
        """RViz's QoS for this display: by default the last 5, reliable, volatile."""
        from rclpy.qos import QoSProfile

        return QoSProfile(depth=5)

    def on_start(self) -> None:
        from rclpy.qos import QoSProfile

        qos = self.default_qos() if self.qos is None else self.qos
        self._wanted = qos if isinstance(qos, QoSProfile) else QoSProfile(depth=qos)
        self._topic_name = self.node.resolve_topic_name(self.topic)
        self._arrival, self._looked, self._silence, self._subscription = None, 0.0, '', None
        self._try()

    def receive(self, message) -> None:
        """Note that a message has come, and take it."""
        self._arrival, self._silence = time.monotonic(), ''
        self.take(message)

    def silence(self) -> str:
        """Return why no message comes, as far as the graph tells; '' while messages come."""
        now = time.monotonic()
        quiet = self._arrival is None or now - self._arrival > _SILENT
        if quiet and now - self._looked >= _LOOK:
            self._looked = now
            self._silence = self._look(heard=self._arrival is not None)
        return self._silence

    def _publishers(self) -> tuple[list[str], list]:
        """The types of the topic other than ours, and the QoS of those of our type."""
        kind = _type_name(self.message_type())
        found = self.node.get_publishers_info_by_topic(self._topic_name)
        return (
            sorted({info.topic_type for info in found} - {kind}),
            [info.qos_profile for info in found if info.topic_type == kind],
        )

    def _try(self) -> None:
        """Subscribe, unless the topic carries another type: DDS refuses two types of a topic in one process."""
        others, ours = self._publishers()
        if others and not ours:
            return
        self._ask_for_what_was_sent(ours)
        try:
            self._subscription = self.subscribe(self.message_type(), self._topic_name, self.receive, self._wanted)
        except Exception as error:  # rclpy has no public class for it
            self._silence = f'cannot subscribe to [{self._topic_name}]: {str(error).splitlines()[0]}'

    def _ask_for_what_was_sent(self, offered: list) -> bool:
        """Ask for TRANSIENT_LOCAL if nobody asked for anything and all offer it; return whether that is new."""
        from rclpy.qos import DurabilityPolicy

        kept = DurabilityPolicy.TRANSIENT_LOCAL
        new = (
            self.qos is None
            and self._wanted.durability != kept
            and bool(offered)
            and all(profile.durability == kept for profile in offered)
        )
        if new:
            self._wanted.durability = kept
        return new

    def _look(self, heard: bool) -> str:
        from helpers.kernel import qos

        name, kind = self._topic_name, _type_name(self.message_type())
        others, ours = self._publishers()
        if not heard and self._subscription is not None and self._ask_for_what_was_sent(ours):
            self.unsubscribe(self._subscription)
            self._subscription = None
        if self._subscription is None:
            self._try()
        misfits = [qos.mismatches(offered, self._wanted) for offered in ours]
        if ours and all(misfits):
            found = '; '.join(
                f'{policy}: the publisher offers {offers}, this display asks for {asks}'
                for policy, offers, asks in misfits[0]
            )
            return f'incompatible QoS on [{name}]: {found}'
        if heard:
            return ''
        if others and not ours:
            return f'[{name}] carries {", ".join(others)}, not {kind}'
        if self._subscription is None:
            return self._silence
        return f'no message on [{name}] so far' if ours else f'no publisher on [{name}]'


class StampedDisplay(TopicDisplay):
    """A display of messages with a header, shown one at a time.

    As in RViz, a message is placed by the transform at the time of its stamp, once that is known; then it stays where
    it is in the fixed frame until the next one. A stamp of zero means the latest transform. In time travel, the last
    message before the moment is shown. Subclasses write `draw`.
    """

    def __init__(self, topic: str, qos=None):
        super().__init__(topic, qos)
        self._kept: deque = deque()
        self._travels = False  # in time travel, old messages are kept
        self._shown = None  # the message that is drawn
        self._place: tuple | None = None  # (message, fixed frame) of the pose that is set
        self._waiting: float | None = None  # since when a message waits for its transform

    def on_start(self) -> None:
        super().on_start()
        self._kept.clear()
        self._shown = self._place = self._waiting = None

    def take(self, message) -> None:
        """Keep a message; those too old for time travel go."""
        if self._kept and _stamp(message) < _stamp(self._kept[-1]):  # time went back: a new run of a simulation
            self._kept.clear()
        self._kept.append(message)
        while len(self._kept) > 1000 or not self._travels and _stamp(message) - _stamp(self._kept[0]) > _HISTORY:
            self._kept.popleft()

    def update(self, fixed_frame, time) -> None:
        self.problem = self.silence()
        self._travels = time.nanoseconds != 0
        if self._kept:
            message, pose = self._choose(fixed_frame, time)
            if message is None:
                self.scene.appearance('message', visible=False)
                self._place = None
            elif not self._is_placed(message, fixed_frame):
                if message is not self._shown:
                    self.draw(message)
                    self._shown = message
                self.scene.pose('message', pose)
                self.scene.appearance('message', visible=True)
                self._place = (message, fixed_frame)

    def draw(self, message) -> None:
        """Set the shapes of a message, in its own frame, at or below the node ``message``."""
        raise NotImplementedError

    def _is_placed(self, message, fixed_frame: str) -> bool:
        return self._place is not None and self._place[0] is message and self._place[1] == fixed_frame

    def _choose(self, fixed_frame: str, moment):
        """Return the message to show and its pose; pose None: it stays where it is. (None, None): nothing."""
        if moment.nanoseconds:
            at = bisect_right([_stamp(message) for message in self._kept], moment.nanoseconds)
            message = self._kept[at - 1] if at else None
            pose = None if message is None else self._pose(message, fixed_frame)[0]
            return (None, None) if pose is None else (message, pose)
        kept = self._place if self._place is not None and self._place[1] == fixed_frame else None
        newest = self._kept[-1]
        if kept is not None and kept[0] is newest:
            return newest, None
        pose, late = self._pose(newest, fixed_frame)
        if pose is not None:
            self._waiting = None
            return newest, pose
        if not late:
            return None, None
        if self._waiting is None:
            self._waiting = time.monotonic()
        for message in list(self._kept)[-2 : -2 - _BACK : -1]:  # a message whose transforms have come meanwhile
            if kept is not None and message is kept[0]:
                break
            pose = self._pose(message, fixed_frame)[0]
            if pose is not None:
                self._waiting = None
                return message, pose
        if time.monotonic() - self._waiting > _PATIENCE:
            self.problem = (
                f'{no_transform(f"[{_frame(newest)}]", fixed_frame)} at the time of the message on [{self._topic_name}]'
            )
            return None, None
        return (kept[0], None) if kept is not None else (None, None)

    def _pose(self, message, fixed_frame: str) -> tuple[np.ndarray | None, bool]:
        """The pose of the message's frame at its time; None and whether only the time is in the way."""
        from rclpy.time import Time
        from tf2_ros import ExtrapolationException, TransformException

        frame = _frame(message)
        if not frame:
            self.problem = f'the message on [{self._topic_name}] has no frame_id'
            return None, False
        try:
            stamp = Time.from_msg(message.header.stamp)
            return poses.from_transform(self.buffer.lookup_transform_core(fixed_frame, frame, stamp)), False
        except ExtrapolationException:
            return None, True
        except TransformException:
            self.problem = no_transform(f'[{frame}]', fixed_frame)
            return None, False


def _stamp(message) -> int:
    stamp = message.header.stamp
    return stamp.sec * 1_000_000_000 + stamp.nanosec


def _frame(message) -> str:
    return message.header.frame_id.removeprefix('/')


def _type_name(message_type) -> str:
    return f'{message_type.__module__.split(".")[0]}/msg/{message_type.__name__}'
