"""One operating system process with its children, and what it writes."""

from __future__ import annotations

import asyncio
import contextlib
import os
import signal
import subprocess
import time
from collections.abc import Callable

STDOUT, STDERR = 0, 1
_GRACE_FOR_OUTPUT = 1.0  # seconds; a grandchild may keep the pipe open for ever
_CHUNK = 65536  # bytes to read at a time: all that a pipe holds
_LOOK_AGAIN = 0.02  # seconds between two looks at a group: no one tells of the end of a grandchild


class ChildProcess:
    """
    A running process. Make one with ``start``.

    ``on_output`` is called with STDOUT or STDERR and the bytes read at once, which need not be whole lines.
    """

    def __init__(self, process: asyncio.subprocess.Process, readers: list[asyncio.Task]):
        self._process, self._readers = process, readers
        self.pid = process.pid

    @classmethod
    async def start(
        cls,
        command: str | list[str],
        *,
        cwd: str | None,
        env: dict[str, str],
        tty: bool,
        on_output: Callable[[int, bytes], None],
    ) -> ChildProcess:
        """
        Start a program in a session of its own.

        :param command: a list of words, or a text for a shell
        :param tty: give it terminals to write to, instead of pipes
        :raises OSError: if it cannot be started
        """
        pipes = [os.openpty() if tty else os.pipe() for _ in (STDOUT, STDERR)]
        try:
            create = asyncio.create_subprocess_shell if isinstance(command, str) else asyncio.create_subprocess_exec
            process = await create(
                *([command] if isinstance(command, str) else command),
                stdin=subprocess.PIPE,
                stdout=pipes[STDOUT][1],
                stderr=pipes[STDERR][1],
                cwd=cwd,
                env=env,
                start_new_session=True,
            )
        except BaseException:
            for read_end, _ in pipes:
                os.close(read_end)
            raise
        finally:
            for _, write_end in pipes:
                os.close(write_end)
        readers = [asyncio.create_task(_read(pipes[i][0], i, on_output)) for i in (STDOUT, STDERR)]
        return cls(process, readers)

    @property
    def running(self) -> bool:
        """True until the process has ended; its children may live on."""
        return self._process.returncode is None

    async def wait(self) -> int:
        """Wait for the end of the process and of its output; return the exit code, negative for a signal."""
        code = await self._process.wait()
        _, open_ones = await asyncio.wait(self._readers, timeout=_GRACE_FOR_OUTPUT)
        for reader in open_ones:
            reader.cancel()
        return code

    def signal(self, number: signal.Signals) -> None:
        """Send a signal to the process and its children; harmless if all have ended."""
        with contextlib.suppress(ProcessLookupError, PermissionError):
            os.killpg(self.pid, number)

    async def gone(self, timeout: float) -> bool:
        """Wait until the process and its children have ended; return False if they need longer."""
        end = time.monotonic() + timeout
        try:
            await asyncio.wait_for(self._process.wait(), timeout)
        except asyncio.TimeoutError:
            return False
        while _group_lives(self.pid):
            if time.monotonic() >= end:
                return False
            await asyncio.sleep(_LOOK_AGAIN)
        return True


def _group_lives(group: int) -> bool:
    try:
        os.killpg(group, 0)
    except ProcessLookupError:
        return False
    except PermissionError:
        pass
    return True


async def _read(descriptor: int, source: int, on_output: Callable[[int, bytes], None]) -> None:
    """Pass on what comes until the other end is closed."""
    loop = asyncio.get_running_loop()
    os.set_blocking(descriptor, False)
    readable = asyncio.Event()
    loop.add_reader(descriptor, readable.set)
    try:
        while True:
            await readable.wait()
            readable.clear()
            try:
                data = os.read(descriptor, _CHUNK)
            except BlockingIOError:
                continue
            except OSError:  # what a terminal gives instead of an end of file
                break
            if not data:
                break
            on_output(source, data)
    finally:
        loop.remove_reader(descriptor)
        os.close(descriptor)
