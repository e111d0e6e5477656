"""The tests of exercise 6.7 look at a scout, the learner's robot, on the learner's side, and let it drive there."""

import json
import math
from pathlib import Path
from random import Random

import numpy as np

from helpers.checks.chapter_06.frame_comparisons import explain, same, words
from helpers.runner import expect

SCRIPT = Path(__file__).with_name('urdf_probe.py')
PARENTS = {
    'base_link': 'base_footprint',
    'left_wheel': 'base_link',
    'right_wheel': 'base_link',
    'caster': 'base_link',
    'laser': 'base_link',
}
SIDES = ('left', 'right')
WHEELS = tuple(f'{side}_wheel' for side in SIDES)
STATIONS = {'kitchen': (-2.0, 2.0), 'office': (2.0, 2.0), 'lab': (-2.0, -2.0), 'storage': (2.0, -2.0)}
MASSES = {'base_link': (2.0, 8.0), 'left_wheel': (0.2, 1.0), 'right_wheel': (0.2, 1.0)}  # kg
MOST = 10.0  # kg, of the whole robot
NEAR = 1e-3  # m
SIZES = {  # m: radius, separation, mast
    'small': ((0.04, 0.045), (0.2, 0.23), (0.48, 0.5)),
    'large': ((0.09, 0.1), (0.38, 0.4), (0.255, 0.275)),
}
CLEAR = 0.01  # m, between the floor and what must not touch it
# Whoever reads the URDF or simulates it refuses it with words like these, and then this rule is broken.
REFUSED = {'drive': 'drive', '<plugin>': 'drive', 'lidar': 'scan', 'unstable': 'stands', 'has fallen': 'stands'}


def drawn(random: Random, size: str = '', low: bool = False) -> tuple[float, float, float]:
    """Radius of the wheels, separation, height of the mast, in metres: far from those of other robots.

    :param size: of SIZES; otherwise any.
    :param low: whether the mast is one of the lowest.
    """
    if size:
        radius, separation, mast = (round(random.uniform(*limits), 3) for limits in SIZES[size])
        return radius, separation, mast
    radius = random.choice([random.uniform(0.04, 0.045), random.uniform(0.055, 0.065), random.uniform(0.09, 0.1)])
    separation = random.choice([random.uniform(0.2, 0.31), random.uniform(0.38, 0.4)])
    mast = round(random.uniform(0.25, 0.252), 4) if low else round(random.uniform(0.25, 0.5), 2)
    return round(radius, 3), round(separation, 3), mast


class Scout:
    """The learner's robot with these sizes (metres), and what `urdf_probe.py` has found in one of its tasks."""

    def __init__(self, learner, task: str, size: str = '', low: bool = False, **given):
        """:param low: whether its mast is one of the lowest."""
        self.radius, self.separation, self.mast = sizes = drawn(learner.random, size, low)
        self.name = f'scout({", ".join(map(str, sizes))})'
        # Another one comes first, in the same program: what a call leaves must not be seen in the next one.
        others = drawn(learner.random, 'small' if self.radius > 0.07 else 'large')
        before = learner.call('scout', *others)
        text = learner.call('scout', *sizes)
        expect(
            text != before or not text,
            f'scout({", ".join(map(str, others))}) and then {self.name} gave the same text. Each call uses the numbers '
            'that it gets, and keeps nothing of an earlier call.',
            'places',
        )
        expect(isinstance(text, str), f'{self.name} gave {text}, expected the text of a URDF.', 'urdf')
        expect(len(text) < 50_000, f'{self.name} gave {len(text)} characters.', 'urdf')
        workspace = learner.workspace({'scout.urdf': text, 'probe.py': SCRIPT.read_text()})
        done = workspace.run('python3', 'probe.py', 'scout.urdf', task, json.dumps(given))
        expect(done.status == 0 and done.lines, f'{self.name} cannot be used: {done.last_line}', 'urdf')
        try:
            self.found = json.loads(done.lines[-1])
        except ValueError:
            expect(False, f'{self.name} cannot be used: {done.last_line}', 'urdf')
        refused = self.found.get('refused', '')
        rule = next((rule for part, rule in REFUSED.items() if part in refused), 'urdf')
        expect(not refused, f'{self.name} cannot be used: {refused}', rule)

    # What robot_state_publisher says

    def check_tree(self) -> None:
        """The rule `tree`."""
        links = self.found['links']
        for name in ('base_footprint', *PARENTS):
            expect(name in links, f'{self.name} has no link `{name}`; it has {", ".join(links)}.', 'tree')
        root = self.found['root']
        expect(root == 'base_footprint', f'{self.name}: the root is `{root}`, expected `base_footprint`.', 'tree')
        self._check_parents('robot_state_publisher says that ')

    def _check_parents(self, who: str = '') -> None:
        for child, parent in PARENTS.items():
            heard = self.found['frames'].get(child, ['nothing'])[0]
            expect(
                heard == parent, f'{self.name}: {who}the parent of `{child}` is `{heard}`, expected `{parent}`.', 'tree'
            )

    def check_joints(self) -> None:
        """The rule `joints`."""
        by_child = {child: (name, kind, axis) for name, (kind, _, child, axis, _) in self.found['joints'].items()}
        for side, wheel in zip(SIDES, WHEELS, strict=True):
            name, kind, axis = by_child[wheel]
            expect(
                name == f'{side}_wheel_joint',
                f'The joint of `{wheel}` is called {name}, not {side}_wheel_joint.',
                'joints',
            )
            explain(
                kind == 'continuous',
                f'The joint of `{wheel}` is {kind}, expected continuous.',
                (kind == 'revolute', 'A revolute joint turns between two limits only.'),
                rule='joints',
            )
            explain(
                same(axis, (0, 1, 0)),
                f'The wheel `{wheel}` turns about {words(axis)}, expected {words((0, 1, 0))}: the axle, to the left.',
                (same(axis, (1, 0, 0)), 'Without an <axis>, or with x, it turns about the direction of travel.'),
                (same(axis, (0, -1, 0)), 'A positive turn would drive it backwards.'),
                rule='joints',
            )
        for child, (name, kind, _) in by_child.items():
            expect(
                child in WHEELS or kind == 'fixed',
                f'The joint {name} of `{child}` is {kind}, expected fixed: only the wheels move.',
                'joints',
            )

    def check_places(self) -> None:
        """The rule `places`, for what `frames` has of each child: its parent, place and quaternion."""
        half = self.separation / 2
        wanted = {
            'base_link': (0, 0, self.radius),
            'left_wheel': (0, half, 0),
            'right_wheel': (0, -half, 0),
            'laser': (0, 0, self.mast - self.radius),
            'caster': None,  # its place has limits, below
        }
        for child, place in wanted.items():
            parent, there, turn = self.found['frames'][child]
            place = there if place is None else place
            explain(
                same(there, place, NEAR),
                f'{self.name}: `{child}` is at {_fine(there)} in `{parent}`, expected {_fine(place)}.',
                (same(there, (0, 0, self.mast), NEAR), 'The mast is measured from the floor, not from the axle.'),
                (same(there, 2 * np.array(place), NEAR), 'Each wheel is half of the separation from the middle.'),
                (same(there, -np.array(place), NEAR), 'y points to the left.'),
                rule='places',
            )
            expect(
                abs(abs(turn[3]) - 1) < 1e-4,
                f'{self.name}: the frame `{child}` is turned, expected not at all. To lay a cylinder on its side, '
                'turn the shape, by the <origin> of <visual> and <collision>.',
                'places',
            )
        x, y, _ = self.found['frames']['caster'][1]
        expect(
            -0.3 - NEAR <= x <= -0.05 + NEAR and abs(y) < NEAR,
            f'{self.name}: `caster` is at x = {x:g} m and y = {y:g} m in `base_link`, expected x from -0.3 to -0.05 '
            'm, and y = 0.',
            'places',
        )

    # What touches and what is heavy

    def check_links(self) -> None:
        """The rule `tree`, as far as the other rules need it."""
        links = self.found['links']
        for link in PARENTS:
            expect(link in links, f'{self.name} has no link `{link}`; it has {", ".join(links)}.', 'tree')
        self._check_parents()

    def _only_shape(self, link: str, kind: str, rule: str) -> dict:
        shapes = self.found['links'][link]['shapes']
        expect(len(shapes) == 1, f'{self.name}: `{link}` has {len(shapes)} <collision>, expected one.', rule)
        expect(
            kind in ('', shapes[0]['kind']),
            f'{self.name}: the <collision> of `{link}` is a {shapes[0]["kind"]}, expected a {kind}.',
            rule,
        )
        return shapes[0]

    def check_wheels(self) -> None:
        """The rule `wheels`."""
        for wheel in WHEELS:
            shape = self._only_shape(wheel, 'cylinder', 'wheels')
            radius, length = shape['sizes']
            expect(
                abs(radius - self.radius) < NEAR / 2,
                f'{self.name}: the <collision> of `{wheel}` has the radius {radius:g} m, expected {self.radius:g} m.',
                'wheels',
            )
            expect(
                0 < length <= 0.02 + 1e-6,
                f'{self.name}: the <collision> of `{wheel}` is {length:g} m wide, expected at most 0.02 m.',
                'wheels',
            )
            matrix = np.array(shape['place'])
            along = matrix[:3, 2]
            expect(
                abs(abs(along[1]) - 1) < 1e-3,
                f'{self.name}: the <collision> of `{wheel}` lies along {words(along)}, expected along y: a cylinder '
                f'stands upright until its <origin> has an rpy{_in_degrees(shape["rpy"])}.',
                'wheels',
            )
            expect(
                same(matrix[:3, 3], (0, 0, 0), NEAR),
                f'{self.name}: the middle of the <collision> of `{wheel}` is at {_fine(matrix[:3, 3])}, expected at '
                'its frame.',
                'wheels',
            )
            friction = self.found['links'][wheel]['friction']
            expect(
                friction >= 0.5,
                f'{self.name}: `{wheel}` has the friction {friction:g}, expected at least 0.5: a wheel that does not '
                'grip turns, and the robot stays where it is.',
                'wheels',
            )
        left, right = (self.found['links'][wheel]['friction'] for wheel in WHEELS)
        expect(
            math.isclose(left, right),
            f'{self.name}: `left_wheel` has the friction {left:g} and `right_wheel` {right:g}, expected the same: the '
            'one that grips less slips, and the robot leaves its way.',
            'wheels',
        )

    def check_caster(self) -> None:
        """The rule `caster`."""
        self._only_shape('caster', 'sphere', 'caster')
        friction = self.found['links']['caster']['friction']
        expect(
            friction == 0,
            f'{self.name}: `caster` has the friction {friction:g}, expected 0: it cannot turn, so it has to slide.',
            'caster',
        )

    def check_floor(self) -> None:
        """The rule `floor`."""
        for link, found in self.found['links'].items():
            for shape in found['shapes']:
                bottom = shape['bottom']
                if link in WHEELS or link == 'caster':
                    expect(
                        abs(bottom) < NEAR,
                        f'{self.name}: the bottom of `{link}` is {bottom:.3f} m above the floor, expected 0.',
                        'floor',
                    )
                else:
                    expect(
                        bottom >= CLEAR - 1e-6,
                        f'{self.name}: the bottom of `{link}` is {bottom:.3f} m above the floor, expected at least '
                        f'{CLEAR} m.',
                        'floor',
                    )

    def check_mass(self) -> None:
        """The rule `mass`."""
        links = self.found['links']
        for link, (least, most) in MASSES.items():
            mass = links[link].get('mass')
            expect(mass is not None, f'{self.name}: `{link}` has no <inertial>, so no mass.', 'mass')
            expect(
                least - 1e-6 <= mass <= most + 1e-6,
                f'{self.name}: `{link}` has the mass {mass:g} kg, expected {least:g} to {most:g} kg.',
                'mass',
            )
        masses = [found['mass'] for found in links.values() if 'mass' in found]
        expect(
            min(masses) >= 0 and sum(masses) <= MOST + 1e-6,
            f'{self.name}: the links have the masses {", ".join(f"{mass:g}" for mass in masses)} kg, expected at most '
            f'{MOST:g} kg in all.',
            'mass',
        )

    def check_inertia(self) -> None:
        """The rule `inertia`."""
        for link in MASSES:
            found, shape = self.found['links'][link], self._only_shape(link, '', 'inertia')
            place = np.array(shape['place'])
            centre, inertia = np.array(found['centre']), np.array(found['inertia'])
            expect(
                same(centre, place[:3, 3], NEAR),
                f'{self.name}: the mass of `{link}` is about {_fine(centre)}, and the middle of its <collision> is at '
                f'{_fine(place[:3, 3])}.',
                'inertia',
            )
            moments = np.linalg.eigvalsh(inertia)
            expect(
                moments[0] > 0,
                f'{self.name}: an inertia of `{link}` is {moments[0]:.3g} kg m², and must be more than 0.',
                'inertia',
            )
            expect(
                moments[0] + moments[1] >= moments[2] * 0.999,
                f'{self.name}: no body has the inertia of `{link}`: two of the moments {_numbers(moments)} are '
                'together less than the third one.',
                'inertia',
            )
            own = _solid(shape['kind'], shape['sizes'], found['mass'])
            expect(own is not None, f'{self.name}: the <collision> of `{link}` is a {shape["kind"]}.', 'inertia')
            wanted = place[:3, :3] @ np.diag(own) @ place[:3, :3].T
            close = np.allclose(inertia, wanted, rtol=0, atol=0.2 * own.min())
            told = (
                f'{self.name}: `{link}` has the inertia {_numbers(np.diag(inertia))} kg m² about x, y and z; a solid '
                f'{shape["kind"]} like its <collision>, of {found["mass"]:g} kg, has {_numbers(np.diag(wanted))}.'
            )
            explain(
                close,
                told,
                (
                    np.allclose(inertia, np.diag(own), rtol=0.2, atol=0),
                    'That is a cylinder about its own z axis. Here it lies on its side, and the axle is y.',
                ),
                (np.allclose(inertia, np.eye(3)), '1 kg m² is the inertia of a large table.'),
                (np.trace(inertia) > 100 * np.trace(wanted), 'Is it in kg m², and not in g m²?'),
                rule='inertia',
            )

    # How it stands, sees and drives

    def check_stands(self) -> None:
        """The rule `stands`."""
        height, roll, pitch = self.found['stands']
        explain(
            abs(height) < 0.005 and abs(roll) < 1 and abs(pitch) < 1,
            f'{self.name}, after a second: it is {height:.3f} m high, with a roll of {roll:.1f}° and a pitch of '
            f'{pitch:.1f}°, expected 0.',
            (height < -0.1, 'It falls through the floor: which <collision> should touch it?'),
            (
                pitch > 1,
                'It tips over to the front: its mass must be behind the axle, between the wheels and the caster.',
            ),
            (pitch < -1, 'It tips over to the back: its mass must be in front of the caster.'),
            rule='stands',
        )

    def check_scan(self) -> None:
        """The rule `scan`."""
        lidar = self.found['lidar']
        expect(lidar is not None, f'{self.name} has no <sensor> of type gpu_lidar.', 'scan')
        expect(
            lidar['type'] == 'gpu_lidar',
            f'{self.name}: the laser is a sensor of the type `{lidar["type"]}`, expected `gpu_lidar`.',
            'scan',
        )
        expect(lidar['link'] == 'laser', f'{self.name}: the laser is in `{lidar["link"]}`, not in `laser`.', 'scan')
        expect(
            180 <= lidar['samples'] <= 720,
            f'{self.name}: the laser has {lidar["samples"]} rays, expected 180 to 720.',
            'scan',
        )
        least, most = lidar['angles']
        expect(
            most - least > 1.9 * math.pi,
            f'{self.name}: the laser looks from {least:.2f} to {most:.2f} rad, expected all around.',
            'scan',
        )
        expect(
            lidar['range'] >= 6,
            f'{self.name}: the laser looks {lidar["range"]:g} m far, expected at least 6 m.',
            'scan',
        )
        expect(
            lidar['least'] <= 0.5 or lidar['nearest'] > 0.5,
            f'{self.name}: the laser sees nothing nearer than {lidar["least"]:g} m, its <min>, and a wall is nearer. '
            'Begin much nearer to the laser.',
            'scan',
        )
        expect(
            lidar['nearest'] > 0.5,
            f'{self.name}: the laser sees something {max(0.0, lidar["nearest"]):.2f} m away. No wall is so near: '
            f'it is the robot.{" It must be lower than a mast of 0.25 m, too." * (self.mast < 0.26)}',
            'scan',
        )
        expect(lidar['hits'] > 0.9 * lidar['samples'], f'{self.name}: the laser does not see the walls.', 'scan')

    def check_drive(self) -> None:
        """The rule `drive`."""
        expect(
            self.found['drive'],
            f'{self.name} has no <plugin> with the name gz::sim::systems::DiffDrive: nothing drives the wheels.',
            'drive',
        )
        expect(
            'diff-drive' in self.found['library'],
            f'{self.name}: the filename of the <plugin> is {self.found["library"] or "not given"}. Gazebo would not '
            'find the differential drive in it: it is in gz-sim-diff-drive-system.',
            'drive',
        )
        (x, _, _), (_, _, yaw) = self.found['motions']
        explain(
            x > 0.02,
            f'{self.name}: 0.3 m/s forward was commanded. After two seconds it is at x = {x:.2f} m.',
            (x < -0.1, 'It drives backwards.'),
            (True, 'It hardly moves. Do both wheels touch the floor, and do they turn about the axle?'),
            rule='drive',
        )
        explain(
            yaw > 4,
            f'{self.name}: a turn to the left was commanded, 1 rad/s. After two seconds it has turned by {yaw:.0f}°.',
            (yaw < -4, 'Left and right are exchanged in the <plugin>.'),
            rule='drive',
        )

    def check_odometry(self) -> None:
        """The rule `odometry`."""
        found = self.found['odometry']
        (x, y, yaw), (x_told, y_told, yaw_told) = found['truth'], found['believed']
        off = math.dist((x, y), (x_told, y_told))
        expect(
            off < 0.12 and abs(found['turned']) < 12,
            f'{self.name}: after a drive of 12 s it is at ({x:.2f}, {y:.2f}) m and looks to {_degrees(yaw)}°; its '
            f'odometry says ({x_told:.2f}, {y_told:.2f}) m and {_degrees(yaw_told)}°. Do wheel_radius and '
            'wheel_separation of the <plugin> fit the wheels?',
            'odometry',
        )

    def check_arrival(self, station: str) -> None:
        """The rule `arrives`."""
        way = self.found['way']
        x, y, _ = way['pose']
        wanted = STATIONS[station]
        explain(
            way['there'] and math.dist((x, y), wanted) < 0.15,
            f'{self.name} was driven to the {station}, at {words(wanted)}. After {way["took"]:.0f} s it is at '
            f'{words((x, y))}.',
            (not way['there'], 'It is too slow: are the <limit>s of the joints too small, or those of the <plugin>?'),
            rule='arrives',
        )
        expect(
            not way['touched'],
            f'{self.name} was driven to the {station} and has touched {", ".join(way["touched"])}: is it too wide?',
            'arrives',
        )


def judge_frames(learner, size: str = '') -> None:
    """What robot_state_publisher makes of the description: the tree, its joints and their places."""
    scout = Scout(learner, 'frames', size)
    scout.check_tree()
    scout.check_joints()
    scout.check_places()


def judge_bodies(learner) -> None:
    """The links with their shapes, masses and moments, of a small and of a large scout: a copied number fits one."""
    for size in SIZES:
        scout = Scout(learner, 'bodies', size)
        scout.check_links()
        scout.check_places()
        scout.check_wheels()
        scout.check_caster()
        scout.check_floor()
        scout.check_mass()
        scout.check_inertia()


def judge_ride(learner) -> None:
    """A drive in the simulated world, to a station that is drawn."""
    station, given = journey(learner.random)
    scout = Scout(learner, 'ride', **given)
    scout.check_stands()
    scout.check_scan()
    Scout(learner, 'scan', low=True).check_scan()  # its body may be too high for a low mast
    scout.check_drive()
    scout.check_odometry()
    scout.check_arrival(station)


def journey(random: Random) -> tuple[str, dict]:
    """A station, and what `urdf_probe.py` is to do: a course of commands, and places on the way to the station."""
    station = random.choice(sorted(STATIONS))
    x, y = STATIONS[station]
    left = random.choice([-1, 1])
    course = [
        [round(random.uniform(0.3, 0.5), 2), 0.0, 3.0],
        [0.3, left * round(random.uniform(0.6, 0.9), 2), 4.0],
        [0.0, left * round(random.uniform(0.9, 1.3), 2), 3.0],
        [-0.3, left * 0.4, 2.0],
    ]
    return station, {'course': course, 'places': [[x, 0.0], [x, y]], 'seconds': 30.0}


def _solid(kind: str, sizes, mass: float) -> np.ndarray | None:
    """The moments of a solid body about x, y and z of its shape, kg m²; None for a shape without a formula."""
    if kind == 'box':
        a, b, c = sizes
        return mass / 12 * np.array([b * b + c * c, a * a + c * c, a * a + b * b])
    if kind == 'cylinder':
        radius, length = sizes
        across = mass / 12 * (3 * radius**2 + length**2)
        return np.array([across, across, mass * radius**2 / 2])
    if kind == 'sphere':
        return np.full(3, 0.4 * mass * sizes[0] ** 2)
    return None


def _fine(place) -> str:
    """A place in metres, to the millimetre."""
    return '(' + ', '.join(f'{round(float(value), 3) + 0.0:g}' for value in place) + ')'


def _in_degrees(rpy: list[float]) -> str:
    """For a message, if angles are so large that they must be degrees."""
    return f', in radians; here it has {", ".join(f"{angle:g}" for angle in rpy)}' if max(map(abs, rpy)) > 7 else ''


def _numbers(values) -> str:
    return ', '.join(f'{value:.3g}' for value in values)


def _degrees(yaw: float) -> int:
    return round(math.degrees(math.remainder(math.radians(yaw), math.tau)))
