"""Tasks beside the learner's cells: files are written and commands run, each in a process that no cell has run in.

The fork server starts them for the tests' side, with texts of the learner's as data, in a place of their own: a folder,
and in a sandbox a home, a /tmp and processes that nobody else sees. Status and output are taken by the fork server and
the tests, outside of that place. Requests: see `helpers.runner.fork_server`; tests use `helpers.runner.workspaces`.
"""

import base64
import json
import os
import stat
import sys
import tempfile
from pathlib import Path
from typing import Any

from helpers.programs import terminals
from helpers.runner import sourced_environment

MAX_FILES = 2000  # names in a listing
MAX_READ = 64 * 2**10  # characters of a file


def perform(request: dict, given: list[int]) -> int:
    """Do a task in the calling process, whose output the tests have; returns the exit status.

    write     the files in the open file given[0] (JSON: path -> text, or base64) below `folder`, with colcon's defaults
    listing   print the names of the files and links below `folder`, without caches, as JSON
    reading   print the text of the file `folder`, as JSON
    command   run `argv` as in a new terminal in which the folder is sourced, if it is built (`overlay`); with the text
              `program` of the tests' own, that one in Python, from a folder that is new, with `argv` as arguments
    shadows   print why what is built below `folder` is refused, as JSON: it takes the place of the machine's own, or
              would make others wait
    pytest    run pytest with `argv`, in this process, which has imported it
    """
    root = Path(os.environ.get('HOME', '/'), request['folder'])
    match request['op']:
        case 'write':
            with open(given[0], encoding='utf-8') as file:
                _write(root, json.load(file))
        case 'listing':
            print(json.dumps(_listing(root)))
        case 'reading':
            return _read(root)
        case 'shadows':
            print(json.dumps(_shadows(root, request['packages'])))
        case 'command':
            return _command(root, request)
        case 'pytest':
            os.chdir(root)
            return _pytest(request, given)
    return 0


def _shadows(root: Path, packages: list[str]) -> str:
    try:
        sourced_environment.look_at_products(root)
        sourced_environment.of(root, packages)
    except sourced_environment.Shadowed as problem:
        return str(problem)
    return ''


def _command(root: Path, request: dict) -> int:
    """Become the command; returns a shell's status if it cannot be."""
    argv = request['argv']
    try:
        environment = sourced_environment.of(root, request['packages'])
    except sourced_environment.Shadowed as problem:
        print(problem)
        return 126
    environment |= {**request['environment'], 'COLCON_DEFAULTS_FILE': str(root / terminals.DEFAULTS)}
    os.chdir(root)
    if program := request.get('program'):
        # Not beside the learner's files, of which some could have been written over it, or be modules that it imports.
        os.chdir(tempfile.mkdtemp())
        Path('program.py').write_text(program)
        argv = ['python3', 'program.py', *argv]
    try:
        os.execvpe(argv[0], argv, environment)
    except OSError as error:
        print(f'{argv[0]}: {error.strerror}')
        return 127


def _write(root: Path, files: dict[str, str | dict]) -> None:
    for name, text in {terminals.DEFAULTS: terminals.colcon_defaults(), **files}.items():
        path = root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        content = text.encode() if isinstance(text, str) else base64.b64decode(text['base64'])
        path.write_bytes(content)
        if content.startswith(b'#!'):
            path.chmod(0o755)


def _read(path: Path) -> int:
    """Print the text of a regular file; 1 if it is none. A pipe that nobody writes to is not waited for."""
    with open(os.open(path, os.O_RDONLY | os.O_NONBLOCK), encoding='utf-8', errors='replace') as file:
        if not stat.S_ISREG(os.fstat(file.fileno()).st_mode):
            return 1
        print(json.dumps(file.read(MAX_READ)))
    return 0


def _listing(root: Path) -> list[str]:
    found = [path.relative_to(root).as_posix() for path in root.rglob('*') if path.is_symlink() or not path.is_dir()]
    return sorted(name for name in found if '__pycache__' not in name)[:MAX_FILES]


def _pytest(request: dict, given: list[int]) -> int:
    """pytest's status. given[0], if it is there, is a socket to functions on the tests' side."""
    import pytest

    os.environ.update(request['environment'])
    os.environ['PYTEST_DISABLE_PLUGIN_AUTOLOAD'] = '1'
    missing: Any = None  # in place of a module: importing it is an ImportError
    without = set(request.get('without', ()))
    for name in {*without, *(loaded for loaded in sys.modules if loaded.partition('.')[0] in without)}:
        sys.modules[name] = missing
    if given:
        os.environ['FUNCTIONS'] = str(given[0])
    sys.path.insert(0, os.getcwd())
    return int(pytest.main(request['argv']))
