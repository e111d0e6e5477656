"""Drops the robot of a URDF in the simulated world: `python drop.py FILE.urdf`, results as JSON on standard output.

Tests run it on the learner's side (see `falling.py`): a text of the learner's is not parsed on the tests' side. The
results, of the root link and in its frame, in metres, kilograms and kg m²: `mass`; `centre` of the mass; `inertia`
about the centre, 3x3; `links`, the names of all of them; `touches` and `looks`, how many shapes; `kinds` of those that
touch, such as box; `low` and `high`, the corners of what touches; `seen`, those of what is seen; `height` of the frame
1.5 s after it was let go 0.5 m above the floor.
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
    visible = [geom for geom in geoms if model.geom_group[geom] == LOOKS]
    corners = np.array([corner for geom in boxes for corner in _corners(model, geom)])
    seen = np.array([corner for geom in visible for corner in _corners(model, geom)])
    world.data.qpos[2] += 0.5
    try:
        world.run(1.5)
    except UnstableError as error:
        return {'refused': str(error)}
    return {
        'links': list(world.robot.description.links),
        'mass': model.body_mass[root],
        'centre': model.body_ipos[root].tolist(),
        'inertia': (turn @ np.diag(model.body_inertia[root]) @ turn.T).tolist(),
        'touches': len(boxes),
        'looks': len(visible),
        'kinds': [mujoco.mjtGeom(model.geom_type[geom]).name.removeprefix('mjGEOM_').lower() for geom in boxes],
        'low': corners.min(axis=0).tolist() if boxes else None,
        'high': corners.max(axis=0).tolist() if boxes else None,
        'seen': [seen.min(axis=0).tolist(), seen.max(axis=0).tolist()] if visible else None,
        'height': world.pose.z,
    }


def _corners(model: mujoco.MjModel, geom: int) -> list[np.ndarray]:
    """The lowest and the highest place that a box reaches along each axis of its link, however it is turned."""
    turn = np.empty(9)
    mujoco.mju_quat2Mat(turn, model.geom_quat[geom])
    reach = np.abs(turn.reshape(3, 3)) @ model.geom_size[geom]
    return [model.geom_pos[geom] - reach, model.geom_pos[geom] + reach]


if __name__ == '__main__':
    print(json.dumps(results(Path(sys.argv[1]).read_text())))
