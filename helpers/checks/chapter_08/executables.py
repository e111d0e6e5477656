"""What tests see of the executables that a launch file starts: are they those of the given package, with its file?"""

import secrets


def sign(learner) -> tuple[str, int]:
    """A name and a value that only the executable in the tests' package shows; the same for all of a session.

    No right answer depends on them, so they need not be the same when the work is graded again.
    """
    drawn: tuple[str, int] = learner.server.workspaces.setdefault(
        'sign', (f'only_{secrets.token_hex(5)}', secrets.randbits(40))
    )
    return drawn


def lacks_parameter_file(log: str) -> bool:
    """Tell from the output of `ros2 launch` whether a parameter file is not there.

    The action Node leaves such a file out with a warning; a program that gets it by itself ends with an error.
    """
    return 'Parameter file path is not a file' in log or 'Error opening YAML file' in log
