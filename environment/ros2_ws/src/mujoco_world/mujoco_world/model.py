"""From a robot's description and a scene to a MuJoCo model."""

from xml.etree import ElementTree

import mujoco
import numpy
import urdf_reader
from urdf_reader import UrdfError

from mujoco_world.robot import Robot
from mujoco_world.scene import Scene

TIMESTEP = 0.002  # s
STIFFNESS = 0.005  # s, time constant of a contact; MuJoCo wants at least two time steps
FLOOR = 'floor'
# Groups of geoms. A laser sees what touches: WALLS and BODY. A camera sees WALLS and LOOKS.
WALLS, LOOKS, BODY = 0, 1, 2
GAIN = 5.0  # N m s/rad, of the controller of a driven wheel's speed
ROTOR = 0.01  # kg m², what a driven wheel feels of its motor's rotor, through the gears
# MuJoCo wants a mass of what moves. A link without <inertial> has none: this is next to none.
LEAST_MASS, LEAST_INERTIA = 1e-3, 1e-6  # kg, kg m²


def build(text: str, robot: Robot, scene: Scene) -> mujoco.MjModel:
    """
    Return the model: the robot on the floor of the scene, its joints driven as its ``<gazebo>`` elements say.

    Names of bodies and joints are those of the URDF. A wall's geom has its name; its body is the world's.

    :param text: the URDF that `robot` was read from.
    :raises UrdfError: MuJoCo cannot make a body of it.
    """
    try:
        spec = mujoco.MjSpec.from_string(_for_mujoco(text, robot.description))
        _add_scene(spec, scene)
        _finish_robot(spec, robot)
        return spec.compile()
    except ValueError as error:
        if isinstance(error, UrdfError):
            raise
        raise UrdfError(f'MuJoCo refuses this robot: {" ".join(str(error).split())}') from None


def _for_mujoco(text: str, description: urdf_reader.Robot) -> str:
    """The URDF with the settings of MuJoCo's reader, and with files where it names packages."""
    for link in description.links.values():
        for shape in (*link.visuals, *link.collisions):
            if isinstance(shape.geometry, urdf_reader.Mesh):
                text = text.replace(shape.geometry.filename, str(urdf_reader.resolve(shape.geometry.filename)))
    root = ElementTree.fromstring(text)
    for element in root.findall('mujoco'):
        root.remove(element)
    settings = ElementTree.SubElement(root, 'mujoco')
    # Every link stays a body of its own, for its frame. An inertia is what the URDF says, however absurd.
    ElementTree.SubElement(
        settings,
        'compiler',
        fusestatic='false',
        discardvisual='false',
        strippath='false',
        inertiafromgeom='false',
        balanceinertia='true',
        boundmass=str(LEAST_MASS),
        boundinertia=str(LEAST_INERTIA),
    )
    return ElementTree.tostring(root, encoding='unicode')


def _finish_robot(spec: mujoco.MjSpec, robot: Robot) -> None:
    """Free the robot from the world, and give it friction, motors and a camera."""
    root = spec.body(robot.description.root)
    root.add_freejoint(name='root')
    for name in robot.description.links:
        body = spec.body(name)
        for geom in body.geoms:
            looks = geom.group == 1  # MuJoCo's reader marks what is only seen
            geom.group = LOOKS if looks else BODY
            if not looks:
                mu = robot.friction.get(name, 1.0)
                geom.friction = [mu, 0.0, 0.0]
                geom.priority = 1  # the friction of the robot's part counts, whatever it stands on
                geom.solref = [STIFFNESS, 1.0]
                geom.condim = 3 if mu else 1
    for joint in (robot.drive.left, robot.drive.right) if robot.drive else ():
        limit = robot.description.joints[joint].limit
        motor = spec.add_actuator(name=joint, target=joint, trntype=mujoco.mjtTrn.mjTRN_JOINT)
        motor.set_to_velocity(GAIN)
        spec.joint(joint).armature = ROTOR
        if limit and limit.effort:
            motor.forcelimited, motor.forcerange = True, [-limit.effort, limit.effort]
        if limit and limit.velocity:
            motor.ctrllimited, motor.ctrlrange = True, [-limit.velocity, limit.velocity]
    if (camera := robot.camera) is not None:
        vertical = 2 * numpy.arctan(numpy.tan(camera.fov / 2) * camera.height / camera.width)
        # A camera of MuJoCo looks along -z, with y up; in the link's frame that is along x, with z up.
        spec.body(camera.link).add_camera(
            name='camera', fovy=float(numpy.degrees(vertical)), quat=[0.5, 0.5, -0.5, -0.5]
        )
        spec.visual.global_.offwidth = max(spec.visual.global_.offwidth, camera.width)
        spec.visual.global_.offheight = max(spec.visual.global_.offheight, camera.height)


def _add_scene(spec: mujoco.MjSpec, scene: Scene) -> None:
    spec.option.timestep = TIMESTEP
    spec.option.cone = mujoco.mjtCone.mjCONE_ELLIPTIC
    spec.option.impratio = 20.0  # wheels creep less under load
    spec.option.disableflags |= mujoco.mjtDisableBit.mjDSBL_AUTORESET  # what blows up is told, not hidden
    world = spec.worldbody
    world.add_geom(name=FLOOR, type=mujoco.mjtGeom.mjGEOM_PLANE, size=[20, 20, 0.1], material=_tiles(spec))
    for wall in scene.walls:
        world.add_geom(
            name=wall.name,
            type=mujoco.mjtGeom.mjGEOM_BOX,
            pos=[*wall.at, wall.height / 2],
            size=[wall.size[0] / 2, wall.size[1] / 2, wall.height / 2],
            rgba=wall.colour,
        )
    for name, (x, y, _) in scene.stations.items():
        world.add_geom(
            name=f'station {name}',
            type=mujoco.mjtGeom.mjGEOM_CYLINDER,
            pos=[x, y, 0.001],
            size=[0.22, 0.001, 0],
            rgba=scene.colours.get(name, (0.45, 0.47, 0.52, 1.0)),
            contype=0,
            conaffinity=0,
            group=LOOKS,
        )
    world.add_light(
        pos=[0, 0, 6],
        dir=[0.3, 0.2, -1],
        type=mujoco.mjtLightType.mjLIGHT_DIRECTIONAL,
        castshadow=False,
        diffuse=[0.45, 0.45, 0.45],
        ambient=[0.25, 0.25, 0.25],
    )


def _tiles(spec: mujoco.MjSpec) -> str:
    """Add a sky and a floor of tiles of half a metre: a camera sees how fast it moves. Returns the tiles' material."""
    spec.add_texture(
        name='sky',
        type=mujoco.mjtTexture.mjTEXTURE_SKYBOX,
        builtin=mujoco.mjtBuiltin.mjBUILTIN_GRADIENT,
        rgb1=[0.80, 0.87, 0.95],
        rgb2=[0.97, 0.97, 0.98],
        width=64,
        height=64,
    )
    spec.add_texture(
        name='tiles',
        type=mujoco.mjtTexture.mjTEXTURE_2D,
        builtin=mujoco.mjtBuiltin.mjBUILTIN_CHECKER,
        rgb1=[0.87, 0.87, 0.85],
        rgb2=[0.80, 0.80, 0.78],
        width=64,
        height=64,
    )
    tiles = spec.add_material(name='tiles', texuniform=True, texrepeat=[1, 1])
    tiles.textures[mujoco.mjtTextureRole.mjTEXROLE_RGB] = 'tiles'
    return tiles.name
