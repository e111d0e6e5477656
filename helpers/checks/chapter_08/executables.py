"""How tests know a node of the given package from one that a launch file has made itself, under the same name."""

import secrets


def sign(learner) -> tuple[str, int]:
    """A name and a value that only the executable in the tests' package shows; the same for all of a session.

    No right answer depends on them, so they need not be the same when the work is graded again.
    """
    drawn: tuple[str, int] = learner.server.workspaces.setdefault(
        'sign', (f'only_{secrets.token_hex(5)}', secrets.randbits(40))
    )
    return drawn
