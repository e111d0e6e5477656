"""From the text of a URDF to a `Robot`. What is refused is what stock's parser (urdfdom) and its tree refuse."""

from math import isfinite
from xml.etree.ElementTree import Element

from urdf_reader.model import (
    Box,
    Collision,
    Cylinder,
    Inertial,
    Joint,
    Limit,
    Link,
    Mesh,
    Mimic,
    Pose,
    Robot,
    Sphere,
    UrdfError,
    Visual,
    unit,
)
from urdf_reader.xml_lines import parse

TYPES = ('revolute', 'continuous', 'prismatic', 'fixed', 'floating', 'planar')
NEED_LIMITS = ('revolute', 'prismatic')
INERTIA = ('ixx', 'ixy', 'ixz', 'iyy', 'iyz', 'izz')


def read(text: str, nested: bool = False) -> Robot:
    """
    Return the robot that a URDF describes.

    :param text: the XML text (not a file's name).
    :param nested: if the text begins with another element, take the first `<robot>` within it.
    :raises UrdfError: the text is no URDF, or its links are no tree; one line, with the line in the text.
    """
    root, lines = parse(text)
    if nested and root.tag != 'robot':
        root = next(root.iter('robot'), root)
    return _Reader(lines).robot(root)


class _Reader:
    def __init__(self, lines: dict[Element, int]):
        self._lines = lines
        self._materials: dict[str, tuple] = {}

    def robot(self, root: Element) -> Robot:
        if root.tag != 'robot':
            self._fail(root, f'a robot description begins with <robot>, this one with <{root.tag}>')
        name = self._name(root, 'robot')
        self._materials = self._named_colours(root)
        links: dict[str, Link] = {}
        for element in root.findall('link'):
            link = self._link(element)
            if link.name in links:
                self._fail(element, f'there are two links {link.name!r}; names of links are unique')
            links[link.name] = link
        if not links:
            self._fail(root, 'the robot has no <link>')
        joints: dict[str, Joint] = {}
        elements: dict[str, Element] = {}
        for element in root.findall('joint'):
            joint = self._joint(element)
            if joint.name in joints:
                self._fail(element, f'there are two joints {joint.name!r}; names of joints are unique')
            joints[joint.name], elements[joint.name] = joint, element
        return Robot(name, links, joints, self._root(links, joints, elements))

    def _root(self, links: dict[str, Link], joints: dict[str, Joint], elements: dict[str, Element]) -> str:
        """Return the name of the only link without a parent; the links must be one tree."""
        above: dict[str, Joint] = {}
        for name, joint in joints.items():
            for role, link in (('parent', joint.parent), ('child', joint.child)):
                if link not in links:
                    self._fail(
                        elements[name],
                        f'joint {name!r}: its {role} {link!r} is no link of this robot; '
                        f'correct the name or add <link name="{link}"/>',
                    )
            if joint.child in above:
                self._fail(
                    elements[name],
                    f'link {joint.child!r} has two parents, by the joints '
                    f'{above[joint.child].name!r} and {name!r}; a link has one',
                )
            above[joint.child] = joint
            if joint.mimic and joint.mimic.joint not in joints:
                self._fail(elements[name], f'joint {name!r}: it mimics {joint.mimic.joint!r}, which is no joint')
        roots = [name for name in links if name not in above]
        if not roots:
            raise UrdfError('every link has a parent: the joints make a loop; one link must be the root')
        if len(roots) > 1:
            raise UrdfError(
                f'the links {roots[0]!r} and {roots[1]!r} both have no parent; '
                'a robot has one root: connect them by a joint'
            )
        for name in links:
            seen = {name}
            while name in above:
                name = above[name].parent
                if name in seen:
                    raise UrdfError(f'the links {", ".join(sorted(seen))} make a loop; a robot is a tree')
                seen.add(name)
        return roots[0]

    def _link(self, element: Element) -> Link:
        name = self._name(element, 'link')
        where = f'link {name!r}'
        return Link(
            name,
            tuple(Visual(**self._shape(e, where), colour=self._colour(e, where)) for e in element.findall('visual')),
            tuple(Collision(**self._shape(e, where)) for e in element.findall('collision')),
            self._inertial(element.find('inertial'), where),
        )

    def _shape(self, element: Element, where: str) -> dict:
        return {
            'geometry': self._geometry(element, where),
            'origin': self._origin(element, where),
            'name': element.get('name', ''),
        }

    def _geometry(self, element: Element, where: str) -> Box | Cylinder | Sphere | Mesh:
        geometry = element.find('geometry')
        shape = next(iter(geometry), None) if geometry is not None else None
        if shape is None:
            self._fail(element, f'{where}: <{element.tag}> has no <geometry> with a shape in it')
        if shape.tag == 'box':
            return Box(self._numbers(shape, 'size', 3, where))
        if shape.tag in ('cylinder', 'sphere'):
            kind, names = (Cylinder, ('radius', 'length')) if shape.tag == 'cylinder' else (Sphere, ('radius',))
            return kind(*(self._number(shape, name, where) for name in names))
        if shape.tag == 'mesh':
            filename = shape.get('filename')
            if not filename:
                self._fail(shape, f'{where}: <mesh> has no filename')
            return Mesh(filename, self._numbers(shape, 'scale', 3, where, default=(1.0, 1.0, 1.0)))
        return self._fail(shape, f'{where}: <{shape.tag}> is no shape; there are box, cylinder, sphere and mesh')

    def _named_colours(self, root: Element) -> dict[str, tuple]:
        """The colours by name, from the materials of the robot and of its visuals; None for one of texture only."""
        found: dict[str, tuple | None] = {}
        for element in root.iter('material'):
            colour = element.find('color')
            name = element.get('name', '')
            if colour is not None:
                found[name] = self._numbers(colour, 'rgba', 4, f'material {name!r}')
            elif element.find('texture') is not None:
                found.setdefault(name, None)
        return found

    def _colour(self, visual: Element, where: str) -> tuple | None:
        material = visual.find('material')
        if material is None:
            return None
        colour = material.find('color')
        if colour is not None:
            return self._numbers(colour, 'rgba', 4, where)
        name = material.get('name', '')
        if name not in self._materials:
            self._fail(material, f'{where}: there is no <material name="{name}"> with a <color>')
        return self._materials[name]

    def _inertial(self, element: Element | None, where: str) -> Inertial | None:
        if element is None:
            return None
        mass, inertia = element.find('mass'), element.find('inertia')
        if mass is None or inertia is None:
            self._fail(element, f'{where}: <inertial> has no <{"mass" if mass is None else "inertia"}>')
        return Inertial(
            self._number(mass, 'value', where),
            tuple(self._number(inertia, name, where) for name in INERTIA),
            self._origin(element, where),
        )

    def _joint(self, element: Element) -> Joint:
        name = self._name(element, 'joint')
        where = f'joint {name!r}'
        kind = element.get('type')
        if kind not in TYPES:
            self._fail(element, f'{where}: its type is {kind!r}; there are {", ".join(TYPES)}')
        parent, child = (self._end(element, role, where) for role in ('parent', 'child'))
        limit, safety = element.find('limit'), element.find('safety_controller')
        if limit is None and kind in NEED_LIMITS:
            self._fail(element, f'{where}: a {kind} joint needs a <limit> with effort and velocity')
        return Joint(
            name,
            kind,
            parent,
            child,
            self._origin(element, where),
            axis=self._axis(element.find('axis'), where),
            limit=None
            if limit is None
            else Limit(
                *(self._number(limit, key, where, default=0.0) for key in ('lower', 'upper')),
                *(self._number(limit, key, where) for key in ('effort', 'velocity')),
            ),
            mimic=self._mimic(element.find('mimic'), where),
            soft_limits=(None, None)
            if safety is None
            else tuple(
                self._number(safety, key, where) if key in safety.attrib else None
                for key in ('soft_lower_limit', 'soft_upper_limit')
            ),
        )

    def _end(self, joint: Element, role: str, where: str) -> str:
        element = joint.find(role)
        if element is None or not element.get('link'):
            self._fail(joint, f'{where}: it has no <{role} link="…"/>')
        return element.get('link')

    def _axis(self, element: Element | None, where: str) -> tuple[float, float, float]:
        if element is None:
            return (1.0, 0.0, 0.0)
        try:
            return unit(self._numbers(element, 'xyz', 3, where))
        except ZeroDivisionError:
            return self._fail(element, f'{where}: its axis is 0 0 0; it needs a direction')

    def _mimic(self, element: Element | None, where: str) -> Mimic | None:
        if element is None:
            return None
        if not element.get('joint'):
            self._fail(element, f'{where}: <mimic> has no joint')
        return Mimic(
            element.get('joint'),
            self._number(element, 'multiplier', where, default=1.0),
            self._number(element, 'offset', where, default=0.0),
        )

    def _origin(self, element: Element, where: str) -> Pose:
        origin = element.find('origin')
        if origin is None:
            return Pose()
        zero = (0.0, 0.0, 0.0)
        return Pose(*(self._numbers(origin, name, 3, where, default=zero) for name in ('xyz', 'rpy')))

    def _name(self, element: Element, what: str) -> str:
        name = element.get('name')
        if not name:
            self._fail(element, f'<{what}> has no name')
        return name

    def _number(self, element: Element, attribute: str, where: str, default: float | None = None) -> float:
        given = None if default is None else (default,)
        return self._numbers(element, attribute, 1, where, given)[0]

    def _numbers(self, element: Element, attribute: str, count: int, where: str, default: tuple | None = None) -> tuple:
        text = element.get(attribute)
        if text is None:
            if default is not None:
                return default
            self._fail(element, f'{where}: <{element.tag}> has no {attribute}')
        try:
            numbers = tuple(map(float, text.split()))
        except ValueError:
            numbers = ()
        if len(numbers) != count or not all(map(isfinite, numbers)):
            what = 'a number' if count == 1 else f'{count} numbers with spaces between them'
            self._fail(element, f'{where}: {attribute}="{text}" of <{element.tag}> must be {what}')
        return numbers

    def _fail(self, element: Element, problem: str):
        raise UrdfError(f'line {self._lines[element]}: {problem}')
