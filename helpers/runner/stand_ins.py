"""Programs that a learner's launch file starts, and that run where no launch file has run.

In the learner's package stands a stand-in. It does nothing but tell with which arguments it was started, and hand over
the parameter files among them. With these, a test starts the program itself, in a place of its own. So it does not
matter what a launch file reads, rewrites or starts besides: what counts is how it starts the program.
"""

import json
import os
import secrets
import socket
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from types import MappingProxyType

from helpers.runner.fork_client import Task

MAX_STARTS = 40  # that are taken
MAX_BYTES = 256 * 2**10  # of what one says
PATIENCE = 5.0  # seconds for one that has come to say what it has to say
HURRY = 0.1  # seconds, when another one has said nothing
FILE_OPTION = '--params-file'
_TEXT = """\
def main():
    import json
    import socket
    import sys

    words, files = sys.argv[1:], {{}}
    for option, name in zip(words, words[1:]):
        if option == {option!r}:
            try:
                with open(name) as file:
                    files[name] = file.read()
            except (OSError, ValueError):
                pass
    said = json.dumps({{'token': {token!r}, 'name': {name!r}, 'arguments': words, 'files': files}})
    try:
        with socket.create_connection(('127.0.0.1', {port})) as end:
            end.sendall(said.encode() + b'\\n')
            end.recv(1)
    except (KeyboardInterrupt, OSError):
        pass
"""


@dataclass(frozen=True)
class Start:
    """How a program was started: its arguments, and the parameter files that they name, path → text."""

    name: str  # of the program
    arguments: tuple[str, ...]
    files: dict[str, str] = field(hash=False)

    def begin(
        self, learner, program: str, modules: Mapping[str, str] = MappingProxyType({}), more: Iterable[str] = ()
    ) -> Task:
        """Start the text of a Python program in this way, in a place of its own.

        :param modules: what it imports besides: path → text.
        :param more: arguments behind the others.
        """
        names = {path: f'given/file_{number}.yaml' for number, path in enumerate(self.files)}
        place = learner.workspace({**modules, **{names[path]: text for path, text in self.files.items()}})
        words = [f'{place.path}/{names[word]}' if word in names else word for word in self.arguments] + list(more)
        return place.start(
            *words,
            program=program,
            environment={'PYTHONPATH': f'{place.path}:{os.environ.get("PYTHONPATH", "")}'} if modules else {},
        )


class StandIns:
    """Hears the stand-ins of a session."""

    def __init__(self) -> None:
        self._token = secrets.token_hex(16)
        self._listener = socket.create_server(('127.0.0.1', 0), backlog=MAX_STARTS)
        self._listener.setblocking(False)
        self._ends: list[socket.socket] = []
        self._starts: list[Start] = []
        self._patience = PATIENCE

    def text(self, name: str) -> str:
        """The function `main` of what stands for the program of this name."""
        port = self._listener.getsockname()[1]
        return _TEXT.format(token=self._token, name=name, port=port, option=FILE_OPTION)

    def starts(self, *names: str) -> list[Start]:
        """The starts of programs of these names that have come since `release`, in their order."""
        while len(self._ends) < MAX_STARTS:
            try:
                end, _ = self._listener.accept()
            except BlockingIOError:
                break
            self._ends.append(end)
            end.settimeout(self._patience)
            try:
                with end.makefile('rb') as stream:
                    start = self._start(stream.readline(MAX_BYTES))
            except OSError:
                self._patience, start = HURRY, None
            if start is not None:
                self._starts.append(start)
        return [start for start in self._starts if start.name in names]

    def release(self) -> None:
        """Let the stand-ins end, and forget what they have said."""
        self.starts()
        for end in self._ends:
            end.close()
        self._ends, self._starts = [], []

    def _start(self, line: bytes) -> Start | None:
        """What a stand-in has said; None if it is not one's."""
        try:
            match json.loads(line):
                case {'token': self._token, 'name': str(name), 'arguments': list(words), 'files': dict(files)}:
                    for text in (*words, *files.values()):
                        text.encode()  # an error, if it is no text, or none that can be written
                    return Start(name, tuple(words), files)
        except (ValueError, AttributeError, RecursionError):
            pass
        return None


def of(learner) -> StandIns:
    """The stand-ins of a session: the programs in which they are, are built once."""
    known = learner.server.workspaces
    if 'stand-ins' not in known:
        known['stand-ins'] = StandIns()
    return known['stand-ins']
