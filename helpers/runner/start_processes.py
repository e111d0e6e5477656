"""How the processes of the learner's side and of the tests are started; a sandbox replaces this module.

Here the learner's side is a plain child process with limits: enough for a learner's own work in their own notebook.
`grading.sandbox` chooses what `grade` uses; everything else only sees `start`'s result.
"""

import os
import resource
import socket
from dataclasses import dataclass
from pathlib import Path

from environment.setup.startup import DEFAULTS
from helpers.programs.english import ENGLISH

ROOT = Path(__file__).resolve().parents[2]
PROFILE = Path(__file__).with_name('fastdds.xml')

SIGNALS = 4096  # that wait, timers included, of all processes in a sandbox

# Kept from the caller's environment: what makes Python and the ROS installation work, nothing else.
KEPT = (
    'PATH',
    'LD_LIBRARY_PATH',
    'AMENT_PREFIX_PATH',
    'PYTHONPATH',
    'ROS_DISTRO',
    'VIRTUAL_ENV',
    '_ROS_WHEELS_BOOTSTRAP_COMPLETE',
)


@dataclass(frozen=True)
class Limits:
    """Bounds for the learner's side; a test asks for others with `@pytest.mark.limits(name=value)`.

    The first ones hold for each process. The last ones hold for all processes together, and only in a sandbox.
    """

    memory: int = 3 * 2**30  # bytes of address space; an rclpy node needs 0.65 GB of it
    cpu: int = 120  # seconds
    files: int = 256  # open file descriptors
    file_size: int = 16 * 2**20  # bytes per file
    output: int = 64 * 2**10  # bytes of printed text that are kept, per program
    processes: int = 256  # processes and threads; an rclpy node has 16 threads
    total_memory: int = 2 * 2**30  # bytes of RAM
    tmp: int = 64 * 2**20  # bytes in /tmp
    home: int = 64 * 2**20  # bytes in the home directory
    shared: int = 16 * 2**20  # bytes in /dev/shm

    def apply(self, *, sandboxed: bool = False) -> None:
        """Bound the calling process. The kernel counts processes per user, so that is for a sandbox only."""
        bounds = {
            resource.RLIMIT_AS: self.memory,
            resource.RLIMIT_CPU: self.cpu,
            resource.RLIMIT_NOFILE: self.files,
            resource.RLIMIT_FSIZE: self.file_size,
            resource.RLIMIT_CORE: 0,
        }
        if sandboxed:
            bounds[resource.RLIMIT_NPROC] = self.processes
            bounds[resource.RLIMIT_MSGQUEUE] = 0
            bounds[resource.RLIMIT_MEMLOCK] = 2**20
            bounds[resource.RLIMIT_SIGPENDING] = SIGNALS
        for what, value in bounds.items():
            hard = resource.getrlimit(what)[1]
            value = value if hard == resource.RLIM_INFINITY else min(value, hard)
            resource.setrlimit(what, (value, value))


LIMITS = Limits()


def ros_environment(domain_id: int) -> dict[str, str]:
    """Environment variables that tests and learner's side share, so that they find each other.

    UDP only, and range SUBNET: with LOCALHOST Fast DDS brings shared memory back, which a sandbox does not share. It is
    the profile that keeps them to this machine.
    """
    return {
        **DEFAULTS,
        'ROS_DOMAIN_ID': str(domain_id),
        'ROS_AUTOMATIC_DISCOVERY_RANGE': 'SUBNET',
        'FASTDDS_BUILTIN_TRANSPORTS': 'UDPv4',
        'FASTRTPS_DEFAULT_PROFILES_FILE': str(PROFILE),
        'RMW_IMPLEMENTATION': 'rmw_fastrtps_cpp',
        'RMW_FASTRTPS_PUBLICATION_MODE': 'SYNCHRONOUS',
        'PYTHONHASHSEED': '0',
        'PYTHONDONTWRITEBYTECODE': '1',
        'PYTHONUNBUFFERED': '1',
    }


def environment(domain_id: int, home: str) -> dict[str, str]:
    """The learner's side's whole environment: nothing of the caller's but what Python and ROS need."""
    kept = {name: os.environ[name] for name in KEPT if name in os.environ}
    path = os.pathsep.join([str(ROOT), *filter(None, [kept.get('PYTHONPATH')])])
    return {
        **kept,
        **ENGLISH,
        **ros_environment(domain_id),
        'PYTHONPATH': path,
        'HOME': home,
        'TMPDIR': home,
        'ROS_LOG_DIR': home,
        'COURSE_RUNNER': '1',
    }


@dataclass
class StartedForkServer:
    """The running fork server of a session's programs, as the tests see it."""

    control: socket.socket
    sandbox: str
    home_folder: str  # where the learner's side may write

    def close(self) -> None:
        """End the programs, and wait until they have ended. Idempotent."""
        if self.control.fileno() >= 0:
            self.control.shutdown(socket.SHUT_WR)  # the fork server kills its children when it sees this
            self.control.settimeout(10)
            try:
                while self.control.recv(65536):
                    pass
            except OSError:
                pass
            self.control.close()


control: socket.socket | None = None  # in a process of tests: to its session's fork server
home = ''  # of that one


def start(domain_id: int, limits: Limits = LIMITS) -> StartedForkServer:
    """The fork server that has been started together with this process of tests."""
    if control is None:
        raise RuntimeError('this launcher works in a process that `helpers.runner.tests_process` has started')
    return StartedForkServer(control, 'none', home)
