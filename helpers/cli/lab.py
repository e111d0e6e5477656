"""``./course lab``: JupyterLab on the notebooks."""

import os
import socket
import sys
from pathlib import Path
from typing import Annotated

import typer

from helpers import paths, start_page
from helpers.cli import Refusal
from helpers.exercises import manifest

DEFAULT_PORT = 8888
TRIES = 50  # ports from DEFAULT_PORT on, if no port is asked for


def lab(
    port: Annotated[int | None, typer.Option(min=1, max=65535, help='TCP port; default: a free one from 8888.')] = None,
    no_browser: Annotated[bool, typer.Option('--no-browser', help='Only print the address.')] = False,
    host: Annotated[str, typer.Option(metavar='ADDRESS', help='Address to listen on; 0.0.0.0 lets other machines in, '
                                                              'who need the token.')] = 'localhost',
):
    """Open JupyterLab on notebooks/."""
    if not paths.NOTEBOOKS.is_dir():
        raise Refusal(f'{paths.NOTEBOOKS} is missing: get a complete copy of the course, or run ./course build')
    chosen = choose_port(port)
    if port is None and chosen != DEFAULT_PORT:
        print(f'course: port {DEFAULT_PORT} is in use; taking {chosen}', file=sys.stderr, flush=True)
    try:
        start = f'/lab/tree/{start_page.write().name}'
    except (OSError, manifest.ManifestError) as error:  # a read-only folder: still good for reading and trying
        print(f'course: no start page: {error}', file=sys.stderr, flush=True)
        start = '/lab'
    # The environment's own kernel, whatever kernels the user has elsewhere under the same name.
    os.environ.setdefault('JUPYTER_PREFER_ENV_PATH', '1')
    command = [*arguments(chosen, no_browser, os.geteuid() == 0, start), f'--ServerApp.ip={host}']
    os.chdir(paths.ROOT)
    os.execv(sys.executable, [sys.executable, *command])  # JupyterLab takes over this process: its signals, its exit


def arguments(port: int, no_browser: bool, root_user: bool, start: str = '/lab',
              folder: Path | None = None) -> list[str]:
    """Return the arguments of the interpreter that start JupyterLab on ``port`` exactly.

    It opens on ``start`` and serves ``folder``, notebooks/ by default.
    """
    result = [
        '-m', 'jupyterlab',
        f'--ServerApp.root_dir={folder or paths.NOTEBOOKS}',
        f'--ServerApp.port={port}',
        '--ServerApp.port_retries=0',
        f'--LabApp.default_url={start}',
        '--MultiKernelManager.default_kernel_name=python3',
        # All versions are locked: no questions about news and newer versions.
        '--LabApp.news_url=None',
        '--LabApp.check_for_updates_class=jupyterlab.NeverCheckForUpdate',
    ]
    if no_browser:
        result.append('--no-browser')
    if root_user:  # containers; Jupyter refuses otherwise
        result.append('--allow-root')
    return result


def choose_port(wanted: int | None) -> int:
    """Return ``wanted``, or a free port from DEFAULT_PORT on.

    :raises Refusal: ``wanted`` is in use or not allowed, or no port is free.
    """
    if wanted is not None:
        problem = _problem(wanted)
        if problem:
            raise Refusal(f'port {wanted}: {problem}; choose another one, or none')
        return wanted
    for port in range(DEFAULT_PORT, DEFAULT_PORT + TRIES):
        if not _problem(port):
            return port
    raise Refusal(f'no port from {DEFAULT_PORT} to {port} is free; choose one with --port')


def _problem(port: int) -> str | None:
    """Return why nobody can listen on ``port`` of this machine, or None."""
    with socket.socket() as probe:
        probe.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)  # as the server does: ignores TIME_WAIT
        try:
            probe.bind(('127.0.0.1', port))
        except OSError as error:
            return error.strerror.lower()
    return None
