"""The environment variables of the tools that the set-up runs, and what their failures mean."""

import os
import re
from collections.abc import Mapping

from environment.setup.errors import PreflightError, StepError
from environment.setup.layout import Layout
from environment.setup.startup import drop_foreign_guard
from environment.setup.underlay import Underlay

# What another Python, another ROS or another build would bring in.
FOREIGN = (
    "PYTHONHOME", "PYTHONSTARTUP", "PYTHONPLATLIBDIR", "VIRTUAL_ENV", "PIP_TARGET", "PIP_PREFIX", "PIP_USER",
    "PIP_REQUIRE_HASHES", "UV_PYTHON", "UV_SYSTEM_PYTHON", "UV_TARGET", "UV_PREFIX", "DESTDIR", "MAKEFLAGS",
    "CMAKE_GENERATOR", "COLCON_DEFAULTS_FILE", "COLCON_EXTENSION_BLOCKLIST", "AMENT_CURRENT_PREFIX",
    "COLCON_CURRENT_PREFIX", "_ROS_WHEELS_BOOTSTRAP_COMPLETE",
    # The tools start one Python after the other: without compiled files each would compile all its modules anew.
    "PYTHONDONTWRITEBYTECODE",
)  # fmt: skip
OF_ROS = ('PYTHONPATH', 'AMENT_PREFIX_PATH', 'CMAKE_PREFIX_PATH', 'COLCON_PREFIX_PATH', 'ROS_PACKAGE_PATH')


def environment(environ: Mapping[str, str], layout: Layout, underlay: Underlay) -> dict[str, str]:
    """`environ` as the tools inside the virtual environment shall see it."""
    env = {name: value for name, value in environ.items() if name not in FOREIGN}
    drop_foreign_guard(env, str(layout.prefix))
    if not underlay.stock:
        for name in OF_ROS:
            env.pop(name, None)
    prefixes = [str(layout.prefix), *map(str, underlay.prefixes)]
    env['AMENT_PREFIX_PATH'] = env['CMAKE_PREFIX_PATH'] = os.pathsep.join(prefixes)
    env['PATH'] = os.pathsep.join([str(layout.prefix / 'bin'), env.get('PATH', os.defpath)])
    env['VIRTUAL_ENV'] = str(layout.prefix)
    env['COLCON_HOME'] = str(layout.state / 'colcon')
    return env


_NO_SPACE = re.compile(r'No space left on device|os error 28|ENOSPC|Errno 28|Disk quota exceeded', re.IGNORECASE)
_NO_MEMORY = re.compile(
    r'Killed signal terminated program|virtual memory exhausted|Cannot allocate memory', re.IGNORECASE
)
_NO_CACHE = re.compile(r'Failed to initialize cache at `([^`]+)`')
_BAD_HASH = re.compile(r'hash(es)? (mismatch|do not match)|DO NOT MATCH THE HASHES', re.IGNORECASE)
_NO_INDEX = re.compile(
    r'Failed to fetch|Request failed after|error sending request|dns error|tcp connect|Connection refused|'
    r'NewConnectionError|Max retries exceeded|ConnectTimeout|ReadTimeout|Temporary failure in name resolution|'
    r'Name or service not known|Network is unreachable|ProxyError|SSLError|Could not connect|'
    r'No matching distribution found|operation timed out',
    re.IGNORECASE,
)


def explain(what: str, output: str, log: str, environ: Mapping[str, str]) -> Exception:
    """The exception for a tool that failed with this output."""
    if _NO_SPACE.search(output):
        return PreflightError(f'the disk filled up while {what}', 'free some space (see: df -h .), then try again')
    if _NO_MEMORY.search(output):
        return PreflightError(f'memory ran out while {what}', 'close other programs, then run ./course again')
    if closed := _NO_CACHE.search(output):
        return PreflightError(
            f'uv, the installer, cannot write to {closed[1]}',
            'run: export HOME=FOLDER, with a folder that you may write to, then ./course again',
        )
    if _BAD_HASH.search(output):
        return PreflightError(
            'the package index serves a file that differs from the lock',
            'check the mirror in use (pip config list), or use https://pypi.org/simple',
        )
    if _NO_INDEX.search(output):
        index = environ.get('UV_DEFAULT_INDEX') or environ.get('UV_INDEX_URL') or environ.get('PIP_INDEX_URL')
        shown = re.sub(r'//[^/@]*@', '//', index) if index else 'https://pypi.org/simple'
        return PreflightError(
            f'the package index {shown} cannot be reached, or does not have a package',
            f'see whether a browser on this machine opens {shown}/uv/ (behind a proxy set HTTPS_PROXY, for a mirror '
            'PIP_INDEX_URL), then run ./course again',
        )
    tail = '\n'.join(output.strip().splitlines()[-20:])
    return StepError(f'failed: {what}', tail, log)
