"""Chooses the Python that the environment is made from."""

import json
import shutil
import subprocess
import sys
from collections.abc import Mapping
from dataclasses import dataclass

from environment.setup.errors import PreflightError
from environment.setup.underlay import Underlay

OLDEST, NEWEST = (3, 10), (3, 13)
SYSTEM = '/usr/bin/python3'

_PROBE = """
import glob, json, os, sys, sysconfig
def has(name):
    try:
        __import__(name)
    except Exception:
        return False
    return True
def pip_wheel():
    try:
        import ensurepip
    except Exception:
        return ""
    own = os.path.join(os.path.dirname(ensurepip.__file__), "_bundled")
    for folder in (own, sysconfig.get_config_var("WHEEL_PKG_DIR") or own):
        for wheel in glob.glob(os.path.join(glob.escape(folder), "pip-*.whl")):
            return wheel
    return ""
print(json.dumps({
    "path": os.path.realpath(sys.executable),
    "version": list(sys.version_info[:3]),
    "cpython": sys.implementation.name == "cpython" and not sysconfig.get_config_var("Py_GIL_DISABLED"),
    "bits": 64 if sys.maxsize > 2**32 else 32,
    "venv": has("venv") and has("ensurepip"),
    "headers": os.path.exists(os.path.join(sysconfig.get_path("include"), "Python.h")),
    "pip_wheel": pip_wheel(),
}))
"""


@dataclass(frozen=True)
class Interpreter:
    """What an interpreter says of itself."""

    command: str
    path: str
    version: tuple[int, int, int]
    cpython: bool
    bits: int
    venv: bool
    headers: bool
    pip_wheel: str = ''  # from which its ensurepip installs pip; '' if it is not where it is usually kept

    @property
    def right_version(self) -> bool:
        return self.cpython and self.bits == 64 and OLDEST <= self.version[:2] <= NEWEST

    @property
    def complete(self) -> bool:
        return self.right_version and self.venv and self.headers

    @property
    def short(self) -> str:
        return f'{self.version[0]}.{self.version[1]}'


def probe(command: str) -> Interpreter | None:
    """Ask the interpreter `command` about itself; None when there is none, or when it does not run."""
    found = shutil.which(command)
    if not found:
        return None
    try:
        # -S and -E: no site hooks, no variables of another environment.
        answer = subprocess.run([found, '-ES', '-c', _PROBE], capture_output=True, text=True, timeout=30, check=False)
        facts = json.loads(answer.stdout)
    except (OSError, ValueError, subprocess.TimeoutExpired):
        return None
    return Interpreter(command=found, **{**facts, 'version': tuple(facts['version'])})


def choose(environ: Mapping[str, str], underlay: Underlay, probe=probe) -> Interpreter:
    """The interpreter for the environment: COURSE_PYTHON, else the one that fits.

    The system's comes first, as graders run it under another user, whom a private home would keep out.
    Raises PreflightError with what is missing from the best candidate.
    """
    wanted = environ.get('COURSE_PYTHON')
    if wanted:
        chosen = probe(wanted)
        if chosen is None:
            raise PreflightError(f'COURSE_PYTHON={wanted} is not a Python that can be run', 'unset COURSE_PYTHON')
        return demand(chosen)
    if underlay.stock:
        for command in underlay.interpreters():
            chosen = probe(command)
            if chosen and chosen.right_version:
                return demand(chosen)
        raise PreflightError(
            f'the Python of the sourced ROS ({underlay}) was not found', 'set COURSE_PYTHON to the Python it uses'
        )
    others = [f'python3.{minor}' for minor in range(NEWEST[1], OLDEST[1] - 1, -1)]
    seen = []
    for command in [SYSTEM, sys.executable, *others]:
        candidate = probe(command) if command else None
        if candidate and candidate.complete:
            return candidate
        seen += [candidate] if candidate else []
    right = [c for c in seen if c.right_version]
    if right:
        return demand(right[0])
    raise _wrong_version(seen[0] if seen else None)


def demand(candidate: Interpreter) -> Interpreter:
    """The same interpreter; raises PreflightError when something is missing from it."""
    if not candidate.right_version:
        raise _wrong_version(candidate)
    missing = [m for m, there in (('venv', candidate.venv), ('dev', candidate.headers)) if not there]
    if not missing:
        return candidate
    names = {'venv': 'venv module', 'dev': 'headers (Python.h)'}
    what = f'Python {candidate.short} ({candidate.path}) has no ' + ' and no '.join(names[m] for m in missing)
    if candidate.path.startswith('/usr/bin/'):
        remedy = 'run: sudo apt install ' + ' '.join(f'python{candidate.short}-{m}' for m in missing) + ' g++'
    else:
        remedy = 'install them, or use another Python: COURSE_PYTHON=/usr/bin/python3 ./course'
    raise PreflightError(what, remedy)


def _wrong_version(candidate: Interpreter | None) -> PreflightError:
    if candidate is None:
        what = 'no Python 3.10-3.13 found'
    elif not candidate.cpython or candidate.bits != 64:
        what = f'{candidate.path} is not the standard 64-bit CPython that the ROS wheels are for'
    else:
        what = f'{candidate.path} is Python {candidate.short}, the course needs 3.10-3.13'
    return PreflightError(
        what, 'run: sudo apt install python3.12 python3.12-venv python3.12-dev, then COURSE_PYTHON=python3.12 ./course'
    )
