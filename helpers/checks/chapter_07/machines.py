"""Exercise 7.1's machines: drawn with their faults, and tried in a real shell."""

import re

from helpers.checks.chapter_07 import findings
from helpers.runner import expect

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
            f'deb {"[arch=amd64]" if "key" in self._causes else key} {_URL} '
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
        return (
            f'{choice(["source", "."])} {choice(["", "", "~", "/home/ada"])}/opt/ros/{distro}/setup.'
            f'{choice(["bash", "sh"])}'
        )

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
    _sources(before['ros2.list'], after['ros2.list'], want)
    _others(before['.bashrc'], after['.bashrc'], want)
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
    expect(lines, 'Your ros2.list has no line whose first word is `deb`.', 'repaired')
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
