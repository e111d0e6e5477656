from grading.variants import Alternative

ALTERNATIVES = [
    Alternative('element_tree', source='''
from xml.etree import ElementTree as tree


def crate(mass, length, width, height):
    """Made of elements, not of text."""
    robot = tree.Element('robot', name='wooden')
    link = tree.SubElement(robot, 'link', name='crate')
    for kind in ('visual', 'collision', 'inertial'):
        part = tree.SubElement(link, kind)
        tree.SubElement(part, 'origin', xyz=f'0 0 {height / 2}', rpy='0 0 0')
        if kind != 'inertial':
            geometry = tree.SubElement(part, 'geometry')
            tree.SubElement(geometry, 'box', size=f'{length} {width} {height}')
    tree.SubElement(part, 'mass', value=str(mass))
    squares = {'x': length**2, 'y': width**2, 'z': height**2}
    moments = {f'i{axis}{axis}': f'{mass / 12 * (sum(squares.values()) - squares[axis]):.9f}' for axis in squares}
    tree.SubElement(part, 'inertia', **moments, ixy='0', ixz='0', iyz='0')
    return tree.tostring(robot, encoding='unicode')
'''),
    Alternative('half_a_turn', old=">{middle}<mass", new="><origin xyz=\"0 0 {height / 2}\" rpy=\"0 0 3.14159\"/><mass"),
]
