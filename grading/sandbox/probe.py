"""Whether this machine can run the sandbox, found out by running it: `python -m grading.sandbox.probe`.

With `--as-grader` it gives up being root first, as the grader does.

Prints nothing and ends with 0 when it works; else one line that says what went wrong.
"""

import os
import subprocess
import sys
import traceback

from environment.setup.facts import namespace_remedy
from grading.sandbox import mounts, namespaces, seccomp, unprivileged
from grading.sandbox.holder import Holder, SandboxError
from helpers.paths import ROOT
from helpers.runner.start_processes import Limits

INSTALL = 'sudo apt-get install bubblewrap'


def problem() -> str:
    """What keeps the sandbox from working, as one line with the remedy; empty if nothing does."""
    if mounts.bwrap() is None:
        return f'bubblewrap is not installed; run: {INSTALL}'
    said = failure()
    return f'{said}; {namespace_remedy()}' if said else ''


def failure() -> str:
    """What went wrong when both sandboxes were made as the grader makes them; empty if nothing did."""
    words = [sys.executable, '-m', 'grading.sandbox.probe']
    try:
        done = subprocess.run(
            unprivileged.command(words, [ROOT, *mounts.readable()]),
            cwd='/',
            capture_output=True,
            text=True,
            timeout=60,
            # LTTng, which rcl brings, would wait for 3 s for its daemon, which cannot be reached from there.
            env={**os.environ, 'PYTHONPATH': str(ROOT), 'LTTNG_UST_REGISTER_TIMEOUT': '0'},
        )
    except (OSError, subprocess.TimeoutExpired) as error:
        return f'the sandbox does not work: {error}'
    if done.returncode == 0:
        return ''
    said = (done.stdout.strip() or done.stderr.strip() or f'exit status {done.returncode}').splitlines()[-1]
    if 'Permission denied' in said and os.geteuid() == 0 and 'bwrap' not in said:
        return (
            f'the sandbox does not work: {said}; root grades as the user {unprivileged.account().pw_name}, '
            f'who must be able to read the course; run: chmod -R o+rX {ROOT}'
        )
    return f'the sandbox does not work: {said}'


def attempt() -> None:
    """Make both sandboxes, one within the other's network, and enter the inner one."""
    outer = Holder(mounts.tests([]))
    inner = Holder(mounts.programs(Limits()), outer.pidfd)
    pid = os.fork()
    if pid == 0:
        try:
            namespaces.join(inner.pidfd, namespaces.ALL)
            namespaces.give_up_privileges()
            seccomp.install()
            os.listdir(sys.prefix)
            os.execv(sys.executable, [sys.executable, '-c', 'import rclpy'])
        except OSError:
            traceback.print_exc(limit=0)
        finally:
            os._exit(1)
    _, status = os.waitpid(pid, 0)
    inner.close()
    outer.close()
    if status:
        raise SandboxError('Python does not run in it')


if __name__ == '__main__':
    if sys.argv[1:] == ['--as-grader']:
        sys.exit(failure() or 0)
    try:
        attempt()
    except (SandboxError, OSError) as error:
        sys.exit(str(error).splitlines()[-1])
