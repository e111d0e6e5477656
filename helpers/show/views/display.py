"""The base class of displays. Like RViz's, a display shows one kind of thing from one topic.

How to write one::

    class PointStamped(Display):
        def __init__(self, topic='/point'):
            super().__init__()
            self.topic, self.message = topic, None

        def on_start(self):
            self.scene.set('point', Sphere(0.05, RED))
            self.subscribe(geometry_msgs.msg.PointStamped, self.topic, self.take)

        def take(self, message):
            self.message = message

        def update(self, fixed_frame, time):
            if self.message is None:
                self.problem = f'no message on {self.topic}'
                return
            pose = self.transform(fixed_frame, self.message.header.frame_id, time)
            self.scene.appearance('point', visible=pose is not None)
            if pose is not None:
                self.scene.pose('point', pose @ matrix((self.message.point.x, …)))

Callbacks and `update` run in one thread, one after the other.
"""

import numpy as np

from helpers.show.views import poses


class Display:
    """One thing to see in a `TfView`. It belongs to one view at a time, and may be started again after `stop`.

    Attributes for subclasses: `node` (rclpy node), `buffer` (tf2_ros Buffer), `scene` (this display's own part of the
    scene, in coordinates of the fixed frame), `problem` (what `status` tells after the update; before it '').
    """

    def __init__(self):
        self.node = self.buffer = self.scene = None
        self.problem = self._told = ''
        self._subscriptions = []

    @property
    def name(self) -> str:
        """What the view calls it."""
        return type(self).__name__

    def start(self, node, buffer, scene) -> None:
        """Begin to listen. Subclasses write `on_start`.

        :raises RuntimeError: it is in a view already.
        """
        if self.node is not None:
            raise RuntimeError(f'this {self.name} is in a view already: make a new one for this view')
        self.node, self.buffer, self.scene = node, buffer, scene
        self.on_start()

    def on_start(self) -> None:
        """Subscribe; set the shapes that do not depend on messages."""

    def update(self, fixed_frame: str, time) -> None:
        """Bring the scene up to date; called about 30 times a second.

        :param fixed_frame: '' while there is no frame at all.
        :param time: rclpy Time; zero means the latest, another one the past (time travel).
        """

    def refresh(self, fixed_frame: str, time) -> None:
        """Update, then tell the problem: nobody who asks meanwhile takes half an update for "nothing is wrong"."""
        self.problem = ''
        self.update(fixed_frame, time)
        self._told = self.problem

    def status(self) -> str:
        """Return what is wrong, such as ``no transform from [laser] to [map]``; '' if nothing is."""
        return self._told

    def stop(self) -> None:
        """Stop listening; what is in the scene stays. Idempotent."""
        node, self.node = self.node, None
        while self._subscriptions:
            node.destroy_subscription(self._subscriptions.pop())

    def subscribe(self, message_type, topic: str, callback, qos=10):
        """Subscribe with the view's node until `stop`."""
        subscription = self.node.create_subscription(message_type, topic, callback, qos)
        self._subscriptions.append(subscription)
        return subscription

    def unsubscribe(self, subscription) -> None:
        """End a subscription that `subscribe` made."""
        self._subscriptions.remove(subscription)
        self.node.destroy_subscription(subscription)

    def transform(self, fixed_frame: str, frame: str, time) -> np.ndarray | None:
        """Return the pose of a frame in the fixed frame as a 4 x 4 matrix; None, and a `problem`, if it is unknown."""
        from tf2_ros import TransformException

        try:
            return poses.from_transform(self.buffer.lookup_transform_core(fixed_frame, frame, time))
        except TransformException:
            self.problem = no_transform(f'[{frame}]', fixed_frame)
            return None


def no_transform(frames: str, fixed_frame: str) -> str:
    """Say that frames, such as ``[laser], [camera]``, cannot be placed in the fixed frame."""
    return f'no transform from {frames} to [{fixed_frame}]' if fixed_frame else f'no transform from {frames}: no frames'
