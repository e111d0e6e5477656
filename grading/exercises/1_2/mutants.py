from grading.variants import Mutant

DISTROS = "distros = {part[3] for part in parts if part[:3] == ['', 'opt', 'ros'] and len(part) > 3}"
MIXED = "elif distros and len(distros | {environ.get('ROS_DISTRO') or min(distros)}) > 1:"
PYTHON = "if any(part.startswith('python') and '.' in part and part != f'python{python}' for part in folders):"
REACH = "reach = environ.get('ROS_AUTOMATIC_DISCOVERY_RANGE') or 'SUBNET'"

MUTANTS = [
    Mutant('variable_of_an_older_distribution', old="if reach == 'OFF' or", breaks='off', expect='nodes do not find each other',
           new="if reach == 'OFF' and environ.get('ROS_LOCALHOST_ONLY') != '1' or"),
    Mutant('path_of_cmake_too', old="prefixes = environ.get('AMENT_PREFIX_PATH', '')", breaks='workspace',
           new="prefixes = ':'.join(filter(None, map(environ.get, ('AMENT_PREFIX_PATH', 'CMAKE_PREFIX_PATH'))))",
           expect='only AMENT_PREFIX_PATH and PYTHONPATH count'),
    Mutant('version_of_ros', old='    return faults', expect='none of the four that can be wrong', breaks='dictionary', new="""
        if environ.get('ROS_VERSION', '2') != '2':
            faults['ROS_VERSION'] = 'old'
        return faults
        """),
    Mutant('any_case', old=REACH, new='''
        reach = environ.get('ROS_AUTOMATIC_DISCOVERY_RANGE') or 'SUBNET'
        reach = reach.upper()
        ''', expect='none of the four', breaks='unknown'),
    Mutant('distro_only', old=MIXED,
           new="elif distros and environ.get('ROS_DISTRO') and environ['ROS_DISTRO'] not in distros:",
           expect='which one was sourced last', breaks='mixed'),
    Mutant('distro_anywhere_in_the_path', old=MIXED,
           new="elif len(distros) > 1 or distros and environ.get('ROS_DISTRO', '') not in prefixes:",
           expect='Path and ROS_DISTRO name two distributions', breaks='ros-distro'),
    Mutant('domain_from_one', old='int(domain) <= 101)', new='0 < int(domain) <= 101)', expect='ROS_DOMAIN_ID=0',
           breaks='domain'),
    Mutant('empty_domain', old='if domain and not', new="if 'ROS_DOMAIN_ID' in environ and not",
           expect='Empty is like missing', breaks='missing'),
    Mutant('empty_path_is_a_prefix', old='if not prefixes:', new="if 'AMENT_PREFIX_PATH' not in environ:",
           expect="'not sourced'", breaks='not-sourced'),
    Mutant('humble_and_jazzy_only', old=MIXED, new="elif 'humble' in prefixes and 'jazzy' in prefixes:",
           expect='expected', breaks='mixed', also=('ros-distro', 'workspace')),
    Mutant('if_humble_in_path', old=MIXED, new="elif 'humble' in prefixes:", expect='expected', breaks='workspace',
           also=('dictionary', 'mixed', 'ros-distro', 'missing', 'every-fault')),
    Mutant('int_of_a_word', old='domain.isdecimal() and', new='0 <=', expect='invalid literal for int',
           breaks='domain'),
    Mutant('length_of_the_path', old=MIXED, new="elif ':' in prefixes:", expect='workspaces', breaks='workspace',
           also=('mixed',)),
    Mutant('names_of_workspaces', old=DISTROS, new='''
        names = ('foxy', 'humble', 'iron', 'jazzy', 'kilted', 'lyrical')
        distros = {name for name in names if name in prefixes}
        ''', expect='their names say nothing', breaks='workspace'),
    Mutant('no_off', old="'off' if reach == 'OFF' else 'unknown'", new="'unknown'", expect="'off'", breaks='off'),
    Mutant('no_python', old="faults['PYTHONPATH'] = 'other Python'", new='pass', expect='for another Python',
           breaks='python'),
    Mutant('no_ros_distro', old=MIXED, new='elif len(distros) > 1:', expect='name two distributions',
           breaks='ros-distro'),
    Mutant('no_unknown', old="if reach == 'OFF' or reach not in RANGES:", new="if reach == 'OFF':",
           expect='none of the four', breaks='unknown'),
    Mutant('none_if_all_is_well', old='return faults', new='return faults or None', expect='expected a dictionary',
           breaks='dictionary'),
    Mutant('one_list_of_faults', old='return faults', new='return list(faults.values())',
           expect='expected a dictionary', breaks='dictionary'),
    Mutant('own_python', old=PYTHON,
           new="if any(part.startswith('python3.') and part != 'python3.12' for part in folders):", expect='expected',
           breaks='python'),
    Mutant('python_begins_so', old="part != f'python{python}'", new="not part.startswith(f'python{python}')",
           expect='for another Python', breaks='python'),
    Mutant('right_python_is_enough', old=PYTHON,
           new="if 'python3.' in environ.get('PYTHONPATH', '') and f'python{python}' not in folders:",
           expect='does not excuse a wrong one', breaks='python'),
    Mutant('stops_at_first', old="faults['AMENT_PREFIX_PATH'] = 'not sourced'",
           new="return {'AMENT_PREFIX_PATH': 'not sourced'}", expect='Do not stop at the first one',
           breaks='every-fault'),
    Mutant('up_to_232', old=') <= 101):', new=') <= 232):', expect='ROS_DOMAIN_ID=102', breaks='domain'),
    Mutant('without_a_domain', old='''
        domain = environ.get('ROS_DOMAIN_ID', '')
        ''', new='''
        domain = environ.get('ROS_DOMAIN_ID', 'none')
        ''', expect='ROS_DOMAIN_ID', breaks='missing'),
    Mutant('all_variables_named', old='return faults', new='return {name: faults.get(name) for name in NAMES}',
           imports="NAMES = ('AMENT_PREFIX_PATH', 'PYTHONPATH', 'ROS_DOMAIN_ID', 'ROS_AUTOMATIC_DISCOVERY_RANGE')",
           expect='must not be in the dictionary', breaks='dictionary'),
    Mutant('opt_ros_anywhere', old=DISTROS, new="distros = set(re.findall('/opt/ros/([a-z]+)', prefixes))",
           imports='import re', expect='Only what begins with /opt/ros/', breaks='workspace'),
    Mutant('localhost_is_a_fault', old="if reach == 'OFF' or reach not in RANGES:",
           new="if reach in ('OFF', 'LOCALHOST') or reach not in RANGES:",
           expect='Nothing is wrong with ROS_AUTOMATIC_DISCOVERY_RANGE', breaks='unknown'),
    Mutant('distributions_of_today', old=DISTROS, new="""
        known = ('foxy', 'galactic', 'humble', 'iron', 'jazzy', 'kilted', 'lyrical', 'rolling')
        distros = {part[3] for part in parts if part[:3] == ['', 'opt', 'ros'] and part[3:] and part[3] in known}
        """, expect='whatever stands behind /opt/ros/', breaks='mixed'),
    Mutant('beginning_of_the_version', old=PYTHON, new=PYTHON.replace("part != f'python{python}'", "part not in f'python{python}'"),
           expect='One of its folders is for Python 3.1;', breaks='python'),
    Mutant('python_3_only', old=PYTHON, new=PYTHON.replace("'python')", "'python3')"), expect='is for Python 2.7',
           breaks='python'),
    Mutant('python_of_two_digits', old=PYTHON, new=PYTHON.replace("'python')", "'python3.1')"),
           expect="'other Python'", breaks='python'),
    Mutant('python_of_a_distribution', old=PYTHON, new="""
        folders = [folder.split('/') for folder in environ.get('PYTHONPATH', '').split(':') if '/opt/ros/' in folder]
        folders = [part for folder in folders for part in folder]
        if any(part.startswith('python') and '.' in part and part != f'python{python}' for part in folders):
        """, expect='it is no folder of a distribution', breaks='python'),
    Mutant('python_anywhere', old=PYTHON, new="if set(re.findall(r'python([0-9]+[.][0-9]+)', environ.get('PYTHONPATH', ''))) - {python}:",
           imports='import re', expect='nothing more', breaks='python'),
    Mutant('distro_by_its_beginning', old=MIXED, new='''
        elif len(distros) > 1 or not all(name.startswith(environ.get('ROS_DISTRO', '')) for name in distros):
        ''', expect='These are two names', breaks='ros-distro'),
    Mutant('version_as_a_number', old=PYTHON,
           new=PYTHON.replace("part != f'python{python}'", 'float(part[6:]) != float(python)'),
           expect='Compare texts', breaks='python'),
    Mutant('first_and_last_folder', old=DISTROS, new=DISTROS.replace('in parts if', 'in (parts[0], parts[-1]) if'),
           expect='with other folders between them', breaks='mixed'),
    Mutant('neighbours', old=MIXED, new="""
        elif any(one[3:4] != other[3:4] for one, other in zip(parts, parts[1:])
                 if one[:3] == other[:3] == ['', 'opt', 'ros']) or len(distros) == 1 and len(
                     distros | {environ.get('ROS_DISTRO') or min(distros)}) > 1:
        """, expect='with other folders between them', breaks='mixed'),
    Mutant('ros_distro_is_the_last_folder', old=MIXED, new="""
        elif len(distros) > 1 or environ.get('ROS_DISTRO') and parts[-1][:3] == ['', 'opt', 'ros'] and (
                parts[-1][3] != environ['ROS_DISTRO']):
        """, expect='Path and ROS_DISTRO name two', breaks='ros-distro'),
    Mutant('folder_begins_with_opt_ros', old=DISTROS,
           new="distros = {part[3] for part in parts if '/'.join(part).startswith('/opt/ros') and len(part) > 3}",
           expect='the other folders are elsewhere', breaks='workspace'),
    Mutant('anything_in_opt', old=DISTROS, new="distros = {part[3] for part in parts if part[1:2] == ['opt'] and len(part) > 3}",
           expect='the other folders are elsewhere', breaks='workspace'),
    Mutant('any_folder_ros', old=DISTROS, new="distros = {part[3] for part in parts if part[2:3] == ['ros'] and len(part) > 3}",
           expect='the other folders are elsewhere', breaks='workspace'),
    Mutant('last_python_folder', old="folders = environ.get('PYTHONPATH', '').replace(':', '/').split('/')",
           new="folders = environ.get('PYTHONPATH', '').split(':')[-1].split('/')", expect='folder', breaks='python'),
    Mutant('minor_version', old=PYTHON, new=PYTHON.replace("part != f'python{python}'",
                                                           "part.split('.')[1] != python.split('.')[1]"),
           expect='One of its three folders', breaks='python'),
    Mutant('part_before_the_last', old="folders = environ.get('PYTHONPATH', '').replace(':', '/').split('/')",
           new="folders = [part for folder in environ.get('PYTHONPATH', '').split(':') for part in folder.split('/')[-2:-1]]",
           expect='counts wherever it stands', breaks='python'),
    Mutant('digits', old='domain.isdecimal()', new='domain.isdigit()', expect='invalid literal for int', breaks='domain'),
    Mutant('begins_with_off', old=REACH, new="""
        reach = environ.get('ROS_AUTOMATIC_DISCOVERY_RANGE') or 'SUBNET'
        reach = 'OFF' if reach.startswith('OFF') else reach
        """, expect='letter by letter', breaks='unknown'),
    Mutant('spaces_around_it', old=REACH, new="""
        reach = environ.get('ROS_AUTOMATIC_DISCOVERY_RANGE') or 'SUBNET'
        reach = reach.strip()
        """, expect='letter by letter', breaks='unknown'),
    Mutant('faults_of_earlier_calls', edits=(("python='3.12'):", "python='3.12', faults={}):"), ('faults = {}', '')),
           expect='diagnose changes its argument `faults`', breaks='dictionary'),
    Mutant('faults_outside', edits=(("def diagnose(environ, python='3.12'):", '''
           FAULTS = {}


           def diagnose(environ, python='3.12'):
           '''), ('faults = {}', 'faults = FAULTS')), expect='remembers earlier calls', breaks='dictionary'),
    Mutant('variables_are_taken_out', old="domain = environ.get('ROS_DOMAIN_ID', '')", new="domain = environ.pop('ROS_DOMAIN_ID', '')",
           expect='diagnose changes `environ`', breaks='dictionary'),
    Mutant('missing_variables_are_put_in', old="domain = environ.get('ROS_DOMAIN_ID', '')",
           new="domain = environ.setdefault('ROS_DOMAIN_ID', '')", expect='belongs to somebody else', breaks='dictionary'),
    Mutant('faults_name_variables', old='return faults', new='return {fault: name for name, fault in faults.items()}',
           expect='Its keys are the names of variables', breaks='dictionary'),
    Mutant('only_below_lib', old=PYTHON, new="""
        if any(before == 'lib' and part.startswith('python') and '.' in part and part != f'python{python}'
               for before, part in zip(folders, folders[1:])):
        """, expect='whatever the part before it is called', breaks='python'),
    Mutant('folders_are_not_split', old=".replace(':', '/')", new='', also='every-fault',
           expect='each name ends at a colon', breaks='python'),
    Mutant('needs_a_distribution', old='elif distros and len(', new='elif len(', also='every-fault',
           expect='min()', breaks='workspace'),
    Mutant('distributions_of_both_paths', old="parts = [folder.split('/') for folder in prefixes.split(':')]",
           new="parts = [folder.split('/') for folder in (prefixes + ':' + environ.get('PYTHONPATH', '')).split(':')]",
           expect='what is in PYTHONPATH does not count', breaks='mixed'),
    Mutant('one_folder_higher', old="part[:3] == ['', 'opt', 'ros']",
           new="(part[:3] == ['', 'opt', 'ros'] or part[2:4] == ['opt', 'ros'] and part.append(part.pop(3)) is None)",
           expect='Only what begins with /opt/ros/', breaks='workspace'),
    Mutant('path_if_there_is_no_other', old="environ.get('PYTHONPATH', '')", new="environ.get('PYTHONPATH', environ.get('PATH', ''))",
           expect='only AMENT_PREFIX_PATH and PYTHONPATH count', breaks='python'),
    Mutant('three_alone_is_another', old="part.startswith('python') and '.' in part", new="part.startswith('python') and part[6:7].isdigit()",
           expect='python3 alone is none', breaks='python'),
    Mutant('exactly_two', old='or min(distros)}) > 1:', new='or min(distros)}) == 2:', expect='Three are in the path',
           breaks='mixed'),
    Mutant('an_empty_distro_excuses_a_mixture', old=MIXED, expect='Two distributions are in the path', breaks='mixed',
           new="elif distros and environ.get('ROS_DISTRO') != '' and len(distros | {environ.get('ROS_DISTRO') or min(distros)}) > 1:"),
    *[
        Mutant(f'{which}_python_of_a_folder', old="folders = environ.get('PYTHONPATH', '').replace(':', '/').split('/')",
               new=f"""
               folders = []
               for folder in environ.get('PYTHONPATH', '').split(':'):
                   folders += [part for part in folder.split('/') if part.startswith('python') and '.' in part]{part}
               """, expect='here there are two', breaks='python')
        for which, part in (('first', '[:1]'), ('last', '[-1:]'))
    ],
    Mutant('three_digits_are_101', old='int(domain) <= 101)', new="(len(domain) < 3 or domain == '101'))",
           expect='ROS_DOMAIN_ID=100', breaks='domain'),
    Mutant('a_blank_at_its_end', old=REACH, new="""
        reach = environ.get('ROS_AUTOMATIC_DISCOVERY_RANGE') or 'SUBNET'
        reach = reach.rstrip()
        """, expect='letter by letter', breaks='unknown'),
    Mutant('distro_in_any_letters', old=MIXED, breaks='ros-distro', also='mixed',
           new="elif distros and len({one.lower() for one in distros | {environ.get('ROS_DISTRO') or min(distros)}}) > 1:",
           expect='a capital letter makes another name'),
    Mutant('distro_of_ros_in_small_letters', old="environ.get('ROS_DISTRO')", new="environ.get('ROS_DISTRO', '').lower()",
           expect='a capital letter makes another name', breaks='ros-distro'),
    Mutant('path_in_small_letters', old="for folder in prefixes.split(':')]", new="for folder in prefixes.lower().split(':')]",
           expect='a capital letter makes another name', breaks='ros-distro', also='mixed'),
    Mutant('rolling_does_not_count', old='len(part) > 3}', new="len(part) > 3 and part[3] != 'rolling'}",
           expect='whatever stands behind /opt/ros/', breaks='mixed'),
    Mutant('python_in_any_letters', old=PYTHON, new=PYTHON.replace('part.startswith', 'part.lower().startswith'),
           expect='a part with a capital P', breaks='python'),
]
