"""The simulated world, without ROS: physics, drive, sensors, and what a bad description does."""

import math
import subprocess
import sys
from pathlib import Path

import mobile_robot_description
import mujoco_world
import numpy as np
import pytest
import yaml
from mujoco_world import pictures, robot, scene
from mujoco_world.world import CONTROL_PERIOD, Noise, NoPicturesError, SceneError, UnstableError, UrdfError, World

EXACT = Noise(range=0.0)
URDF = mobile_robot_description.urdf()


def close(*values, within):
    """What equals these numbers, each within so much."""
    return pytest.approx(values, abs=within)


def test_the_description_is_short_enough_to_read_and_has_the_frames_of_rep_105():
    assert len(URDF.splitlines()) <= 120 and max(map(len, URDF.splitlines())) <= 135
    links = robot.read(URDF).description.links
    assert {'base_footprint', 'base_link', 'laser', 'camera', 'left_wheel', 'right_wheel'} <= links.keys()


def test_at_rest_the_robot_stands_on_the_floor():
    world = World(scene='empty')
    world.run(1.0)
    pose = world.pose
    assert (pose.x, pose.y, pose.yaw) == close(0, 0, 0, within=1e-5)
    assert (pose.z, pose.roll, pose.pitch) == close(0, 0, 0, within=1e-3)
    assert world.time == 1.0 and not world.touching


def test_drives_straight_within_its_limit_of_acceleration():
    world = World(scene='empty')
    world.drive(0.5, 0.0)
    world.run(0.25)
    assert world.odometry.linear == pytest.approx(0.25, abs=0.02)  # 1 m/s²
    world.run(3.75)
    assert (world.pose.x, world.pose.y, world.pose.yaw) == close(1.875, 0, 0, within=0.002)


@pytest.mark.parametrize(
    ('limits', 'forward', 'back', 'turn'),
    [
        ('<max_linear_velocity>0.1</max_linear_velocity>', 0.1, -0.4, 1.0),
        ('<min_linear_velocity>-0.1</min_linear_velocity>', 0.4, -0.1, 1.0),
        ('<max_angular_velocity>0.2</max_angular_velocity>', 0.4, -0.4, 0.2),
        ('<max_velocity>0.2</max_velocity>', 0.2, -0.4, 0.2),
        ('<max_velocity>0.2</max_velocity><max_linear_velocity>0.3</max_linear_velocity>', 0.3, -0.4, 0.2),
    ],
)
def test_the_plugin_may_limit_the_velocity(limits, forward, back, turn):
    world = World(URDF.replace('<wheel_radius>', f'{limits}<wheel_radius>'), scene='empty')
    for command, wanted in (((0.4, 0.0), (forward, 0.0)), ((-0.4, 0.0), (back, 0.0)), ((0.0, 1.0), (0.0, turn))):
        world.drive(*command)
        world.run(2.0)
        assert (world.odometry.linear, world.odometry.angular) == close(*wanted, within=0.02)


def test_a_least_velocity_above_the_largest_is_refused():
    limits = '<min_linear_velocity>0.3</min_linear_velocity><max_linear_velocity>0.1</max_linear_velocity>'
    with pytest.raises(UrdfError, match='linear velocity has the minimum 0.3 above the maximum 0.1'):
        World(URDF.replace('<wheel_radius>', f'{limits}<wheel_radius>'), scene='empty')


def test_turns_by_the_right_angle_on_the_spot_and_on_a_circle():
    world = World(scene='empty')
    world.drive(0.0, math.pi / 4)
    world.run(2.0)
    world.drive(0.0, 0.0)
    world.run(0.5)
    assert world.pose.yaw == pytest.approx(math.pi / 2, abs=0.03)
    assert (world.pose.x, world.pose.y) == close(0, 0, within=0.01)
    world.reset()
    world.drive(0.3, 0.3)  # a circle of one metre
    world.run(2 * math.pi / 0.3)
    assert (world.pose.x, world.pose.y) == close(0, 0, within=0.1)


def test_odometry_agrees_with_the_truth_where_no_noise_is():
    world = World(scene='empty')
    for linear, angular in ((0.4, 0.0), (0.2, 0.6), (0.0, -1.0), (-0.3, 0.2)):
        world.drive(linear, angular)
        world.run(1.5)
    pose, odometry = world.pose, world.odometry
    assert (odometry.x, odometry.y, odometry.yaw) == close(pose.x, pose.y, pose.yaw, within=0.01)


def test_odometry_drifts_with_the_root_of_the_way():
    def errors(seconds):
        found = []
        for seed in range(6):
            world = World(scene='empty', noise=Noise(odometry=0.02), seed=seed)
            world.drive(1.0, 0.0)
            world.run(seconds)
            found.append(world.odometry.x - world.pose.x)
        return np.std(found)

    # Two wheels, each with 0.02 m after a metre; their mean has 0.02 / sqrt(2).
    assert errors(1.0) == pytest.approx(0.02 / math.sqrt(2) * math.sqrt(0.5), rel=0.6)
    assert errors(3.0) > 1.3 * errors(1.0)


def test_the_scan_sees_the_walls_where_they_are():
    world = World(noise=EXACT)
    world.run(0.1)
    lidar, ranges = world.robot.lidar, world.scan()
    assert len(ranges) == 360 and ranges.dtype == np.float32
    ahead, left, behind, right = ranges[[180, 270, 0, 90]]
    # The east wall begins at x = 4, the west wall at -4, the hall's at y = ±0.95; the laser is 0.05 m before the axle.
    assert (ahead, behind, left, right) == close(3.95, 4.05, 0.95, 0.95, within=0.005)
    assert lidar.min_angle + 180 * lidar.increment == pytest.approx(0.0, abs=1e-4)


def test_ranges_that_the_laser_cannot_give_are_infinite():
    world = World(scene='empty', noise=EXACT)
    assert np.isposinf(world.scan()).all()
    near = scene.Scene(walls=(scene.Wall('near', (0.05, 0.11), (2.0, 0.2)),))  # 1 cm from the laser
    assert np.isneginf(World(scene=near, noise=EXACT).scan()[270])


def test_noise_of_the_laser_is_that_of_the_description_unless_another_is_given():
    exact = World(noise=EXACT).scan()
    for noise, deviation in ((Noise(), 0.01), (Noise(range=0.1), 0.1)):
        world = World(noise=noise, seed=3)
        assert np.std(world.scan() - exact) == pytest.approx(deviation, rel=0.2)
    with pytest.raises(ValueError, match='noise range is -1'):
        Noise(range=-1)


def test_the_same_seed_gives_the_same_run_and_another_seed_another_one():
    def run(seed):
        world = World(noise=Noise(odometry=0.02), seed=seed)
        world.drive(0.5, 0.4)
        world.run(2.0)
        return world.pose, world.odometry, world.scan().tolist()

    assert run(1) == run(1)
    assert run(1)[1:] != run(2)[1:]
    again = World(noise=Noise(odometry=0.02), seed=1)
    again.run(1.0)
    again.reset()
    again.drive(0.5, 0.4)
    again.run(2.0)
    assert (again.pose, again.odometry, again.scan().tolist()) == run(1)
    assert again.time == 3.0


def test_a_wall_holds_the_robot_and_its_wheels_slip():
    world = World(start=(3.0, 0.0, 0.0))
    world.drive(1.0, 0.0)
    world.run(2.0)
    assert world.touching == {'east'}
    world.run(2.0)
    assert world.pose.x == pytest.approx(3.84, abs=0.005)
    assert world.odometry.x > 1.2  # the wheels do not know of the wall


def test_without_commands_the_robot_stops():
    world = World(scene='empty', command_timeout=0.5)
    world.drive(0.5, 0.0)
    world.run(2.0)
    assert world.odometry.linear == pytest.approx(0.0, abs=0.001) and 0.1 < world.pose.x < 0.4
    world.drive(0.5, 0.0)
    world.keep_command()
    world.run(2.0)
    assert world.odometry.linear == pytest.approx(0.5, abs=0.01)


def test_a_robot_on_ice_does_not_get_away():
    slippery = URDF.replace('<mu1>1.0</mu1>', '<mu1>0.0</mu1>')
    assert slippery != URDF
    world = World(slippery, 'empty')
    world.drive(0.5, 0.0)
    world.run(2.0)
    assert abs(world.pose.x) < 0.02 < world.odometry.x


# What a bad description does


def test_without_collision_the_robot_falls_through_the_floor():
    world = World(mobile_robot_description.urdf('no_collision'), 'empty')
    world.run(1.0)
    assert world.pose.z == pytest.approx(-9.81 / 2, rel=0.02)
    with pytest.raises(UnstableError, match='has fallen 1000 m: is there a <collision>'):
        world.run(15.0)


def test_without_inertial_the_robot_shakes():
    world = World(mobile_robot_description.urdf('no_inertial'), 'empty')
    world.drive(0.3, 0.0)
    tilts = []
    for _ in range(100):
        world.step()
        tilts.append(max(abs(world.pose.roll), abs(world.pose.pitch)))
    assert max(tilts) > 0.3 and max(tilts[-50:]) - min(tilts[-50:]) > 0.05


def test_a_top_heavy_robot_tips_over_when_it_brakes():
    def tilt(fault):
        world, most = World(mobile_robot_description.urdf(fault), 'empty'), 0.0
        for speed in (0.5, 0.0):
            world.drive(speed, 0.0)
            for _ in range(150):
                world.step()
                most = max(most, abs(world.pose.pitch))
        return most

    assert tilt('top_heavy') > 0.5 and tilt('') < 0.05


def test_a_simulation_that_blows_up_says_so_and_begins_anew(capfd, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    world = World(scene='empty')
    world.data.qvel[:] = 1e12
    with pytest.raises(UnstableError, match='<inertial>'):
        world.run(1.0)
    world.reset()
    world.run(0.5)
    assert world.pose.z == pytest.approx(0.0, abs=0.001)
    assert not list(tmp_path.iterdir()) and 'WARNING' not in capfd.readouterr().err  # MuJoCo's own log


@pytest.mark.parametrize(
    ('old', 'new', 'message'),
    [
        ('</robot>', '', 'line 1[0-9]+.*no element|XML'),
        ('<left_joint>left_wheel_joint', '<left_joint>left_wheel', "'left_wheel' is no continuous joint"),
        ('<gazebo reference="laser">', '<gazebo reference="lazer">', 'lazer'),
        ('<samples>360', '<samples>many', '<samples>many</…> must be a number'),
        ('<max>8.0', '<max>0.01', 'a minimum is above its maximum'),
        ('<wheel_radius>0.08</wheel_radius>', '', 'has no <wheel_radius>'),
        ('ixx="0.038"', 'ixx="-1"', 'MuJoCo refuses this robot|inertia'),
    ],
)
def test_a_bad_description_is_one_line_that_says_where(old, new, message):
    assert old in URDF
    with pytest.raises(UrdfError, match=message) as caught:
        World(URDF.replace(old, new))
    assert '\n' not in str(caught.value)


def test_a_robot_without_drive_and_sensors_stands_there():
    world = World(
        '<robot name="stone"><link name="stone"><collision><geometry><sphere radius="0.1"/></geometry>'
        '</collision><inertial><mass value="1"/><inertia ixx="0.004" iyy="0.004" izz="0.004" ixy="0" ixz="0" '
        'iyz="0"/></inertial></link></robot>',
        'empty',
    )
    world.run(1.0)
    assert world.pose.z == pytest.approx(0.1, abs=0.002)
    for call, lack in (
        (lambda: world.drive(0.1, 0), 'cannot drive'),
        (world.scan, 'no laser'),
        (world.image, 'no camera'),
    ):
        with pytest.raises(ValueError, match=lack):
            call()
    with pytest.raises(ValueError, match='finite'):
        World(scene='empty').drive(math.nan, 0.0)


# Scenes


def test_from_the_hall_every_station_can_be_reached_and_nothing_is_touched():
    rooms = scene.load('rooms')
    assert set(rooms.stations) == {'dock', 'kitchen', 'office', 'lab', 'storage'} == set(rooms.colours)
    for x, y, _ in rooms.stations.values():
        for part in np.linspace(0.0, 1.0, 21):
            for place in ((x * part, 0.0), (x, y * part)):  # along the hall, then through the door
                distance = min(
                    max(abs(place[0] - wall.at[0]) - wall.size[0] / 2, abs(place[1] - wall.at[1]) - wall.size[1] / 2)
                    for wall in rooms.walls
                )
                assert distance > 0.35, f'{place} is too near to a wall'


def test_a_scene_of_ones_own(tmp_path):
    file = tmp_path / 'mine.yaml'
    file.write_text(yaml.safe_dump({'start': [1, 0, 0], 'walls': [{'name': 'one', 'at': [2, 0], 'size': [0.2, 2]}]}))
    world = World(scene=file, noise=EXACT)
    assert world.scene.name == 'mine' and world.scan()[180] == pytest.approx(0.85, abs=0.01)


@pytest.mark.parametrize(
    ('text', 'message'),
    [
        ('walls: [{name: a, at: [1], size: [1, 1]}]', 'not 2 numbers'),
        ('walls: [{name: a, at: [1, 1], size: [0, 1]}]', 'above zero'),
        ('walls: [{at: [1, 1], size: [1, 1]}]', "'name'"),
        ('start: [1, 2, .nan]', 'not 3 numbers'),
        ('walls: [', 'no YAML'),
    ],
)
def test_a_bad_scene_says_what_is_wrong(tmp_path, text, message):
    (tmp_path / 'bad.yaml').write_text(text)
    with pytest.raises(SceneError, match=message):
        scene.load(tmp_path / 'bad.yaml')
    with pytest.raises(SceneError, match='there are empty, rooms'):
        scene.load('room')
    with pytest.raises(SceneError, match='No such file'):
        scene.load(Path('nowhere.yaml'))


# The camera


def test_the_camera_sees_the_open_door_or_says_what_is_missing():
    world = World(start=(-2.0, -0.3, math.pi / 2))
    try:
        image = world.image()
    except NoPicturesError as error:
        assert 'libegl1' in str(error)
        pytest.skip('no EGL on this machine')
    assert image.shape == (120, 160, 3) and image.dtype == np.uint8
    red, _, blue = image.astype(int)[65:75, 70:90].reshape(-1, 3).mean(axis=0)
    sky = image[:40, 60:100].reshape(-1, 3).mean(axis=0)
    assert sky[2] > 200 and sky[2] > sky[0]  # blue
    assert (image[60:80].astype(int) @ [1, -1, 0]).max() > 60  # the kitchen's red disc
    world.close()


def test_a_program_that_does_not_close_its_world_ends_without_a_word():
    code = """
from mujoco_world.world import NoPicturesError, World
world = World()
try:
    world.image()
except NoPicturesError:
    pass
"""
    done = subprocess.run([sys.executable, '-c', code], capture_output=True, text=True, timeout=60)
    assert (done.returncode, done.stdout, done.stderr) == (0, '', '')


def test_without_opengl_all_but_the_camera_works(monkeypatch):
    def broken(*args):
        raise OSError('no libEGL')

    monkeypatch.setattr(mujoco_world.ctypes, 'CDLL', broken)
    assert mujoco_world._opengl() == 'disable'  # else the import of MuJoCo fails
    monkeypatch.setattr(pictures.mujoco, 'Renderer', broken)
    world = World()
    for _ in range(2):
        with pytest.raises(NoPicturesError, match='apt-get install libegl1'):
            world.image()
    world.run(CONTROL_PERIOD)
    world.close()
