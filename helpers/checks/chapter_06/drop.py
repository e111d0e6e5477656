"""Drops the robot of a URDF in the simulated world: `python drop.py FILE.urdf`, results as JSON on standard output.

Tests run it on the learner's side (see `falling.py`): a text of the learner's is not parsed on the tests' side. The
results, of the root link and in its frame, in metres, kilograms and kg m²: `mass`; `centre` of the mass; `inertia`
about the centre, 3x3; `touches` and `looks`, how many shapes; `low` and `high`, the corners of what touches; `height`
of the frame 1.5 s after it was let go 0.5 m above the floor.
"""

import json
import sys
from pathlib import Path

import mujoco
import numpy as np
from mujoco_world.model import BODY, LOOKS
from mujoco_world.world import UnstableError, UrdfError, World


def results(text: str) -> dict:
    """See above; `refused` is there alone if the URDF cannot be simulated."""
    try:
        world = World(text, scene='empty')
    except UrdfError as error:
        return {'refused': str(error)}
    model, root = world.model, world.model.body(world.robot.description.root).id
    turn = np.empty(9)
    mujoco.mju_quat2Mat(turn, model.body_iquat[root])
    turn = turn.reshape(3, 3)
    geoms = [geom for geom in range(model.ngeom) if model.geom_bodyid[geom] == root]
    boxes = [geom for geom in geoms if model.geom_group[geom] == BODY]
    corners = np.array([model.geom_pos[geom] + sign * model.geom_size[geom] for geom in boxes for sign in (-1, 1)])
    world.data.qpos[2] += 0.5
    try:
        world.run(1.5)
    except UnstableError as error:
        return {'refused': str(error)}
    return {
        'mass': model.body_mass[root],
        'centre': model.body_ipos[root].tolist(),
        'inertia': (turn @ np.diag(model.body_inertia[root]) @ turn.T).tolist(),
        'touches': len(boxes),
        'looks': sum(int(model.geom_group[geom]) == LOOKS for geom in geoms),
        'low': corners.min(axis=0).tolist() if boxes else None,
        'high': corners.max(axis=0).tolist() if boxes else None,
        'height': world.pose.z,
    }


if __name__ == '__main__':
    print(json.dumps(results(Path(sys.argv[1]).read_text())))
