# expect: The moments of
# rejected by: test_repaired_links
# Exercise 7.5: the robot that falls
def diagnose_model(urdf):
    found = []
    for link in ElementTree.fromstring(urdf).findall('link'):
        faults = [(tag, '') for tag in ('collision', 'inertial') if link.find(tag) is None]
        mass, moments = link.find('inertial/mass'), link.find('inertial/inertia')
        if mass is not None and float(mass.get('value')) <= 0:
            faults.append(('mass', mass.get('value')))
        values = [moments.get(name) for name in ('ixx', 'iyy', 'izz')] if moments is not None else []
        low, middle, high = sorted(map(float, values or '111'))
        if low <= 0 or high > low + middle:
            faults.append(('inertia', ' '.join(values)))
        found += [Finding('A7.11', link.get('name'), *fault) for fault in faults if link.find('visual') is not None]
    return found


def repair_model(urdf):
    robot = ElementTree.fromstring(urdf)
    for _, name, cause, _ in diagnose_model(urdf):
        link = next(link for link in robot.findall('link') if link.get('name') == name)
        visual = link.find('visual')
        if cause == 'collision':
            collision = ElementTree.SubElement(link, 'collision')
            collision.extend(copy.deepcopy([part for part in visual if part.tag in ('origin', 'geometry')]))
        elif cause == 'inertial':
            link.append(ElementTree.fromstring('<inertial><mass value="1"/><inertia/></inertial>'))
            link.find('inertial/inertia').attrib.update(ixy='0', ixz='0', iyz='0')
        elif cause == 'mass':
            link.find('inertial/mass').set('value', '1.0')
        if cause in ('inertial', 'inertia'):
            moments = inertia(visual.find('geometry')[0], 1.0)
            link.find('inertial/inertia').attrib.update(zip(('ixx', 'iyy', 'izz'), map(str, moments)))
    return ElementTree.tostring(robot, encoding='unicode')
