"""The learner's side without a sandbox, for `helpers.runner.warm`: a fork server of programs for each session.

Plain processes with limits: enough for a learner's own work in their own notebook.
"""

import socket

from helpers.runner import fork_server, forked, preloading
from helpers.runner.lifetime import adopt_orphans
from helpers.runner.start_processes import environment


def warm_up() -> None:
    """Nothing more than what programs import most."""


def prepare(request: dict) -> None:
    """Import what the session's programs import; the next session's find it, too."""
    preloading.warm_up_for(request['modules'])


def run(request: dict, control: int, printed: int) -> None:
    """Serve one session's tests. The request has `domain`, `home` and `modules` (`preloading.on_demand`)."""
    forked.stand_alone(printed, [control])
    adopt_orphans()
    forked.move(request['home'], environment(request['domain'], request['home']))
    fork_server.serve(socket.socket(fileno=control), fork_server.ProgramProcesses())
