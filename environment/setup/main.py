"""`./course ANY ARGUMENTS`: make sure of the environment, then become the course's command line inside it."""

import os
import shutil
import signal
import subprocess
from collections.abc import Mapping
from pathlib import Path

from environment.setup import interpreter, interruption, mutex, preflight, startup, tools, usage
from environment.setup import underlay as underlays
from environment.setup.console import Console
from environment.setup.errors import PreflightError, StepError
from environment.setup.layout import Layout
from environment.setup.stamps import Stamps
from environment.setup.steps import VERSION, Setup

ROOT = Path(__file__).resolve().parents[2]
FAILED, UNUSABLE = 1, 2
# Not `python -m`: that would import first from the folder in which the command is given. This may be another checkout,
# or hold a json.py of a learner's.
_START = (
    'import sys; sys.path[0] = sys.argv.pop(1); '
    'from environment.setup import interruption; interruption.ends_at_once(); '
    'from helpers.cli.app import main; sys.exit(main())'
)

# Of the settings that `startup.drop_settings_of_another_ros` drops those whose owner has to know.
_DROPPED = {
    'RMW_IMPLEMENTATION': 'this ROS does not have it, and runs on Fast DDS',
    'ROS_DISCOVERY_SERVER': "the course's nodes find each other without a server",
}


def main(arguments: list[str], root: Path = ROOT) -> int:
    """Returns an exit status; on success it does not return, as this process becomes the command line."""
    layout = Layout(root)
    console = Console()
    interruption.raises()
    try:
        if usage.asked(arguments) and not _ready(layout, os.environ):
            print(usage.text(root))
            return 0
        underlay = ensure(layout, os.environ, console)
        interruption.ends_at_once()
    except PreflightError as error:
        console.line(f'course: {error}')
        return UNUSABLE
    except StepError as failure:
        console.line(failure.tail)
        console.line(f'course: {failure.what}; the whole output is in {failure.log}')
        return FAILED
    except KeyboardInterrupt:
        console.line('course: interrupted; the next ./course goes on from here')
        return 128 + signal.SIGINT
    python = str(layout.python)
    env = activated(layout, underlay, os.environ)
    for name, why in _DROPPED.items():
        if os.environ.get(name) and name not in env:
            console.line(f'course: {name}={os.environ[name]} does not count here: {why}')
    interruption.waits()
    os.execve(python, [python, '-c', _START, str(root), *arguments], env)


def _ready(layout: Layout, environ: Mapping[str, str]) -> bool:
    """Whether there is nothing to set up. Raises PreflightError, as `ensure` does."""
    return not Setup(layout, _underlay(layout, environ), environ).stale()


def ensure(layout: Layout, environ: Mapping[str, str], console: Console) -> underlays.Underlay:
    """Make the environment fresh; returns the underlay it stands on. Quick when there is nothing to do.

    Raises PreflightError, StepError, KeyboardInterrupt.
    """
    underlay = _underlay(layout, environ)
    setup = Setup(layout, underlay, environ, console)
    if not setup.stale():
        return underlay
    if underlay != underlays.find(environ):
        raise PreflightError(
            f'the course has to be built anew upon the ROS in {underlay}, which this terminal has not sourced',
            f'run: source {underlay.prefixes[-1]}/setup.bash && ./course (or, for the wheels from PyPI: rm -rf .venv)',
        )
    preflight.check_writable(layout.root)

    def waiting(process: str) -> None:
        which = f' (process {process})' if process else ''
        console.line(f'course: another ./course{which} is setting up; waiting for it to end')

    with mutex.exclusive(layout.mutex, waiting) as descriptor:
        setup.keep = (descriptor,)
        stale = setup.stale()
        if stale:
            refresh(setup, stale)
    return underlay


def _underlay(layout: Layout, environ: Mapping[str, str]) -> underlays.Underlay:
    """The sourced one; else the one that the environment was made for, as long as that is still there."""
    found = underlays.find(environ)
    if not found.stock:
        facts = Setup(layout, found, environ).venv_facts()
        before = underlays.parse(facts['underlay']) if facts else found
        if before.stock and all(prefix.is_dir() for prefix in before.prefixes):
            return before
    return found


def refresh(setup: Setup, stale: list[str]) -> None:
    """Do the steps that are due. If the first set-up cannot go on, it leaves nothing behind."""
    layout, environ = setup.layout, setup.environ
    anew = 'venv' in stale
    builds = anew or any(name.startswith('package.') or name == 'relocation' for name in stale)
    chosen = interpreter.choose(environ, setup.underlay) if anew else None
    if builds:
        needed = preflight.SPACE_NEEDED - _size_hint(layout) if anew else preflight.SPACE_NEEDED // 10
        preflight.check(layout.root, environ, setup.underlay, needed)
    if anew and layout.prefix.exists():
        setup.console.line(f'The environment has to be made anew: {_reason(setup)}.')
    try:
        if anew:
            setup.make_venv(chosen)
        if anew or 'requirements' in setup.stale():
            setup.install_requirements()
        if 'relocation' in setup.stale():
            setup.relocate()
        if 'backports' in setup.stale():
            setup.backport()
        setup.build_overlay()
        if 'kernel' in setup.stale():
            setup.install_kernel()
        if builds:
            setup.compile_course()
    except PreflightError:
        if anew:
            shutil.rmtree(layout.prefix, ignore_errors=True)
        raise
    except OSError as error:
        if anew:
            shutil.rmtree(layout.prefix, ignore_errors=True)
        if isinstance(error, (FileNotFoundError, NotADirectoryError)):
            raise
        raise tools.explain('setting up', str(error), str(layout.logs), environ) from error
    setup.console.line('The environment is ready.')


def _size_hint(layout: Layout) -> int:
    """Bytes that clearing away the old environment will free."""
    if not layout.prefix.is_dir():
        return 0
    return sum(f.lstat().st_size for f in layout.prefix.rglob('*') if f.is_file() and not f.is_symlink())


def _reason(setup: Setup) -> str:
    facts = setup.venv_facts()
    if not facts:
        return 'the last set-up was interrupted early'
    if facts.get('setup') != VERSION:
        return 'the set-up itself has changed'
    if facts['prefix'] != str(setup.layout.prefix):
        return f'the course was at {Path(facts["prefix"]).parent}'
    if facts['underlay'] != str(setup.underlay):
        return f'it stands on {facts["underlay"]}, now ROS is {setup.underlay}'
    if Stamps(setup.layout.state / 'stamps').read('requirements.started'):
        return 'an installation was interrupted'
    return 'its Python has changed'


def activated(layout: Layout, underlay: underlays.Underlay, environ: Mapping[str, str]) -> dict[str, str]:
    """The variables that `source .venv/setup.bash` would give, for a program that is started without a shell."""
    env = dict(environ)
    env.pop('PYTHONHOME', None)
    if underlay.stock:
        # A stock ROS adds more than can be known here: let its own script say so.
        script = '. "$0" >/dev/null && exec env -0'
        answer = subprocess.run(
            ['bash', '-c', script, str(layout.prefix / 'setup.bash')], env=env, capture_output=True, check=True
        )
        env = dict(item.split('=', 1) for item in answer.stdout.decode().split('\0') if '=' in item)
    else:
        env.update(startup.OF_ROS)
    startup.activate(env, str(layout.prefix))
    startup.drop_settings_of_another_ros(env, str(layout.prefix))
    first = str(layout.prefix / 'bin')
    env['PATH'] = os.pathsep.join([first, *(p for p in env.get('PATH', os.defpath).split(os.pathsep) if p != first)])
    env['VIRTUAL_ENV'] = str(layout.prefix)
    if not environ.get('ROS_DOMAIN_ID'):
        env['COURSE_DOMAIN_UNCHOSEN'] = '1'
    return env
