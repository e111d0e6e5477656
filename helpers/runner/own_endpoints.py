"""A test's own subscription to a learner's system, which records a topic, and its own publisher."""

from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from rclpy.subscription import Subscription

if TYPE_CHECKING:
    from helpers.runner.learner import Learner


@dataclass
class Received:
    """What a subscription of the test's has received: `messages`, and `stamps` (simulated seconds of receipt).

    `numbers` are those that the publishers gave the messages, from 1: who comes late to a latched topic hears the last
    message, and sees how many there were before it. `published` is when, in ns of the machine's clock: the
    order of what one process has said on several topics at one simulated moment.
    """

    topic: str
    messages: list = field(default_factory=list)
    stamps: list[float] = field(default_factory=list)
    numbers: list[int] = field(default_factory=list)
    published: list[int] = field(default_factory=list)
    subscription: Subscription = field(init=False, repr=False)
    strict: bool = field(default=True, repr=False)
    optional: bool = field(default=False, repr=False)  # no hint if the learner has no publisher there
    matched: int = field(default=0, repr=False)  # publishers that were ever connected
    gone: int = field(default=0, repr=False)  # those of them that are not any more
    silent: int = field(default=0, repr=False)  # those that were gone before the first message of anybody came
    spoken: bool = field(default=False, repr=False)  # a message has come, which may be forgotten by now
    known: set = field(default_factory=set, repr=False)  # those of the test's and the learner's programs
    judged: tuple = field(default=(), repr=False)  # what was known of the publishers when they were last looked at

    @property
    def data(self) -> list:
        """The `data` fields of the messages."""
        return [message.data for message in self.messages]

    def clear(self) -> None:
        """Forget what has been received."""
        self.messages.clear()
        self.stamps.clear()
        self.numbers.clear()
        self.published.clear()

    def __len__(self) -> int:
        return len(self.messages)


class Talker:
    """A publisher of the test's. `optional`: a program may do without a subscription to it; no hint tells of that."""

    optional = False

    def __init__(self, learner: 'Learner', publisher, strict: bool):
        self.learner, self.publisher, self.strict = learner, publisher, strict
        self.topic = publisher.topic_name

    def send(self, *messages) -> None:
        """Publish; `settle` or `run` lets the learner's node react.

        The first send waits until the learner's nodes are connected.
        """
        self.learner.connect()
        for message in messages:
            self.publisher.publish(message)
        self.learner.unsettled = True
