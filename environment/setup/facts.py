"""What this machine has, what is missing, and which command repairs that: what `./course doctor` prints.

Standard library only. `facts(root)` runs all probes; each probe is a function of its own that returns one `Fact`.
"""

import os
import shutil
import socket
import stat
import subprocess
from collections.abc import Callable, Iterator, Mapping
from ctypes.util import find_library
from dataclasses import dataclass
from pathlib import Path

from environment.setup import interpreter, preflight, startup
from environment.setup.cache import Cache
from environment.setup.cache import folder as cache_folder
from environment.setup.errors import PreflightError
from environment.setup.layout import Layout
from environment.setup.steps import Setup
from environment.setup.underlay import Underlay, parse

SPACE_WANTED = 1_000_000_000  # bytes for notebooks, logs, submissions
RANGES = ('SUBNET', 'LOCALHOST', 'OFF', 'SYSTEM_DEFAULT')
HIGHEST_DOMAIN = 101  # above it DDS ports fall into the range that Linux gives to outgoing connections


@dataclass(frozen=True)
class Fact:
    """One line of the report.

    `ok` is whether it is as it should be; if not, `remedy` says what to do. If something `required` is missing, the
    course does not work; otherwise only what `text` names does not. `instructors`: nobody else needs it.
    """

    name: str
    ok: bool
    text: str
    remedy: str = ''
    required: bool = True
    instructors: bool = False


def facts(root: Path, environ: Mapping[str, str] = os.environ) -> Iterator[Fact]:
    """All facts, in the order of the report, those for instructors last.

    A probe that fails itself becomes a fact that is not as it should be, never an exception.
    """
    layout = Layout(root)
    probes: tuple[Callable[[], Fact], ...] = (
        lambda: python(layout),
        lambda: underlay(layout, environ),
        lambda: overlay(layout, environ),
        lambda: compiler(environ),
        lambda: disk(root),
        lambda: cache(layout, environ),
        lambda: shared_memory(),
        lambda: domain(environ, layout),
        lambda: discovery(environ),
        lambda: wire(layout, environ),
        lambda: port('JupyterLab', 8888),
        lambda: graphics(),
        lambda: readable_by_others(layout),
        lambda: sandbox(attempt=lambda: try_grading(layout)),
        lambda: browser(),
    )
    for probe in probes:
        try:
            yield probe()
        except Exception as error:  # the report must go on
            yield Fact('a probe', False, f'failed: {error!r}', 'please report this', required=False)


def python(layout: Layout) -> Fact:
    """Whether the environment's interpreter is whole."""
    found = interpreter.probe(str(_base(layout)))
    if found is None:
        return Fact('Python', False, f'{_base(layout)} does not run', f'run: rm -rf {layout.prefix} && ./course doctor')
    text = f'{".".join(map(str, found.version))} ({found.path})'
    try:
        interpreter.demand(found)
    except PreflightError as error:
        return Fact('Python', False, error.what, error.remedy)
    return Fact('Python', True, text)


def _base(layout: Layout) -> Path:
    return Path(os.path.realpath(layout.python))


def closed_to_others(path: Path, within: Path | None = None) -> Path | None:
    """The first directory on the way to `path`, or `path` itself, that other users cannot enter or read.

    :param within: the folder at which the way begins
    """
    for step in [*reversed(path.parents), path]:
        if within and not step.is_relative_to(within):
            continue
        mode = step.stat().st_mode
        needed = stat.S_IXOTH if step != path or not path.is_dir() else stat.S_IXOTH | stat.S_IROTH
        if mode & needed != needed:
            return step
    return None


def readable_by_others(layout: Layout) -> Fact:
    """Whether another user, such as the grader's, can run the environment's Python."""
    name = 'Python for other users'
    closed = closed_to_others(_base(layout))
    if closed:
        text = f'{closed} is private, so that a sandbox under another user cannot run {_base(layout)}'
        remedy = 'to grade in a sandbox: COURSE_PYTHON=/usr/bin/python3 ./course doctor (makes the environment anew)'
        return Fact(name, False, text, remedy, required=False, instructors=True)
    closed = closed_to_others(layout.prefix, layout.root)  # a sandbox is shown this folder wherever it is
    if closed:
        text = f'{closed} is private, so that a sandbox under another user cannot read the environment'
        remedy = f'to grade in a sandbox: chmod -R o+rX {layout.root}'
        return Fact(name, False, text, remedy, required=False, instructors=True)
    return Fact(name, True, 'readable', instructors=True)


def recorded_underlay(layout: Layout) -> Underlay:
    """The underlay that the environment was made for."""
    made_for = Setup(layout, Underlay(), {}).venv_facts()
    return parse(made_for['underlay']) if made_for else Underlay()


def underlay(layout: Layout, environ: Mapping[str, str]) -> Fact:
    found = recorded_underlay(layout)
    if not found.stock:
        return Fact('ROS underlay', True, 'Jazzy, wheels from PyPI')
    gone = [p for p in found.prefixes if not p.is_dir()]
    if gone:
        return Fact('ROS underlay', False, f'{gone[0]} is gone', 'run ./course doctor in a terminal without it')
    return Fact('ROS underlay', True, f'stock Jazzy in {found}')


def overlay(layout: Layout, environ: Mapping[str, str]) -> Fact:
    """Whether the environment is what the lock and the sources ask for."""
    plain = {name: value for name, value in environ.items() if name != 'COURSE_PYTHON'}
    setup = Setup(layout, recorded_underlay(layout), plain)
    stale = setup.stale()
    if stale:
        return Fact('course packages', False, f'not fresh: {", ".join(stale)}', 'run: ./course doctor')
    count = len(setup.packages())
    return Fact('course packages', True, f'{count} built' if count else 'all in the underlay')


def compiler(environ: Mapping[str, str]) -> Fact:
    try:
        preflight.check_compiler(environ)
    except PreflightError as error:
        return Fact('C++ compiler', False, error.what, error.remedy)
    return Fact('C++ compiler', True, 'compiles and links')


def disk(root: Path) -> Fact:
    free = shutil.disk_usage(root).free
    text = f'{free / 1e9:.1f} GB free at {root}'
    return Fact('disk', free >= SPACE_WANTED, text, f'free at least {SPACE_WANTED / 1e9:.0f} GB (see: df -h {root})')


def cache(layout: Layout, environ: Mapping[str, str]) -> Fact:
    """Where built ROS packages are kept for another copy of the course on this machine."""
    found = Cache(cache_folder(environ), layout.prefix)
    name, problem = 'built packages', found.problem()
    if problem:
        remedy = 'nothing needs to be done: a second copy builds for itself'
        return Fact(name, False, f'not kept for other copies: {problem}', remedy, required=False)
    count, size = found.size()
    return Fact(name, True, f'{count} kept for other copies in {found.directory} ({size / 1e6:.0f} MB)')


def shared_memory(directory: Path = Path('/dev/shm')) -> Fact:
    """Fast DDS hands messages between processes of one machine through shared memory."""
    remedy = 'mount it: sudo mount -t tmpfs -o mode=1777,size=256m tmpfs /dev/shm (Docker: --shm-size=256m)'
    if not directory.is_dir() or not os.access(directory, os.W_OK):
        return Fact('shared memory', False, f'{directory} is not writable: large messages are slow', remedy, False)
    free = shutil.disk_usage(directory).free
    remedy = f'start ./course lab again, which removes what killed programs have left there; or {remedy}'
    return Fact('shared memory', free >= 32_000_000, f'{free / 1e6:.0f} MB free in {directory}', remedy, False)


def domain(environ: Mapping[str, str], layout: Layout | None = None) -> Fact:
    """Which ROS domain the programs of this terminal are in; `layout` tells which one is this copy's own."""
    text = environ.get('ROS_DOMAIN_ID', '')
    memory = layout.prefix / startup.DOMAIN if layout else None
    if text and memory and memory.is_file() and memory.read_text().strip() == text:
        return Fact('ROS domain', True, f"{text} (this copy's own)")
    remedy = f'run: export ROS_DOMAIN_ID=N, with N from 0 to {HIGHEST_DOMAIN}, or unset ROS_DOMAIN_ID'
    if not text:
        return Fact('ROS domain', True, '0 (ROS_DOMAIN_ID is not set)')
    if not text.isdecimal() or int(text) > 232:
        return Fact('ROS domain', False, f'ROS_DOMAIN_ID={text} is no domain', remedy)
    if int(text) > HIGHEST_DOMAIN:
        text = f'ROS_DOMAIN_ID={text}: its ports may collide with outgoing connections'
        return Fact('ROS domain', False, text, remedy, required=False)
    return Fact('ROS domain', True, text)


def discovery(environ: Mapping[str, str]) -> Fact:
    """How far nodes look for each other."""
    text = environ.get('ROS_AUTOMATIC_DISCOVERY_RANGE', 'SUBNET')
    if text not in RANGES:
        known = ', '.join(RANGES)
        return Fact('discovery range', False, f'{text} is unknown to ROS', f'set it to one of {known}, or unset it')
    if text == 'OFF':
        remedy = 'run: unset ROS_AUTOMATIC_DISCOVERY_RANGE'
        return Fact('discovery range', False, 'OFF: nodes do not find each other', remedy)
    reach = {'LOCALHOST': 'this machine only', 'SUBNET': 'the whole local network'}
    return Fact('discovery range', True, f'{text} ({reach.get(text, "as the DDS profile says")})')


# With these a user may have parted nodes that are on one machine.
_ON_THE_WIRE = (
    'ROS_DOMAIN_ID',
    'ROS_STATIC_PEERS',
    'ROS_SECURITY_ENABLE',
    'RMW_IMPLEMENTATION',
    'FASTDDS_BUILTIN_TRANSPORTS',
    'FASTDDS_DEFAULT_PROFILES_FILE',
    'FASTRTPS_DEFAULT_PROFILES_FILE',
)
# Two nodes, each in its own participant, so that the message takes the way it takes between two programs.
_EXCHANGE = """
import os, time, rclpy
from std_msgs.msg import String
contexts = [rclpy.Context(), rclpy.Context()]
for context in contexts:
    rclpy.init(context=context)
talker, listener = (rclpy.create_node(n, context=c) for n, c in zip(("doctor_talker", "doctor_listener"), contexts))
heard = []
topic = f"doctor_{os.getpid()}"
listener.create_subscription(String, topic, heard.append, 10)
publisher = talker.create_publisher(String, topic, 10)
executor = rclpy.executors.SingleThreadedExecutor(context=contexts[1])
executor.add_node(listener)
end = time.monotonic() + 10
while not heard and time.monotonic() < end:
    publisher.publish(String(data="hello"))
    executor.spin_once(timeout_sec=0.1)
executor.shutdown()
for node, context in zip((talker, listener), contexts):
    node.destroy_node()
    context.shutdown()
print("heard" if heard else "silence")
"""


def wire(layout: Layout, environ: Mapping[str, str]) -> Fact:
    """Whether a message really travels from one ROS participant to another."""
    try:
        trial = subprocess.run(
            [layout.python, '-c', _EXCHANGE], env=dict(environ), capture_output=True, text=True, timeout=30, check=False
        )
    except subprocess.TimeoutExpired:
        return Fact('a message by ROS', False, 'nothing within 30 s', 'run: ./course doctor, with the network up')
    if trial.stdout.strip() == 'heard':
        return Fact('a message by ROS', True, 'sent and received')
    reason = (trial.stderr.strip().splitlines() or ['no message within 10 s'])[-1]
    if reason.startswith(('ImportError', 'ModuleNotFoundError', 'AttributeError')):
        # Folders of PYTHONPATH come first: a module of another installation, or a yaml.py, stands in for the right one.
        own = [str(layout.root), *filter(None, environ.get('AMENT_PREFIX_PATH', '').split(os.pathsep))]
        folders = [Path(one) for one in environ.get('PYTHONPATH', '').split(os.pathsep) if one]
        foreign = os.pathsep.join(str(one) for one in folders if not any(one.is_relative_to(root) for root in own))
        remedy = 'run: unset PYTHONPATH' if foreign else 'run: rm -rf .venv, then ./course'
        return Fact('a message by ROS', False, reason + (f'; PYTHONPATH is {foreign}' if foreign else ''), remedy)
    usual: dict[str, str] = {}
    startup.give_defaults(usual, str(layout.prefix))
    chosen = [name for name in _ON_THE_WIRE if environ.get(name) not in (None, usual.get(name))]
    remedies = [f'run: unset {" ".join(chosen)}'] if chosen else []
    return Fact('a message by ROS', False, reason, '; '.join([*remedies, 'let the firewall pass UDP on lo']))


def port(user: str, number: int) -> Fact:
    """Whether `user` gets its usual port; it takes the next one otherwise."""
    with socket.socket() as probe:
        probe.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        try:
            probe.bind(('127.0.0.1', number))
        except OSError:
            text = f'{number} is in use, {user} will take another'
            return Fact('port', False, text, f"see who has it: ss -ltnp 'sport = :{number}'", required=False)
    return Fact('port', True, f'{number} is free for {user}')


def try_grading(layout: Layout) -> str:
    """Make the grader's sandbox; returns '' when it works, else what went wrong. Without a grader: `try_bubblewrap`."""
    if not Path(layout.root, 'grading', 'sandbox', 'probe.py').is_file():
        return try_bubblewrap()
    try:
        trial = subprocess.run(
            [layout.python, '-m', 'grading.sandbox.probe', '--as-grader'],
            cwd=layout.root,
            capture_output=True,
            text=True,
            timeout=60,
            check=False,
        )
    except (OSError, subprocess.TimeoutExpired) as error:
        return str(error)
    return '' if trial.returncode == 0 else (trial.stderr.strip().splitlines() or ['no reason given'])[-1]


def try_bubblewrap() -> str:
    """Start bubblewrap by itself; returns '' when it works, else what it said."""
    command = ['bwrap', '--ro-bind', '/', '/', '--dev', '/dev', '--proc', '/proc', '--tmpfs', '/tmp']
    command += ['--unshare-user', '--unshare-pid', '--unshare-ipc', '--unshare-net', '--die-with-parent', 'true']
    try:
        trial = subprocess.run(command, capture_output=True, text=True, timeout=10, check=False)
    except (OSError, subprocess.TimeoutExpired) as error:
        return str(error)
    return '' if trial.returncode == 0 else trial.stderr.strip() or f'exit status {trial.returncode}'


def sandbox(
    which: Callable[[str], str | None] = shutil.which,
    attempt: Callable[[], str] = try_bubblewrap,
    kernel: Path = Path('/proc/sys'),
) -> Fact:
    """Whether submissions can be graded in a sandbox; learners do not need it."""
    name = 'sandbox for grading'
    if which('bwrap') is None:
        remedy = 'run: sudo apt install bubblewrap'
        return Fact(name, False, 'bubblewrap is missing', remedy, required=False, instructors=True)
    failure = attempt()
    if not failure:
        return Fact(name, True, 'bubblewrap works', instructors=True)
    text = f'bubblewrap does not work: {failure}'
    return Fact(name, False, text, namespace_remedy(kernel), required=False, instructors=True)


def namespace_remedy(kernel: Path = Path('/proc/sys')) -> str:
    """What lets an ordinary user make namespaces on this machine."""

    def setting(name: str) -> str:
        try:
            return (kernel / name).read_text().strip()
        except OSError:
            return ''

    if setting('kernel/apparmor_restrict_unprivileged_userns') == '1':
        profile = '/usr/share/apparmor/extra-profiles/bwrap-userns-restrict'
        return (
            'AppArmor forbids user namespaces; run: sudo apt install apparmor-profiles && '
            f'sudo ln -s {profile} /etc/apparmor.d/ && sudo apparmor_parser -r {profile}'
        )
    if setting('kernel/unprivileged_userns_clone') == '0':
        return 'run: sudo sysctl -w kernel.unprivileged_userns_clone=1'
    if setting('user/max_user_namespaces') == '0':
        return 'run: sudo sysctl -w user.max_user_namespaces=10000'
    return 'in a container: allow user namespaces (Docker: --security-opt seccomp=unconfined)'


def browser(which: Callable[[str], str | None] = shutil.which) -> Fact:
    """Tests open the notebooks in a browser; without one those tests are left out."""
    names = ('chromium', 'chromium-browser', 'google-chrome', 'chrome')
    found = next(filter(None, map(which, names)), None)
    if found:
        return Fact('browser for tests', True, found, instructors=True)
    text = 'no chromium: the tests in a browser are left out'
    return Fact('browser for tests', False, text, 'run: sudo apt install chromium', required=False, instructors=True)


def graphics() -> Fact:
    """A library that draws without a screen; needed for simulated cameras only."""
    found = [name for name in ('EGL', 'OSMesa') if find_library(name)]
    if found:
        return Fact('off-screen OpenGL', True, ' and '.join(found))
    text = 'neither EGL nor OSMesa: no simulated cameras'
    return Fact('off-screen OpenGL', False, text, 'run: sudo apt install libegl1 libgl1-mesa-dri', required=False)
