"""Looks at the robot of a URDF: `python urdf_probe.py FILE.urdf TASK JSON`, results as JSON on standard output.

Tests run it on the learner's side (see `scouts.py`): a text of the learner's is not parsed on the tests' side. Tasks
are `frames`, `bodies`, `scan` and `ride`; JSON is what a test has drawn. `refused` is there alone if the URDF cannot be
used. Lengths are in metres, angles in radians, masses in kilograms.
"""

import json
import math
import subprocess
import sys
import time
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import urdf_reader
from ament_index_python import get_package_prefix
from urdf_reader import UrdfError

PATIENCE = 10.0  # seconds of wall time for what robot_state_publisher sends


def frames(text: str, given: dict) -> dict:
    """What robot_state_publisher broadcasts: `frames` has parent, place and quaternion of each child."""
    robot = urdf_reader.read(text)
    name = 'robot_state_publisher'
    program = f'{get_package_prefix(name)}/lib/{name}/{name}'
    publisher = subprocess.Popen([program, sys.argv[1]], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    try:
        found = _heard(robot)
    finally:
        publisher.terminate()
        try:
            publisher.wait(2.0)
        except subprocess.TimeoutExpired:  # on a busy machine it may be slow to end
            publisher.kill()
            publisher.wait()
    joints = {
        name: [joint.type, joint.parent, joint.child, joint.axis, joint.origin.matrix.tolist()]
        for name, joint in robot.joints.items()
    }
    return {'frames': found, 'joints': joints, 'root': robot.root, 'links': list(robot.links)}


def _heard(robot: urdf_reader.Robot) -> dict:
    """Parent, place and quaternion of each child that is broadcast while all joints stand at 0."""
    import rclpy
    from rclpy.executors import SingleThreadedExecutor
    from rclpy.qos import DurabilityPolicy, QoSProfile
    from sensor_msgs.msg import JointState
    from tf2_msgs.msg import TFMessage

    rclpy.init()
    listener = rclpy.create_node('listener')
    found: dict = {}

    def on_frames(message):
        for one in message.transforms:
            place, turn = one.transform.translation, one.transform.rotation
            xyz, quaternion = (place.x, place.y, place.z), (turn.x, turn.y, turn.z, turn.w)
            found[one.child_frame_id] = [one.header.frame_id, xyz, quaternion]

    latched = QoSProfile(depth=10, durability=DurabilityPolicy.TRANSIENT_LOCAL)
    listener.create_subscription(TFMessage, '/tf_static', on_frames, latched)
    listener.create_subscription(TFMessage, '/tf', on_frames, 10)
    motors = listener.create_publisher(JointState, '/joint_states', 10)
    moving = [name for name, joint in robot.joints.items() if joint.moves]
    executor = SingleThreadedExecutor()
    executor.add_node(listener)
    deadline = time.monotonic() + PATIENCE
    while len(found) < len(robot.joints) and time.monotonic() < deadline:
        message = JointState(name=moving, position=[0.0] * len(moving))
        message.header.stamp = listener.get_clock().now().to_msg()
        motors.publish(message)
        executor.spin_once(timeout_sec=0.05)
    rclpy.shutdown()
    return found


def bodies(text: str, given: dict) -> dict:
    """Of each link: `mass`, `centre`, `inertia` (3x3, in the link's frame), the shapes that touch, and their bottom.

    `frames` as in `frames`, but as the joints have them.
    """
    robot = urdf_reader.read(text)
    from mujoco_world.robot import read
    from tf_transformations import quaternion_from_matrix

    simulated = read(text)
    above = {joint.child: joint for joint in robot.joints.values()}

    def in_root(link: str) -> np.ndarray:
        matrix = np.eye(4)
        while link in above:
            matrix, link = above[link].origin.matrix @ matrix, above[link].parent
        return matrix

    found = {}
    for name, link in robot.links.items():
        shapes = [_shape(shape, in_root(name)) for shape in link.collisions]
        found[name] = {'shapes': shapes, 'looks': len(link.visuals), 'friction': simulated.friction.get(name, 1.0)}
        if link.inertial:
            ixx, ixy, ixz, iyy, iyz, izz = link.inertial.inertia
            turn = link.inertial.origin.matrix[:3, :3]
            inertia = turn @ np.array([[ixx, ixy, ixz], [ixy, iyy, iyz], [ixz, iyz, izz]]) @ turn.T
            found[name] |= {'mass': link.inertial.mass, 'centre': link.inertial.origin.xyz, 'inertia': inertia.tolist()}
    frames = {
        child: [joint.parent, joint.origin.matrix[:3, 3].tolist(), list(quaternion_from_matrix(joint.origin.matrix))]
        for child, joint in above.items()
    }
    return {'links': found, 'frames': frames}


def _shape(shape, link_in_root: np.ndarray) -> dict:
    """Kind, sizes, place and rotation in its link, and the height of its lowest point above the root frame."""
    geometry, place = shape.geometry, link_in_root @ shape.origin.matrix
    kind, up = type(geometry).__name__.lower(), place[2, :3]
    if kind == 'box':
        sizes = geometry.size
        reach = float(np.abs(up) @ np.array(sizes) / 2)
    elif kind == 'cylinder':
        sizes = (geometry.radius, geometry.length)
        reach = abs(up[2]) * geometry.length / 2 + geometry.radius * math.sqrt(max(0.0, 1 - up[2] ** 2))
    elif kind == 'sphere':
        sizes, reach = (geometry.radius,), geometry.radius
    else:
        sizes, reach = (), 0.0
    return {
        'kind': kind,
        'sizes': list(sizes),
        'place': shape.origin.matrix.tolist(),
        'rpy': list(shape.origin.rpy),
        'bottom': float(place[2, 3] - reach),
    }


def scan(text: str, given: dict) -> dict:
    """What the laser is, and what it sees in the rooms; `lidar` is None if there is none."""
    from mujoco_world.world import World

    world = World(text, scene='rooms')
    lidar = world.robot.lidar
    if lidar is None:
        return {'lidar': None}
    ranges = world.scan()
    found = {
        'link': lidar.link,
        'type': _sensor_type(text),
        'samples': lidar.samples,
        'angles': [lidar.min_angle, lidar.max_angle],
        'least': lidar.min_range,
        'range': lidar.max_range,
        'hits': int(np.isfinite(ranges).sum()),
        'nearest': float(np.nan_to_num(ranges, posinf=1e9, neginf=-1.0).min()),
    }
    return {'lidar': found}


def ride(text: str, given: dict) -> dict:
    """How the robot stands, sees and drives in the simulated world."""
    from mujoco_world.world import World

    world = World(text, scene='empty')
    found: dict = {'drive': world.robot.drive is not None, 'library': _library(text)}
    world.run(1.0)
    pose = world.pose
    found['stands'] = [pose.z, math.degrees(pose.roll), math.degrees(pose.pitch)]
    found |= scan(text, given)
    if not found['drive'] or pose.z < -0.1:  # nothing drives, or it falls
        return found
    found['motions'] = [_motion(text, *command) for command in ((0.3, 0.0), (0.0, 1.0))]
    world = World(text, scene='empty')
    for linear, angular, seconds in given['course']:
        world.drive(linear, angular)
        world.run(seconds)
    true, believed = world.pose, world.odometry
    found['odometry'] = {
        'truth': [true.x, true.y, math.degrees(true.yaw)],
        'believed': [believed.x, believed.y, math.degrees(believed.yaw)],
        'turned': math.degrees(math.remainder(true.yaw - believed.yaw, math.tau)),
    }
    return found | {'way': _drive_to(World(text, scene='rooms'), given['places'], given['seconds'])}


def _motion(text: str, linear: float, angular: float) -> list[float]:
    """x, y and yaw (degrees) after two seconds of a command."""
    from mujoco_world.world import World

    world = World(text, scene='empty')
    world.drive(linear, angular)
    world.run(2.0)
    return [world.pose.x, world.pose.y, math.degrees(world.pose.yaw)]


def _drive_to(world, places: list, seconds: float) -> dict:
    """Drive by the odometry from place to place; where the robot truly is in the end, and what it has touched."""
    places, touched = [*places], set()
    while places and world.time < seconds:
        believed = world.odometry
        dx, dy = places[0][0] - believed.x, places[0][1] - believed.y
        away, angle = math.hypot(dx, dy), math.remainder(math.atan2(dy, dx) - believed.yaw, math.tau)
        if away < 0.05:
            places.pop(0)
        world.drive(min(0.4, away) if abs(angle) < 0.4 else 0.0, max(-1.5, min(1.5, 2 * angle)))
        world.run(0.1)
        touched |= world.touching
    took = world.time
    world.drive(0.0, 0.0)
    world.run(0.5)
    pose = world.pose
    return {'there': not places, 'took': took, 'pose': [pose.x, pose.y, pose.z], 'touched': sorted(touched)}


def _library(text: str) -> str:
    """The file from which Gazebo would load the plugin of the differential drive."""
    from mujoco_world.robot import DRIVE

    plugins = ElementTree.fromstring(text).iter('plugin')
    return next((plugin.get('filename', '') for plugin in plugins if plugin.get('name') == DRIVE), '')


def _sensor_type(text: str) -> str:
    """The type of the sensor that is the laser."""
    types = [sensor.get('type', '') for sensor in ElementTree.fromstring(text).iter('sensor')]
    return next((kind for kind in types if 'lidar' in kind), '')


def _foreign(text: str) -> str:
    """An element that sets the physics of the whole world, which no robot may do; '' if there is none."""
    try:
        elements = [element.tag for element in ElementTree.fromstring(text).iter()]
    except ElementTree.ParseError:
        return ''  # whoever reads the URDF says so
    return next((tag for tag in elements if tag in ('mujoco', 'gravity', 'physics')), '')


def main() -> dict:
    """See above."""
    from mujoco_world.world import UnstableError

    text, given = Path(sys.argv[1]).read_text(), json.loads(sys.argv[3])
    if tag := _foreign(text):
        return {
            'refused': f'<{tag}> sets the physics of the whole world. A URDF describes the robot only: leave it out.'
        }
    try:
        return {'frames': frames, 'bodies': bodies, 'scan': scan, 'ride': ride}[sys.argv[2]](text, given)
    except (UrdfError, UnstableError) as error:
        return {'refused': str(error)}


if __name__ == '__main__':
    print(json.dumps(main()))
