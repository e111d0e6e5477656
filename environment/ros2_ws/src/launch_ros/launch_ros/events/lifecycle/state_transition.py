"""The change of a lifecycle node's state."""

from launch.event import Event
from lifecycle_msgs.msg import TransitionEvent


class StateTransition(Event):
    """A lifecycle node has gone from one state to another. States and transition are named by their labels."""

    name = 'launch_ros.events.lifecycle.StateTransition'

    def __init__(self, *, action, msg: TransitionEvent):
        self.action, self.msg = action, msg
        self.timestamp = msg.timestamp
        self.transition = msg.transition.label
        self.start_state = msg.start_state.label
        self.goal_state = msg.goal_state.label
