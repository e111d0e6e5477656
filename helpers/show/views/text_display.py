"""The display of a text: what a topic says, beside a frame."""

from helpers.show.views import poses
from helpers.show.views.shapes import DARK, Label
from helpers.show.views.topic_display import TopicDisplay


class Text(TopicDisplay):
    """The latest text of a topic (std_msgs/String), above a frame.

    :param topic: name of the topic.
    :param frame: the frame beside which it stands.
    :param above: how far above the frame it stands, in m along the fixed frame's z.
    :param colour: red, green, blue from 0 to 1.
    :param qos: QoS or depth; None: reliable, and also what was sent before if the publishers keep it.
    """

    def __init__(self, topic: str, frame: str, above: float = 0.5, colour=DARK, qos=None):
        super().__init__(topic, qos)
        self.frame, self.above, self.colour = frame, above, colour
        self.text: str | None = None  #: the latest one; None while nothing has come

    def message_type(self):
        from std_msgs.msg import String

        return String

    def take(self, message) -> None:
        self.text = message.data

    def update(self, fixed_frame: str, time) -> None:
        self.problem = self.silence() if self.text is None else ''
        if self.text is None:
            return
        pose = self.transform(fixed_frame, self.frame, time)
        self.scene.appearance('text', visible=pose is not None)
        if pose is not None:
            self.scene.set('text', Label(self.text, None, self.colour, True))
            self.scene.pose('text', poses.matrix((0.0, 0.0, self.above)) @ pose)
