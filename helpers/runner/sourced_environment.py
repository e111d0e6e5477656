"""The environment of a terminal in which a built workspace is sourced, without sourcing it: nothing of it runs here.

`install/setup.bash` and the hooks of packages are programs in which a package has a part. What a test started after
them would be whatever they make of `ros2` or `python3`. So the usual variables are made from what is installed, and
hooks of a package's own are left out. Tools are the machine's: what a package installs stands behind them, and what
would take their place is refused: modules that Python knows, or would import if they were there, and libraries that are
not called as a package of the workspace.
"""

import importlib.metadata
import os
import stat
import subprocess
import sys
import tempfile
from collections.abc import Iterable, Iterator
from contextlib import suppress
from functools import cache
from pathlib import Path

from helpers.programs import terminals

PATIENCE = 60.0  # seconds to source the ROS installation, on a machine under load
MAX_NAMES = 2000  # in one folder
_MAX_PRODUCTS = 20_000  # files and folders in a workspace
_MAX_TEXT = 2**20  # characters
_PACKAGES = 'site-packages', 'dist-packages'  # folders of installed modules
_SCRIPTS = {'console_scripts', 'gui_scripts'}  # of what a distribution may bring, what only makes programs
_MODULES = '.py', '.pyc', '.so'
_HARMLESS = {'test', 'tests', '__pycache__'}  # a package for tests may be called as Python's own one
_DISTRIBUTIONS = '.egg-info', '.dist-info'
# What Python's library and the tools import if it is there, and go on without: `test_overlay.py` finds out which.
OPTIONAL = frozenset(
    """
    ConfigParser HTMLParser Queue StringIO __builtin__ _abcoll _argcomplete _distutils_system_mod _dummy_thread
    _manylinux _pyrepl _ruamel_yaml _ruamel_yaml_clibz _typeshed _winreg annotationlib apport_python_hook
    atomicwrites cPickle cStringIO cached_property chardet colorama coloredlogs composition_interfaces
    compression comtypes configobj distutils dummy_thread dummy_threading eventlet exceptiongroup
    future_builtins gevent htmlentitydefs httplib hypothesis importlib_metadata importlib_resources interegular
    jaraco java js2py more_itertools netifaces ntsecuritycon ordereddict org orjson pgen2 pydot regex sniffio
    thread threadpoolctl toml tomli twisted urllib2 urlparse vms_lib win32 win32api win32con win32evtlog
    win32evtlogutil win32gui win32security xmlrpclib zope
    """.split()
)


class Shadowed(Exception):
    """Something installed would come in the place of the machine's own; the message is for the learner."""


@cache
def underlay() -> dict[str, str]:
    """The variables that sourcing the ROS installation sets. Asked for once, by a process that forks the others."""
    if terminals.underlay() is None:
        return {}
    done = subprocess.run(
        terminals.shell('exec env -0'), stdin=subprocess.DEVNULL, capture_output=True, timeout=PATIENCE, check=False
    )
    found = dict(part.split('=', 1) for part in os.fsdecode(done.stdout).split('\0') if '=' in part)
    left_out = {'_', 'SHLVL', 'PWD', 'OLDPWD'}
    return {name: text for name, text in found.items() if name not in left_out and os.environ.get(name) != text}


def of(root: Path, packages: Iterable[str]) -> dict[str, str]:
    """The environment of a terminal in the workspace `root`, sourced if it is built.

    :param packages: those whose sources were written there.
    :raises Shadowed: what is installed would take the place of the machine's own.
    """
    found = {**os.environ, **underlay(), 'PYTHONNOUSERSITE': '1'}
    packages = frozenset(packages)
    for prefix in _prefixes(root):
        for place in _python(root, prefix):
            _look_at_modules(place, packages)
            _put(found, 'PYTHONPATH', place, first=True)
        if libraries := _names(prefix / 'lib', '.so'):
            _look_at_libraries(prefix.name, libraries, packages)
            _put(found, 'LD_LIBRARY_PATH', _links(root, prefix / 'lib', libraries))
        if (prefix / 'bin').is_dir():
            _put(found, 'PATH', prefix / 'bin')
        _put(found, 'CMAKE_PREFIX_PATH', prefix, first=True)
        if _is_ament(prefix):
            _put(found, 'AMENT_PREFIX_PATH', prefix, first=True)
    if (root / 'install').is_dir():
        _put(found, 'COLCON_PREFIX_PATH', root / 'install', first=True)
    return found


def _put(environment: dict[str, str], name: str, place: Path, first: bool = False) -> None:
    """Add a folder to a list of folders."""
    there = [environment[name]] if environment.get(name) else []
    environment[name] = os.pathsep.join([str(place), *there] if first else [*there, str(place)])


def _links(root: Path, place: Path, names: Iterable[str]) -> Path:
    """A new folder in which only these libraries are.

    The loader of programs also looks into folders below the one that it is told, as for kinds of processors, and looks
    there for the system's libraries, too.
    """
    folder = Path(tempfile.mkdtemp(dir=root.parent))
    for name in names:
        (folder / name).symlink_to(place / name)
    return folder


def _prefixes(root: Path) -> list[Path]:
    """Where packages are installed, as far as colcon has come to their end."""
    with suppress(OSError):
        return [
            prefix
            for prefix in sorted((root / 'install').iterdir())
            if (prefix / 'share' / 'colcon-core' / 'packages' / prefix.name).is_file()
        ]
    return []


def _is_ament(prefix: Path) -> bool:
    """Whether ROS finds the package: colcon writes a hook for this, or ament_package() in CMakeLists.txt a script."""
    share = prefix / 'share' / prefix.name
    return any((share / name).is_file() for name in ('hook/ament_prefix_path.dsv', 'local_setup.dsv'))


def _python(root: Path, prefix: Path) -> Iterator[Path]:
    """The folders in which Python finds a package's modules; with --symlink-install that of the build, too."""
    version = f'python{sys.version_info[0]}.{sys.version_info[1]}'
    for place in (prefix / 'lib' / version / 'site-packages', prefix / 'local' / 'lib' / version / 'dist-packages'):
        if place.is_dir():
            yield place
            if _names(place, '.egg-link'):
                yield root / 'build' / prefix.name


def _names(place: Path, part: str) -> list[str]:
    """The names in a folder that have this in them."""
    try:
        found = os.listdir(place)
    except OSError:
        return []
    if len(found) > MAX_NAMES:
        raise Shadowed(f'Your package installs more than {MAX_NAMES} files in one folder.')
    return sorted(name for name in found if part in name)


def _look_at_modules(place: Path, packages: frozenset[str]) -> None:
    """Raise Shadowed if a module here comes before one of the machine's, or extends the machine's tools."""
    unknown = set()
    for name in _names(place, ''):
        module, _, rest = name.partition('.')
        if name.lower().endswith(_DISTRIBUTIONS):  # as Python looks for them
            _look_at_distribution(place / name, name, packages)
        elif module in packages or not module.isidentifier() or rest and not name.endswith(_MODULES):
            continue
        elif module in _regular():
            _refuse(module, 'knows one by this name already', bool(rest) or _is_package(place / name))
        elif module not in _HARMLESS:
            unknown.add(module)
    for module in sorted(unknown):
        _refuse(module, 'has a part of one by this name already', module in _known())
        _refuse(module, 'would load one by this name in programs of the machine', module in OPTIONAL)


def _refuse(module: str, why: str, refused: bool = True) -> None:
    if refused:
        raise Shadowed(
            f'Your package installs a Python module `{module}`, and Python {why}: '
            'each program in this workspace would load yours. Give it another name, or do not install it.'
        )


def _is_package(folder: Path) -> bool:
    """Whether a folder comes before modules of its name: one without `__init__` stands behind them all."""
    return any(name.startswith('__init__.') for name in _names(folder, '__init__'))


def _look_at_distribution(place: Path, name: str, packages: frozenset[str]) -> None:
    owner = name.rpartition('.')[0].partition('-')[0].replace('-', '_').lower()
    if owner in _known_distributions() - {package.lower() for package in packages}:
        raise Shadowed(f'Your package installs itself as {owner}, which is the name of a program of this machine.')
    text = _text(place / 'entry_points.txt')
    try:  # read as the tools do: what only they understand changes them all the same
        groups = sorted({one.group for one in _Distribution(text).entry_points} - _SCRIPTS)
    except (TypeError, ValueError):
        raise Shadowed('Your package installs a list of entry points, entry_points.txt, that cannot be read.') from None
    if groups:
        raise Shadowed(
            f'Your package has entry points of the group {groups[0]}, which change tools such as ros2. Only '
            'console_scripts are asked for.'
        )


class _Distribution(importlib.metadata.Distribution):
    """A distribution of which nothing is known but the text of its entry points."""

    def __init__(self, entry_points: str):
        self._entry_points = entry_points

    def read_text(self, filename: str) -> str | None:
        return self._entry_points if filename == 'entry_points.txt' else None

    def locate_file(self, path):
        raise FileNotFoundError(path)


def _text(path: Path) -> str:
    """The text of a regular file; empty if there is none.

    :raises Shadowed: it is something else, which others may have to wait for, or no text.
    """
    try:
        # Without waiting for somebody at the other end of a pipe.
        with open(os.open(path, os.O_RDONLY | os.O_NONBLOCK), encoding='utf-8') as file:
            if stat.S_ISREG(os.fstat(file.fileno()).st_mode):
                return file.read(_MAX_TEXT)
    except (FileNotFoundError, NotADirectoryError):
        return ''
    except (OSError, ValueError):
        pass
    raise Shadowed(f'Your package installs {path.name[:80]}, which cannot be read as a text.')


def look_at_products(root: Path) -> None:
    """Look at all that a build has left in a workspace.

    :raises Shadowed: it has left what is neither a file nor a folder, nor a link to a file or to a folder of the
        workspace: who opens a pipe waits for the other end.
    """
    folders, seen = [root / 'install', root / 'build', root / 'src'], 0
    while folders:
        with suppress(OSError), os.scandir(folders.pop()) as entries:
            for entry in entries:
                seen += 1
                if seen > _MAX_PRODUCTS:
                    raise Shadowed(f'Your package leaves more than {_MAX_PRODUCTS} files when it is built.')
                name = ascii(entry.name)[:80]
                if entry.is_dir(follow_symlinks=False):
                    folders.append(Path(entry.path))
                elif entry.is_symlink():
                    if not _leads_to_a_file(Path(entry.path), root):
                        raise Shadowed(f'Your package leaves a link {name} when it is built, which leads to no file.')
                elif not entry.is_file(follow_symlinks=False):
                    raise Shadowed(f'Your package leaves {name} when it is built, which is no regular file.')


def _leads_to_a_file(link: Path, root: Path) -> bool:
    """Whether a link leads to a regular file, to a folder of the workspace, or nowhere."""
    try:
        kind = link.stat().st_mode
    except (FileNotFoundError, NotADirectoryError):
        return True
    except OSError:
        return False
    return stat.S_ISREG(kind) or stat.S_ISDIR(kind) and link.resolve().is_relative_to(root.resolve())


def _look_at_libraries(package: str, names: Iterable[str], packages: frozenset[str]) -> None:
    own = tuple(f'lib{one}' for one in packages)
    for name in names:
        if not name.startswith(own):
            raise Shadowed(
                f'Your package installs the library {name}, which other programs would load, too. The name must begin '
                f'with lib{package}.'
            )


@cache
def _places() -> tuple[Path, ...]:
    """The folders of installed modules that are the machine's."""
    listed = [*sys.path, *underlay().get('PYTHONPATH', '').split(os.pathsep)]
    return tuple(path for path in map(Path, dict.fromkeys(listed)) if path.name in _PACKAGES and path.is_dir())


@cache
def _known() -> frozenset[str]:
    """The modules of the machine's Python."""
    names = {name.partition('.')[0] for place in _places() for name in os.listdir(place) if '-info' not in name}
    return frozenset({*sys.stdlib_module_names, 'sitecustomize', 'usercustomize', *names} - {*_HARMLESS, ''})


@cache
def _regular() -> frozenset[str]:
    """Those of the known modules behind which a folder without `__init__` stands. Others have parts in many places."""
    folders = [path for place in _places() for path in place.iterdir() if path.is_dir()]
    return _known() - {path.name for path in folders if not (path / '__init__.py').is_file()}


@cache
def _known_distributions() -> frozenset[str]:
    names = [name for place in _places() for name in os.listdir(place) if name.endswith(_DISTRIBUTIONS)]
    return frozenset(name.rpartition('.')[0].partition('-')[0].replace('-', '_').lower() for name in names)


def warm_up() -> None:
    """Find out what is the same for all that this process forks."""
    _regular()
    _known_distributions()
