"""Set-up of a fresh clone: without any cache, with the installers' caches, with that of built packages, and bytes.

Cold: no `.venv`, empty caches; what the machine's disk cache holds stays. Warm: `.venv` deleted, the caches of uv and
pip that the cold one filled. Both build all ROS packages. Second copy: `.venv` deleted, and all caches, as another copy
of the course on this machine finds them. Nothing to do: the next `./course`. The bytes are what all
network interfaces but the loopback received meanwhile, so nothing else should download; an index on this machine's own
disk (pip's configuration counts, as it does for a learner) adds nothing to them.
"""

import os
import re
import shutil
import subprocess
import tempfile
import time
from collections.abc import Iterator
from pathlib import Path

import psutil

from helpers import paths

PATIENCE = 3600  # s
# Variables of this course's environment and of other ROS installations; a learner's terminal has none.
_FOREIGN = re.compile('_?(ROS|AMENT|COLCON|CMAKE|PYTHON|VIRTUAL|CONDA|COURSE|LD_|RCUTILS|(PIP|UV)_(NO_)?CACHE)')


def measure() -> Iterator[tuple[str, float, str]]:
    """Yield the seconds of the whole and of each step, bytes received, and the size of what is made.

    :raises RuntimeError: there is no git repository to clone, or the set-up failed.
    """
    (paths.ROOT / 'build').mkdir(exist_ok=True)
    with tempfile.TemporaryDirectory(prefix='bench-setup-', dir=paths.ROOT / 'build') as folder:
        clone, caches = Path(folder, 'course'), Path(folder, 'caches')
        _run(['git', 'clone', '-q', '--no-hardlinks', str(paths.ROOT), str(clone)], None)
        environ = {name: value for name, value in os.environ.items() if not _FOREIGN.match(name)}
        own = str(paths.ROOT / '.venv' / 'bin')
        environ['PATH'] = os.pathsep.join(part for part in os.environ['PATH'].split(os.pathsep) if part != own)
        environ |= {
            'UV_CACHE_DIR': str(caches / 'uv'),
            'PIP_CACHE_DIR': str(caches / 'pip'),
            'XDG_CACHE_HOME': str(caches / 'others'),
        }
        for kind in ('cold', 'warm', 'second copy'):
            if kind == 'warm':
                shutil.rmtree(caches / 'others', ignore_errors=True)
            shutil.rmtree(clone / '.venv', ignore_errors=True)
            received = _received()
            seconds, steps = _course(clone, environ)
            received = _received() - received
            yield f'{kind}: all', seconds, 's'
            for step, spent in steps:
                yield f'{kind}: {step}', spent, 's'
            yield f'{kind}: received', received / 1e6, 'MB'
        yield 'nothing to do', _course(clone, environ)[0], 's'
        yield 'the clone with its .venv', _size(clone) / 1e9, 'GB'


def _course(clone: Path, environ: dict[str, str]) -> tuple[float, list[tuple[str, float]]]:
    """Seconds of ``./course setup``, and of the steps that it tells of."""
    begin = time.perf_counter()
    told = _run([str(clone / 'course'), 'setup'], environ)
    seconds = time.perf_counter() - begin
    return seconds, [(step, float(spent)) for step, spent in re.findall(r'^(.+): ([\d.]+) s$', told, re.MULTILINE)]


def _run(argv: list[str], environ: dict[str, str] | None) -> str:
    done = subprocess.run(argv, env=environ, capture_output=True, text=True, timeout=PATIENCE)
    if done.returncode:
        raise RuntimeError(f'{Path(argv[0]).name} {argv[1]} ended with {done.returncode}: {done.stderr.strip()[-800:]}')
    return done.stderr


def _received() -> int:
    return sum(counts.bytes_recv for name, counts in psutil.net_io_counters(pernic=True).items() if name != 'lo')


def _size(folder: Path) -> int:
    return sum(path.lstat().st_size for path in folder.rglob('*') if not path.is_symlink())
