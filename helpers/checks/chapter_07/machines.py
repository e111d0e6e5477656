"""Exercise 7.1's machines: drawn with their faults, and tried in a real shell."""

import re

from helpers.checks.chapter_07 import findings
from helpers.runner import expect

RELEASES = (('jazzy', 'noble'), ('humble', 'jammy'), ('foxy', 'focal'))
CAUSES = ('missing', 'release', 'key', 'not sourced', 'PATH', 'other', 'domain', 'range')
# How a cause may show, where it has several forms: arguments of `draw`.
FORMS = {
    'domain': [{'way': way} for way in ('none', 'only', 'last')],
    'range': [{'reach': reach} for reach in ('OFF', 'LOCALHOST')],
}
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


def draw(random, *causes: str, plain: bool = False, way: str = '', reach: str = '') -> tuple[dict, dict, list[tuple]]:
    """A machine with these faults: its files, what the team wants, and the findings that are right.

    :param plain: lines that do something have the commonest form, and no comment has a fault in it.
    :param way: how the domain is wrong: 'none' (no line), 'only' (one line), 'last' (the last of two lines).
    :param reach: the range that is wrong.
    """
    (distro, codename), (older, other_codename) = random.sample(RELEASES, 2)
    want = {'distro': distro, 'codename': codename, 'domain': random.randint(1, 101)}
    expected = []

    def fault(row, cause, line):
        expected.append((row, '.bashrc' if row != 'A7.1' else 'ros2.list', cause, line))
        return line

    key = random.choice(
        ['[signed-by=/usr/share/keyrings/ros-archive-keyring.gpg]', '[arch=amd64 signed-by=/etc/apt/keyrings/ros.gpg]']
    )
    if 'release' in causes:  # the right release stands in the line, but as no release
        key = f'[signed-by=/usr/share/keyrings/ros-{codename}.gpg]'
    deb = (
        f'deb {"[arch=amd64]" if "key" in causes else key} {_URL} '
        f'{other_codename if "release" in causes else codename} main'
    )
    for cause in ('key', 'release'):
        if cause in causes:
            fault('A7.1', cause, deb)
    if 'missing' in causes:
        deb = '' if plain else '# ' + deb
        fault('A7.1', 'missing', '')
    sources = ['# ROS 2', deb] + ([] if plain else [f'#deb-src {_URL} {other_codename} main'])

    def setup(name):
        if plain:
            return f'source /opt/ros/{name}/setup.bash'
        return (
            f'{random.choice(["source", "."])} {random.choice(["", "", "~", "/home/ada"])}/opt/ros/{name}/setup.'
            f'{random.choice(["bash", "sh"])}'
        )

    source = setup(distro)
    lines = [
        '# what every terminal reads',
        f'export ROBOT=robot{random.randint(10, 99)}',
        "alias ll='ls -l'",
        f'export PATH=$PATH:/opt/arm{random.randint(10, 99)}/bin',
        'export MANPATH=/opt/arm/man',
        *([] if plain else [f'#source /opt/ros/{older}/setup.bash']),
    ]
    if 'not sourced' in causes:
        fault('A7.2', 'not sourced', '')
        source = '' if plain else random.choice(['', f'# {source}', f'  # {source}'])
    lines.append(source)
    if 'other' in causes:
        line = fault('A7.5', 'other', setup(older))
        lines.insert(random.choice([2, len(lines)]), line)
    ways = ['export '] if plain else ['export ', '']
    folder = f'/opt/tool{random.randint(10, 99)}/bin'
    line = f'{random.choice(ways)}PATH={folder}:/usr/bin:/bin'
    lines.append(fault('A7.3', 'PATH', line) if 'PATH' in causes else f'export PATH={folder}:$PATH')
    wrong = random.choice([number for number in range(102) if number != want['domain']])
    if 'domain' in causes:
        way = way or random.choice(['none', 'only', 'last'])
        lines += [f'{random.choice(ways)}ROS_DOMAIN_ID={want["domain"]}'] if way == 'last' else []
        lines += [] if way == 'none' else [f'{random.choice(ways)}ROS_DOMAIN_ID={wrong}']
        fault('A7.7', 'domain', lines[-1] if way != 'none' else '')
    else:
        lines += [f'{random.choice(ways)}ROS_DOMAIN_ID={value}' for value in (wrong, want['domain'])]
    reach = reach or random.choice(['OFF', 'LOCALHOST'])
    name = f'{random.choice(ways)}ROS_AUTOMATIC_DISCOVERY_RANGE'
    lines.append(f'{name}=SYSTEM_DEFAULT')
    lines.append(fault('A7.7', 'range', f'{name}={reach}') if 'range' in causes else f'{name}=SUBNET')
    return {'ros2.list': '\n'.join(sources) + '\n', '.bashrc': '\n'.join(lines) + '\n'}, want, expected


def diagnose(learner, files: dict, want: dict, expected: list[tuple], rule: str = '') -> None:
    """Ask the learner's diagnose_machine, and fail with words if it does not find what is expected."""
    given = '\n'.join([f'The team wants {want}.', *(f'{name}:\n{text}' for name, text in files.items())])
    findings.compare(learner.call('diagnose_machine', files, want), expected, WHY, rule, given)


def is_file_set(files, names) -> bool:
    """Whether a learner's function has returned these files, as texts."""
    return isinstance(files, dict) and set(files) == set(names) and all(isinstance(t, str) for t in files.values())


def try_out(learner, before: dict, after, want: dict) -> None:
    """Fail with words if the repaired files do not do what they should, apt's by reading, the shell's in a shell."""
    expect(
        is_file_set(after, before),
        'repair_machine must return a dictionary with the texts of ros2.list and .bashrc.',
        'repaired',
    )
    _sources(before['ros2.list'], after['ros2.list'], want)
    _others(before['.bashrc'], after['.bashrc'], want)
    marks = {distro: f'{distro}{learner.random.getrandbits(40):x}' for distro, _ in RELEASES}
    setups = {
        f'home/opt/ros/{distro}/setup.{shell}': f'export SOURCED="$SOURCED {mark}"\n'
        for distro, mark in marks.items()
        for shell in ('bash', 'sh')
    }
    bashrc = re.sub(r'[^\s"\'=:]*/opt/ros/', '$HOME/opt/ros/', after['.bashrc'])
    workspace = learner.workspace({'home/.bashrc': bashrc, **setups})
    # What counts is what comes after a word that is not in the file: nobody else prints that.
    end = f'end{learner.random.getrandbits(64):x}'
    done = workspace.run(
        'bash',
        '-c',
        'cd home; exec env -i HOME="$PWD" PATH=/opt/first/bin:/usr/bin:/bin bash '
        f"--noprofile --norc -c '. ~/.bashrc; builtin echo; builtin echo {end}; for name in SOURCED "
        'PATH ROS_DOMAIN_ID ROS_AUTOMATIC_DISCOVERY_RANGE ROBOT; do builtin echo "$name=${!name}"; '
        "done'",
    )
    _, came, told = done.output.partition(f'\n{end}\n')
    expect(came, f'A shell with your .bashrc ends before it gets to its first command: {done.last_line}', 'repaired')
    seen = dict(line.split('=', 1) for line in told.splitlines() if '=' in line)
    names = {mark: distro for distro, mark in marks.items()}
    sourced = {names.get(mark, mark) for mark in seen.get('SOURCED', '').split()}
    _shell(seen | {'SOURCED': ' '.join(sorted(sourced))}, before['.bashrc'], want)


def _shell(seen: dict[str, str], before: str, want: dict) -> None:
    """Judge the variables of a shell that has read the repaired file; `before` is the file as it was."""
    sourced = set(seen.get('SOURCED', '').split())
    expect(want['distro'] in sourced, f'A shell with your .bashrc has not sourced {want["distro"]}.', 'repaired')
    expect(
        sourced == {want['distro']}, f'A shell with your .bashrc has sourced {", ".join(sorted(sourced))}.', 'repaired'
    )
    folders = seen.get('PATH', '').split(':')
    expect(
        '/opt/first/bin' in folders, 'In a shell with your .bashrc, what was on the PATH before is lost.', 'repaired'
    )
    tool = [
        folder
        for line in before.splitlines()
        if 'PATH=' in line and not line.startswith('#')
        for folder in line.split('=', 1)[1].split(':')
        if folder.startswith('/opt/tool')
    ]
    expect(
        set(tool) <= set(folders),
        f'{tool and tool[0]} was on the PATH, and is not any more. Repair the line, do not drop it.',
        'folders',
    )
    domain = seen.get('ROS_DOMAIN_ID') or '0'
    expect(
        domain == str(want['domain']),
        f'A shell with your .bashrc is in domain {domain}, not {want["domain"]}.',
        'repaired',
    )
    reach = seen.get('ROS_AUTOMATIC_DISCOVERY_RANGE')
    expect(
        reach not in ('OFF', 'LOCALHOST'),
        f'A shell with your .bashrc has the discovery range {reach}: nobody on another machine is found.',
        'repaired',
    )


def _others(before: str, after: str, want: dict) -> None:
    """Fail with words if a line has gone that had nothing to do with a fault."""
    there = {line.strip() for line in after.splitlines()}
    for line in map(str.strip, before.splitlines()):
        of_a_fault = (
            any(word in line for word in ('ROS_DOMAIN_ID', 'DISCOVERY_RANGE', 'PATH='))
            or re.match(r'(source|\.) ', line)
            or line.startswith('#')
            and want['distro'] in line
        )
        expect(
            not line or of_a_fault or line in there,
            f'The line `{line}` of .bashrc is gone: keep all other lines.',
            'kept',
        )


def _sources(before: str, after: str, want: dict) -> None:
    lines = [line.strip() for line in after.splitlines() if line.strip().startswith('deb ')]
    expect(lines, 'Your ros2.list has no line that begins with `deb`.', 'repaired')
    for line in lines:
        parts = line.split()
        expect(
            len(parts) > 3 and parts[-2:] == [want['codename'], 'main'] and parts[-3].rstrip('/') == _URL,
            f'In your ros2.list, `{line}` is not for {want["codename"]}.',
            'repaired',
        )
        expect('signed-by=/' in line, f'In your ros2.list, `{line}` names no key.', 'repaired')
    expect('# ROS 2' in after.splitlines(), 'A comment of ros2.list is gone: keep all other lines.', 'kept')
    good = [
        line
        for line in before.splitlines()
        if line.startswith('deb ') and 'signed-by=' in line and line.split()[-2] == want['codename']
    ]
    expect(set(good) <= set(lines), f'`{good and good[0]}` was right, and is gone.', 'kept')
