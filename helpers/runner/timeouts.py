"""How long the runner waits for a learner's program at most."""

from dataclasses import dataclass


@dataclass(frozen=True)
class Timeouts:
    """Bounds on waiting, in seconds of wall time. They only end programs that would never end by themselves."""

    load: float = 6.0
    start: float = 6.0
    call: float = 6.0
    step: float = 6.0  # for what the worker itself awaits at one moment of simulated time
    stuck: float = 6.5  # for all callbacks at one moment of simulated time
    discovery: float = 20.0


TIMEOUTS = Timeouts()
# For an exercise that has already been stuck in another test. Only a program that stands in one of the learner's lines
# is given up so soon; who is late because of the machine gets four times as long.
AGAIN = Timeouts(3.0, 3.0, 3.0, 3.0, stuck=1.5)
