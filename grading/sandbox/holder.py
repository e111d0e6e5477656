"""A running bubblewrap that others enter.

bubblewrap makes the namespaces and mounts, and starts a program that does nothing as process 1 of the sandbox.
Processes that are already warm then enter with setns. What runs inside cannot kill process 1; when that one ends, so
does all.
"""

import json
import os
import select
import signal
import subprocess
import time

from grading.sandbox import mounts, namespaces

PATIENCE = 20.0  # seconds, on a machine under load


class SandboxError(Exception):
    """bubblewrap did not start."""


class Holder:
    """The sandbox that `arguments` describe. Raises SandboxError."""

    def __init__(self, arguments: list[str], inside: int | None = None, filter_: bytes = b''):
        """`inside`: a pidfd; the sandbox is made within the user and network namespaces of that process.

        `filter_`: of system calls, for process 1.
        """

        def enter() -> None:
            if inside is not None:
                namespaces.join(inside, namespaces.NEWUSER | namespaces.NEWNET)

        read, write = os.pipe()
        passed = [write, os.open('/usr/bin/cat', os.O_RDONLY)]
        words = [arguments[0], '--info-fd', str(write), *mounts.keeper(passed[1])]
        if filter_:
            passed.append(os.memfd_create('filter'))
            os.write(passed[-1], filter_)
            os.lseek(passed[-1], 0, os.SEEK_SET)
            words += ['--seccomp', str(passed[-1])]
        try:
            self.process = subprocess.Popen(
                [*words, *arguments[1:]],
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                stderr=subprocess.PIPE,
                pass_fds=passed,
                # Not the environment's LD_LIBRARY_PATH: bubblewrap would look for its libraries in each folder of that.
                env={'PATH': os.environ.get('PATH', os.defpath)},
                preexec_fn=enter,
                start_new_session=True,
            )
        except (OSError, subprocess.SubprocessError) as error:
            os.close(read)
            raise SandboxError(f'{arguments[0]}: {error}') from None
        finally:
            for descriptor in passed:
                os.close(descriptor)
        try:
            self.pid = self._ready(read)
            self.pidfd = os.pidfd_open(self.pid)
        except (ValueError, KeyError, OSError) as error:
            self.process.kill()
            text = self.process.communicate()[1].decode(errors='replace').strip()
            raise SandboxError(text or f'{arguments[0]}: {error}') from None
        finally:
            os.close(read)

    def _ready(self, info: int) -> int:
        """Wait until process 1 runs; returns its pid."""
        deadline = time.monotonic() + PATIENCE
        text = b''
        while not text.rstrip().endswith(b'}'):
            if not select.select([info], [], [], max(0.0, deadline - time.monotonic()))[0]:
                raise OSError('no answer')
            chunk = os.read(info, 4096)
            if not chunk:
                raise OSError('it ended')
            text += chunk
        assert self.process.stdin is not None and self.process.stdout is not None  # both are pipes
        # All is mounted before the program starts, which sends back what it gets.
        try:
            os.write(self.process.stdin.fileno(), b'\n')
        except BrokenPipeError:
            raise OSError('it ended') from None
        out = self.process.stdout.fileno()
        if not select.select([out], [], [], max(0.0, deadline - time.monotonic()))[0] or not os.read(out, 1):
            raise OSError('it ended')
        return json.loads(text)['child-pid']

    def close(self) -> None:
        """Kill all that runs in the sandbox, and wait until it has gone. Idempotent."""
        if self.process.returncode is None:
            try:
                signal.pidfd_send_signal(self.pidfd, signal.SIGKILL)
            except ProcessLookupError:
                pass
            self.process.communicate()
            os.close(self.pidfd)
