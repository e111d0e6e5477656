from grading.variants import Alternative

# With the numbers that faults had before they had names.
ALTERNATIVES = [
    Alternative('text', source='''
def moments_of(link):
    element = link.find('inertial').find('inertia')
    return [element.get(name) for name in ('ixx', 'iyy', 'izz')]


def diagnose_model(urdf):
    found = []
    for link in ElementTree.fromstring(urdf).iter('link'):
        name = link.attrib['name']
        if not link.findall('visual'):
            continue
        if not link.findall('collision'):
            found.append(Finding('A7.11', name, 'collision', ''))
        if not link.findall('inertial'):
            found.append(Finding('A7.11', name, 'inertial', ''))
            continue
        mass = link.find('inertial').find('mass').attrib['value']
        if not float(mass) > 0:
            found.append(Finding('A7.11', name, 'mass', mass))
        x, y, z = map(float, moments_of(link))
        if min(x, y, z) <= 0 or x > y + z or y > x + z or z > x + y:
            found.append(Finding('A7.11', name, 'inertia', ' '.join(moments_of(link))))
    return found


def repair_model(urdf):
    robot, wrong = ElementTree.fromstring(urdf), {(name, cause) for _, name, cause, _ in diagnose_model(urdf)}
    for link in robot.iter('link'):
        causes = {cause for name, cause in wrong if name == link.get('name')}
        if 'collision' in causes:
            collision = copy.deepcopy(link.find('visual'))
            collision.tag = 'collision'
            link.append(collision)
        if 'inertial' in causes:
            ElementTree.SubElement(ElementTree.SubElement(link, 'inertial'), 'mass')
            ElementTree.SubElement(link.find('inertial'), 'inertia', ixy='0.0', ixz='0.0', iyz='0.0')
        if causes & {'inertial', 'mass'}:
            link.find('inertial').find('mass').set('value', '1')
        if causes & {'inertial', 'inertia'}:
            mass = float(link.find('inertial').find('mass').get('value'))
            values = inertia(link.find('visual').find('geometry')[0], mass)
            for name, value in zip(('ixx', 'iyy', 'izz'), values):
                link.find('inertial').find('inertia').set(name, f'{value:.9f}')
    return ElementTree.tostring(robot).decode()
'''),
]
