"""Exercise 7.1's machines: drawn with their faults, and tried in a real shell."""

import re
from collections import Counter

from helpers.checks.chapter_07 import findings
from helpers.runner import about, expect

RELEASES = (('jazzy', 'noble'), ('humble', 'jammy'), ('foxy', 'focal'))
CAUSES = ('missing', 'release', 'key', 'not sourced', 'PATH', 'other', 'domain', 'range')
# How a cause may show, where it has several forms: arguments of `draw`.
FORMS = {
    'domain': [{'way': way} for way in ('none', 'only', 'last', 'both')],
    'range': [{'reach': reach} for reach in ('OFF', 'LOCALHOST')],
}
WHY = {
    'missing': 'Without a line whose first word is `deb`, apt does not know where ROS is; a comment is no such line, '
    'and `deb-src` is another word.',
    'release': 'The word before `main` is the release of Ubuntu; packages for another one do not fit.',
    'key': 'Without signed-by apt does not trust the source.',
    'not sourced': 'Only a line that is no comment sources ROS, with `source` or with `.`; it must be the wanted one.',
    'PATH': 'A line that sets PATH without `$PATH` drops every folder that was in it, those of ROS and colcon, too.',
    'other': 'Each line that sources another distribution than the wanted one is a fault, also beside the right one.',
    'domain': 'What a variable is in the end is said by its last line; without any line the domain is 0.',
    'range': 'With OFF nobody is found, with LOCALHOST nobody on another machine.',
}
_URL = 'http://packages.ros.org/ros2/ubuntu'
_SETUP = re.compile(r'(?:source|\.)\s+\S*/opt/ros/(\w+)/setup\.(?:ba)?sh')
_COMPLETION = 'share/ros2cli/environment/ros2-argcomplete.bash'  # a file of ROS that sources none
_VALUE = re.compile(r'(?:export\s+)?(\w+)=(.*)')


def draw(random, *causes: str, plain: bool = False, way: str = '', reach: str = '') -> tuple[dict, dict, list[tuple]]:
    """A machine with these faults: its files, what the team wants, and the findings that are right.

    :param plain: lines that do something have the commonest form, and no comment has a fault in it.
    :param way: how the domain is wrong: 'none' (no line), 'only' (one line), 'last' (the last of two lines),
        'both' (each of two lines, with two numbers).
    :param reach: the range that is wrong.
    """
    machine = _Machine(random, causes, plain)
    sources = machine.sources()
    lines = [*machine.setups(), *machine.path(), *machine.domain(way), *machine.reach(reach)]
    files = {'ros2.list': '\n'.join(sources) + '\n', '.bashrc': '\n'.join(lines) + '\n'}
    return files, machine.want, machine.expected


def twice(random) -> tuple[dict, dict, list[tuple]]:
    """A machine on which two lines have the same fault, three times over, as `draw` returns it."""
    files, want, _ = draw(random, plain=True)
    numbers = random.sample(range(100, 1000), 2)
    debs = [f'deb [arch=amd64] {_URL}/{number} {want["codename"]} main' for number in numbers]
    paths = [f'export PATH=/opt/tool{number}/bin' for number in numbers]
    ranges = [f'export ROS_AUTOMATIC_DISCOVERY_RANGE={reach}' for reach in ('OFF', 'LOCALHOST')]
    files['ros2.list'] += '\n'.join(debs) + '\n'
    files['.bashrc'] += '\n'.join([*paths, *ranges, 'export ROS_AUTOMATIC_DISCOVERY_RANGE=SUBNET']) + '\n'
    expected = [('no_source', 'ros2.list', 'key', line) for line in debs]
    expected += [('no_colcon', '.bashrc', 'PATH', line) for line in paths]
    return files, want, expected + [('unseen', '.bashrc', 'range', line) for line in ranges]


def expected_of(files: dict, want: dict) -> list[tuple]:
    """The findings on a machine's files, read from their lines as the card says."""
    debs, lines = (
        [line.strip() for line in files[name].splitlines() if line.strip()[:1] not in ('', '#')]
        for name in ('ros2.list', '.bashrc')
    )
    debs = [line for line in debs if line.split()[0] == 'deb']
    found = [] if debs else [('no_source', 'ros2.list', 'missing', '')]
    found += [('no_source', 'ros2.list', 'release', line) for line in debs if line.split()[-2] != want['codename']]
    found += [('no_source', 'ros2.list', 'key', line) for line in debs if 'signed-by=' not in line]
    sourced = [(match[1], line) for line in lines if (match := _SETUP.match(line))]
    if want['distro'] not in dict(sourced):
        found.append(('no_ros2', '.bashrc', 'not sourced', ''))
    found += [('mixed_distros', '.bashrc', 'other', line) for distro, line in sourced if distro != want['distro']]
    values = [(match[1], match[2], line) for line in lines if (match := _VALUE.match(line))]
    found += [('no_colcon', '.bashrc', 'PATH', line) for name, value, line in values if _drops(name, value)]
    found += [
        ('unseen', '.bashrc', 'range', line)
        for name, value, line in values
        if name == 'ROS_AUTOMATIC_DISCOVERY_RANGE' and value in ('OFF', 'LOCALHOST')
    ]
    domains = [('', '0'), *((line, value) for name, value, line in values if name == 'ROS_DOMAIN_ID')]
    if int(domains[-1][1]) != want['domain']:
        found.append(('unseen', '.bashrc', 'domain', domains[-1][0]))
    return found


def _drops(name: str, value: str) -> bool:
    """Whether this value of a variable drops what was on the PATH."""
    return name == 'PATH' and not re.search(r'\$PATH\b|\$\{PATH\}', value)


def judge_rare_lines(learner) -> None:
    """Lines that look like others, each beside a healthy machine's: what do they do?

    Rule by rule: a release whose name begins with the wanted one, PATH as a part of a folder, a number in another
    number, another option than the key, a second line that sources, and commands that only hold the words of a line
    that does something.
    """
    random = learner.random
    (distro, codename), (older, _) = random.sample(RELEASES, 2)
    domain, number = random.randint(1, 9), random.randint(10, 99)
    deb, source = f'deb [signed-by=/key.gpg] {_URL}', f'source /opt/ros/{distro}/setup.bash'
    folder = f'/opt/tool{number}/bin'
    cases = [
        ('release', f'{deb} {codename}-{random.choice(["updates", "testing"])} main', [source], 0),
        ('comments', f'\t {deb} {codename} main  ', [source], 0),
        ('comments', '', [source, f'   . /opt/ros/{older}/setup.sh  ', f'   # export ROS_DOMAIN_ID={number}'], 0),
        ('path', '', [source, f'PATH=/usr/bin:{folder}', f'export PATH=/opt/PATH/bin:{folder}'], 0),
        ('path', '', [source, f'PATH=$HOME/bin:{folder}', f'export PATH={folder}:$MANPATH'], 0),
        ('path', '', [source, f'PATH={folder}:$PATH:/bin', f'export PATH=$PATH:{folder}', f'export XPATH={folder}'], 0),
        ('domain', '', [source, f'export ROS_DOMAIN_ID={domain}{number % 10}'], domain),
        ('domain', '', [source, f'export ROS_DOMAIN_ID={domain}'], domain * 10 + number % 10),
        ('domain', '', [source, f'ROS_DOMAIN_ID={domain}', 'ROS_DOMAIN_ID=0'], 0),
        ('domain', '', [source, f'ROS_DOMAIN_ID={domain}', f'export OLD_ROS_DOMAIN_ID={number}'], domain),
        ('range', '', [source, 'export ROBOT_MODE=OFF', 'export OLD_ROS_AUTOMATIC_DISCOVERY_RANGE=LOCALHOST'], 0),
        ('key', f'deb [trusted=yes] {_URL} {codename} main', [source], 0),
        ('not-sourced', '', [f'source /opt/ros/{older}/setup.bash', source], 0),
        ('not-sourced', '', [source, f'. /opt/ros/{older}/setup.bash'], 0),
        ('sources', '', [f"alias {distro}='{source}'", f'echo {source}'], 0),
        ('sources', '', [source, f"alias {older}='source /opt/ros/{older}/setup.bash'"], 0),
        ('sources', '', [source, f'source /opt/ros/{older}/{_COMPLETION}'], 0),
        ('sources', '', [f'source /opt/ros/{distro}/{_COMPLETION}'], 0),
        ('variables', '', [source, f"alias far='export ROS_DOMAIN_ID={number}'", f'echo PATH={folder}'], 0),
        (
            'missing',
            f'deb-src [signed-by=/key.gpg] {_URL} {codename} main  # as the deb line, which is gone',
            [source],
            0,
        ),
    ]
    for rule, first, lines, wanted in cases:
        files = {'ros2.list': f'{first or deb + " " + codename + " main"}\n', '.bashrc': '\n'.join(lines) + '\n'}
        want = {'distro': distro, 'codename': codename, 'domain': wanted}
        with about(rule):
            diagnose(learner, files, want, expected_of(files, want), rule)


def rare_repairs(random) -> list[tuple[dict, dict]]:
    """Machines, with what the team wants, whose wrong lines are many, or are also a part of lines that are right."""
    (distro, codename), (older, other) = random.sample(RELEASES, 2)
    domain, number = random.randint(10, 99), random.randint(10, 99)
    source, wrong = (f'source /opt/ros/{name}/setup.bash' for name in (distro, older))
    right, old = (f'deb [signed-by=/key.gpg] {_URL} {name} main' for name in (codename, other))
    paths = [f'export PATH=/opt/tool{number}/{name}:/opt/tool{number}/{name}2' for name in ('bin', 'sbin')]
    lines = [f"alias {older}='{wrong}'", f'# {wrong}', f'export ROBOT=robot{number}', source, wrong]
    lines += [f'export ROBOT_PATH=/srv/{number}', *paths, f'echo "{wrong} is for the old robot"']
    several = {
        'ros2.list': f'# ROS 2\n# {old}\n{right}\n{old}\n{old.replace("deb", "deb-src", 1)}\n',
        '.bashrc': '\n'.join([*lines, f'export ROS_DOMAIN_ID={domain}']) + '\n',
    }
    zero = {
        'ros2.list': f'# ROS 2\n{right}\n{right.replace("deb", "deb-src", 1)}\n',
        '.bashrc': '\n'.join([source, f'ROS_DOMAIN_ID={domain}', f'export ROS_DOMAIN_ID={domain + 1}']) + '\n',
    }
    kept = {
        'ros2.list': f'# ROS 2\n{right}\n',
        '.bashrc': '\n'.join(
            ['export ROS_AUTOMATIC_DISCOVERY_RANGE=SUBNET', f'export ROS_DOMAIN_ID={domain + 1}', source, wrong]
            + [
                'if [ -f ~/.aliases ]; then',
                '    . ~/.aliases',
                'fi',
                '',
                'if [ -d ~/maps ]; then',
                '    cd ~/maps',
                'fi',
            ]
            + [f'export PATH=/opt/tool{number}/bin:$PATH', f'export ROS_DOMAIN_ID={domain}']
        ),
    }
    indented = {
        'ros2.list': f'# ROS 2\n{right}\n',
        '.bashrc': '\n'.join(
            [
                source,
                f'  {wrong}',
                f'    export PATH=/opt/tool{number}/bin',
                '  export ROS_AUTOMATIC_DISCOVERY_RANGE=OFF',
            ]
            + [f'\texport ROS_DOMAIN_ID={domain + 1}', f'  export ROBOT=robot{number}']
        ),
    }
    want = {'distro': distro, 'codename': codename, 'domain': domain}
    return [(several, want), (zero, {**want, 'domain': 0}), (kept, want), (indented, want)]


def judge_rare_repairs(learner) -> None:
    """Repair the machines of `rare_repairs`, and try them out."""
    for files, want in rare_repairs(learner.random):
        with about('repaired'):
            repaired = learner.call('repair_machine', files, want)
        try_out(learner, files, repaired, want)


class _Machine:
    """Draws the lines of a machine's files with its faults, and notes in `expected` the findings that are right."""

    def __init__(self, random, causes: tuple[str, ...], plain: bool):
        self._random, self._causes, self._plain = random, causes, plain
        (self._distro, self._codename), (self._older, self._other_codename) = random.sample(RELEASES, 2)
        self.want = {'distro': self._distro, 'codename': self._codename, 'domain': random.randint(1, 101)}
        self.expected: list[tuple] = []

    def sources(self) -> list[str]:
        """The lines of ros2.list."""
        key = self._random.choice(
            [
                '[signed-by=/usr/share/keyrings/ros-archive-keyring.gpg]',
                '[arch=amd64 signed-by=/etc/apt/keyrings/ros.gpg]',
            ]
        )
        if 'release' in self._causes:  # the right release stands in the line, but as no release
            key = f'[signed-by=/usr/share/keyrings/ros-{self._codename}.gpg]'
        deb = (
            f'deb {"[arch=amd64]" if "key" in self._causes else key} {self._url()} '
            f'{self._other_codename if "release" in self._causes else self._codename} main'
        )
        for cause in ('key', 'release'):
            if cause in self._causes:
                self._fault('no_source', cause, deb)
        if 'missing' in self._causes:
            deb = '' if self._plain else '# ' + deb
            self._fault('no_source', 'missing', '')
        return ['# ROS 2', deb] + (
            []
            if self._plain
            else [f'#deb-src {_URL} {self._other_codename} main', f'deb-src {_URL} {self._other_codename} main']
        )

    def _url(self) -> str:
        """Where a line looks: one without a key in a mirror, whose name says nothing."""
        return 'http://mirror.example.org/ubuntu' if 'key' in self._causes else _URL

    def setups(self) -> list[str]:
        """The first lines of .bashrc, with what they source."""
        source = self._setup(self._distro)
        lines = [
            '# what every terminal reads',
            f'export ROBOT=robot{self._random.randint(10, 99)}',
            "alias ll='ls -l'",
            f'export PATH=$PATH:/opt/arm{self._random.randint(10, 99)}/bin',
            'export MANPATH=/opt/arm/man',
            *([] if self._plain else [f'#source /opt/ros/{self._older}/setup.bash']),
        ]
        if 'not sourced' in self._causes:
            self._fault('no_ros2', 'not sourced', '')
            source = '' if self._plain else self._random.choice(['', f'# {source}', f'  # {source}'])
        lines.append(source)
        if 'other' in self._causes:
            line = self._fault('mixed_distros', 'other', self._setup(self._older))
            lines.insert(self._random.choice([2, len(lines)]), line)
        return lines

    def path(self) -> list[str]:
        """The line of .bashrc that sets PATH."""
        folder = f'/opt/tool{self._random.randint(10, 99)}/bin'
        line = f'{self._export()}PATH={folder}:/usr/bin:/bin'
        return [self._fault('no_colcon', 'PATH', line) if 'PATH' in self._causes else f'export PATH={folder}:$PATH']

    def domain(self, way: str) -> list[str]:
        """The lines of .bashrc that set the domain; for `way` see `draw`."""
        right = self.want['domain']
        wrong, other = self._random.sample([number for number in range(102) if number != right], 2)
        if 'domain' not in self._causes:
            return [f'{self._export()}ROS_DOMAIN_ID={value}' for value in (wrong, right)]
        way = way or self._random.choice(['none', 'only', 'last', 'both'])
        first = {'last': [right], 'both': [other]}.get(way, [])
        lines = [f'{self._export()}ROS_DOMAIN_ID={number}' for number in first]
        lines += [] if way == 'none' else [f'{self._export()}ROS_DOMAIN_ID={wrong}']
        self._fault('unseen', 'domain', lines[-1] if lines else '')
        return lines

    def reach(self, wrong: str) -> list[str]:
        """The lines of .bashrc that set the range of discovery; `wrong`: the range that is, '' for any."""
        wrong = wrong or self._random.choice(['OFF', 'LOCALHOST'])
        name = f'{self._export()}ROS_AUTOMATIC_DISCOVERY_RANGE'
        last = self._fault('unseen', 'range', f'{name}={wrong}') if 'range' in self._causes else f'{name}=SUBNET'
        return [f'{name}=SYSTEM_DEFAULT', last]

    def _fault(self, fault: str, cause: str, line: str) -> str:
        """Note a finding; returns the line."""
        self.expected.append((fault, '.bashrc' if fault != 'no_source' else 'ros2.list', cause, line))
        return line

    def _setup(self, distro: str) -> str:
        """A line that sources a distribution."""
        if self._plain:
            return f'source /opt/ros/{distro}/setup.bash'
        choice = self._random.choice
        # What is sourced beside the wanted distribution lies in a folder that is called like that.
        folder = f'/srv/{self._distro}' if distro == self._older else choice(['', '', '~', '/home/ada'])
        return f'{choice(["source", "."])} {folder}/opt/ros/{distro}/setup.{choice(["bash", "sh"])}'

    def _export(self) -> str:
        """The word before a variable, or nothing."""
        return self._random.choice(['export '] if self._plain else ['export ', ''])


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
    for name, text in before.items():
        _lines_apart(name, text, after[name])
    _sources(before['ros2.list'], after['ros2.list'], want)
    _others(before, after, want)
    marks = {distro: f'{distro}{learner.random.getrandbits(40):x}' for distro, _ in RELEASES}
    setups = {
        f'home/opt/ros/{distro}/setup.{shell}': f'export SOURCED="$SOURCED {mark}"\n'
        for distro, mark in marks.items()
        for shell in ('bash', 'sh')
    }
    # From the beginning of a word only: else each of its letters would be tried as one.
    bashrc = re.sub(r'(?<![^\s"\'=:])[^\s"\'=:]*/opt/ros/', '$HOME/opt/ros/', after['.bashrc'])
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
        for line in map(str.strip, before.splitlines())
        if (value := _VALUE.match(line)) and value[1] == 'PATH'
        for folder in value[2].split(':')
        if folder.startswith('/opt/tool')
    ]
    lost = [folder for folder in tool if folder not in folders]
    expect(
        not lost,
        f'{lost and lost[0]} was on the PATH, and is not any more. Repair the line, do not drop it.',
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
    expect(
        reach in (None, '', 'SUBNET', 'SYSTEM_DEFAULT'),
        f'A shell with your .bashrc has the discovery range {reach!r}, which ROS does not know. Remove the line, or '
        'write SUBNET.',
        'repaired',
    )


def _others(before: dict, after: dict, want: dict) -> None:
    """Fail with words if a line has gone that had nothing to do with a fault."""
    found = expected_of(before, want)
    causes = {cause for _, _, cause, _ in found}
    for name, text in before.items():
        there = Counter(map(str.rstrip, after[name].splitlines()))
        for whole, count in Counter(map(str.rstrip, text.splitlines())).items():
            line = whole.strip()
            value = _VALUE.match(line)
            of_a_fault = (
                any(line == evidence for _, _, _, evidence in found)
                or 'domain' in causes
                and value
                and value[1] == 'ROS_DOMAIN_ID'  # whoever writes a new one may drop the earlier ones
                or causes & {'not sourced', 'missing'}
                and line.startswith('#')
                and (want['distro'] in line or 'deb' in line)  # it may have been made to do something again
            )
            expect(of_a_fault or there[whole] >= count, _lost(name, whole, count, there), 'kept')


def _lines_apart(name: str, before: str, after: str) -> None:
    """Fail with words if lines that a file had before now stand in one line."""
    lines = [line.strip() for line in before.splitlines() if line.strip()]
    one = '\n' not in after.strip() and sum(line in after for line in lines) > 1
    expect(not one, f"In your {name} the lines stand in one line: join them with '\\n'.", 'kept')


def _lost(name: str, line: str, count: int, there: Counter) -> str:
    """What is said of a line that a file had so many times; `there`: the lines that it has after the repair."""
    if not line:
        return f'{name} had {count} empty line(s), and now has {there[line]}: keep all other lines.'
    if line not in there and line.strip() in {one.strip() for one in there}:
        return f'The line `{line}` of {name} has lost the spaces at its beginning: keep all other lines as they are.'
    if line not in there:
        return f'The line `{line}` of {name} is gone: keep all other lines.'
    return (
        f'The line `{line}` stood {count} times in {name}, and now {there[line]} times: keep all other lines, also '
        'those that are equal.'
    )


def _sources(before: str, after: str, want: dict) -> None:
    lines = [line.strip() for line in after.splitlines() if line.strip().startswith('deb ')]
    expect(lines, 'Your ros2.list has no line whose first word is `deb`.', 'repaired')
    for line in lines:
        parts = line.split()
        expect(
            len(parts) > 3 and parts[-2:] == [want['codename'], 'main'] and parts[-3].rstrip('/') == _URL,
            f'In your ros2.list, `{line}` is not for {want["codename"]}.',
            'repaired',
        )
        expect('signed-by=/' in line, f'In your ros2.list, `{line}` names no key.', 'repaired')
