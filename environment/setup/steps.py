"""The steps that make the environment, in order; each is skipped when its stamp is fresh."""

import json
import os
import shutil
import subprocess
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path

from environment.setup import backports, kernel, overlay, relocation, requirements, startup, tool_processes, tools
from environment.setup.building import Building
from environment.setup.console import Console
from environment.setup.interpreter import Interpreter
from environment.setup.layout import Layout
from environment.setup.stamps import Stamps, digest, digest_tree
from environment.setup.underlay import Underlay, without_ros_wheels

VERSION = '2'  # raise it when a step changes so that what it made before is no longer right

# Requirements that shape what colcon generates; a change of any other one leaves the built packages as they are.
OF_THE_BUILD = r'(ros-|empy=|lark=|numpy=|setuptools=)'


@dataclass
class Setup:
    """One set-up of one checkout."""

    layout: Layout
    underlay: Underlay
    environ: Mapping[str, str]
    console: Console = field(default_factory=Console)
    keep: tuple[int, ...] = ()  # file descriptors that the tools hold: the lock

    def __post_init__(self):
        self.stamps = Stamps(self.layout.state / 'stamps')

    # What is needed, as digests.

    def lock(self) -> str:
        text = self.layout.requirements.read_text()
        return without_ros_wheels(text) if self.underlay.stock else text

    def recipe(self, lock: str) -> str:
        """How the packages are built, and with which tools."""
        parts = (digest_tree(folder) for folder in (self.layout.cmake, self.layout.builder))
        return digest(VERSION, str(self.underlay), requirements.entries(lock, OF_THE_BUILD), *parts)

    def foundation(self, lock: str) -> str:
        """What the packages are built upon."""
        return digest(self.recipe(lock), self.stamps.read('venv'))

    def packages(self) -> dict[str, overlay.SourcePackage]:
        found = overlay.discover(self.layout.sources)
        return {name: p for name, p in found.items() if not self.underlay.provides(name)}

    def stale(self) -> list[str]:
        """What is not as it should be: names of steps and packages; empty when the environment is fresh."""
        if not self.venv_usable():
            return ['venv']
        lock = self.lock()
        foundation = self.foundation(lock)
        wanted = {
            'requirements': digest(lock),
            'relocation': foundation,
            'backports': self.backports_key(foundation),
            'kernel': self.kernel_key(),
        }
        stale = [name for name, key in wanted.items() if self.stamps.read(name) != key]
        packages = self.packages()
        for name, key in overlay.keys(packages, foundation).items():
            if self.stamps.read(packages[name].stamp) != key:
                stale.append(packages[name].stamp)
        stale += [s for s in self.stamps.names('package.') if s.removeprefix('package.') not in packages]
        if not relocation.scripts_ask(self.layout.prefix, self.base_python()):
            stale.append('setup.bash')
        return stale

    def backports_key(self, foundation: str) -> str:
        return digest(foundation, backports.text())

    def kernel_key(self) -> str:
        files = (Path(startup.__file__).read_text(), kernel.PROFILE.read_text(), kernel.SETTINGS.read_text())
        return digest(json.dumps(kernel.kernelspec(self.layout)), *files, str(self.layout.root))

    # The virtual environment.

    def venv_facts(self) -> dict:
        """What the environment was made for; {} when there is none, or none that was finished."""
        text = self.stamps.read('venv')
        return json.loads(text) if text else {}

    def venv_usable(self) -> bool:
        """Whether the environment was made here, for this underlay, and its interpreter is still the same one."""
        facts = self.venv_facts()
        if not facts or facts.get('setup') != VERSION or facts['prefix'] != str(self.layout.prefix):
            return False
        if facts['underlay'] != str(self.underlay):
            return False
        wanted = self.environ.get('COURSE_PYTHON')
        if wanted and os.path.realpath(shutil.which(wanted) or wanted) != facts['python'] and facts['asked'] != wanted:
            return False
        # An interrupted installation may have left a package half there, which no installer can tell.
        if self.stamps.read('requirements.started'):
            return False
        return os.path.realpath(self.layout.python) == facts['python'] and self.layout.python.exists()

    def base_python(self) -> Path:
        """The interpreter that the environment was made from."""
        return Path(self.venv_facts()['python'])

    def make_venv(self, interpreter: Interpreter) -> None:
        prefix = self.layout.prefix
        if prefix.is_symlink() or prefix.is_file():
            prefix.unlink()
        elif prefix.exists():
            self.console.begin('Clearing away the old environment')
            # First the stamps: if this is interrupted, nothing looks whole.
            shutil.rmtree(self.layout.state / 'stamps', ignore_errors=True)
            shutil.rmtree(prefix)
            self.console.end()
        options = ['--system-site-packages'] if self.underlay.stock else []
        # pip itself comes with the locked packages; to install and compile the bundled one first takes two seconds.
        options += ['--without-pip'] if interpreter.pip_wheel else []
        self.run(
            f'Making a virtual environment with Python {interpreter.short}',
            [interpreter.command, '-m', 'venv', *options, prefix],
            'venv',
        )
        uv = self.layout.state / 'uv.txt'
        uv.write_text(requirements.entry(self.layout.requirements.read_text(), 'uv'))
        pip = [*self.pip(interpreter.pip_wheel), '--disable-pip-version-check']
        patience = [] if 'PIP_DEFAULT_TIMEOUT' in self.environ else ['--timeout', '15']
        self.run(
            'Fetching uv, the installer',
            [*pip, 'install', '--retries', '1', *patience, '--no-deps', '-I', '--require-hashes', '-r', uv],
            'uv',
        )
        self.stamps.write(
            'venv',
            json.dumps(
                {
                    'setup': VERSION,
                    'prefix': str(prefix),
                    'python': interpreter.path,
                    'version': interpreter.short,
                    'asked': self.environ.get('COURSE_PYTHON', ''),
                    'underlay': str(self.underlay),
                    'pip_wheel': interpreter.pip_wheel,
                }
            ),
        )

    def pip(self, wheel: str) -> list:
        """How pip is called: the environment's own, once that is there, else the one in the wheel."""
        installed = not wheel or (self.layout.site_packages() / 'pip').is_dir()
        return [self.layout.python, '-m', 'pip'] if installed else [self.layout.python, Path(wheel, 'pip')]

    # What comes from PyPI.

    def install_requirements(self) -> None:
        lock = self.lock()
        file = self.layout.state / 'requirements.txt'
        before = requirements.names(file.read_text()) if file.exists() else set()
        self.stamps.remove('requirements')
        self.stamps.remove('backports')  # they change files of these packages
        self.stamps.write('requirements.started', '1')
        env = self._env()
        pip = self.pip(self.venv_facts().get('pip_wheel', ''))
        config = subprocess.run([*pip, 'config', 'list'], env=env, capture_output=True, text=True, check=False)
        env.update(requirements.for_uv(env, config.stdout))
        uv = [self.layout.prefix / 'bin' / 'uv', 'pip']
        gone = sorted(before - requirements.names(lock))
        # What shares files with one of these is not whole without it, though the installer would think so.
        again = requirements.sharing(self.layout.site_packages(), gone) if gone else []
        if gone:
            self.run(
                'Removing packages that are no longer needed',
                [*uv, 'uninstall', '--python', self.layout.python, *gone],
                'uninstall',
                env,
            )
        wanted = self.layout.state / 'requirements.new.txt'
        wanted.write_text(lock)
        self.run(
            f"Installing {len(requirements.names(lock))} locked packages",
            # Several indexes may hold different versions of one package; the hashes say which file is right.
            [
                *uv, "install", "--python", self.layout.python, "--index-strategy", "unsafe-best-match",
                "--no-deps", "--require-hashes", "--build-constraints", wanted, "-r", wanted,
                *(f"--reinstall-package={name}" for name in again),
            ],
            "requirements",
            env,
        )  # fmt: skip
        wanted.replace(file)
        self.stamps.write('requirements', digest(lock))
        self.stamps.remove('requirements.started')

    def relocate(self) -> None:
        foundation = self.foundation(self.lock())
        self.stamps.remove('relocation')
        if not self.underlay.stock:
            asked = subprocess.run(
                [self.base_python(), "-ES", "-c", "import sysconfig; print(sysconfig.get_path('include'))"],
                capture_output=True, text=True, check=True,
            )  # fmt: skip
            numpy = self.layout.site_packages() / 'numpy' / '_core' / 'include'
            self.console.begin('Repairing paths in the ROS packages')
            relocation.repair(relocation.Places(self.layout.prefix, Path(asked.stdout.strip()), numpy))
            relocation.link_vendored_programs(self.layout.prefix)
            self.console.end()
        self.stamps.write('relocation', foundation)

    def backport(self) -> None:
        self.stamps.remove('backports')
        backports.apply(self.layout.prefix, self.layout.site_packages())
        self.stamps.write('backports', self.backports_key(self.foundation(self.lock())))

    # The course's own packages.

    def build_overlay(self) -> None:
        Building(self).run()

    def install_kernel(self) -> None:
        self.stamps.remove('kernel')
        kernel.install(self.layout)
        self.stamps.write('kernel', self.kernel_key())

    def compile_course(self) -> None:
        self.run("Compiling the course's modules", [self.layout.python, '-m', 'helpers.runner.bytecode'], 'compile')

    # Helpers.

    def _env(self) -> dict[str, str]:
        """For the installers: a stock ROS on PYTHONPATH would make them find packages installed that are not."""
        return tools.environment(self.environ, self.layout, Underlay())

    def run(self, label: str, argv: list, log: str, env: dict | None = None, on_line=None) -> None:
        """Run a tool under the heading `label`; what it prints goes to the file `log`, and line by line to `on_line`.

        Raises what `tools.explain` makes of a failure.
        """
        env = self._env() if env is None else env
        file = self.layout.logs / f'{log}.log'
        self.console.begin(label)
        status, output = tool_processes.run(
            argv, file, env, on_line or self.console.update, self.layout.root, self.keep
        )
        if status:
            raise tools.explain(label[0].lower() + label[1:], output, str(file), env)
        self.console.end()
