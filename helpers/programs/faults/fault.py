"""The base class of all faults: a folder with a small system in it that does not do what it should.

The system is made of ordinary files. ``start.txt`` names the programs, one line for each terminal in
which one runs. Everything runs in child processes below that folder; nothing else on the machine changes.
"""

import atexit
import hashlib
import os
import random
import re
import shlex
import shutil
import signal
import sys
import time
from collections.abc import Iterator
from contextlib import ExitStack
from pathlib import Path

from helpers.kernel import domains
from helpers.programs import terminals
from helpers.programs.faults.finding import Finding, number_of
from helpers.programs.faults.machine import Machine
from helpers.programs.processes import BackgroundProcess, background
from helpers.programs.workspace import Workspace

START = 'start.txt'
# Placeholders in texts: the folder of the system, its domain, and a domain that no program uses.
ROOT, DOMAIN, OTHER = '@ROOT@', '@DOMAIN@', '@OTHER@'
_MARK = '.fault'  # in a folder that a fault has made, and may remove
_SHOWN = 8  # lines of a program
_START = 30.0  # s in which a program prints its first line, on a machine under load
_SETTLE = 5.0  # s in which a program that hangs comes to the place where it does
_STOP = 3.0  # s in which programs end after Ctrl+C; then they are killed
_STACKS = re.compile(r'(Current thread|Thread) 0x|  File "|$')  # the lines that faulthandler prints
_staged: dict[Path, 'Fault'] = {}


class Verdict:
    """Whether a system does what it should. True or false, and a line that says what was seen."""

    def __init__(self, works: bool, seen: str):
        self.works, self.seen = works, seen

    def __bool__(self) -> bool:
        return self.works

    def __repr__(self) -> str:
        return f'{"✓ it works" if self.works else "✗ it does not work"}: {self.seen}'


class Fault:
    """A system with a fault. Made by `helpers.programs.faults.stage`; a subclass for each fault of the chapter.

    A subclass sets, in `plan`, what the system is: ``task``, ``files``, ``diagnosis``; and it says, in `works`, whether
    it does its task. The same name, seed and kind give the same system, on every machine.
    """

    name = ''  #: what the chapter and its findings call it, such as ``'no_data'``
    title = ''  #: the symptom, as somebody would report it
    kinds: tuple[str, ...] = ()  #: the causes it may have
    machine = ''  #: the machine on which commands run; '' is this one
    program = ''  #: the program that `stacks` looks at
    patience = 10.0  # s; the longest time in which a system that works shows it
    grace = 5.0  # s; the longest time in which a program ends that is to be started again; then it is killed

    def __init__(self, seed: int | str = 0, kind: str | None = None, folder=None, domain: int | None = None):
        if kind is not None and kind not in self.kinds:
            raise ValueError(f'{self.name} has no kind {kind!r}: it has {", ".join(self.kinds)}')
        self.seed = seed
        # From the earlier number: a seed draws what it drew before faults had names.
        self.random = random.Random(f'{number_of(self.name)} {seed}')
        drawn = self.random.choice(self.kinds)
        self.kind = kind or drawn  #: the cause that was drawn
        self.path = Path(folder or Path('faults_ws', self.name)).absolute()  #: the folder of the system
        self.env = {} if domain is None else {'ROS_DOMAIN_ID': str(domain)}
        self.task = ''  #: what the system should do, in a sentence
        self.files: dict[str, str] = {}  #: the files as they are staged: path below the folder -> text
        self.repaired: dict[str, str] = {}  #: the files that a repair changes, as they should be
        self._truth: list[Finding] = []
        self.facts: dict = {}  #: more that is true of this system: names of nodes, topics, types
        self.homes: dict[str, Machine] = {}  #: the machines of the system by name
        self.programs: dict[str, BackgroundProcess] = {}  #: running programs by name
        self._other = ''
        self._held = ExitStack()  # the domains that it has claimed
        self._versions: dict[str, str] = {}  # of the running programs
        self._edits: set[tuple[str, str, str]] = set()  # that were made
        self._asked: dict[str, set[int]] = {}  # by program: lines of output that are stacks
        self.plan()

    # What a subclass says.

    def plan(self) -> None:
        """Draw the names and write the system down: ``task``, ``files``, ``repaired``, ``diagnosis``."""
        raise NotImplementedError

    def prepare(self) -> None:
        """Put into the folder the files of the system that the learner does not change."""

    def diagnose(self, where: str, cause: str, evidence: str = '', fault: str = '') -> None:
        """Note a fault of this system, with the words of the exercises' cards; for `plan`.

        :param fault: its name, where the exercises know it by another one than that of this class.
        """
        self._truth.append(Finding(fault or self.name, where, cause, evidence))

    def works(self, timeout: float) -> Verdict:
        """Watch the system for at most ``timeout`` seconds, and say whether it does its task."""
        raise NotImplementedError

    def show_symptom(self) -> None:
        """Print what a user of the system sees."""
        raise NotImplementedError

    # What a learner calls.

    @property
    def diagnosis(self) -> list[Finding]:
        """The truth: a finding for each fault."""
        return self._truth

    def symptom(self) -> None:
        """Run the system, and print what its user sees."""
        self.up()
        self.show_symptom()

    def run(self, script: str, on: str = '') -> None:
        """Run commands, one a line, in a new terminal of this system; shows them and what they print.

        :param on: the machine, where a system has several.
        """
        self.up()
        self.terminal(on).run(script)

    def show(self, file: str) -> None:
        """Print a file of the system.

        :raises FileNotFoundError: there is no such file.
        """
        print(self._read(file).rstrip('\n'))

    def edit(self, file: str, old: str, new: str) -> None:
        """Replace a piece of text in a file, as an editor would. The same edit again changes nothing.

        :raises ValueError: the text is not there, or more than once.
        :raises FileNotFoundError: there is no such file.
        """
        text = self._read(file)
        if (file, old, new) in self._edits and old not in text and new in text:  # the same cell once more
            print(f'{file}: this edit has been made already')
            return
        if text.count(old) != 1:
            raise ValueError(
                f'{file} has {old!r} {text.count(old)} times: give more of the text around it'
                if old in text
                else f'{file} has no {old!r}: fault.show({file!r}) prints it'
            )
        self.write(file, text.replace(old, new))
        self._edits.add((file, old, new))

    def write(self, file: str, text: str) -> None:
        """Write a file of the system; a first empty line of the text is left out.

        :raises ValueError: ``file`` leads out of the system's folder.
        """
        path = self._file(file)
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text.removeprefix('\n'))

    def repair(self) -> None:
        """Repair it as the course would; for tests, and for those who want to see one way."""
        for file, text in self.repaired.items():
            self.write(file, self._fill(text))

    def verify(self, timeout: float | None = None) -> Verdict:
        """Start what has changed again, and say whether the system does its task now.

        :param timeout: seconds to wait for it, after the programs are up.
        """
        self.up()  # `timeout` counts from the moment at which all programs are up
        return self.works(self.patience if timeout is None else timeout)

    def stacks(self, name: str = '') -> None:
        """Print where each thread of a program stands: the newest call first, as ``faulthandler`` does.

        The program must have ``faulthandler.register(signal.SIGUSR1)``.

        :param name: the program; by default the one that the fault is about.
        :raises ValueError: ``start.txt`` starts no such program.
        """
        self.up()
        name = name or self.program
        if name not in self.programs:
            raise ValueError(f'{name or "which program?"}: there run {", ".join(self.programs) or "no programs"}')
        print('\n'.join(self.settled(name)))

    def start(self) -> list[str]:
        """Start the programs of ``start.txt``; those that still run and have not changed go on.

        :return: the names of those that were started now.
        :raises RuntimeError: the system is not staged (any more).
        """
        self._alive()
        wanted = dict(self._commands())
        for name in [
            name
            for name, program in self.programs.items()
            if not program.running or self._version(wanted.get(name)) != self._versions[name]
        ]:
            self.programs.pop(name).stop(timeout=self.grace)
        started = [name for name in wanted if name not in self.programs]
        for name in started:
            self._versions[name], self._asked[name] = self._version(wanted[name]), set()
            self.programs[name] = self._launch(*wanted[name])
        return started

    def stop(self) -> None:
        """End the programs and remove the folder; idempotent."""
        for name in self.programs:  # all at once: each takes a moment to end
            self.signal(name, signal.SIGINT)
        self.watch(
            lambda: not any(program.running for program in self.programs.values()), _STOP, ends=tuple(self.programs)
        )
        for program in self.programs.values():
            program.stop(timeout=0)
        self.programs.clear()
        self.homes.clear()
        self._held.close()
        if _staged.get(self.path) is self:
            del _staged[self.path]
            shutil.rmtree(self.path, ignore_errors=True)
            if (
                self.path.parent.name == 'faults_ws'
                and self.path.parent.is_dir()
                and not any(self.path.parent.iterdir())
            ):
                self.path.parent.rmdir()

    def __enter__(self) -> 'Fault':
        return self

    def __exit__(self, kind, error, tb) -> None:
        self.stop()

    def __repr__(self) -> str:
        files = '\n'.join(f'    {name}' for name in sorted(self.files))
        return f'{self.name}: {self.title}\n{self.task}\nFiles in {_relative(self.path)}:\n{files}'

    # What a subclass uses.

    def terminal(self, on: str = '') -> Workspace:
        """Where commands run: on a machine of the system, or as in a terminal of this one.

        :raises ValueError: the system has no such machine.
        """
        if on and on not in self.homes:
            raise ValueError(f'there is no machine {on!r}: there are {", ".join(self.homes) or "none"}')
        self._alive()
        on = on or self.machine
        return self.homes[on] if on else Workspace(self.path, self.env)

    def ask(self, script: str, timeout: float = 60.0, on: str = '') -> tuple[int, str]:
        """Run commands in a new terminal without showing them; returns exit status and output.

        :raises TimeoutError: they did not end in time.
        """
        with self.terminal(on).start(script) as process:
            try:
                process.wait_for_output(lambda line: False, timeout)
            except RuntimeError:  # it has ended
                return process.returncode, process.output
        raise AssertionError('a process that ended has no status')

    def up(self) -> None:
        """Start what is not running, and wait until each program has printed something, or has ended."""
        if self.start():
            self.watch(
                lambda: all(program.lines or not program.running for program in self.programs.values()),
                _START,
                ends=tuple(self.programs),
            )

    def hangs(self, stacks: list[str]) -> bool:
        """Whether a program with these stacks has come to where it hangs; True if that is not known."""
        return True

    def settled(self, name: str) -> list[str]:
        """The stacks of a program as soon as it `hangs`, the last ones if it does not; or a line that says why not."""
        program = self.programs[name]
        if not program.running:
            return [f'({name} does not run: no stacks)']
        if not self.watch(lambda: _listens(program.pid), _SETTLE, ends=tuple(self.programs)):
            return [f'({name} has no faulthandler.register: no stacks)']
        stacks: list[str] = []

        def stands() -> bool:
            stacks[:] = self._stacks(name)
            return self.hangs(stacks)

        self.watch(stands, _SETTLE, ends=tuple(self.programs), period=0.1)
        return stacks

    def _stacks(self, name: str) -> list[str]:
        before = len(self.lines(name))
        self.signal(name, signal.SIGUSR1)
        # The oldest call of the last thread ends them.
        self.watch(
            lambda: any('in <module>' in line for line in self.lines(name)[before:]), _SETTLE, ends=tuple(self.programs)
        )
        found = {i: line for i, line in enumerate(self.lines(name)) if i >= before and _STACKS.match(line)}
        self._asked[name] |= found.keys()
        return list(found.values())

    def watch(self, seen, timeout: float, ends: tuple[str, ...] = (), period: float = 0.02) -> bool:
        """Wait until ``seen()`` is true, at most ``timeout`` seconds; False if it never was, or a program ended.

        :param ends: programs that may end by themselves.
        :param period: seconds between two looks.
        """
        deadline = time.monotonic() + timeout
        while not seen():
            lost = [name for name, program in self.programs.items() if name not in ends and not program.running]
            if time.monotonic() > deadline or lost:
                return bool(seen())
            time.sleep(period)
        return True

    def show_programs(self) -> None:
        """Print the last lines of each program."""
        for name, program in self.programs.items():
            print(f'--- {name}{"" if program.running else f", ended with status {program.returncode}"}')
            own = [line for i, line in enumerate(program.lines) if i not in self._asked[name]]
            print(*own[-_SHOWN:], sep='\n', end='\n' if own else '')

    def signal(self, name: str, number: int, timeout: float = 0.0) -> bool:
        """Send a signal to a program, and tell whether it has ended ``timeout`` seconds later."""
        program = self.programs[name]
        if program.running:
            os.kill(program.pid, number)
        deadline = time.monotonic() + timeout
        while program.running and time.monotonic() < deadline:
            time.sleep(0.02)
        return not program.running

    def lines(self, name: str) -> list[str]:
        """What a program has printed; nothing if it is not started."""
        return self.programs[name].lines if name in self.programs else []

    def stage(self) -> 'Fault':
        """Write the files into the folder. An earlier fault in it is stopped.

        :raises FileExistsError: the folder was not made by a fault; nothing is touched.
        """
        if self.path in _staged:
            _staged[self.path].stop()
        if self.path.exists() and any(self.path.iterdir()) and not (self.path / _MARK).is_file():
            raise FileExistsError(f'{self.path} is not a fault of this course: move it away, or give another folder')
        shutil.rmtree(self.path, ignore_errors=True)
        self.path.mkdir(parents=True)
        (self.path / _MARK).touch()
        _staged[self.path] = self
        (self.path / terminals.DEFAULTS).write_text(terminals.colcon_defaults())
        self.prepare()
        for file, text in self.files.items():
            self.write(file, self._fill(text))
        self._truth = [found._replace(evidence=self._fill(found.evidence)) for found in self._truth]
        return self

    def home(self, name: str) -> Machine:
        """A machine of the system, in a folder of its name; made when it is first asked for."""
        if name not in self.homes:
            self.homes[name] = Machine(self.path / name, self.env)
            self.homes[name].path.mkdir(parents=True)
            self.homes[name].write(terminals.DEFAULTS, terminals.colcon_defaults())
        return self.homes[name]

    def _commands(self):
        file = self.path / START
        for machine, command in commands(file.read_text() if file.is_file() else ''):
            yield Path(_script(command)).stem, (machine, command)

    def _launch(self, machine: str, command: str) -> BackgroundProcess:
        if machine:
            return self.terminal(machine).start(f'exec {command}')
        argv = shlex.split(command)
        if argv[0] != 'python3':
            return self.terminal().start(f'exec {command}')
        argv[0] = sys.executable
        return background(argv, env=self.env, cwd=self.path)

    def _version(self, program: tuple[str, str] | None) -> str:
        """What a program is made of, as a digest: its line, the files in it, and the settings of its machine."""
        if program is None:
            return ''
        machine, command = program
        digest = hashlib.sha256(repr(program).encode())
        for name in (*shlex.split(command), '.bashrc'):
            file = self.path / machine / name
            digest.update(file.read_bytes() if file.is_file() else b'-')
        return digest.hexdigest()

    def _fill(self, text: str) -> str:
        """Replace the placeholders in a text: the folder, this domain, and another one."""
        here = self.env.get('ROS_DOMAIN_ID') or os.environ.get('ROS_DOMAIN_ID') or '0'
        if OTHER in text and not self._other:
            self._other = str(self._held.enter_context(domains.claim()))
        return text.replace(ROOT, str(self.path)).replace(DOMAIN, here).replace(OTHER, self._other)

    def _alive(self) -> None:
        if not (self.path / _MARK).is_file():
            raise RuntimeError(f'this system is stopped, and its folder is gone: stage it again, {self._again()}')

    def _again(self) -> str:
        """The call that stages this system."""
        return f'faults.stage({self.name!r}, seed={self.seed!r})'

    def _read(self, name: str) -> str:
        if not self._file(name).is_file():
            raise FileNotFoundError(f'the system has no file {name}; it has {", ".join(sorted(self.files))}')
        return self._file(name).read_text()

    def _file(self, name: str) -> Path:
        self._alive()
        path = (self.path / name).resolve()
        if self.path.resolve() not in path.parents:
            raise ValueError(f'{name} is not inside of {self.path.name}')
        return path


def commands(start: str) -> Iterator[tuple[str, str]]:
    """The programs of a start.txt, as (machine, command). A line is ``COMMAND`` or ``MACHINE: COMMAND``."""
    for line in start.splitlines():
        line = line.partition('#')[0].strip()
        if line:
            machine, _, command = line.rpartition(': ')
            yield machine, command


def _script(command: str) -> str:
    """What a command starts: ``python3 lidar.py --ros-args`` -> ``lidar.py``, ``ros2 run tf2_ros tf2_echo`` ->
    ``tf2_echo``.
    """
    parts = shlex.split(command)
    if parts[:2] == ['ros2', 'run']:
        return parts[3]
    return next((part for part in parts if part.endswith('.py')), parts[0])


def _listens(pid: int) -> bool:
    """Whether a process handles the signal USR1. One that does not is ended by it."""
    try:
        status = Path(f'/proc/{pid}/status').read_text()
    except OSError:  # it has ended
        return False
    caught = re.search(r'^SigCgt:\s*([0-9a-f]+)$', status, re.MULTILINE)
    return bool(caught) and bool(int(caught[1], 16) >> (signal.SIGUSR1 - 1) & 1)


def _relative(path: Path) -> str:
    return os.path.relpath(path)


@atexit.register
def stop_all() -> None:
    """End all faults that are staged, and remove their folders."""
    for fault in list(_staged.values()):
        fault.stop()
