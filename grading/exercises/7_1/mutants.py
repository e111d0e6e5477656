from grading.variants import Mutant

MUTANTS = [
    Mutant('comments_count', old="debs = [line for line in active(files['ros2.list']) if line.startswith('deb ')]",
           new="debs = [line for line in files['ros2.list'].splitlines() if 'deb ' in line]", breaks='comments',
           also=('missing', 'all'), expect='You'),
    Mutant('indented_comments', edits=(
        ("lines = active(files['.bashrc'])",
         "lines = [line.strip() for line in files['.bashrc'].splitlines() if line[:1] != '#']"),
        ('if re.match(SETUP, line)}', "if re.match('# ?' + SETUP, line) or re.match(SETUP, line)}"),
        ('re.match(SETUP, line)[1] for', "re.match('(?:# ?)?' + SETUP, line)[1] for")), breaks='comments',
           also=('not-sourced', 'all'), expect='You'),
    Mutant('lines_of_sources_count', old="line.startswith('deb ')]", new="line.startswith('deb')]", breaks='missing',
           also=('release', 'key', 'all', 'comments', 'repaired', 'kept'), expect='You'),
    Mutant('no_missing', old='if not debs:', new='if debs is None:', breaks='missing', also='all',
           expect='Without a line whose first word is `deb`'),
    Mutant('no_release', old="'release': line.split()[-2] != want['codename']", new="'release': False",
           breaks='release', also='all', expect='release of Ubuntu'),
    Mutant('release_is_the_distro', old="line.split()[-2] != want['codename']", new="want['distro'] not in line",
           breaks='release', also=('all', 'comments'), expect='release of Ubuntu'),
    Mutant('no_key', old="'key': 'signed-by=' not in line", new="'key': False", breaks='key', also='all',
           expect='Without signed-by'),
    Mutant('any_option_is_a_key', old="'signed-by=' not in line", new="'[' not in line", breaks='key', also='all',
           expect='Without signed-by'),
    Mutant('never_not_sourced', old="if want['distro'] not in sourced.values():", new='if sourced is None:',
           breaks='not-sourced', also=('all', 'comments'), expect='Only a line that is no comment'),
    Mutant('a_name_that_there_is_not', old="Finding('no_ros2', ", new="Finding('no-ros2', ", breaks='not-sourced',
           also=('all', 'comments'), expect="'no-ros2' is no fault of section 7.2"),
    Mutant('any_distribution_will_do', old="if want['distro'] not in sourced.values():", new='if not sourced:',
           breaks='all', expect='it must be the wanted one'),
    Mutant('no_path', old="name == 'PATH' and '$PATH' not in value", new="name == 'PATHS'", breaks='path',
           also=('all', 'variables'), expect='drops every folder'),
    Mutant('every_path', old="name == 'PATH' and '$PATH' not in value", new="name == 'PATH'", breaks='path',
           also='all', expect='there is no such fault'),
    Mutant('no_other', old="if sourced[line] != want['distro']]", new='if sourced[line] is None]', breaks='other',
           also=('all', 'comments', 'sources'), expect='Each line that sources another'),
    Mutant('other_only_without_the_right_one', old="if sourced[line] != want['distro']]",
           new="if sourced[line] != want['distro'] and want['distro'] not in sourced.values()]", breaks='other',
           also=('all', 'comments', 'sources'), expect='also beside the right one'),
    Mutant('no_domain', old="if int(domain[-1][1]) != want['domain']:", new='if not domain:', breaks='domain',
           also=('all', 'variables'), expect='What a variable is in the end'),
    Mutant('first_domain', edits=(('if int(domain[-1][1]) !', 'if int(domain[0][1]) !'),
            (', domain[-1][0]', ', domain[0][0]')), breaks='domain', also='all', expect='by its last line'),
    Mutant('no_line_is_no_fault', old="or [('', '0')]", new="or [('', str(want['domain']))]", breaks='domain',
           also='all', expect='without any line the domain is 0'),
    Mutant('no_range', old="name == 'ROS_AUTOMATIC_DISCOVERY_RANGE' and value in ('OFF', 'LOCALHOST')",
           new="name == 'RANGE'", breaks='range', also=('all', 'variables'), expect='With OFF nobody'),
    Mutant('only_off', old="value in ('OFF', 'LOCALHOST')", new="value == 'OFF'", breaks='range',
           also=('all', 'variables'), expect='LOCALHOST nobody'),
    Mutant('two_of_eight_causes', source=r'''
def diagnose_machine(files, want):
    sourced = [re.match(SETUP, line)[1] for line in active(files['.bashrc']) if re.match(SETUP, line)]
    found = [] if want['distro'] in sourced else [Finding('no_ros2', '.bashrc', 'not sourced', '')]
    return found + [Finding('mixed_distros', '.bashrc', 'other', line) for line in active(files['.bashrc'])
                    if re.match(SETUP, line) and re.match(SETUP, line)[1] != want['distro']]


def repair_machine(files, want):
    lines = [line for line in files['.bashrc'].splitlines()
             if not re.match(SETUP, line) or re.match(SETUP, line)[1] == want['distro']]
    return {**files, '.bashrc': '\n'.join(lines) + f"\nsource /opt/ros/{want['distro']}/setup.bash\n"}
''', breaks='missing', also=('release', 'key', 'path', 'domain', 'range', 'variables', 'all', 'repaired'),
           expect='You did not find `no_source`'),
    Mutant('needs_export', old="'=' in line", new="line.startswith('export ')", breaks='variables',
           also=('all', 'path', 'domain', 'range'), expect='drops every folder that was in it'),
    Mutant('only_the_word_source', old='if re.match(SETUP, line)}', new="if re.match(SETUP, line) and line[0] == 's'}",
           breaks='sources', also=('all', 'comments', 'not-sourced', 'other'), expect='You did not find'),
    Mutant('only_in_opt', old='if re.match(SETUP, line)}',
           new="if re.match(SETUP, line) and ' /opt/ros' in line and 'bash' in line}", breaks='sources',
           also=('all', 'comments', 'not-sourced', 'other'), expect='You'),
    Mutant('one_finding_only', old='    return found\n', new='    return found[:1]\n', breaks='all',
           also=('variables',), expect='You did not find'),
    Mutant('one_other_only', old="for line in sourced if sourced[line] != want['distro']]",
           new="for line in sourced if sourced[line] != want['distro']][:1]", breaks='all', expect='You did not find'),
    Mutant('repair_drops_the_path', old="wrong.get(line.strip(), 'PATH') == 'PATH'", new='line.strip() not in wrong',
           breaks='folders', expect='Repair the line, do not drop it'),
    Mutant('repairs_nothing', old="    found = diagnose_machine(files, want)\n", new='''
        return dict(files)
        found = diagnose_machine(files, want)
        ''', breaks='repaired', expect='changed nothing'),
    Mutant('keeps_the_other', edits=(
        ("wrong.get(line.strip(), 'PATH') == 'PATH'", "wrong.get(line.strip(), 'PATH') in ('PATH', 'other')"),
        ('(line.strip() in wrong)', "(wrong.get(line.strip()) == 'PATH')")), breaks='repaired', expect='has sourced'),
    Mutant('keeps_the_range', edits=(
        ("wrong.get(line.strip(), 'PATH') == 'PATH'", "wrong.get(line.strip(), 'PATH') in ('PATH', 'range')"),
        ('(line.strip() in wrong)', "(wrong.get(line.strip()) == 'PATH')")), breaks='repaired',
           expect='discovery range'),
    Mutant('no_domain_added', old=', f"export ROS_DOMAIN_ID={want[\'domain\']}"]', new=']', breaks='repaired',
           expect='is in domain'),
    Mutant('adds_at_the_top', old='bashrc += [', new='bashrc[:0] = [', breaks='repaired', expect='is in domain'),
    Mutant('a_new_bashrc', old="bashrc = [line + ':$PATH' * (line.strip() in wrong) for line in keep['.bashrc']]",
           new="bashrc = [line + ':$PATH' * (line.strip() in wrong) for line in keep['.bashrc'] if 'PATH=' in line]",
           breaks='kept', expect='keep all other lines'),
    Mutant('a_new_list', old="sources = keep['ros2.list'] + [DEB", new="sources = ['# ROS 2'] + [DEB",
           breaks='repaired', also='kept', expect='whose first word is `deb`'),
    Mutant('path_at_the_end_only', old="'$PATH' not in value", new="not value.endswith('$PATH')",
           expect='there is no such fault', breaks='path', also=('all', 'comments', 'kept', 'repaired')),
    Mutant('any_name_with_path', old="name == 'PATH' and", new="name.endswith('PATH') and",
           expect='there is no such fault', breaks='path', also=('all', 'comments', 'kept', 'repaired')),
    Mutant('subnet_alone', old="value in ('OFF', 'LOCALHOST')", new="value != 'SUBNET'", expect='there is no such fault',
           breaks='range', also=('all', 'comments', 'kept', 'repaired')),
    Mutant('release_anywhere_in_the_line', old="line.split()[-2] != want['codename']",
           new="want['codename'] not in line", expect='You did not find `no_source`, cause `release`', breaks='release',
           also=('all', 'repaired')),
    Mutant('first_apt_line_only', old='for line in debs:', new='for line in debs[:1]:', breaks='all',
           expect='You did not find `no_source`, cause `key`'),
    Mutant('one_finding_for_a_path', old="if name == 'PATH' and '$PATH' not in value:",
           new="if name == 'PATH' and '$PATH' not in value and 'PATH' not in [one.cause for one in found]:",
           breaks='all', expect='You did not find `no_colcon`, cause `PATH`'),
    Mutant('the_last_range_holds', old="value in ('OFF', 'LOCALHOST'):",
           new="value in ('OFF', 'LOCALHOST') and line == [one[0] for one in values if one[1] == name][-1]:",
           breaks='all', expect='You did not find `unseen`, cause `range`'),
]
