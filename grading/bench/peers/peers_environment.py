"""The environment of the other graders: made when it is first needed, and again when its lock changes."""

import hashlib
import json
import os
import subprocess
import sys
from pathlib import Path

from helpers import paths

LOCK = Path(__file__).with_name('requirements.lock')
PREFIX = paths.ROOT / 'build' / 'bench' / 'peers'
KERNEL = 'course-with-peers'
# The course's Python, where these packages come after its own: otter is imported in the kernel too.
_LAUNCH = (
    'import sys; sys.path.append({site!r}); from ipykernel.kernelapp import launch_new_instance; launch_new_instance()'
)


def program(name: str) -> str:
    """Return the path of a program of theirs, and install them if need be.

    :raises RuntimeError: this Python is too old for them, or the installation failed, with the installer's last lines.
    """
    if sys.version_info < (3, 11):
        raise RuntimeError('the other graders need Python 3.11: set COURSE_PYTHON to one, and run ./course bench again')
    wanted = hashlib.sha256(LOCK.read_bytes()).hexdigest()
    done = PREFIX / 'lock.sha256'
    if not done.exists() or done.read_text() != wanted:
        _install()
        done.write_text(wanted)
    return str(PREFIX / 'bin' / name)


def environment(domain_id: int) -> dict[str, str]:
    """The environment variables for a program of theirs: their kernel, and a ROS domain."""
    path = os.pathsep.join([str(PREFIX / 'bin'), os.environ['PATH']])
    return {
        **os.environ,
        'PATH': path,
        'ROS_DOMAIN_ID': str(domain_id),
        'JUPYTER_PATH': str(PREFIX / 'share' / 'jupyter'),
    }


def run(name: str, *arguments: str, domain_id: int, cwd: Path) -> None:
    """Run a program of theirs to its end.

    :raises RuntimeError: it failed; with what it said last.
    """
    argv = [program(name), *arguments]
    done = subprocess.run(argv, env=environment(domain_id), cwd=cwd, capture_output=True, text=True, timeout=600)
    if done.returncode:
        raise RuntimeError(f'{name} {arguments[0]} failed: {(done.stdout + done.stderr)[-800:]}')


def _install() -> None:
    uv = [sys.executable, '-m', 'uv']
    base = getattr(sys, '_base_executable', sys.executable)
    python = PREFIX / 'bin' / 'python'
    for argv in (
        [*uv, 'venv', '-q', '--clear', '--python', base, str(PREFIX)],
        [*uv, 'pip', 'install', '-q', '--require-hashes', '--python', str(python), '-r', str(LOCK)],
    ):
        done = subprocess.run(argv, capture_output=True, text=True)
        if done.returncode:
            raise RuntimeError(f'the other graders could not be installed: {done.stderr[-800:]}')
    site = next((PREFIX / 'lib').glob('python3*/site-packages'))
    kernel = PREFIX / 'share' / 'jupyter' / 'kernels' / KERNEL
    kernel.mkdir(parents=True, exist_ok=True)
    spec = {
        'argv': [sys.executable, '-c', _LAUNCH.format(site=str(site)), '-f', '{connection_file}'],
        'display_name': 'ROS 2 course, with other graders',
        'language': 'python',
    }
    (kernel / 'kernel.json').write_text(json.dumps(spec, indent=1) + '\n')
