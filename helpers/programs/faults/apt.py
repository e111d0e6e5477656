"""`no_source`: apt cannot use the source of ROS. The real apt, on a private root, with a folder for a server.

On a machine without apt the fault works, too: then Python reads the source line.
"""

import re
import shutil
import tempfile
from pathlib import Path

from helpers.programs.faults import words
from helpers.programs.faults.fault import ROOT, Fault, Verdict
from helpers.programs.faults.machine import BASHRC, SYSTEM_PATH

REPOSITORY = Path(__file__).parent / 'repository'
PACKAGE = 'ros-jazzy-ros-base'
_LIST = 'etc/apt/sources.list.d/ros2.list'
_KEY = 'ros-archive-keyring.gpg'
_SOURCE = re.compile(r'deb\s+\[([^]]*)\]\s+file:(\S+)\s+(\S+)\s+(\S.*)')  # options, address, release, components
_ABSENT = """\
There is no apt-get on this machine: only Debian, Ubuntu and their relatives have it. So apt cannot show its error here.
The files are there all the same. Read the line and repair it; verify() compares it with the server."""
_OTHERS = ('docker', 'vscode', 'nodesource', 'gazebo')
# Everything apt reads and writes is below ROOT; it drops no rights and asks for no translations.
_CONFIGURATION = f'''\
Dir "{ROOT}/pc";
Dir::State::status "{ROOT}/pc/var/lib/dpkg/status";
APT::Architecture "amd64";
APT::Sandbox::User "";
Acquire::Languages "none";
'''


class NoSource(Fault):
    """`apt update` fails, or does not offer ROS.

    Kinds: ``key_file`` (no key at the place that the line names), ``wrong_key`` (somebody else's key), ``suite`` (the
    name of the ROS distribution in place of Ubuntu's), ``codename`` (another Ubuntu), ``component`` (misspelt),
    ``malformed`` (a word of the line is missing).
    """

    name, title = 'no_source', 'apt update fails on the ROS source, or finds no ROS'
    kinds = ('key_file', 'wrong_key', 'suite', 'codename', 'component', 'malformed')
    machine = 'pc'

    def stage(self) -> Fault:
        """As for all; in another folder if the path of this one has a space."""
        if any(map(str.isspace, str(self.path))):  # apt ends a word of a source line there
            self.path = Path(tempfile.mkdtemp(prefix='fault_'))
        return super().stage()

    def plan(self) -> None:
        draw = self.random
        other = f'{draw.choice(_OTHERS)}-archive-keyring.gpg'
        self._other_key = other
        words_right = {'key': _KEY, 'suite': 'noble', 'component': 'main'}
        change = {
            'key_file': {'key': f'{words.misspelt(_KEY.partition(".")[0], draw)}.gpg'},
            'wrong_key': {'key': other},
            'suite': {'suite': 'jazzy'},
            'codename': {'suite': 'jammy'},
            'component': {'component': draw.choice(['mian', 'man', 'mail', 'Main'])},
            'malformed': {draw.choice(['suite', 'component']): ''},
        }[self.kind]
        file = f'pc/{_LIST}'
        self.files = {file: _line(**words_right | change)}
        self.repaired = {file: _line(**words_right)}
        self.task = (
            f'On this machine, Ubuntu 24.04 ("noble"), apt-get update should end without an error, and offer '
            f'{PACKAGE}. (The server packages.ros.org is a folder here.)'
        )
        ((field, wrong),) = change.items()
        cause = {'key_file': 'key', 'wrong_key': 'key', 'suite': 'release', 'codename': 'release'}.get(self.kind)
        self.diagnose(file, cause or self.kind, self.files[file].strip())
        self.facts = {'field': field, 'found': wrong, 'expected': words_right[field]}

    def prepare(self) -> None:
        pc = self.home('pc')
        pc.env['APT_CONFIG'] = str(pc.path / 'apt.conf')
        pc.write(BASHRC, '')
        pc.write('apt.conf', self._fill(_CONFIGURATION))
        pc.write('etc/os-release', 'NAME="Ubuntu"\nVERSION_ID="24.04"\nVERSION_CODENAME=noble\n')
        pc.write('var/lib/dpkg/status', '')
        for folder in (
            'etc/apt/apt.conf.d',
            'etc/apt/preferences.d',
            'var/lib/apt/lists/partial',
            'var/cache/apt/archives/partial',
            'usr/share/keyrings',
        ):
            (pc.path / folder).mkdir(parents=True)
        shutil.copytree(REPOSITORY / 'ubuntu', self.path / 'packages.ros.org' / 'ros2' / 'ubuntu')
        shutil.copy(REPOSITORY / _KEY, pc.path / 'usr/share/keyrings')
        shutil.copy(REPOSITORY / 'other-archive-keyring.gpg', pc.path / 'usr/share/keyrings' / self._other_key)

    def show_symptom(self) -> None:
        if _apt():
            self.run(f'apt-get update\napt-cache policy {PACKAGE}')
        else:
            print(_ABSENT)

    def works(self, timeout: float) -> Verdict:
        if _apt():
            status, output = self.ask(f'apt-get update && apt-cache policy {PACKAGE}')
            offered = status == 0 and 'W:' not in output and 'Candidate: 0' in output
        else:
            offered = self.fits()
        return Verdict(offered, f'the source {"offers" if offered else "does not offer"} {PACKAGE}')

    def fits(self) -> bool:
        """Whether all lines of the source have the server's key, and one a release and component with the package."""
        lines = [line.strip() for line in self._file(f'pc/{_LIST}').read_text().splitlines()]
        found = [_SOURCE.fullmatch(line) for line in lines if line and not line.startswith('#')]
        return all(found) and all(map(_signed, found)) and any(map(_offers, found))


def _apt() -> bool:
    return shutil.which('apt-get', path=SYSTEM_PATH) is not None


def _signed(source: re.Match) -> bool:
    """Whether the key that a source line names is the one that has signed the server's list."""
    key = re.search(r'signed-by=(\S+)', source[1])
    return bool(key) and Path(key[1]).is_file() and Path(key[1]).read_bytes() == (REPOSITORY / _KEY).read_bytes()


def _offers(source: re.Match) -> bool:
    """Whether there is such a release, with all these components, and with the package."""
    release = Path(source[2], 'dists', source[3])
    lists = [release / component / 'binary-amd64' / 'Packages' for component in source[4].split()]
    return all(one.is_file() for one in lists) and any(f'Package: {PACKAGE}\n' in one.read_text() for one in lists)


def _line(key: str, suite: str, component: str) -> str:
    parts = (
        f'deb [arch=amd64 signed-by={ROOT}/pc/usr/share/keyrings/{key}]',
        f'file:{ROOT}/packages.ros.org/ros2/ubuntu',
        suite,
        component,
    )
    return ' '.join(part for part in parts if part) + '\n'
