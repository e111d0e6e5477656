"""What the tests of exercise 6.1 know of the mast."""

import math
from difflib import get_close_matches

from helpers.runner import expect
from helpers.runner.frames import Listener, pose

PARENTS = {'mast': 'base_link', 'lidar': 'mast', 'camera': 'mast', 'camera_optical': 'camera'}
NOT_TURNED = '"Not turned" is x=0, y=0, z=0, w=1.'


def truth(height: float, tilt: float) -> dict:
    """The matrix of each child in its parent; `tilt` in degrees."""
    return {
        'mast': pose(x=-0.1, z=0.3),
        'lidar': pose(z=height, roll=math.pi),
        'camera': pose(x=0.05, z=height - 0.1, pitch=math.radians(tilt)),
        'camera_optical': pose(roll=-math.pi / 2, yaw=-math.pi / 2),
    }


def late_joiner(learner, height: float, tilt: float) -> Listener:
    """Start the mast, and listen when all has been said. Fails if not all frames are heard, with their parents."""
    node = learner.start('SensorMast', height, tilt)
    learner.run(0.5)
    expect(node.name == '/sensor_mast', f'Your node is called {node.name}, expected /sensor_mast.')
    late = learner.tf_listener()
    learner.settle()
    heard = late.static_transforms
    on_tf = learner.endpoints('/tf').publishers
    expect(
        heard or not on_tf,
        'Your transforms went to /tf. That is for frames that move; who comes late does not get '
        'them. Use a StaticTransformBroadcaster.',
    )
    expect(heard, 'A listener that came late heard nothing on /tf_static.')
    for child, transform in heard.items():
        swapped = PARENTS.get(transform.header.frame_id) == child
        expect(
            not swapped,
            f'You sent `{transform.header.frame_id}` as the parent of `{child}`. Parent and child are '
            'swapped: header.frame_id is the parent.',
        )
    lost = [child for child in PARENTS if child not in heard]
    expect(
        not lost,
        f'A listener that came late heard of {", ".join(f"`{child}`" for child in sorted(heard))}, and '
        f'nothing of `{lost and lost[0]}`. {_why(heard, lost)}',
    )
    return late


def _why(heard, lost: list[str]) -> str:
    """Why frames may be missing among those that were heard."""
    if len(heard) == 1:
        return 'It gets the last message of each publisher: send all transforms in one list.'
    others = [child for child in heard if child not in PARENTS]
    near = get_close_matches(lost[0], others, 1, 0.5) if lost else []
    return f'Is it what you call `{near[0]}`? A name counts letter by letter.' if near else 'Nobody has sent it.'


def in_base(late: Listener, child: str):
    """The matrix of a frame in base_link; fails if there is no way."""
    matrix = late.matrix('base_link', child)
    expect(
        matrix is not None,
        f'tf2 finds no way from `{child}` to `base_link`: the frames are no tree. Look at the parents.',
    )
    return matrix
