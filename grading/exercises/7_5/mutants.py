from grading.variants import Mutant

END = "    return ElementTree.tostring(robot, encoding='unicode')\n"
CAUSE = {'also': 'all'}
MASS = {**CAUSE, 'breaks': 'mass'}
INERTIA = {**CAUSE, 'breaks': 'inertia'}

MUTANTS = [
    Mutant('no_collision', old="for tag in ('collision', 'inertial') if", new="for tag in ('inertial',) if",
           breaks='collision', expect='is seen, and touches nothing', **CAUSE),
    Mutant('no_inertial', old="for tag in ('collision', 'inertial') if", new="for tag in ('collision',) if",
           breaks='inertial', expect='has no mass', **CAUSE),
    Mutant('no_mass', old="faults.append(('mass', mass.get('value')))", new='pass',
           expect='A mass must be more than 0', **MASS),
    Mutant('negative_masses_only', old="(mass.get('value')) <= 0:", new="(mass.get('value')) < 0:",
           expect='A mass must be more than 0', **MASS),
    Mutant('two_ways_to_write_zero', old="float(mass.get('value')) <= 0:", expect='A mass must be more than 0',
           new="(mass.get('value') in ('0', '0.0') or mass.get('value').startswith('-')):", **MASS),
    Mutant('mass_as_a_number', old="('mass', mass.get('value'))", new="('mass', f\"{float(mass.get('value')):.3f}\")",
           expect='your evidence is', **MASS),
    Mutant('no_moments', old="faults.append(('inertia', ' '.join(values)))", new='pass',
           expect='Each of the three moments', **INERTIA),
    Mutant('no_triangle', old='if low <= 0 or high > low + middle:', new='if low <= 0:',
           expect='none is more than the sum of the two others', **INERTIA),
    Mutant('four_decimals', old='low, middle, high = sorted(map(float, values or ', breaks='inertia', also='all',
           new='low, middle, high = sorted(round(float(one), 4) for one in (values or ',
           expect='Each of the three moments'),
    Mutant('collisions_with_an_origin_only', old="if link.find(tag) is None]", expect='there is no such fault',
           new="if link.find(tag) is None or tag == 'collision' and link.find('collision/origin') is None]",
           breaks='collision', also=('inertial', 'mass', 'inertia', 'frames', 'all')),
    Mutant('ixx_only', old="for name in ('ixx', 'iyy', 'izz')] if", new="for name in ('ixx', 'ixx', 'ixx')] if",
           expect='moments', **INERTIA),
    Mutant('small_masses_too', old="(mass.get('value')) <= 0:", new="(mass.get('value')) <= 0.01:", breaks='mass',
           expect='there is no such fault'),
    Mutant('masses_below_a_gram', old="(mass.get('value')) <= 0:", new="(mass.get('value')) <= 0.001:", breaks='mass',
           expect='there is no such fault'),
    Mutant('moments_that_are_hardly_more', old='if low <= 0 or', new='if low <= 1e-6 or', breaks='inertia',
           expect='there is no such fault'),
    Mutant('frames_by_their_name', old="faults if link.find('visual') is not None]", breaks='frames',
           new="faults if link.find('visual') is not None or len(link) and not link.get('name').endswith('frame')]",
           expect='there is no such fault'),
    Mutant('one_missing_part_of_a_link', old="if link.find(tag) is None]", new="if link.find(tag) is None][:1]", breaks='all',
           expect='You did not find `falls`, cause `inertial`'),
    Mutant('frames_with_something_in_them', old="faults if link.find('visual') is not None]",
           new="faults if link.find('visual') is not None or len(link)]", breaks='frames', expect='is only a frame'),
    Mutant('masses_of_frames', old="faults if link.find('visual') is not None]",
           new="faults if link.find('visual') is not None or fault[0] in ('mass', 'inertia')]", breaks='frames',
           expect='there is no such fault'),
    Mutant('no_origin_of_the_mass', old=END, new='''
    for inertial in robot.findall('link/inertial'):
        for origin in inertial.findall('origin'):
            inertial.remove(origin)
    return ElementTree.tostring(robot, encoding='unicode')
''', breaks='kept', expect='is changed'),
    Mutant('new_inertia', old="        if cause in ('inertial', 'inertia'):\n", new='''
        if cause == 'inertia':
            for origin in link.findall('inertial/origin'):
                link.find('inertial').remove(origin)
        if cause in ('inertial', 'inertia'):
''', breaks='kept', expect='this is missing'),
    Mutant('collision_is_not_turned', old="collision.extend(copy.deepcopy([part for part in visual if part.tag in ('origin', 'geometry')]))",
           new='''
           collision.extend(copy.deepcopy([part for part in visual if part.tag in ('origin', 'geometry')]))
           for origin in collision.findall('origin'):
               origin.set('rpy', '0 0 0')
           ''', breaks='shape', expect='is not that of its <visual>'),
    Mutant('fixed_joints_lost', old=END, new='''
    for joint in robot.findall("joint[@type='fixed']"):
        robot.remove(joint)
    return ElementTree.tostring(robot, encoding='unicode')
''', breaks='kept', expect='outside of the links, this is missing'),
    Mutant('links_and_joints_alone', old=END, new='''
    for part in robot.findall('material'):
        robot.remove(part)
    return ElementTree.tostring(robot, encoding='unicode')
''', breaks='kept', expect='outside of the links, this is missing'),
    Mutant('another_name', old=END, new='''
    robot.set('name', 'repaired')
    return ElementTree.tostring(robot, encoding='unicode')
''', breaks='kept', expect='outside of the links'),
    Mutant('collisions_as_the_visuals', old='    robot = ElementTree.fromstring(urdf)\n', new='''
    robot = ElementTree.fromstring(urdf)
    for link in robot.findall('link[visual]'):
        for geometry in link.findall('collision/geometry'):
            geometry[:] = copy.deepcopy(list(link.find('visual/geometry')))
''', breaks='kept', expect='is changed'),
    Mutant('frames_too', old="faults if link.find('visual') is not None]", new='faults]', breaks='frames', also='all',
           expect='is only a frame'),
    Mutant('one_for_each_link', old='*fault) for fault in faults if', new='*fault) for fault in faults[:1] if',
           breaks='all', expect='You did not find'),
    Mutant('one_finding', old='    return found\n', new='    return found[:1]\n', breaks='all',
           expect='You did not find'),
    Mutant('only_collisions_added', old="    for _, name, cause, _ in diagnose_model(urdf):\n", new='''
    for _, name, cause, _ in diagnose_model(urdf):
        if cause != 'collision':
            continue
''', breaks='weight', expect='has no <mass>'),
    Mutant('nothing_repaired', old='    robot = ElementTree.fromstring(urdf)\n', new='''
    return urdf
    robot = ElementTree.fromstring(urdf)
''', breaks='shape', also='weight', expect='<collision> after your repair'),
    Mutant('collision_without_origin', old="in ('origin', 'geometry')", new="== 'geometry'", breaks='shape',
           expect='The <origin> of the <collision>'),
    Mutant('parts_by_number', old="[part for part in visual if part.tag in ('origin', 'geometry')]", new='list(visual)[:2]',
           breaks='shape', expect='The <geometry> of the <collision>'),
    Mutant('collision_twice', old="collision = ElementTree.SubElement(link, 'collision')", new='''
            link.append(copy.deepcopy(visual))
            link[-1].tag = 'collision'
            collision = ElementTree.SubElement(link, 'collision')
''', breaks='shape', expect='has 2 <collision>'),
    Mutant('moments_of_one_kilogram', old="float(link.find('inertial/mass').get('value'))", new='1.0', breaks='weight',
           expect='The moments of'),
    Mutant('moments_before_the_mass', edits=(
        ('in diagnose_model(urdf):', "in sorted(diagnose_model(urdf), key=lambda one: one.cause == 'mass'):"),
        ("float(link.find('inertial/mass').get('value'))", "abs(float(link.find('inertial/mass').get('value'))) or 1.0")),
           breaks='weight', expect='The moments of base_link are'),
    Mutant('moments_stay', old="if cause in ('inertial', 'inertia'):", new="if cause == 'inertial':", breaks='weight',
           expect='The moments of'),
    Mutant('moments_of_one', old="zip(('ixx', 'iyy', 'izz'), map(str, moments))",
           new="ixx='1.0', iyy='1.0', izz='1.0'", breaks='weight', expect='The moments of'),
    Mutant('mass_without_sign', old="set('value', '1.0')",
           new="set('value', str(abs(float(link.find('inertial/mass').get('value'))) or 1.0))", breaks='weight',
           expect='The mass of'),
    Mutant('all_masses_one', old="    return ElementTree.tostring(robot, encoding='unicode')\n", new='''
    for mass in robot.iter('mass'):
        mass.set('value', '1.0')
    return ElementTree.tostring(robot, encoding='unicode')
''', breaks='kept', also='weight', expect='was right, and is changed'),
    Mutant('frames_dropped', old="    return ElementTree.tostring(robot, encoding='unicode')\n", new='''
    for link in robot.findall('link'):
        if link.find('visual') is None:
            robot.remove(link)
    return ElementTree.tostring(robot, encoding='unicode')
''', breaks='kept', expect='is gone'),
    Mutant('flat_bodies_too', old='high > low + middle', new='high >= low + middle', expect='there is no such fault',
           breaks='inertia'),
    Mutant('no_moment_is_right', old='if low <= 0 or high', new='if low < 0 or high',
           expect='You did not find `falls`, cause `inertia`', breaks='inertia', also=('all', 'weight', 'kept')),
    Mutant('only_izz_is_a_sum', old='low, middle, high = sorted(map(float, values', breaks='inertia', also='all',
           new='low, middle, high = (lambda a, b, c: (min(a, b, c), a + b - min(a, b, c), c))(*map(float, values',
           expect='none is more than the sum'),
    Mutant('only_far_above_the_sum', old='high > low + middle', new='high > 1.5 * (low + middle)', breaks='inertia',
           also='all', expect='none is more than the sum'),
    Mutant('moments_in_order', old="map(str, moments))", new='map(str, sorted(moments)))', breaks='weight',
           expect='The moments of'),
    Mutant('three_of_six_values', old="attrib.update(ixy='0', ixz='0', iyz='0')", new='attrib', breaks='weight',
           expect='An <inertia> has six values'),
    Mutant('an_origin_in_every_visual', breaks='shape', expect='not None',
           old="collision.extend(copy.deepcopy([part for part in visual if part.tag in ('origin', 'geometry')]))", new='''
           collision.append(copy.deepcopy(visual.find('origin')))
           collision.append(copy.deepcopy(visual.find('geometry')))
           '''),
    Mutant('one_for_each_visual', old="for fault in faults if link.find('visual') is not None]",
           new="for fault in faults for _ in link.findall('visual')]", breaks='all', expect='2 times. Each fault is one finding'),
    Mutant('masses_of_frames_become_one', old=END, new='''
    for mass in robot.iter('mass') if diagnose_model(urdf) else []:
        mass.set('value', mass.get('value') if float(mass.get('value')) > 0 else '1.0')
    return ElementTree.tostring(robot, encoding='unicode')
''', breaks='kept', expect='was right, and is changed'),
    Mutant('a_millionth_more_than_the_sum', old='high > low + middle', new='high > low + middle + 1e-6', breaks='inertia',
           expect='none is more than the sum', also='all'),
    Mutant('one_percent_more_than_the_sum', old='high > low + middle', new='high > 1.01 * (low + middle)', breaks='inertia',
           expect='none is more than the sum', also=('all', 'weight', 'kept')),
    Mutant('six_decimals', old='map(str, moments))', new="[f'{one:.6f}' for one in moments])", breaks='weight',
           expect='The moments of'),
    Mutant('the_visual_comes_first', old="visual = link.find('visual')", new='visual = link[0]', breaks='shape',
           expect='of the <collision> of', also=('weight', 'kept')),
    Mutant('bytes_of_a_robot', old="ElementTree.tostring(robot, encoding='unicode')", new='ElementTree.tostring(robot)',
           breaks='kept', expect="with encoding='unicode'", also='weight'),
    Mutant('five_at_most', old='    return found\n', new='    return found[:5]\n', breaks='all', expect='You did not find'),
    Mutant('mass_below_a_ton', old="float(mass.get('value')) <= 0", new="not 0 < float(mass.get('value')) < 1000",
           expect='A mass must be more than 0', breaks='mass', also=('all', 'inertia', 'frames')),
    Mutant('one_collision_each', old="        visual = link.find('visual')\n", new="""
        visual = link.find('visual')
        for more in link.findall('collision')[1:]:
            link.remove(more)
""", breaks='kept', expect='has 1 <collision> after your repair, expected 2'),
]
