"""Runs the tools that the set-up calls."""

import contextlib
import os
import selectors
import signal
import subprocess
import time
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path

GRACE = 10.0  # seconds that an interrupted tool has to end by itself


def run(
    argv: Sequence[str | os.PathLike],
    log: Path,
    environment: Mapping[str, str],
    on_line: Callable[[str], None] = lambda line: None,
    cwd: Path | None = None,
    keep: Sequence[int] = (),
) -> tuple[int, str]:
    """Run `argv` to its end; its output goes to the file `log`, each line also to `on_line`.

    Returns the exit status and the output. `keep` are file descriptors that the tool shall hold. The tool has its own
    process group: an exception here, such as a KeyboardInterrupt, ends the whole group before it goes on.
    """
    log.parent.mkdir(parents=True, exist_ok=True)
    lines: list[str] = []
    with log.open('wb') as sink:
        process = subprocess.Popen(
            [os.fspath(a) for a in argv],
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            env=dict(environment),
            cwd=cwd,
            start_new_session=True,
            pass_fds=tuple(keep),
        )
        try:
            for line in _lines(process):
                if line is None:
                    on_line('')
                    continue
                sink.write(line)
                lines.append(line.decode(errors='replace'))
                on_line(lines[-1])
            process.wait()
        except BaseException:
            _end(process)
            raise
        finally:
            process.stdout.close()
    return process.returncode, ''.join(lines)


def _lines(process: subprocess.Popen):
    """Lines of output as they come; None once a second in between, so that a clock can be drawn."""
    descriptor = process.stdout.fileno()
    pending = b''
    with selectors.DefaultSelector() as selector:
        selector.register(descriptor, selectors.EVENT_READ)
        while True:
            if not selector.select(timeout=1.0):
                # A tool's forgotten grandchild may hold the pipe open: the tool's own end counts.
                if process.poll() is not None:
                    break
                yield None
                continue
            block = os.read(descriptor, 65536)
            if not block:
                break
            *whole, pending = (pending + block).split(b'\n')
            for line in whole:
                yield line + b'\n'
    if pending:
        yield pending


def _end(process: subprocess.Popen) -> None:
    """Interrupt the group; kill what is left of it after `GRACE` seconds."""
    with contextlib.suppress(ProcessLookupError):
        os.killpg(process.pid, signal.SIGINT)
    deadline = time.monotonic() + GRACE
    while process.poll() is None and time.monotonic() < deadline:
        with contextlib.suppress(subprocess.TimeoutExpired):
            process.wait(deadline - time.monotonic())
    with contextlib.suppress(ProcessLookupError):
        os.killpg(process.pid, signal.SIGKILL)
    process.wait()
