"""A talker on /chatter and a listener that is best effort, as the C++ demos have them."""

from demo_nodes_py import topics
from node_program.running import run
from rclpy.qos import qos_profile_sensor_data


class Talker(topics.Talker):
    """Counts aloud from 1; its queue keeps 7 messages."""

    FIRST, LOG = 1, "Publishing: '{}'"

    def __init__(self) -> None:
        """Publish with the depth of the C++ demo."""
        super().__init__(qos=7)


class BestEffortListener(topics.Listener):
    """A listener that does not ask for a message again."""

    def __init__(self) -> None:
        """Subscribe as to a sensor."""
        super().__init__(qos=qos_profile_sensor_data)


def talker(args: list[str] | None = None) -> None:
    """Run the talker."""
    run(Talker, args)


def listener_best_effort(args: list[str] | None = None) -> None:
    """Run the listener that is best effort."""
    run(BestEffortListener, args)
