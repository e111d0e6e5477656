"""Exercise 7.5's robots: drawn with their faults, and dropped to the floor in MuJoCo."""

import copy
import json
from collections import Counter
from contextlib import suppress
from xml.etree import ElementTree

from helpers.checks.chapter_07.findings import compare
from helpers.runner import about, expect

CAUSES = ('collision', 'inertial', 'mass', 'inertia')
FRAMES = ('empty', 'collision', 'inertial')
_FRAME_NAMES = ('laser', 'imu_link', 'tool0', 'base_footprint')  # of links that nobody sees
WHY = {
    'collision': 'A link with <visual> and without <collision> is seen, and touches nothing. A link without <visual> '
    'is only a frame.',
    'inertial': 'A link with <visual> and without <inertial> has no mass. A link without <visual> needs none.',
    'mass': 'A mass must be more than 0.',
    'inertia': 'Each of the three moments is more than 0, and none is more than the sum of the two others.',
}
DEEPEST = 20
_MOMENTS, _PRODUCTS = ('ixx', 'iyy', 'izz'), ('ixy', 'ixz', 'iyz')
_LINKS = ('left_wheel', 'right_wheel', 'Caster', 'mast-2', 'Gripper', 'front bumper')
# Runs on the learner's side: drops the robot from one metre, and tells where its parts are after two seconds.
_DROP = """\
import json

import mujoco

spec = mujoco.MjSpec.from_string(open('robot.urdf').read())
spec.bodies[1].add_freejoint()
spec.bodies[1].pos = [0, 0, 1]
spec.worldbody.add_geom(type=mujoco.mjtGeom.mjGEOM_PLANE, size=[5, 5, 0.1])
spec.option.timestep = 0.002
try:
    model = spec.compile()
except ValueError as error:
    print(json.dumps({'error': str(error).splitlines()[0]}))
else:
    data = mujoco.MjData(model)
    mujoco.mj_step(model, data, 1000)
    print(json.dumps({model.body(i).name: float(data.xpos[i][2]) for i in range(1, model.nbody)}))
"""


class FaultyRobot:
    """A drawn robot: its `urdf`, and the `expected` findings. `causes`: pairs of link and cause, or causes."""

    def __init__(
        self,
        random,
        *causes,
        frame='',
        form: int | None = None,
        flat: bool = False,
        parts: int = 0,
        small: bool = False,
        bare: bool = False,
        double: bool = False,
    ):
        """`form`: which of the wrong values it is, by its number.

        :param frame: what is in a link without <visual>, if there is one: ``empty``, ``collision`` or ``inertial``.
        :param flat: the links are as thin as paper, so that one moment is the sum of the two others, light or heavy.
        :param parts: so many more links; too many for a simulation.
        :param small: all links but the base have millimetres and grams.
        :param bare: no <visual> has an <origin>.
        :param double: each link has two <visual>, as those of the course's robot; too many for a repair.
        """
        self._random, self._form, self._flat, self._small, self._bare = random, form, flat, small, bare
        self._double = double
        names = [*random.sample(_LINKS, 3), *(f'part_{number}' for number in range(parts))]
        self._frame = random.choice(_FRAME_NAMES) if frame else ''
        faults: dict[str, list[str]] = {}
        for cause in causes:
            faults.setdefault(random.choice(names) if isinstance(cause, str) else cause[0], []).append(
                cause if isinstance(cause, str) else cause[1]
            )
        self.expected: list[tuple] = []
        self.faulty = faults
        root = ElementTree.Element('robot', name=f'robot{random.randint(10, 99)}')
        ElementTree.SubElement(ElementTree.SubElement(root, 'material', name='paint'), 'color', rgba='0.2 0.4 0.6 1')
        self._link(root, 'base_link', faults.get('base_link', ()), box=True)
        if frame:
            self._add_frame(root, frame)
        for number, name in enumerate([self._frame, *names]):
            if number:
                self._link(root, name, faults.get(name, ()))
            if name:
                _add_joint(root, name, number)
        ElementTree.indent(root)
        self.urdf = '<?xml version="1.0"?>\n' + ElementTree.tostring(root, encoding='unicode')

    def _add_frame(self, root, content: str) -> None:
        """A link that nobody sees; for `content` see `frame` of `__init__`."""
        link = ElementTree.SubElement(root, 'link', name=self._frame)
        if content == 'collision':
            geometry = ElementTree.SubElement(ElementTree.SubElement(link, content), 'geometry')
            ElementTree.SubElement(geometry, 'sphere', radius='0.05')
        elif content == 'inertial':
            inertial = ElementTree.SubElement(link, content)
            ElementTree.SubElement(inertial, 'mass', value='0')
            ElementTree.SubElement(inertial, 'inertia', dict.fromkeys((*_MOMENTS, *_PRODUCTS), '0'))

    def _link(self, root, name: str, faults, box: bool = False) -> None:
        """A link that is seen, with these faults; `box`: it is the base, which is always the same box."""
        random = self._random
        link = ElementTree.SubElement(root, 'link', name=name)
        small = self._small and not box
        shape, mass = (('box', {'size': '0.3 0.4 0.1'}), random.uniform(0.3, 3.0)) if box else _body(random, small)
        turned = random.choice(['0 0.15 0', '0.1 0 -0.2', *([] if 'collision' in faults else ['0 0 0'])])
        origin = {'xyz': f'0 0 {random.uniform(0.005, 0.02):.4f}', 'rpy': turned}
        # A body may be made of several; what is wrong beside them does not concern them.
        touching = 0 if 'collision' in faults else 2 if {'mass', 'inertial'} & set(faults) else 1
        for part in ['visual'] * (1 + self._double) + ['collision'] * touching:
            there = ElementTree.SubElement(link, part)
            if part == 'visual' and 'collision' in faults:  # its parts may stand in any order
                ElementTree.SubElement(there, 'material', name='paint')
            # Without an origin, it is where the link is.
            if not self._bare if part == 'visual' else random.random() < 0.5:
                ElementTree.SubElement(there, 'origin', origin)
            geometry = ElementTree.SubElement(there, 'geometry')
            if part == 'visual':
                ElementTree.SubElement(geometry, *shape)
                if 'collision' not in faults:
                    ElementTree.SubElement(there, 'material', name='paint')
            else:  # another body than what is seen, as in many robots
                ElementTree.SubElement(geometry, 'sphere', radius=f'{random.uniform(0.2, 0.3):.3f}')
        if 'inertial' not in faults:
            inertial = ElementTree.SubElement(link, 'inertial')
            ElementTree.SubElement(inertial, 'origin', origin)
            self._add_mass(inertial, name, mass, faults, small)
            self._add_moments(inertial, name, solid(*shape, mass), faults, small)
        self.expected += [('falls', name, cause, '') for cause in ('collision', 'inertial') if cause in faults]
        parts = list(link)
        if faults:  # nothing says that the visual comes first
            random.shuffle(parts)
            parts.sort(key=lambda part: part.tag == 'visual')
        link[:] = parts

    def _add_mass(self, inertial, name: str, mass: float, faults, small: bool) -> None:
        text = f'{mass:.4f}' if small else f'{mass:.2f}'
        if 'mass' in faults:
            text = self._one_of(['0', self._random.choice(['0.00', '0.000']), f'-{text}'])
            self.expected.append(('falls', name, 'mass', text))
        elif self._flat:
            text = self._random.choice(['0.004', '0.0003', '1e-6', '1250', '7e4'])
        ElementTree.SubElement(inertial, 'mass', value=text)

    def _add_moments(self, inertial, name: str, right, faults, small: bool) -> None:
        """`right`: the moments of the solid body."""
        random, digits = self._random, '.6g' if small else '.6f'
        exact = random.choice([['0.00002', '0.00002', '0.00004'], ['2e-9', '4e-9', '2e-9'], ['2e5', '2e5', '4e5']])
        moments = exact if self._flat else [f'{one:{digits}}' for one in right]
        if 'inertia' in faults:
            place = random.randrange(3) if self._form is None else self._form // 3 % 3
            # Other ones than those of the solid body, of which one is wrong, and a sum that is wrong by a little.
            moments = [f'{1.3 * one:{digits}}' for one in right]
            others = [float(one) for number, one in enumerate(moments) if number != place]
            # By how much a small one is wrong is little as a number, and much as a part.
            more = f'{1.5 * sum(others):.6g}' if small else f'{1.002 * sum(others):.7f}'
            wrong = self._one_of(['0', f'-{min(others):.3g}', more])
            moments = moments[:1] * 3 if wrong == '0' else moments  # then 0 is the only thing that is wrong
            moments[place] = wrong
            self.expected.append(('falls', name, 'inertia', ' '.join(moments)))
        values = dict(zip(_MOMENTS, moments, strict=True))
        ElementTree.SubElement(inertial, 'inertia', values, ixy='1e-9', ixz='-1e-9', iyz='0')

    def _one_of(self, values: list[str]) -> str:
        return self._random.choice(values) if self._form is None else values[self._form % len(values)]

    def diagnose(self, learner, rule: str = '') -> None:
        """Ask the learner's diagnose_model, and fail with words if it does not find what is expected."""
        names = [finding[1] for finding in self.expected]
        links = [
            link
            for link in ElementTree.fromstring(self.urdf.partition('\n')[2]).findall('link')
            if link.get('name') in names
        ]
        given = '\n'.join(ElementTree.tostring(link, encoding='unicode').strip() for link in links[:2])
        compare(learner.call('diagnose_model', self.urdf), self.expected, WHY, rule, given, self._of_a_frame)

    def _of_a_frame(self, finding) -> tuple[str, str]:
        """For `compare`: why a finding about a frame is none, and the rule that says so."""
        frame = finding[1] == self._frame
        return ('A link without <visual> is only a frame: nothing in it is judged.', 'frames') if frame else ('', '')

    def check(self, repaired) -> None:
        """Fail with words if the repaired text is no robot, or a link is not as it should be."""
        expect(
            isinstance(repaired, str),
            f'repair_model returned {str(repaired)[:60]}, expected a string. ElementTree.tostring gives one with '
            "encoding='unicode', and bytes without.",
            'kept',
        )
        try:
            robot = ElementTree.fromstring(repaired)
        except (ElementTree.ParseError, ValueError) as error:  # also a text with half of a surrogate pair
            expect(False, f'The repaired text is not XML: {error}.', 'kept')
        # Looking at it recurses: what is deeper than a robot is none.
        expect(
            _depth(robot) <= DEEPEST, f'The repaired text has elements in elements, more than {DEEPEST} deep.', 'kept'
        )
        old = ElementTree.fromstring(self.urdf.partition('\n')[2])
        after = {link.get('name'): link for link in robot.findall('link')}
        for before in old.findall('link'):
            name = before.get('name')
            expect(name in after, f'The link {name} is gone.', 'kept')
            if name not in self.faulty:
                expect(
                    _canonical(before) == _canonical(after[name]), f'The link {name} was right, and is changed.', 'kept'
                )
            else:
                self._check_link(name, before, after[name])
                _check_rest(name, self._rest(name, before), self._rest(name, after[name]))
        here, there = (Counter(link.get('name') for link in one.findall('link')) for one in (old, robot))
        more = [*(there - here)]
        expect(not more, f'The repaired robot has a link {more and more[0]} too many.', 'kept')
        _check_rest('', _others(old), _others(robot))

    def _rest(self, name: str, link) -> list[str]:
        """What a link has besides the things that were wrong in it."""
        link, faults = copy.deepcopy(link), self.faulty[name]
        for cause in {'collision', 'inertial'} & set(faults):
            for part in link.findall(cause):
                link.remove(part)
        for key in ('value', *_MOMENTS):  # these are judged by themselves
            for part in link.findall('inertial/*'):
                part.attrib.pop(key, None)
        for part in link.findall('inertial/inertia') if 'inertia' in faults else ():
            part.attrib.clear()  # a solid body has no other moments: 0 is right for them, too
        return sorted(map(_canonical, [part for part in link if part.tag != 'inertial'] + link.findall('inertial/*')))

    def _check_link(self, name: str, before, link) -> None:
        visual, collisions = before.find('visual'), link.findall('collision')
        touches = 'collision' not in self.faulty[name]
        count = len(before.findall('collision')) if touches else 1
        expect(
            len(collisions) == count,
            f'The link {name} has {len(collisions)} <collision> after your repair, expected {count}.',
            'kept' if touches else 'shape',
        )
        if not touches:
            self._check_collision(name, visual, collisions[0])
        mass, moments = link.find('inertial/mass'), link.find('inertial/inertia')
        expect(mass is not None and moments is not None, f'The link {name} has no <mass> or <inertia>.', 'weight')
        faults = self.faulty[name]
        right = 1.0 if {'mass', 'inertial'} & set(faults) else float(before.find('inertial/mass').get('value'))
        expect(
            _close(mass.get('value'), right),
            f'The mass of {name} is {mass.get("value")}, expected {right:g}.',
            'weight' if {'mass', 'inertial'} & set(faults) else 'kept',
        )
        values = [moments.get(key, '') for key in _MOMENTS]
        old = [one.get(key) for one in before.findall('inertial/inertia') for key in _MOMENTS]
        shape, new = visual.find('geometry')[0], bool({'inertia', 'inertial'} & set(faults))
        wanted = list(solid(shape.tag, shape.attrib, right) if new else map(float, old))
        # Where all is small, a new one may have two digits: a number of decimals is no measure for it.
        digits = {'part': 0.05 if new else 1e-4, 'most': 0.0} if self._small else {}
        expect(
            all(_close(value, one, **digits) for value, one in zip(values, wanted, strict=True)),
            f'The moments of {name} are {" ".join(values)}, expected {" ".join(f"{value:.5g}" for value in wanted)}.',
            'weight' if new else 'kept',
        )
        for key in _PRODUCTS if {'inertia', 'inertial'} & set(faults) else ():
            expect(
                _close(moments.get(key), 0.0),
                f'After your repair, {key} of {name} is {moments.get(key)}. An <inertia> has six values; these three, '
                'ixy, ixz and iyz, are 0 for such a body.',
                'weight',
            )

    @staticmethod
    def _check_collision(name: str, visual, collision) -> None:
        for part in ('origin', 'geometry'):
            there, seen = collision.find(part), visual.find(part)
            if seen is None:
                numbers = ElementTree.fromstring(_canonical(there)).attrib.values() if there is not None else ()
                fits = {one for value in numbers for one in value.split()} <= {'0', '-0'}
                expect(fits, f'The <visual> of {name} has no <origin>, so its <collision> has none.', 'shape')
                continue
            expect(
                there is not None and _canonical(there) == _canonical(seen),
                f'The <{part}> of the <collision> of {name} is not that of its <visual>.',
                'shape',
            )

    def drop(self, learner, repaired) -> None:
        """Fail with words if a simulation refuses the repaired robot, or it falls through the floor."""
        self.check(repaired)
        workspace = learner.workspace({'robot.urdf': repaired, 'drop.py': _DROP})
        done = workspace.run('python3', 'drop.py')
        seen = json.loads(done.last_line) if done.status == 0 else {'error': done.last_line}
        expect('error' not in seen, f'The simulation refuses the robot: {seen.get("error")}', 'weight')
        lowest = min(seen, key=seen.get)
        expect(
            seen[lowest] > -0.1,
            f'Two seconds after it was dropped, {lowest} is at {seen[lowest]:.1f} m: it fell through the floor.',
            'shape',
        )


def _add_joint(root, name: str, number: int) -> None:
    """The joint between the base and a link, which is the one with this number."""
    kind = 'fixed' if number % 2 == 0 else 'continuous'
    joint = ElementTree.SubElement(root, 'joint', name=f'{name}_joint', type=kind)
    ElementTree.SubElement(joint, 'parent', link='base_link')
    ElementTree.SubElement(joint, 'child', link=name)
    xyz = f'{0.3 * number - 0.4:.2f} {0.4 * (-1) ** number} 0.0'
    ElementTree.SubElement(joint, 'origin', xyz=xyz, rpy='1.5708 0 0')
    ElementTree.SubElement(joint, 'axis', xyz='0 0 1')


def _body(random, small: bool) -> tuple[tuple[str, dict[str, str]], float]:
    """A shape, with its sizes, and its mass.

    :param small: all its moments are 0 with six decimals, and nearly right with eight.
    """
    while True:
        numbers = [
            f'{random.uniform(0.004, 0.015):.4f}' if small else f'{random.uniform(0.05, 0.2):.3f}' for _ in '123'
        ]
        shape = random.choice(
            [
                ('box', {'size': ' '.join(numbers)}),
                ('sphere', {'radius': numbers[0]}),
                ('cylinder', {'radius': numbers[0], 'length': numbers[1]}),
            ]
        )
        mass = round(random.uniform(0.005, 0.03), 4) if small else random.uniform(0.3, 3.0)
        if not small or all(1.5e-7 < one < 4.5e-7 for one in solid(*shape, mass)):
            return shape, mass


def judge_rare_links(learner) -> None:
    """Repairs of links that are small, or that are seen where they are, without an <origin>."""
    for cause, rule, form in (('collision', 'shape', {'bare': True}), ('inertia', 'weight', {'small': True})):
        for _ in range(2):
            robot = FaultyRobot(learner.random, cause, **form)
            robot.diagnose(learner)
            with about(rule):
                robot.check(learner.call('repair_model', robot.urdf))


def solid(shape: str, sizes: dict[str, str], mass: float) -> tuple[float, float, float]:
    """Moments of inertia of a solid body about its centre, kg m² (any textbook of mechanics)."""
    if shape == 'box':
        x, y, z = (float(size) ** 2 for size in sizes['size'].split())
        return mass * (y + z) / 12, mass * (x + z) / 12, mass * (x + y) / 12
    square = float(sizes['radius']) ** 2
    if shape == 'sphere':
        return (mass * square * 2 / 5,) * 3
    across = mass * (square / 4 + float(sizes['length']) ** 2 / 12)
    return across, across, mass * square / 2


def _depth(element) -> int:
    """How deep the elements in it are; at most a little more than is allowed."""
    depth, inside = 0, [element]
    while inside and depth <= DEEPEST:
        depth, inside = depth + 1, [part for one in inside for part in one]
    return depth


def _canonical(element) -> str:
    """The element's text; the same for other spaces, and for numbers that are written in another way."""
    element = copy.deepcopy(element)
    for part in element.iter():
        for key, value in part.items():
            with suppress(ValueError):
                part.set(key, ' '.join(f'{float(word):g}' for word in value.split()))
    return ElementTree.canonicalize(ElementTree.tostring(element, encoding='unicode'), strip_text=True)


def _others(robot) -> list[str]:
    """What a robot has besides its links, and its own element."""
    return sorted([*(_canonical(part) for part in robot if part.tag != 'link'), f'<robot> {sorted(robot.items())}'])


def _check_rest(link: str, before: list[str], after: list[str]) -> None:
    """Fail with words if anything is changed that was right, in this link or (with '') outside of the links."""
    lost, new = [[one for one in some if one not in rest] for some, rest in ((before, after), (after, before))]
    where = f'in the link {link}' if link else 'outside of the links'
    expect(not lost, f'What was right must stay: after your repair, {where}, this is missing: {lost[:1]}', 'kept')
    expect(not new, f'What was right must stay: after your repair, {where}, this is there, too: {new[:1]}', 'kept')


def _close(text: str, value: float, part: float = 1e-4, most: float = 2e-6) -> bool:
    """Whether a text is this number; it may differ by a part of it, and by `most` more."""
    try:
        return abs(float(text) - value) <= part * abs(value) + most
    except (TypeError, ValueError):
        return False
