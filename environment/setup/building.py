"""Brings the course's own ROS packages into the environment: from the cache of another copy, or built by colcon."""

import os
import platform
import shutil
import subprocess
from collections.abc import Mapping
from pathlib import Path

from environment.setup import forecast, overlay, relocation, tools
from environment.setup.cache import Cache
from environment.setup.cache import folder as cache_folder
from environment.setup.errors import StepError
from environment.setup.installed import Installed
from environment.setup.stamps import digest

# What colcon writes at the end into the prefix itself: it depends on no package.
_SCRIPTS = 'the scripts of the prefix'
_OF_SCRIPTS = ('setup.*', 'local_setup.*', '_local_setup_util_*.py', '.colcon_install_layout', 'COLCON_IGNORE')


def toolchain(environ: Mapping[str, str]) -> str:
    """What compiles here, in words: the machine, its C library, the compilers and their settings."""
    path = environ.get('PATH', os.defpath)
    parts = [platform.machine(), *platform.libc_ver()]
    parts += [f'{name}={environ.get(name, "")}' for name in ('CC', 'CXX', 'CFLAGS', 'CXXFLAGS', 'LDFLAGS')]
    for name in (environ.get('CC', 'cc'), environ.get('CXX', 'c++')):
        found = shutil.which(name.split()[0], path=path)
        told = subprocess.run([found, '--version'], capture_output=True, text=True, check=False) if found else None
        parts.append(told.stdout.partition('\n')[0] if told else '')
    return '\n'.join(parts)


class Building:
    """One round of bringing packages in, for a `steps.Setup`."""

    def __init__(self, setup):
        self.setup = setup
        self.prefix, self.build = setup.layout.prefix, setup.layout.build
        self.packages = setup.packages()
        self.keys = overlay.keys(self.packages, setup.foundation(setup.lock()))
        self.installed = Installed(setup.layout.installed, self.prefix)
        self.cache = Cache(cache_folder(setup.environ), self.prefix)
        # Upon a stock ROS, which may be updated at any time, nothing says whether a package is still right.
        self.use_cache = not setup.underlay.stock and not self.cache.problem()

    def run(self) -> None:
        """Make all packages fresh; those that are need nothing. Raises StepError, and what `tools.explain` makes."""
        self._forget_what_is_gone()
        due = [name for name, p in self.packages.items() if self.setup.stamps.read(p.stamp) != self.keys[name]]
        # A killed run's build may have gone on to its end: what it finished from these very sources counts.
        for name in list(due):
            if self._started(name) == self.keys[name] and overlay.succeeded(name, self.build):
                self._finish(name, self.installed.of_build(name, self.build / name))
                due.remove(name)
        if due:
            for name in due:
                self._prepare(name)
            self._take_from_cache(due)
        if due or not self._scripts_are_right():
            self._build(due)
        shutil.rmtree(self.build, ignore_errors=True)

    def _forget_what_is_gone(self) -> None:
        for stamp in self.setup.stamps.names('package.'):
            name = stamp.removeprefix('package.')
            if name not in self.packages:
                self.installed.uninstall(name)
                self.setup.stamps.remove(stamp)

    def _started(self, name: str) -> str:
        return self.setup.stamps.read(f'started.{name}')

    def _prepare(self, name: str) -> None:
        """Remove what an earlier build of the package made; what it left unfinished would look up to date."""
        self.setup.stamps.remove(self.packages[name].stamp)
        if not self.installed.read(name):  # interrupted: what it did install is in the lists of its build
            self.installed.write(name, self.installed.of_build(name, self.build / name))
        self.installed.uninstall(name)
        shutil.rmtree(self.build / name, ignore_errors=True)

    def _finish(self, name: str, paths: list[str]) -> None:
        self.installed.write(name, paths)
        self.setup.stamps.write(self.packages[name].stamp, self.keys[name])
        self.setup.stamps.remove(f'started.{name}')

    # The cache.

    def _cache_keys(self) -> dict[str, str]:
        """For each package, and for the scripts, what the entry is named: all that it is made from, but no path."""
        facts = self.setup.venv_facts()
        foundation = digest(self.setup.recipe(self.setup.lock()), facts['version'], toolchain(self.setup.environ))
        return {**overlay.keys(self.packages, foundation), _SCRIPTS: digest(foundation, facts['python'])}

    def _take_from_cache(self, due: list[str]) -> None:
        """Take what the cache has; `due` is shortened by it."""
        if not self.use_cache:
            return
        keys, console = self._cache_keys(), self.setup.console
        console.begin(f'Looking for built ROS packages in {self.cache.directory}')
        wanted = len(due)
        for name in list(due):
            paths = self.cache.fetch(keys[name])
            if paths is not None:
                self._finish(name, paths)
                due.remove(name)
        if not self._scripts_are_right():
            self.cache.fetch(keys[_SCRIPTS])
        console.end(f'{wanted - len(due)} of {wanted} found')

    def _fill_cache(self, built: list[str]) -> None:
        if not self.use_cache:
            return
        keys = self._cache_keys()
        for name in built:
            self.cache.store(keys[name], self.installed.read(name))
        self.cache.store(keys[_SCRIPTS], [path.name for part in _OF_SCRIPTS for path in self.prefix.glob(part)])
        self.cache.prune()

    # colcon.

    def _scripts_are_right(self) -> bool:
        return relocation.scripts_ask(self.prefix, self.setup.base_python())

    def _build(self, due: list[str]) -> None:
        for name in due:
            self.setup.stamps.write(f'started.{name}', self.keys[name])
        console = self.setup.console
        told = forecast.Forecast({name: forecast.effort(self.packages[name].directory) for name in due})

        def watch(output: str) -> None:
            line = told.line(output)
            if line:
                console.line(line)
            console.update('')

        try:
            self.setup.run(
                f'Building {_counted(due)}' if due else 'Writing the scripts that set up a terminal',
                overlay.colcon(self.setup.layout, due),
                'colcon',
                tools.environment(self.setup.environ, self.setup.layout, self.setup.underlay),
                on_line=watch,
            )
        finally:
            relocation.let_scripts_ask(self.prefix, self.setup.base_python())
            built = [name for name in due if overlay.succeeded(name, self.build)]
            for name in built:
                self._finish(name, self.installed.of_build(name, self.build / name))
            self._fill_cache(built)
        missing = sorted(set(due) - set(built))
        if missing:
            log: Path = self.setup.layout.logs / 'colcon.log'
            raise StepError(f'colcon did not build {", ".join(missing)}', '', str(log))


def _counted(packages: list[str], named: int = 5) -> str:
    """'2 ROS packages (a, b)'; of many only the number, as the line would be longer than a terminal."""
    names = f' ({", ".join(packages)})' if len(packages) <= named else ''
    return f'{len(packages)} ROS package{"s" * (len(packages) != 1)}{names}'
