"""The tests' side of workspaces: a test has files written, built and run on the learner's side, and reads what came.

    ws = learner.workspace({'src/greeter/setup.py': learner.text('GREETER_SETUP'), ...})
    ws.build()                                        # once per session for the same files, however many tests ask
    done = ws.run('ros2', 'run', 'greeter', 'hello')
    expect(done.status == 0, done.output)

Nothing of the learner's is built or run on the tests' side.
"""

import hashlib
import json
import re
import shlex
from dataclasses import dataclass
from pathlib import Path, PurePosixPath

from helpers.runner import values
from helpers.runner.text import clean
from helpers.runner.verdicts import InvalidProgram, LearnerCrashed, LearnerFault, LearnerTimeout

BUILD_TIMEOUT = 90.0  # seconds
RUN_TIMEOUT = 20.0
OUTPUT = 32 * 2**10  # bytes that are kept, the last ones
MAX_TEXT = 64 * 2**10  # characters of a file of the learner's


@dataclass(frozen=True)
class Done:
    """A command that has ended: exit status and output (stdout and stderr as they came)."""

    command: str
    status: int
    output: str

    @property
    def lines(self) -> list[str]:
        """The lines of its output that are not empty, without spaces around them."""
        return [line.strip() for line in self.output.splitlines() if line.strip()]

    @property
    def last_line(self) -> str:
        """The last line that tells something: where Python and the tools put the error."""
        telling = [line for line in self.lines if not line.startswith('[ros2run]')]
        return telling[-1][:300] if telling else ''


def package(folder: Path) -> dict[str, str]:
    """The text files of a package's folder, as `workspace` wants them: below `src`."""
    return {f'src/{folder.name}/{path.relative_to(folder).as_posix()}': path.read_text()
            for path in sorted(folder.rglob('*')) if path.is_file() and '__pycache__' not in path.parts}


class Workspace:
    """A workspace on the learner's side. Made by `learner.workspace`."""

    def __init__(self, process, title: str, name: str, cache: dict):
        """`cache`: what was written and built in this session."""
        self._process, self._title, self._name, self._cache = process, title, name, cache
        self.transcript: list[str] = []  # what a learner may read of it

    def build(self, *arguments: str, check: bool = True) -> Done:
        """`colcon build` with these arguments; the same build of the same files is done once in a session.

        :param check: fail the test if it does not succeed, with the reason in the message.
        """
        key = (self._name, *arguments)
        if key not in self._cache:
            self._cache[key] = self._run(['colcon', 'build', '--event-handlers', 'console_cohesion+', *arguments],
                                         BUILD_TIMEOUT)
        done = self._cache[key]
        if check and done.status != 0:
            raise LearnerFault(f'colcon build failed: {reason(done.output)}', clean(done.output, 6000))
        return done

    def run(self, *argv: str, timeout: float = RUN_TIMEOUT) -> Done:
        """A command in a new terminal in which the workspace is sourced, if it is built.

        A command that does not end in `timeout` seconds fails the test with the verdict timeout.
        """
        return self._run(list(argv), timeout)

    def installed(self) -> list[str]:
        """The files below `install`, sorted."""
        answer = self._process.ask('listing', 20.0, folder=f'{self._name}/install')
        return [str(name) for name in answer.get('files') or ()]

    def _run(self, argv: list[str], timeout: float) -> Done:
        shown = shlex.join(argv)
        answer = self._process.ask('run', timeout + 20, argv=argv, folder=self._name, timeout=timeout, keep=OUTPUT)
        output = str(answer.get('output', ''))
        self.transcript.append(f'$ {shown}\n{output}')
        status = answer.get('status')
        if status is None:
            raise LearnerTimeout(f'`{shown}` did not end within {timeout:g} s.', clean(output, 6000))
        if not isinstance(status, int):
            raise LearnerCrashed('Your program disturbed its connection to the tests (a status that is no number).')
        return Done(shown, status, output)


class Workspaces:
    """What `Learner` can do with files and commands; a base of it."""

    def value(self, name: str):
        """What the learner's cell binds to `name`; values as in `learner.call`."""
        answer = self.command_process().ask('value', self.timeouts.call, name=name)
        try:
            return values.decode(answer.get('result'))
        except ValueError as error:
            raise LearnerCrashed(f'`{name}` is {error}.') from None

    def text(self, name: str) -> str:
        """The text that the learner's cell binds to `name`, without empty lines at its beginning."""
        found = self.value(name)
        if not isinstance(found, str):
            raise InvalidProgram(f'`{name}` must be a text, the contents of a file.')
        if len(found) > MAX_TEXT:
            raise InvalidProgram(f'`{name}` is longer than {MAX_TEXT} characters.')
        return found.lstrip('\n')

    def workspace(self, files: dict[str, str]) -> Workspace:
        """A workspace with these text files (path below the workspace -> text) on the learner's side.

        The same files give the same workspace for all tests of a session, with what is built in it.
        """
        for name in files:
            if PurePosixPath(name).is_absolute() or '..' in PurePosixPath(name).parts:
                raise ValueError(f'{name!r} is not inside of a workspace')
        title = self.program['title']
        digest = hashlib.sha256(json.dumps([title, files], sort_keys=True).encode()).hexdigest()
        name, cache = f'ws_{digest[:16]}', self.server.workspaces
        process = self.command_process()
        if name not in cache:
            process.ask('files', self.timeouts.call, folder=name, files=files)
            cache[name] = True
        found = Workspace(process, title, name, cache)
        self.transcripts.append(found.transcript)
        return found


_CMAKE = re.compile(r'CMake Error[^\n]*\n((?:\s*\n|  [^\n]*\n)+)')
_TELLING = re.compile(r'^.*(?:[Ee]rror\b|No such file|not found).*$', re.MULTILINE)


def reason(output: str) -> str:
    """The part of a failed build's output that says why, in one line."""
    if found := _CMAKE.search(output):
        paragraph = ' '.join(found[1].split('Call Stack')[0].split())
        return paragraph[:400]
    if 'setup() was never called' in output or "setup()' was never called" in output:
        return ('setup.py did not get as far as setup(): one of its arguments cannot be read. Run `python3 setup.py '
                '--version` in the folder of the package to see which.')
    # The tools' own tracebacks and command lines are long and tell nothing.
    telling = [line for line in _TELLING.findall(output) if 'CalledProcessError' not in line and len(line) < 400]
    return (telling[-1] if telling else (output.strip().splitlines() or ['it printed nothing'])[-1]).strip()[:400]
