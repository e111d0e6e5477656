"""The tests' side of workspaces: a test has files written, built and run on the learner's side, and reads what came.

    ws = learner.workspace({'src/greeter/setup.py': learner.text('GREETER_SETUP'), ...})
    ws.build()                                        # once per session for the same files, however many tests ask
    done = ws.run('ros2', 'run', 'greeter', 'hello')
    expect(done.status == 0, done.output)

Nothing of the learner's is built or run on the tests' side, and nothing where a cell of theirs has run: status and
output of a command are what the fork server and the tests have seen.
"""

import ast
import base64
import json
import os
import re
import secrets
import shlex
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path, PurePosixPath
from typing import Any

from helpers.exercises import package_answers
from helpers.runner import values
from helpers.runner.fork_client import ForkServer, Task
from helpers.runner.load import busy, starved
from helpers.runner.program_process import ProgramProcess
from helpers.runner.text import clean
from helpers.runner.timeouts import Timeouts
from helpers.runner.verdicts import InvalidProgram, LearnerCrashed, LearnerError, LearnerTimeout

BUILD_TIMEOUT = 90.0  # seconds
BUILD_AGAIN = 15.0  # for another build of an exercise of which one has not come to its end
RUN_TIMEOUT = 20.0
PATIENCE = 4  # so many times its timeout is a command waited for while the machine is busy
LISTING = 2**20  # bytes
LISTING_TIMEOUT = WRITE_TIMEOUT = 60.0
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
        return last_line(self.output)

    @property
    def where(self) -> str:
        """Where a Python program of the workspace ended, as in 'in report.py, line 6, '; '' if that is not known."""
        frames = _FRAME.findall(self.output.rpartition('Traceback (most')[2]) if self.status else []
        own = [(path, line) for path, line in frames if '/install/' in path or '/src/' in path]
        return f'in {PurePosixPath(own[-1][0]).name}, line {own[-1][1]}, ' if own else ''


def _of_data_files(output: str) -> str:
    """What is wrong with data_files in setup.py, of which colcon says only AssertionError; '' for another fault."""
    found = _DATA_FILES.search(output)
    if not found:
        return ''
    if 'isabs' in found[1]:
        return (
            'A path of data_files in setup.py begins with a slash. Write it without: share/… is below the installation.'
        )
    return (
        'data_files in setup.py is a list of pairs, of a folder and a list of files, such as '
        "('share/NAME', ['package.xml'])."
    )


def last_line(output: str) -> str:
    """The last line that tells something, of an exception its first one; '' if nothing was printed."""
    lines = [line.rstrip() for line in output.splitlines() if line.strip(' ^~')]
    telling = [line for line in lines if not line.startswith('[ros2run]')]
    if not telling:
        return ''
    # Of an exception some lines may follow, such as a name with a mark below the letter that is wrong.
    raised = [line for line in telling if _RAISED.match(line)]
    last = raised[-1] if raised and telling[-1][0].isspace() else telling[-1]
    return last.strip()[:300]


def package(folder: Path) -> dict[str, str]:
    """The text files of a package's folder, as `workspace` wants them: below `src`."""
    return {
        f'src/{folder.name}/{path.relative_to(folder).as_posix()}': path.read_text()
        for path in sorted(folder.rglob('*'))
        if path.is_file() and '__pycache__' not in path.parts
    }


class ExerciseWorkspace:
    """A workspace in a place of its own, where no cell of the learner's has run. Made by `learner.workspace`."""

    def __init__(self, learner, name: str, packages: Iterable[str] = ()):
        """`packages`: those whose sources were written there."""
        self._learner, self.name, self._packages = learner, name, sorted(packages)
        self._cache = learner.server.workspaces  # what was written and built in this session
        self.transcript: list[str] = []  # what a learner may read of it

    @property
    def path(self) -> str:
        """Where it is, for those in its place."""
        return f'{self._learner.server.home}/{self.name}'

    def build(self, *arguments: str, check: bool = True) -> Done:
        """`colcon build` with these arguments; the same build of the same files is done once in a session.

        :param check: fail the test if it does not succeed, with the reason in the message.

        All builds of an exercise that do not come to their end take little longer together than one of them.
        """
        key, shadows = (self.name, *arguments), (self.name, 'shadows', *arguments)
        if key not in self._cache:
            hanging = self._cache.setdefault(('hanging', self._learner.program['title']), [])
            try:
                if len(hanging) > 1:
                    raise hanging[0]
                timeout = BUILD_AGAIN if hanging else BUILD_TIMEOUT
                self._cache[key] = self._run(
                    ('colcon', 'build', '--event-handlers', 'console_cohesion+', *arguments), timeout, alone=True
                )
            except LearnerTimeout as error:  # nobody waits for it a second time
                hanging.append(error)
                self._cache[key] = hanging[0]
            else:
                if self._cache[key].status == 0:
                    self._cache[shadows] = self._shadows()
        done = self._cache[key]
        if isinstance(done, LearnerTimeout):
            raise LearnerTimeout(done.message, done.details)
        if found := self._cache.get(shadows):
            raise LearnerError(found)
        if check and done.status != 0:
            raise LearnerError(f'colcon build failed: {self.why(done)}', clean(done.output, 6000))
        return done

    def why(self, build: Done) -> str:
        """Why a build failed, in one line. What setup() refuses, colcon does not tell; so setup.py is run by itself."""
        for package in self._packages if _NEVER_CALLED.search(build.output) else ():
            said = self.once('bash', '-c', 'cd "src/$1" && python3 setup.py --version', 'bash', package).output
            if found := _SETUP.search(said):
                if 'Pair.__new__' in found[1]:  # setuptools' word for what it has split at the `=`
                    return (
                        'In setup.py an entry point has no `=` between the name of the program and what it runs: '
                        'name = package.module:function.'
                    )
                return f'setup() in setup.py cannot read one of its arguments: {found[1].strip()}'[:400]
        return _of_data_files(build.output) or reason(build.output)

    def run(self, *argv: str, timeout: float = RUN_TIMEOUT, program: str = '') -> Done:
        """A command in a new terminal in which the workspace is sourced, if it is built.

        :param program: the text of a Python program of the tests' own, which is then run with these arguments.

        One that does not end in `timeout` seconds fails the test with the verdict timeout; one that gets no computing
        time is given more, so that the work of others costs nobody a mark. Whatever it leaves behind is ended.
        """
        return self._run(argv, timeout, program)

    def _run(self, argv: tuple[str, ...], timeout: float, program: str = '', alone: bool = False) -> Done:
        """:param alone: whether it waits for nobody else: if it does not compute either, it never ends."""
        shown = shlex.join(['python3', 'program.py', *argv] if program else argv)
        task = self.start(*argv, program=program)
        status, waited, used = None, 0.0, 0.0
        slice_ = timeout / 3
        while status is None and (waited < timeout - 1 or waited < PATIENCE * timeout - 1 and busy()):
            status, waited, before = task.wait(slice_), waited + slice_, used
            if status is None and alone and (now := self._learner.server.used(self.name)) is not None:
                used = now
                if waited > timeout - 1 and not (used < timeout and starved(used - before, slice_)):
                    break
        task.end()
        self.transcript.append(f'$ {shown}\n{task.output}')
        if status is None:
            raise LearnerTimeout(f'`{shown}` did not end within {timeout:g} s.', clean(task.output, 6000))
        return Done(shown, status, task.output)

    def once(self, *argv: str, program: str = '') -> Done:
        """`run` for what only reads: with the same files it is run once in a session, whatever test asks."""
        key = (self.name, 'once', program, *argv)
        if key in self._cache:
            self.transcript.append(f'$ {self._cache[key].command}\n{self._cache[key].output}')
        else:
            self._cache[key] = self.run(*argv, program=program)
        return self._cache[key]

    def start(self, *argv: str, environment: dict[str, str] | None = None, program: str = '') -> Task:
        """Start a command as `run` does, and leave it running: `output`, `wait(timeout)`, `signal(number)`, `end()`.

        What still runs when the test ends is ended then.
        """
        self._learner.end_calls()
        return self._learner.server.task(
            'command',
            self.name,
            keep=OUTPUT,
            argv=list(argv),
            folder=self.name,
            environment=environment or {},
            packages=self._packages,
            program=program,
        )

    def pytest(
        self,
        *argv: str,
        functions: int | None = None,
        modules: tuple[str, ...] = (),
        without: Iterable[str] = (),
        environment: dict[str, str] | None = None,
    ) -> Task:
        """Start pytest with these arguments, in a process that has imported it, and `modules`, already.

        :param functions: a socket that the tests in there may use, see `helpers.runner.functions`.
        :param without: Python packages that cannot be imported, nor anything in them.
        """
        self._learner.end_calls()
        given = [functions] if functions is not None else []
        return self._learner.server.task(
            'pytest',
            self.name,
            *given,
            keep=OUTPUT,
            argv=list(argv),
            folder=self.name,
            environment=environment or {},
            modules=list(modules),
            without=sorted(without),
        )

    def installed(self) -> list[str]:
        """The files below `install`, sorted."""
        task = self._learner.server.task('listing', self.name, keep=LISTING, folder=f'{self.name}/install')
        if task.wait(LISTING_TIMEOUT) != 0:
            return []
        return [str(name) for name in _told(task)]

    def read(self, name: str) -> str:
        """The text of a file below `install`, as it stands there: nothing of the learner's runs for this."""
        task = self._learner.server.task('reading', self.name, keep=LISTING, folder=f'{self.name}/install/{name}')
        return _told(task) if task.wait(LISTING_TIMEOUT) == 0 else ''

    def _shadows(self) -> str:
        """Why what is installed is refused: it takes the place of the machine's own. Empty if nothing does."""
        task = self._learner.server.task('shadows', self.name, keep=LISTING, folder=self.name, packages=self._packages)
        status = task.wait(LISTING_TIMEOUT)
        return _told(task) if status == 0 else 'What your package installs cannot be read.'

    def forget(self) -> None:
        """Remove it: it is not needed any more."""
        self._learner.server.forget(self.name)
        for key in [key for key, value in self._cache.items() if self.name in (key[0], value)]:
            del self._cache[key]


class Workspaces:
    """What `Learner` can do with files and commands; a base of it, which has what is declared first."""

    server: ForkServer
    program: dict
    timeouts: 'Timeouts'
    transcripts: list[list[str]]

    def command_process(self) -> ProgramProcess:
        """The process in which functions are called."""
        raise NotImplementedError

    def end_calls(self) -> None:
        """End that process."""
        raise NotImplementedError

    def value(self, name: str):
        """What the learner's cell binds to `name`; values as in `learner.call`."""
        answer = self.command_process().ask('value', self.timeouts.call, name=name)
        try:
            return values.decode(answer.get('result'))
        except ValueError as error:
            raise LearnerCrashed(f'`{name}` is {error}.') from None

    def text(self, name: str) -> str:
        """The text that the learner's cell binds to `name`, without empty lines at its beginning.

        One that stands there as it is is read, and the cell does not run. Else it comes from a process that is ended
        before anything else is done with the text.
        """
        found = _constant(self.program['answer'], name)
        if found is None:
            found = self.value(name)
            self.end_calls()
        if not isinstance(found, str):
            raise InvalidProgram(f'`{name}` must be a text, the contents of a file.')
        if len(found) > MAX_TEXT:
            raise InvalidProgram(f'`{name}` is longer than {MAX_TEXT} characters.')
        return found.lstrip('\n').encode('utf-8', 'replace').decode()

    def files(self, name: str = package_answers.NAME) -> dict[str, str]:
        """The texts of the package that is the learner's answer, by path in the package. Nothing of it is run."""
        try:
            statements = ast.parse(self.program['answer']).body
            found = next(
                ast.literal_eval(one.value)
                for one in statements
                if isinstance(one, ast.Assign) and ast.unparse(one.targets[0]) == name
            )
            return package_answers.texts({path: text.encode() for path, text in found.items()})
        except package_answers.InvalidExercise as error:
            raise InvalidProgram(str(error)) from None
        except (StopIteration, SyntaxError, ValueError, AttributeError, RecursionError, MemoryError):
            raise InvalidProgram('There is no package.') from None

    def workspace(self, files: dict[str, str | bytes], alone: bool = False) -> ExerciseWorkspace:
        """A workspace with these files (path below the workspace -> content) in a place of its own.

        The same files give the same workspace for all tests of a session, with what is built in it, unless it is
        `alone`. Its name tells nothing, and what another program has done is not in it.
        """
        written = {
            name: content if isinstance(content, str) else {'base64': base64.b64encode(content).decode()}
            for name, content in files.items()
        }
        for name in files:
            if PurePosixPath(name).is_absolute() or '..' in PurePosixPath(name).parts:
                raise ValueError(f'{name!r} is not inside of a workspace')
        self.end_calls()
        cache, key = self.server.workspaces, ('files', self.program['title'], json.dumps(written, sort_keys=True))
        if alone or key not in cache:
            name = f'ws_{secrets.token_hex(8)}'
            given = os.memfd_create('files')
            try:
                os.write(given, json.dumps(written).encode())
                os.lseek(given, 0, os.SEEK_SET)
                task = self.server.task('write', name, given, keep=OUTPUT, folder=name)
            finally:
                os.close(given)
            if (status := task.wait(WRITE_TIMEOUT)) != 0:
                raise LearnerError(
                    'The files of your package could not be written: they are too large, or one has the '
                    f'name of a folder (status {status}).'
                )
            if alone:
                return ExerciseWorkspace(self, name)
            cache[key] = name
        packages = {name.split('/')[1] for name in files if name.startswith('src/')}
        found = ExerciseWorkspace(self, cache[key], packages)
        self.transcripts.append(found.transcript)
        return found


def _told(task: Task) -> Any:
    """What a task has said of a workspace, as JSON; of more than LISTING bytes only the end is here.

    :raises LearnerError: it is too long, or no JSON.
    """
    try:
        return json.loads(task.output)
    except (ValueError, RecursionError):
        raise LearnerError(
            'What your package installs cannot be listed: the names of the files are too long together.'
        ) from None


def _constant(answer: str, name: str) -> str | None:
    """The text that the exercise's cell assigns to a name, if it is plainly there and nothing else is done with it."""
    try:
        tree = ast.parse(answer)
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        return None
    bound = sum(
        isinstance(node, ast.Name)
        and node.id == name
        and not isinstance(node.ctx, ast.Load)
        or isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef, ast.ClassDef))
        and node.name == name
        or isinstance(node, ast.alias)
        and name in (node.asname, node.name, '*')
        for node in ast.walk(tree)
    )
    for node in tree.body if bound == 1 else ():
        match node:
            case ast.Assign(targets=[ast.Name(id=found)], value=ast.Constant(value=str(text))) if found == name:
                return text
    return None


_CMAKE = re.compile(r'CMake Error(?: at (CMakeLists\.txt):(\d+))?[^\n]*\n((?:[ \t]*\n|  [^\n]*\n){1,40})')
_NEVER_CALLED = re.compile(r"setup\(\)'? was never called")
_SETUP = re.compile(r'^error in \S+ setup command: (.+)$', re.MULTILINE)
_DATA_FILES = re.compile(r'in get_data_files_mapping\n\s*assert ([^\n]*)')
_RAISED = re.compile(r'[\w.]+(?:Error|Exception): ')
_FRAME = re.compile(r'File "([^"\n]{1,400}\.py)", line (\d{1,6})')
_IN_A_STRING = re.compile(r'File "<string>", line (\d+)')
_TELLING = re.compile(r'^.*(?:[Ee]rror\b|No such file|not found).*$', re.MULTILINE)


def reason(output: str) -> str:
    """The part of a failed build's output that says why, in one line."""
    if found := _CMAKE.search(output):
        place = f'{found[1]}, line {found[2]}: ' if found[1] else ''
        paragraph = ' '.join(found[3].split('Call Stack')[0].split())
        return f'{place}{paragraph}'[:400]
    if _NEVER_CALLED.search(output):
        return (
            'setup.py ends without a call of setup() that works. Run `python3 setup.py --version` in the folder of the '
            'package to see why.'
        )
    # The tools' own tracebacks and command lines are long and tell nothing.
    telling = [line for line in _TELLING.findall(output) if 'CalledProcessError' not in line and len(line) < 400]
    if not telling:
        return (output.strip().splitlines() or ['it printed nothing'])[-1].strip()[:400]
    return f'{_place_in_setup(output, telling[-1])}{telling[-1].strip()}'[:400]


def _place_in_setup(output: str, error: str) -> str:
    """Where in setup.py, which colcon runs as a string in a program that is another one, this error has come."""
    places = _IN_A_STRING.findall(output[: output.rindex(error)].rpartition('Traceback (most')[2])
    return f'setup.py, line {places[-1]}: ' if len(places) > 1 else ''
