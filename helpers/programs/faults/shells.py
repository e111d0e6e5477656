"""`no_ros2` and `no_colcon`: a command is not found."""

from helpers.programs.faults import words
from helpers.programs.faults.fault import Fault, Verdict
from helpers.programs.faults.machine import BASHRC, SETUP

_ROS = f'source ~/{SETUP.format(distro="jazzy")}\n'
_PATHS = tuple(
    f'{line}\n'
    for line in (
        'export PATH="$HOME/bin:/usr/bin:/bin"',
        'export PATH="/usr/bin:/bin"',
        'PATH="/usr/bin:/bin:$HOME/bin"',
    )
)
_TOOLS = ('.local/bin', 'tools/bin', 'opt/tools/bin', 'colcon/bin')
_OLDER = ('humble', 'iron', 'foxy', 'galactic')


def bashrc(draw, *lines: str) -> str:
    """A ``.bashrc`` with these lines, among harmless ones."""
    extras = ["alias ll='ls -l'\n", 'export EDITOR=nano\n', 'export HISTSIZE=5000\n', "alias gs='git status'\n"]
    first, last = draw.choice(extras[:2]), draw.choice(extras[2:])
    return ''.join(('# Every new terminal reads this file.\n', first, *lines, last))


class CommandNotFound(Fault):
    """The shell does not find ``ros2``.

    Kinds: ``unsourced`` (no line that sources ROS), ``wrong_file`` (the line names a distribution that is not there),
    ``overwritten`` (a later line throws the PATH away).
    """

    name, title = 'no_ros2', 'ros2: command not found'
    kinds = ('unsourced', 'wrong_file', 'overwritten')
    machine = 'home'

    def plan(self) -> None:
        draw = self.random
        older, path, robot = draw.choice(_OLDER), draw.choice(_PATHS), draw.choice(words.ROBOTS)
        name = f'export ROBOT={robot}\n'
        commented = draw.choice(['', f'# {_ROS}'])
        state = draw.getstate()  # the same harmless lines in both
        lines = {
            'unsourced': (commented, name),
            'wrong_file': (_ROS.replace('jazzy', older), name),
            'overwritten': (_ROS, name, path),
        }[self.kind]
        file = f'{self.machine}/{BASHRC}'
        self.files = {file: bashrc(draw, *lines)}
        draw.setstate(state)
        self.repaired = {file: bashrc(draw, _ROS, name)}
        self.task = 'In a new terminal, ros2 should run. ROS is installed in ~/opt/ros/jazzy.'
        if self.kind == 'overwritten':
            self.diagnose(file, 'PATH', path.strip(), 'no_colcon')
        else:
            self.diagnose(file, 'not sourced')
        if self.kind == 'wrong_file':
            self.diagnose(file, 'other', _ROS.replace('jazzy', older).strip(), 'mixed_distros')

    def prepare(self) -> None:
        self.home(self.machine).install()

    def show_symptom(self) -> None:
        self.run('ros2 pkg prefix rclpy')

    def works(self, timeout: float) -> Verdict:
        status, _ = self.ask('ros2 pkg prefix rclpy')
        return Verdict(status == 0, f'ros2 {"runs" if status == 0 else "does not run"} in a new terminal')


class NoColcon(Fault):
    """The shell finds ``ros2``, but not ``colcon``, which is installed elsewhere.

    Kinds: ``missing`` (its folder is not on the PATH), ``misspelt`` (another folder is), ``overwritten`` (a later line
    throws the PATH away).
    """

    name, title = 'no_colcon', 'colcon: command not found'
    kinds = ('missing', 'misspelt', 'overwritten')
    machine = 'home'

    def plan(self) -> None:
        draw = self.random
        self.tools = draw.choice(_TOOLS)
        parent, _, last = self.tools.rpartition('/')
        right = f'export PATH="$HOME/{self.tools}:$PATH"\n'
        wrong = f'export PATH="$HOME/{parent}/{words.misspelt(last, draw)}:$PATH"\n'
        over = f'export PATH="$HOME/opt/ros/jazzy/bin:{draw.choice(["/usr/bin:/bin", "$HOME/bin:/usr/bin:/bin"])}"\n'
        state = draw.getstate()  # the same harmless lines in both
        lines = {'missing': (_ROS,), 'misspelt': (_ROS, wrong), 'overwritten': (_ROS, right, over)}[self.kind]
        file = f'{self.machine}/{BASHRC}'
        self.files = {file: bashrc(draw, *lines)}
        draw.setstate(state)
        self.repaired = {file: bashrc(draw, _ROS, right)}
        self.task = 'In a new terminal, colcon build should build the workspace ~/ros2_ws, and ros2 should run, too.'
        cause, line = {'missing': ('missing', ''), 'misspelt': ('name', wrong), 'overwritten': ('PATH', over)}[
            self.kind
        ]
        self.diagnose(file, cause, line.strip())
        self.facts = {'folder': self.tools}

    def prepare(self) -> None:
        self.home(self.machine).install_apart({'colcon': self.tools})
        (self.path / self.machine / 'ros2_ws' / 'src').mkdir(parents=True)

    def show_symptom(self) -> None:
        self.run('cd ros2_ws\ncolcon build')

    def works(self, timeout: float) -> Verdict:
        status, _ = self.ask('command -v ros2 && cd ros2_ws && colcon build')
        return Verdict(status == 0, f'colcon {"builds" if status == 0 else "does not build"} in a new terminal')
