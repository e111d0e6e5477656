"""Exercise 7.1's machines: drawn with their faults, and tried in a real shell."""

from helpers.runner import expect

RELEASES = (('jazzy', 'noble'), ('humble', 'jammy'), ('foxy', 'focal'))
CAUSES = ('missing', 'release', 'key', 'not sourced', 'PATH', 'other', 'domain', 'range')
WHY = {
    'missing': 'Without a line that begins with `deb`, apt does not know where ROS is; a comment is no such line.',
    'release': 'The word before `main` is the release of Ubuntu; packages for another one do not fit.',
    'key': 'Without signed-by apt does not trust the source.',
    'not sourced': 'Only a line that is no comment sources ROS, with `source` or with `.`; it must be the wanted one.',
    'PATH': 'A line that sets PATH without `$PATH` drops every folder that was in it, those of ROS and colcon, too.',
    'other': 'Each line that sources another distribution than the wanted one is a fault, also beside the right one.',
    'domain': 'What a variable is in the end is said by its last line; without any line the domain is 0.',
    'range': 'With OFF nobody is found, with LOCALHOST nobody on another machine.',
}
_URL = 'http://packages.ros.org/ros2/ubuntu'


def draw(random, *causes: str) -> tuple[dict, dict, list[tuple]]:
    """A machine with these faults: its files, what the team wants, and the findings that are right."""
    (distro, codename), (older, other_codename) = random.sample(RELEASES, 2)
    want = {'distro': distro, 'codename': codename, 'domain': random.randint(1, 101)}
    expected = []

    def fault(row, cause, line):
        expected.append((row, '.bashrc' if row != 'A7.1' else 'ros2.list', cause, line))
        return line

    key = random.choice(['[signed-by=/usr/share/keyrings/ros-archive-keyring.gpg]',
                         '[arch=amd64 signed-by=/etc/apt/keyrings/ros.gpg]'])
    deb = (f'deb {"[arch=amd64]" if "key" in causes else key} {_URL} '
           f'{other_codename if "release" in causes else codename} main')
    for cause in ('key', 'release'):
        if cause in causes:
            fault('A7.1', cause, deb)
    if 'missing' in causes:
        deb = '# ' + deb
        fault('A7.1', 'missing', '')
    sources = ['# ROS 2', deb, f'#deb-src {_URL} {other_codename} main']

    source = f'{random.choice(["source", "."])} /opt/ros/{distro}/setup.bash'
    lines = ['# what every terminal reads', f'export ROBOT=robot{random.randint(10, 99)}', "alias ll='ls -l'",
             f'#source /opt/ros/{older}/setup.bash']
    if 'not sourced' in causes:
        fault('A7.2', 'not sourced', '')
        source = random.choice(['', f'# {source}'])
    lines.append(source)
    if 'other' in causes:
        line = fault('A7.5', 'other', f'{random.choice(["source", "."])} /opt/ros/{older}/setup.bash')
        lines.insert(random.choice([2, len(lines)]), line)
    folder = f'/opt/tool{random.randint(10, 99)}/bin'
    line = f'{random.choice(["export ", ""])}PATH={folder}:/usr/bin:/bin'
    lines.append(fault('A7.3', 'PATH', line) if 'PATH' in causes else f'export PATH={folder}:$PATH')
    wrong = want['domain'] % 101 + random.randint(1, 100)
    wrong = wrong if wrong != want['domain'] else 0
    if 'domain' in causes:
        way = random.choice(['none', 'only', 'last'])
        lines += [f'export ROS_DOMAIN_ID={want["domain"]}'] if way == 'last' else []
        lines += [] if way == 'none' else [f'export ROS_DOMAIN_ID={wrong}']
        fault('A7.7', 'domain', lines[-1] if way != 'none' else '')
    else:
        lines += [f'export ROS_DOMAIN_ID={wrong}', f'export ROS_DOMAIN_ID={want["domain"]}']
    reach = random.choice(['OFF', 'LOCALHOST'])
    lines.append(fault('A7.7', 'range', f'export ROS_AUTOMATIC_DISCOVERY_RANGE={reach}') if 'range' in causes
                 else 'export ROS_AUTOMATIC_DISCOVERY_RANGE=SUBNET')
    return {'ros2.list': '\n'.join(sources) + '\n', '.bashrc': '\n'.join(lines) + '\n'}, want, expected


def is_file_set(files, names) -> bool:
    """Whether a learner's function has returned these files, as texts."""
    return isinstance(files, dict) and set(files) == set(names) and all(isinstance(t, str) for t in files.values())


def try_out(learner, before: dict, after, want: dict) -> None:
    """Fail with words if the repaired files do not do what they should, apt's by reading, the shell's in a shell."""
    expect(is_file_set(after, before), 'repair_machine must return a dictionary with the texts of ros2.list and '
                                       '.bashrc.')
    _sources(before['ros2.list'], after['ros2.list'], want)
    setups = {f'home/opt/ros/{distro}/setup.bash': f'export SOURCED="$SOURCED {distro}"\n'
              for distro, _ in RELEASES}
    workspace = learner.workspace({'home/.bashrc': after['.bashrc'].replace('/opt/ros/', '$HOME/opt/ros/'), **setups})
    done = workspace.run('bash', '-c', 'cd home; env -i HOME="$PWD" PATH=/opt/first/bin:/usr/bin:/bin bash --noprofile '
                         '--norc -c \'. ~/.bashrc; echo; for name in SOURCED PATH ROS_DOMAIN_ID '
                         'ROS_AUTOMATIC_DISCOVERY_RANGE ROBOT; do echo "$name=${!name}"; done\'')
    seen = dict(line.split('=', 1) for line in done.lines if '=' in line)
    sourced = set(seen.get('SOURCED', '').split())
    expect(want['distro'] in sourced, f'A shell with your .bashrc has not sourced {want["distro"]}.')
    expect(sourced == {want['distro']}, f'A shell with your .bashrc has sourced {", ".join(sorted(sourced))}.')
    folders = seen.get('PATH', '').split(':')
    expect('/opt/first/bin' in folders, 'In a shell with your .bashrc, what was on the PATH before is lost.')
    tool = [folder for line in before['.bashrc'].splitlines() if 'PATH=' in line and not line.startswith('#')
            for folder in line.split('=', 1)[1].split(':') if folder.startswith('/opt/tool')]
    expect(set(tool) <= set(folders), f'{tool and tool[0]} was on the PATH, and is not any more. Repair the line, do '
                                      'not drop it.')
    domain = seen.get('ROS_DOMAIN_ID') or '0'
    expect(domain == str(want['domain']), f'A shell with your .bashrc is in domain {domain}, not {want["domain"]}.')
    reach = seen.get('ROS_AUTOMATIC_DISCOVERY_RANGE')
    expect(reach not in ('OFF', 'LOCALHOST'), f'A shell with your .bashrc has the discovery range {reach}: nobody on '
                                              'another machine is found.')
    expect(f'ROBOT={seen.get("ROBOT")}' in before['.bashrc'], 'The line that sets ROBOT is gone: keep all other lines.')


def _sources(before: str, after: str, want: dict) -> None:
    lines = [line.strip() for line in after.splitlines() if line.strip().startswith('deb ')]
    expect(lines, 'Your ros2.list has no line that begins with `deb`.')
    for line in lines:
        parts = line.split()
        expect(parts[-2:] == [want['codename'], 'main'] and parts[-3].rstrip('/') == _URL,
               f'In your ros2.list, `{line}` is not for {want["codename"]}.')
        expect('signed-by=/' in line, f'In your ros2.list, `{line}` names no key.')
    expect('# ROS 2' in after.splitlines(), 'A comment of ros2.list is gone: keep all other lines.')
    good = [line for line in before.splitlines() if line.startswith('deb ') and 'signed-by=' in line
            and line.split()[-2] == want['codename']]
    expect(set(good) <= set(lines), f'`{good and good[0]}` was right, and is gone.')
