"""A workspace of the notebook's own: a folder in which colcon and ros2 run, one new terminal after the other."""

import os
import re
import shlex
import shutil
import time
from contextlib import contextmanager
from pathlib import Path

from helpers.exercises import file_answers, file_parts
from helpers.kernel import journal
from helpers.programs import terminals
from helpers.programs.belongings import Belongings
from helpers.programs.processes import BackgroundProcess, background

_PATIENCE = 1.5  # seconds until a build shows how far it is
_SILENCE = 20.0  # seconds without a new line until a person is told what the command may wait for
_WAITS = (
    f'… {_SILENCE:.0f} s without a new line. If the command waits for another program, stop it (■), and run the cell '
    'that starts that program.'
)
_LOG_LINES = 20  # of a failed package
# Commands of the lesson that write files. During others, which may take long, somebody may work in an editor.
_WRITES = re.compile(r'pkg create|\b(mkdir|touch|cp|mv|rm|ln|sed|tee)\b|--fix|(?<![0-9&])>')


class BuildError(RuntimeError):
    """A build failed; its log is printed above."""


class Workspace:
    """A folder with packages in ``src``. Commands are printed as you would type them, with their output.

    ::

        ws = Workspace('ros2_ws')
        ws.reset()
        ws.run('ros2 pkg list')
    """

    def __init__(self, path='ros2_ws', env=None):
        """:param path: the folder; a relative one is beside the notebook.
        :param env: variables to add to the environment of its terminals.
        """
        self.path = Path(path).absolute()
        self.env = dict(env or {})
        self._belongings = Belongings(self.path)

    def reset(self) -> None:
        """Make it new: an empty ``src``, no ``build``, ``install`` and ``log``.

        What you made or changed yourself, in a terminal, an editor or a cell of your own, is moved into a folder
        beside it: packages, and files and folders beside ``src``, such as a recording.

        :raises FileExistsError: the folder was not made by a `Workspace`; nothing is touched.
        """
        defaults = self.path / terminals.DEFAULTS
        if self.path.exists() and any(self.path.iterdir()) and not defaults.is_file():
            raise FileExistsError(f'{self.path} is not a workspace of this course: move it away, or give another name')
        kept = self._belongings.keep()
        if kept:
            names = ', '.join(sorted(path.name for path in kept.iterdir()))
            print(f'What you made or changed in {self.path.name} is kept: {names}, now in {kept}')
        shutil.rmtree(self.path, ignore_errors=True)
        self._make()

    def write(self, path: str | Path, text: str) -> None:
        """Write a file; ``path`` begins at the workspace's folder. A first empty line of the text is left out.

        :raises ValueError: ``path`` leads out of the workspace.
        """
        file = (self.path / path).resolve()
        if self.path.resolve() not in file.parents:
            raise ValueError(f'{path} is not inside of {self.path.name}')
        text = text.removeprefix('\n')
        self._make()
        self._keep_files({str(file.relative_to(self.path.resolve())): text.encode()})
        with self._lesson():
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(text)

    def add(self, package) -> None:
        """Copy the files of a package's folder into a package of its name in ``src``; other files in there stay.

        :raises FileNotFoundError: there is no such folder.
        """
        package = Path(package)
        if not package.is_dir():
            raise FileNotFoundError(f'there is no package {package}')
        self._make()
        target = self.path / 'src' / package.name
        files = [path for path in package.rglob('*') if path.is_file() and '__pycache__' not in path.parts]
        self._keep_files({f'src/{package.name}/{path.relative_to(package)}': path.read_bytes() for path in files})
        with self._lesson():
            shutil.copytree(package, target, ignore=shutil.ignore_patterns('__pycache__'), dirs_exist_ok=True)

    def start(self, script: str) -> BackgroundProcess:
        """Start commands in a new terminal and return at once; the handle is that of `helpers.background`."""
        return self._start(script, shown=False)

    def run(self, script: str) -> None:
        """Run commands, one a line, in a new terminal whose folder is the workspace; shows them and their output."""
        with self._lesson(bool(_WRITES.search(script))):
            silence = _Silence()
            status = self._finish(self._start(script), silence.look)
            silence.end()
        if status:
            print(f'[exit status {status}]')

    def build(self, *arguments: str) -> None:
        """Run ``colcon build`` with these arguments; shows how far it is, and the log if it fails.

        :raises BuildError: a package was not built.
        """
        progress = _Progress(self.path / 'log' / 'latest_build')
        status = self._finish(self._start(' '.join(['colcon build', *arguments])), lambda _: progress.show())
        progress.end()
        if status:
            _show_logs(self.path)
            raise BuildError('colcon build failed; the reason stands above')

    def tree(self, folder: str = '.', depth: int = 9) -> None:
        """Print the folders and files below ``folder``, without caches."""
        top = self.path / folder
        if not top.is_dir():
            raise FileNotFoundError(f'there is no folder {top} yet: run the cells above that make it')
        print(f'{top.name}/')
        _tree(top, '', depth)

    def _make(self) -> None:
        """Make the folder if it is not there: cells may be run before the one with `reset`."""
        if not self.path.exists():
            (self.path / 'src').mkdir(parents=True)
            (self.path / terminals.DEFAULTS).write_text(terminals.colcon_defaults())

    def _keep_files(self, new: dict[str, bytes]) -> None:
        """Before the lesson writes these files: copies of those which the learner has changed."""
        if kept := self._belongings.keep_files(new, _texts_of_cells()):
            names = ', '.join(sorted(str(path.relative_to(kept)) for path in kept.rglob('*') if path.is_file()))
            print(f'What you had changed in {self.path.name} is kept: {names}, a copy is now in {kept}')

    @contextmanager
    def _lesson(self, writes: bool = True):
        """What is made meanwhile is the lesson's, unless the cell that runs is the learner's own."""
        before = self._belongings.now()
        try:
            yield
        finally:
            if self.path.is_dir():
                if not writes or journal.in_own_cell():
                    before = self._belongings.now()
                self._belongings.note(before, _texts_of_cells())

    def _start(self, script: str, shown: bool = True) -> BackgroundProcess:
        if not self.path.is_dir():
            raise FileNotFoundError(f'there is no folder {self.path}: call reset() first')
        lines = [line.strip() for line in script.strip().splitlines()]
        name = lines[-1].removeprefix('exec ') if lines else ''
        if shown:  # each line before it is run, as on a screen
            lines = [part for line in lines for part in (f'echo {shlex.quote("$ " + line)}', line)]
            # The stop button ends the whole script: bash itself would go on after a program that ends well on Ctrl+C.
            lines.insert(0, "trap 'exit 130' INT")
        environment = {'COLCON_DEFAULTS_FILE': str(self.path / terminals.DEFAULTS), **self.env}
        return background(self._terminal('\n'.join(lines)), env=environment, cwd=self.path, name=name)

    def _terminal(self, script: str) -> list[str]:
        """The command that runs a script in a new terminal."""
        # Variables that belong to the kernel's own Python, or that make tools print colours though it is no terminal.
        return [
            'env',
            '-u',
            'PYTHONDONTWRITEBYTECODE',
            '-u',
            '_ROS_WHEELS_BOOTSTRAP_COMPLETE',
            '-u',
            'FORCE_COLOR',
            '-u',
            'CLICOLOR_FORCE',
            *terminals.shell(script),
        ]

    @staticmethod
    def _finish(process: BackgroundProcess, meanwhile) -> int:
        """Print what comes until the process ends, calling `meanwhile` with it; return its exit status."""
        shown, running = 0, True
        with process:
            while running:
                try:
                    process.wait_for_output(lambda line: False, timeout=0.2)
                except TimeoutError:
                    pass
                except RuntimeError:  # it has ended
                    running = False
                for line in process.lines[shown:]:
                    print(line)
                    shown += 1
                meanwhile(process)
        return process.returncode


def _texts_of_cells() -> list[str]:
    """What cells of this kernel have written into files by `%%writefile`, `%%writefile -a` and `%%answer`."""
    written = [f'{text.rstrip()}\n' for text in file_parts.written().values()]
    return [*written, *(text for cell in journal.cells for _, _, text, _ in file_answers.files(cell.source))]


class _LineBelow:
    """A line below the output of a cell that runs, in a notebook; it changes, and goes at the end."""

    def __init__(self):
        self._display = None

    def show(self, line: str) -> None:
        if not journal.in_kernel():
            return
        if self._display is None:
            from IPython.display import display

            self._display = display({'text/plain': line}, raw=True, display_id=True)
        else:
            self._display.update({'text/plain': line}, raw=True)

    def end(self) -> None:
        if self._display is not None:
            self._display.update({'text/plain': ''}, raw=True)


class _Progress:
    """Below a build that takes longer: the seconds so far, and the newest line of the log."""

    def __init__(self, log: Path):
        self.log = log
        self._begin = time.monotonic()
        self._below = _LineBelow()

    def show(self) -> None:
        seconds = time.monotonic() - self._begin
        if seconds >= _PATIENCE:
            self._below.show(f'… {seconds:.0f} s   {_newest_line(self.log)}')

    def end(self) -> None:
        self._below.end()


class _Silence:
    """Below a command that prints nothing for long: what it may wait for, as ROS's own commands wait without end."""

    def __init__(self):
        self._lines, self._since = 0, time.monotonic()
        self._below = _LineBelow()

    def look(self, process: BackgroundProcess) -> None:
        now = time.monotonic()
        if len(process.lines) != self._lines:
            self._lines, self._since = len(process.lines), now
            self._below.end()
        elif now - self._since > _SILENCE and journal.cells and journal.cells[-1].id:  # not where nbval compares
            self._below.show(_WAITS)

    def end(self) -> None:
        self._below.end()


def _newest_line(log: Path) -> str:
    """The last line of the newest log of a package, at most 80 characters."""
    logs = sorted(log.glob('*/stdout_stderr.log'), key=lambda path: path.stat().st_mtime)
    lines = logs[-1].read_text(errors='replace').splitlines() if logs else []
    return f'{logs[-1].parent.name}: {lines[-1][:80]}' if lines else ''


def _show_logs(workspace: Path) -> None:
    """Print the end of what the tools of a failed package printed on stdout; colcon itself shows their stderr."""
    for status in sorted(workspace.glob('build/*/colcon_build.rc')):
        log = workspace / 'log' / 'latest_build' / status.parent.name / 'stdout.log'
        lines = log.read_text(errors='replace').splitlines() if log.is_file() else []
        if status.read_text().strip() != '0' and lines:
            print(f'--- {log.relative_to(workspace)} ends so:', *lines[-_LOG_LINES:], sep='\n')


def _tree(folder: Path, indent: str, depth: int) -> None:
    entries = sorted(
        path
        for path in folder.iterdir()
        if not path.name.startswith('.') and path.name not in ('__pycache__', terminals.DEFAULTS)
    )
    for entry in entries:
        branch, trunk = ('└── ', '    ') if entry == entries[-1] else ('├── ', '│   ')
        inside = entry.is_dir() and not entry.is_symlink()
        print(f'{indent}{branch}{entry.name}{"/" if inside else ""}{_target(entry)}')
        if inside and depth > 1:
            _tree(entry, indent + trunk, depth - 1)


def _target(path: Path) -> str:
    return f' -> {os.readlink(path)}' if path.is_symlink() else ''
