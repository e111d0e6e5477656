"""Child processes of a kernel: programs beside the notebook whose output can be read, and which end with the kernel."""

import atexit
import os
import pty
import shlex
import shutil
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Mapping, Sequence
from contextlib import contextmanager

from helpers import process_tree
from helpers.kernel import journal

#: What a terminal sends for the keys that have no letter.
KEYS = {'up': '\x1b[A', 'down': '\x1b[B', 'right': '\x1b[C', 'left': '\x1b[D', 'enter': '\n'}

_SHOWN = 10  # lines of output in an error text
_children: list['BackgroundProcess'] = []
_reaper: subprocess.Popen | None = None
_process = os.getpid()


def background(
    argv: Sequence[str] | str,
    *,
    env: Mapping[str, str] | None = None,
    cwd=None,
    echo: bool = False,
    terminal: bool = False,
    name: str | None = None,
) -> 'BackgroundProcess':
    """Start a command as a child process and return its handle.

    ::

        with background(['ros2', 'run', 'demo_nodes_py', 'talker']) as talker:
            talker.wait_for_output('Publishing')

    It has a process group of its own. It ends with ``stop()``, with the block, or with the kernel, also a killed one.
    In a kernel it replaces the same command in the same folder that an earlier cell run left running.

    :param argv: the command and its arguments, or one string that is split as a shell would.
    :param env: variables to add to the environment.
    :param cwd: folder to run in.
    :param echo: print each line as it comes.
    :param terminal: give it a terminal of its own (a pseudo-terminal), on which its `type` presses keys; otherwise
        it has nothing to read.
    :param name: what messages call it; the command, if there is none.
    :raises FileNotFoundError: there is no such command.
    """
    argv = shlex.split(argv) if isinstance(argv, str) else [str(part) for part in argv]
    for child in _children.copy():
        if child.made_in < journal.number() and (child.argv, child.cwd) == (argv, cwd):
            child.stop()
    return BackgroundProcess(argv, env, cwd, echo, terminal, name)


class BackgroundProcess:
    """A running child process; made by `background`."""

    def __init__(self, argv, env=None, cwd=None, echo=False, terminal=False, name=None):
        self.argv = argv
        self._name = shlex.join(argv) if name is None else name
        self.cwd = cwd
        self.made_in = journal.number()  # the cell run
        self.lines: list[str] = []  #: output so far (stdout and stderr together), without line ends
        self._news = threading.Condition()
        self._echo = echo
        self._closed = False
        self._keyboard: int | None = None  # the file descriptor of our side of its terminal
        if terminal:
            self._keyboard, end = pty.openpty()
        try:
            with _interruptible():
                self._popen = subprocess.Popen(
                    argv,
                    stdin=end if terminal else subprocess.DEVNULL,
                    stdout=end if terminal else subprocess.PIPE,
                    stderr=subprocess.STDOUT,
                    start_new_session=True,
                    env={**os.environ, 'PYTHONUNBUFFERED': '1', **(env or {})},
                    cwd=cwd,
                )
        except (FileNotFoundError, PermissionError) as error:
            if terminal:
                os.close(self._keyboard)
            if cwd is not None and not os.path.isdir(cwd):
                raise FileNotFoundError(f'there is no folder {cwd}: run the cells above that make it') from None
            # A folder of PATH that may not be read is an error of permissions, too.
            if isinstance(error, PermissionError) and shutil.which(argv[0]):
                raise
            raise FileNotFoundError(f'no command {argv[0]!r}: check its spelling and the PATH') from None
        finally:
            if terminal:
                os.close(end)
        _children.append(self)
        tell_reaper(f'+{self._popen.pid}')
        self._reader = threading.Thread(target=self._read, daemon=True, name=f'output of {argv[0]}')
        self._reader.start()

    @property
    def pid(self) -> int:
        """The process id."""
        return self._popen.pid

    @property
    def returncode(self) -> int | None:
        """Exit status; negative is the signal that ended it; None while it runs."""
        return self._popen.poll()

    @property
    def running(self) -> bool:
        """Whether the process runs."""
        return self.returncode is None

    @property
    def output(self) -> str:
        """The output so far as one text."""
        return '\n'.join(self.lines)

    def wait_for_output(self, text: str | Callable[[str], bool], timeout: float = 10.0) -> str:
        """Wait for a line that contains ``text`` (or for which ``text(line)`` is true), and return it.

        Lines that came earlier count.

        :param timeout: seconds.
        :raises TimeoutError: no such line in time.
        :raises RuntimeError: the process ended without such a line; shows its exit status and last lines.
        """
        matches = text if callable(text) else lambda line: text in line
        deadline = time.monotonic() + timeout
        seen = 0
        with self._news:
            while True:
                while seen < len(self.lines):
                    seen += 1
                    if matches(self.lines[seen - 1]):
                        return self.lines[seen - 1]
                left = deadline - time.monotonic()
                if self._closed:
                    raise RuntimeError(f'{self._name} ended{self._status()} before it printed {text!r}{self._tail()}')
                if left <= 0:
                    raise TimeoutError(f'{self._name} did not print {text!r} in {timeout:g} s{self._tail()}')
                self._news.wait(left)

    def type(self, keys: str) -> None:
        """Press keys on its terminal: letters, or names from `KEYS` such as ``'up'``.

        :raises RuntimeError: it was started without ``terminal=True``, or has ended.
        """
        with self._news:
            if self._keyboard is None:
                raise RuntimeError(f'{self._name} has no terminal (any more): start it with terminal=True')
            os.write(self._keyboard, KEYS.get(keys, keys).encode())

    def stop(self, timeout: float = 10.0) -> int:
        """End the process and all that it started: SIGINT, and SIGKILL after ``timeout`` seconds; idempotent.

        :return: its exit status.
        """
        if self.running:
            self._signal(signal.SIGINT)
            try:
                self._popen.wait(timeout)
            except subprocess.TimeoutExpired:
                process_tree.kill_family(self._popen.pid)
        process_tree.kill_group(self._popen.pid)  # what it has left there
        status = self._popen.wait()
        self._reader.join(5.0)  # to the end of its output; only a process outside of the group may still have it open
        tell_reaper(f'-{self._popen.pid}')
        if self in _children:
            _children.remove(self)
        return status

    def __enter__(self) -> 'BackgroundProcess':
        return self

    def __exit__(self, kind, error, tb) -> None:
        self.stop()

    def __repr__(self) -> str:
        state = 'running' if self.running else f'ended{self._status()}'
        return f'<{self._name}: {state}, {len(self.lines)} lines>'

    def _status(self) -> str:
        try:
            return f' with status {self._popen.wait(1.0)}'
        except subprocess.TimeoutExpired:
            return ''

    def _tail(self) -> str:
        if not self.lines:
            return '; it printed nothing'
        return '; its last lines:\n' + '\n'.join(f'    {line}' for line in self.lines[-_SHOWN:])

    def _read(self) -> None:
        descriptor = self._popen.stdout.fileno() if self._keyboard is None else self._keyboard
        with open(descriptor, encoding='utf-8', errors='replace', closefd=False) as stream:
            for line in _lines(stream):
                with self._news:
                    self.lines.append(line)
                    self._news.notify_all()
                if self._echo:
                    print(line, flush=True)
        with self._news:
            self._closed = True
            if self._keyboard is None:
                self._popen.stdout.close()
            else:
                os.close(self._keyboard)
                self._keyboard = None
            self._news.notify_all()

    def _signal(self, number: int) -> None:
        try:
            os.killpg(self._popen.pid, number)
        except (ProcessLookupError, PermissionError):
            pass


def _lines(stream):
    """Yield the lines of a stream without their ends. The end of a terminal is an error, EIO, on Linux."""
    try:
        for line in stream:
            yield line.rstrip('\n')
    except OSError:
        pass


@contextmanager
def _interruptible():
    """While a child is born do not ignore SIGINT, as a program in the background of a shell does: that is inherited."""
    ignored = signal.getsignal(signal.SIGINT) is signal.SIG_IGN
    if not ignored or threading.current_thread() is not threading.main_thread():
        yield
        return
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, signal.SIG_IGN)


def tell_reaper(line: str) -> None:
    """Tell the reaper (`helpers.programs.reaper`) which process groups must not outlive this process."""
    global _reaper
    if _reaper is None or _reaper.poll() is not None:
        script = os.path.join(os.path.dirname(__file__), 'reaper.py')
        _reaper = subprocess.Popen(
            [sys.executable, '-I', '-S', script], stdin=subprocess.PIPE, start_new_session=True, text=True, bufsize=1
        )
    try:
        _reaper.stdin.write(line + '\n')
        _reaper.stdin.flush()
    except BrokenPipeError:
        pass


@atexit.register
def _at_exit() -> None:
    if os.getpid() != _process:  # a forked child owns none of this
        return
    for child in _children:
        child._signal(signal.SIGINT)
    for child in _children.copy():
        child.stop(timeout=1.0)
    if _reaper is not None:
        _reaper.stdin.close()
        _reaper.wait()
