"""Cells of another language, `%%bash` and its sisters: the stop button ends their programs, and leaves none behind.

IPython alone signals the shell only, waits for 0.1 s, and gives up: what the shell has started goes on, and a program
that needs longer for its end, as a node of ROS does, is told so twice. Here the cell's program has a process group of
its own. The stop button sends SIGINT to all of it, once, and SIGTERM to what ignores that; what is left after a bounded
wait, or at the second press, is killed.
"""

import codecs
import os
import selectors
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from helpers import process_tree
from helpers.kernel import journal
from helpers.programs import processes

PATIENCE = 5.0  # seconds that a program has for its end after the stop button
_SHELLS = {'bash', 'dash', 'ksh', 'sh', 'zsh'}


def register() -> None:
    """Let the script cells of this process's IPython run here from now on; idempotent."""
    shell = journal.shell()
    if shell is None:
        return
    try:
        magics = shell.magics_manager.registry['ScriptMagics']  # not `get`: IPython loads it when it is asked for
    except KeyError:
        return
    if 'shebang' in vars(magics):
        return
    stock = magics.shebang

    def shebang(line, cell):
        given, command = stock.parser.parse_known_args(_split(line))
        if given.bg or not command:
            return stock(line, cell)
        return _run(shell, given, command, cell)

    shebang.parser = stock.parser
    magics.shebang = shebang  # which %%bash and the others call
    shell.register_magic_function(shebang, 'cell', 'script')


def _split(line: str) -> list[str]:
    from IPython.utils.process import arg_split

    return arg_split(line)


def _run(shell, given, command: list[str], cell: str) -> None:
    """Run a cell's text by a command, and show or keep what it prints.

    :raises KeyboardInterrupt: the stop button was pressed.
    :raises CalledProcessError: the command ended with another status than 0.
    """
    text = (cell if cell.endswith('\n') else f'{cell}\n').encode('utf8', 'replace')
    for name in filter(None, (given.out, given.err)):
        shell.user_ns[name] = ''
    # Not a pipe: a long text would have to be written while the program's output is read.
    with tempfile.TemporaryFile() as script:
        script.write(text)
        script.seek(0)
        try:
            program = subprocess.Popen(
                command, stdin=script, stdout=subprocess.PIPE, stderr=subprocess.PIPE, start_new_session=True
            )
        except FileNotFoundError:
            print(f"Couldn't find program: {command[0]!r}")
            return
    with program.stdout, program.stderr:
        output = _Output(shell, {program.stdout: (given.out, sys.stdout), program.stderr: (given.err, sys.stderr)})
        try:
            processes.tell_reaper(f'+{program.pid}')
            output.read()
            program.wait()
        except KeyboardInterrupt:
            _end(program, output)
            if given.raise_error:
                raise KeyboardInterrupt from None
            return
        finally:
            processes.tell_reaper(f'-{program.pid}')
    if given.raise_error and program.returncode:
        raise subprocess.CalledProcessError(program.returncode, text)


class _Output:
    """What a program prints, on its way into the notebook or into variables."""

    def __init__(self, shell, targets: dict):
        self._shell = shell
        self._selector = selectors.DefaultSelector()
        for stream, (name, file) in targets.items():
            decoder = codecs.getincrementaldecoder('utf-8')(errors='replace')
            self._selector.register(stream, selectors.EVENT_READ, (decoder, name, file))

    def read(self, seconds: float | None = None) -> None:
        """Pass on what comes, for so long, or until everybody who can print has ended; at least what is there."""
        end = None if seconds is None else time.monotonic() + seconds
        while self._selector.get_map():
            left = None if end is None else end - time.monotonic()
            ready = self._selector.select(None if left is None else max(0.0, left))
            for key, _ in ready:
                decoder, name, file = key.data
                data = os.read(key.fd, 65536)
                if not data:
                    self._selector.unregister(key.fileobj)
                text = decoder.decode(data, final=not data)
                if name:
                    self._shell.user_ns[name] += text
                elif text:
                    file.write(text)
                    file.flush()
            if left is not None and left <= 0:
                return


def _end(program: subprocess.Popen, output: _Output) -> None:
    """End a program and all that it has started; what it says meanwhile is shown."""
    try:
        _signal(program, signal.SIGINT)
        if Path(program.args[0]).name in _SHELLS:
            program.terminate()  # or the shell goes on with the next line when a program has ended in peace
        for pid in _living(program):
            if _ignores_sigint(pid):  # as what a shell has started with &
                _send(os.kill, pid, signal.SIGTERM)
        end = time.monotonic() + PATIENCE
        while _living(program) and time.monotonic() < end:
            output.read(0.02)
            time.sleep(0.02)  # `read` returns at once when nobody can print any more
    except KeyboardInterrupt:  # pressed again
        pass
    if living := _living(program):
        for pid in living:
            process_tree.kill_family(pid)
        print('The stop button was pressed, and the program did not end: it was killed.', file=sys.stderr)
    program.wait()
    output.read(1.0)  # to the end, unless something outside of the group may still print


def _signal(program: subprocess.Popen, number: int) -> None:
    """Send a signal to the program's process group."""
    _send(os.killpg, program.pid, number)


def _send(send, receiver: int, number: int) -> None:
    try:
        send(receiver, number)
    except (ProcessLookupError, PermissionError):  # it has just ended, or is somebody else's by now
        pass


def _living(program: subprocess.Popen) -> list[int]:
    """What runs in the program's process group. One that has ended and was not waited for does not."""
    program.poll()
    found = []
    for status in Path('/proc').glob('[0-9]*/stat'):
        try:
            state, _, group = status.read_text(errors='replace').rpartition(')')[2].split()[:3]
        except (OSError, ValueError):  # it has just ended
            continue
        if int(group) == program.pid and state not in 'ZX':
            found.append(int(status.parent.name))
    return found


def _ignores_sigint(pid: int) -> bool:
    try:
        lines = Path(f'/proc/{pid}/status').read_text(errors='replace').splitlines()
    except OSError:
        return False
    masks = [int(line.split()[1], 16) for line in lines if line.startswith('SigIgn:')]
    return any(mask >> signal.SIGINT - 1 & 1 for mask in masks)
