"""``./course lab``: JupyterLab on the notebooks."""

import errno
import os
import socket
import sys
import tempfile
from collections.abc import MutableMapping
from pathlib import Path
from typing import Annotated

import typer

from helpers import paths
from helpers.cli import Refusal, own
from helpers.exercises import manifest, start_page
from helpers.kernel import shared_memory

DEFAULT_PORT = 8888
EXTENSIONS = paths.ROOT / 'helpers' / 'cli' / 'labextensions'  # the course's own
# Where JupyterLab finds the kernel of the notebooks, `python3`, as the course wants it: after a restart it says where
# a missing name comes from, and knows `%%answer`, before any cell has imported `helpers`.
KERNELS = paths.ROOT / 'helpers' / 'cli' / 'jupyter'
TRIES = 50  # ports from DEFAULT_PORT on, if no port is asked for


def lab(
    port: Annotated[int | None, typer.Option(min=1, max=65535, help='TCP port; default: a free one from 8888.')] = None,
    no_browser: Annotated[bool, typer.Option('--no-browser', help='Only print the address.')] = False,
    host: Annotated[
        str,
        typer.Option(
            metavar='ADDRESS', help='Address to listen on; 0.0.0.0 lets other machines in, who need the token.'
        ),
    ] = 'localhost',
):
    """Open JupyterLab on notebooks/."""
    if not paths.NOTEBOOKS.is_dir():
        raise Refusal(f'{paths.NOTEBOOKS} is missing: get a complete copy of the course, or run ./course build')
    own.enter()
    shared_memory.tidy()
    check_private_folders()
    chosen = choose_port(port, host)
    if port is None and chosen != DEFAULT_PORT:
        say(f'port {DEFAULT_PORT} is in use; taking {chosen}')
    start = f'/lab/tree/{start_page.FILE}' if make_start_page() else '/lab'
    say('JupyterLab is starting; it tells its address below. To end it: Ctrl+C, twice')
    use_own_kernel(os.environ)
    command = [*arguments(chosen, no_browser, os.geteuid() == 0, start), f'--ServerApp.ip={host}']
    os.chdir(paths.ROOT)
    os.execv(sys.executable, [sys.executable, *command])  # JupyterLab takes over this process: its signals, its exit


def use_own_kernel(environ: MutableMapping[str, str]) -> None:
    """Let Jupyter take the course's kernel, whatever kernels the user has elsewhere under the same name."""
    environ.setdefault('JUPYTER_PREFER_ENV_PATH', '1')
    environ['JUPYTER_PATH'] = os.pathsep.join(filter(None, [str(KERNELS), environ.get('JUPYTER_PATH')]))


def say(text: str) -> None:
    """Tell the learner one line, in front of what JupyterLab says."""
    print(f'course: {text}', file=sys.stderr, flush=True)


def make_start_page() -> bool:
    """Write the start page again if the folder allows it; returns whether there is one. JupyterLab works without it."""
    try:
        start_page.write()
    except manifest.ManifestError as error:
        say(f'the start page is an old one, or none: {error}')
    except OSError as error:
        if error.errno in (errno.ENOSPC, errno.EDQUOT):
            say(f'the disk is full, nothing that you write is kept: free some space (see: df -h {paths.NOTEBOOKS})')
        else:
            say(
                f'{paths.NOTEBOOKS} is not writable for you, nothing that you write in it is kept; '
                f'run: sudo chown -R $(id -un) "{paths.NOTEBOOKS}", or copy the course to a folder of your own'
            )
    return (paths.NOTEBOOKS / start_page.FILE).is_file()


def check_private_folders() -> None:
    """Raise Refusal unless Jupyter can keep its own files: its server ends with a long report otherwise."""
    from jupyter_core.paths import jupyter_config_dir, jupyter_runtime_dir

    for folder in (jupyter_runtime_dir(), jupyter_config_dir()):
        try:
            os.makedirs(folder, mode=0o700, exist_ok=True)
            with tempfile.NamedTemporaryFile(dir=folder) as probe:
                probe.write(b'x')
                probe.flush()
        except OSError as error:
            remedy = (
                'free some space'
                if error.errno in (errno.ENOSPC, errno.EDQUOT)
                else 'run: export HOME=FOLDER, with a folder that you may write to, then ./course lab'
            )
            raise Refusal(f'Jupyter cannot write to {folder} ({error.strerror.lower()}); {remedy}') from None


def arguments(
    port: int, no_browser: bool, root_user: bool, start: str = '/lab', folder: Path | None = None
) -> list[str]:
    """Return the arguments of the interpreter that start JupyterLab on ``port`` exactly.

    It opens on ``start`` and serves ``folder``, notebooks/ by default.
    """
    result = [
        '-m',
        'jupyterlab',
        f'--ServerApp.root_dir={folder or paths.NOTEBOOKS}',
        f'--ServerApp.port={port}',
        '--ServerApp.port_retries=0',
        f'--LabApp.default_url={start}',
        '--MultiKernelManager.default_kernel_name=python3',
        # All versions are locked: no questions about news and newer versions.
        '--LabApp.news_url=None',
        '--LabApp.check_for_updates_class=jupyterlab.NeverCheckForUpdate',
        f'--LabApp.extra_labextensions_path={EXTENSIONS}',
        '--Application.log_level=WARN',  # shows the address and errors, not a line for each of the server's extensions
    ]
    if no_browser:
        result.append('--no-browser')
    if root_user:  # containers; Jupyter refuses otherwise
        result.append('--allow-root')
    return result


def choose_port(wanted: int | None, host: str = 'localhost') -> int:
    """Return ``wanted``, or a free port from DEFAULT_PORT on.

    :raises Refusal: ``wanted`` is in use or not allowed, no port is free, or ``host`` is no address of this machine.
    """
    if wanted is not None:
        problem = _problem(wanted, host)
        if problem:
            raise Refusal(f'port {wanted}: {problem}; choose another one, or none')
        return wanted
    for port in range(DEFAULT_PORT, DEFAULT_PORT + TRIES):
        if not _problem(port, host):
            return port
    raise Refusal(f'no port from {DEFAULT_PORT} to {port} is free; choose one with --port')


def _problem(port: int, host: str) -> str | None:
    """Return why nobody can listen on ``port`` of ``host``, or None.

    :raises Refusal: it is not the port, but ``host``.
    """
    from tornado.netutil import bind_sockets  # what the server itself does

    try:
        for server in bind_sockets(port, '' if host == '*' else host):
            server.close()
    except OSError as error:
        if isinstance(error, socket.gaierror) or error.errno == errno.EADDRNOTAVAIL:
            raise Refusal(
                f'--host {host}: this machine has no such address; leave --host out, or take 0.0.0.0 '
                'to let other machines in'
            ) from None
        return error.strerror.lower()
    return None
