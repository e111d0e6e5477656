"""One Python that runs the commands of many: ROS's code generators in itself, any `setup.py` in a fork of itself.

A generator spends its time in loading modules, parsing the .idl files and splitting its templates; all of this is done
once here (`generators`). A `setup.py` finds setuptools loaded. The server ends when its parent does.
"""

import importlib
import importlib.metadata
import json
import os
import runpy
import signal
import socket
import sys
import traceback
import warnings
from pathlib import Path

from environment.builder import generators

REFUSED = 255  # the client is to run the command itself
_PRELOADED = ('setuptools', 'distutils.core', 'setuptools.command.build_py', 'setuptools.command.egg_info',
              'setuptools.command.install', 'setuptools.command.install_egg_info', 'setuptools.command.install_lib',
              'setuptools.command.install_scripts', 'setuptools.dist', 'pkg_resources')  # fmt: skip


def start(path: Path) -> int:
    """Fork a server that listens at `path`; returns its process id. Call it while there is one thread only."""
    listener = socket.socket(socket.AF_UNIX)
    listener.bind(str(path))
    listener.listen(64)
    parent = os.getpid()
    process = os.fork()
    if process:
        listener.close()
        return process
    status = 1
    try:
        _end_with(parent)
        signal.signal(signal.SIGCHLD, signal.SIG_IGN)  # nobody waits for the forks: they answer by themselves
        warnings.filterwarnings(
            'ignore', 'pkg_resources is deprecated'
        )  # setuptools itself imports it, to install scripts
        for name in _PRELOADED:
            importlib.import_module(name)
        _share_entry_points()
        generators.share_work()
        _serve(listener)
        status = 0
    finally:
        os._exit(status)


def _end_with(parent: int) -> None:
    """Let the kernel end this process when its parent ends, however that ends."""
    import ctypes

    set_signal_for_parents_death = 1
    ctypes.CDLL(None).prctl(set_signal_for_parents_death, signal.SIGTERM)
    if os.getppid() != parent:
        os._exit(1)


def _share_entry_points() -> None:
    """Read the entry points of what is installed once: a setup.py asks for them fifteen times, in 300 folders each.

    They are those of setuptools' own plugins, which no package of the workspace adds to.
    """
    known = importlib.metadata.entry_points()
    importlib.metadata.entry_points = lambda **chosen: known.select(**chosen)


def _serve(listener: socket.socket) -> None:
    while True:
        connection, _ = listener.accept()
        with connection:
            descriptors: list[int] = []
            try:
                size, descriptors, _, _ = socket.recv_fds(connection, 4, 2)
                request = json.loads(_read(connection, int.from_bytes(size, 'big')))
                _handle(connection, request, descriptors)
            except (OSError, ValueError):
                traceback.print_exc()  # the client sees a closed connection, and runs the command itself
            finally:
                for descriptor in descriptors:
                    os.close(descriptor)


def _read(connection: socket.socket, size: int) -> bytes:
    data = b''
    while len(data) < size:
        block = connection.recv(size - len(data))
        if not block:
            raise ValueError('the client ended in the middle of its request')
        data += block
    return data


def _handle(connection: socket.socket, request: dict, descriptors: list[int]) -> None:
    arguments = request['command'][1:]
    generate = generators.find(arguments)
    if generate:
        connection.sendall(bytes([_run_here(generate, request, descriptors)]))
    elif 'setup.py' in arguments or arguments[:1] == ['-c']:
        if not os.fork():
            connection.sendall(bytes([_run_in_fork(arguments, request, descriptors)]))
            os._exit(0)
    else:
        connection.sendall(bytes([REFUSED]))


def _run_here(generate, request: dict, descriptors: list[int]) -> int:
    """Run a generator in this process; what it prints goes to the client."""
    kept = [os.dup(1), os.dup(2)]
    try:
        _take(request, descriptors)
        generate()
        return 0
    except BaseException:
        traceback.print_exc()
        return 1
    finally:
        sys.stdout.flush()
        sys.stderr.flush()
        for number, descriptor in zip((1, 2), kept, strict=True):
            os.dup2(descriptor, number)
            os.close(descriptor)


def _run_in_fork(arguments: list[str], request: dict, descriptors: list[int]) -> int:
    """Do in this process, which is a fork, what `python ARGUMENTS` would do; returns its exit status."""
    signal.signal(signal.SIGCHLD, signal.SIG_DFL)
    try:
        _take(request, descriptors)
        os.environ.clear()
        os.environ.update(request['environ'])
        sys.path[0:0] = ['', *filter(None, os.environ.get('PYTHONPATH', '').split(os.pathsep))]
        _run(arguments)
        return 0
    except SystemExit as end:
        if isinstance(end.code, str):
            print(end.code, file=sys.stderr)
        return end.code if isinstance(end.code, int) else int(end.code is not None)
    except BaseException:
        traceback.print_exc()
        return 1
    finally:
        sys.stdout.flush()
        sys.stderr.flush()


def _run(arguments: list[str]) -> None:
    if arguments[0] == '-c':
        sys.argv = ['-c', *arguments[2:]]
        exec(compile(arguments[1], '<string>', 'exec'), {'__name__': '__main__'})
        return
    script = arguments.index('setup.py')
    for option, value in zip(arguments[:script], arguments[1:script], strict=False):
        if option == '-W':
            action, _, message = value.partition(':')
            warnings.filterwarnings(action, message)
    sys.argv = arguments[script:]
    override = _override()
    if override:
        runpy.run_path(override)
    runpy.run_path('setup.py', run_name='__main__')


def _override() -> str:
    """The sitecustomize.py by which colcon tells Python where to install to; '' if there is none."""
    for folder in os.environ.get('PYTHONPATH', '').split(os.pathsep):
        path = os.path.join(folder, 'sitecustomize.py')
        if os.path.basename(folder) == 'prefix_override' and os.path.isfile(path):
            return path
    return ''


def _take(request: dict, descriptors: list[int]) -> None:
    os.chdir(request['cwd'])
    for number, descriptor in zip((1, 2), descriptors, strict=True):
        os.dup2(descriptor, number)
