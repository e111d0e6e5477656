"""`no_program`: `ros2 run` does not find or start a program of a package."""

from helpers.programs.faults import words
from helpers.programs.faults.fault import Fault, Verdict

_MANIFEST = """\
<?xml version="1.0"?>
<package format="3">
  <name>{package}</name>
  <version>0.1.0</version>
  <description>Says what a robot does.</description>
  <maintainer email="you@example.org">you</maintainer>
  <license>Apache-2.0</license>
  <exec_depend>rclpy</exec_depend>
  <export>
    <build_type>ament_python</build_type>
  </export>
</package>
"""
_SETUP = """\
from setuptools import find_packages, setup

package_name = '{package}'

setup(
    name=package_name,
    version='0.1.0',
    packages=find_packages(exclude=['test']),
    data_files=[
        ('share/ament_index/resource_index/packages', ['resource/' + package_name]),
        ('share/' + package_name, ['package.xml']),
    ],
    install_requires=['setuptools'],
    zip_safe=True,
    entry_points={{
        'console_scripts': [
{entry}        ],
    }},
)
"""
_CONFIGURATION = """\
[develop]
script_dir=$base/lib/{package}
[install]
install_scripts=$base/lib/{package}
"""
_PROGRAM = """\
def main():
    print('{package}: {module} is ready')
"""


class NoProgram(Fault):
    """`ros2 run` does not start a program.

    Kinds: ``missing`` (no entry point), ``name`` (the entry point has another name), ``module`` and ``function`` (it
    names one that does not exist), ``script_dir`` (setup.cfg installs programs where ros2 does not look).
    """

    name, title = 'no_program', 'ros2 run does not start the program'
    kinds = ('missing', 'name', 'module', 'function', 'script_dir')

    def plan(self) -> None:
        draw = self.random
        robot, (_, module, _) = draw.choice(words.ROBOTS), draw.choice(words.SENSORS)
        package = f'{robot}_tools'
        bad_name, bad_module = words.misspelt(module, draw), words.misspelt(module, draw)
        bad_function = draw.choice(['mian', 'start', 'Main'])
        entry = self._entry(module, package, module, 'main')
        wrong = {
            'missing': '',
            'name': self._entry(bad_name, package, module, 'main'),
            'module': self._entry(module, package, bad_module, 'main'),
            'function': self._entry(module, package, module, bad_function),
        }.get(self.kind, entry)
        top = f'src/{package}'
        self.files = {
            f'{top}/package.xml': _MANIFEST.format(package=package),
            f'{top}/resource/{package}': '',
            f'{top}/{package}/__init__.py': '',
            f'{top}/{package}/{module}.py': _PROGRAM.format(package=package, module=module),
            f'{top}/setup.py': _SETUP.format(package=package, entry=wrong),
            f'{top}/setup.cfg': _CONFIGURATION.format(package=package),
        }
        where = f'{top}/setup.py'
        self.repaired = {where: _SETUP.format(package=package, entry=entry)}
        if self.kind == 'script_dir':
            where = f'{top}/setup.cfg'
            self.repaired = {where: self.files[where]}
            self.files[where] = self.files[where].replace('/lib/', '/bin/')
        self.package, self.module = package, module
        self.task = f'After colcon build, ros2 run {package} {module} should print that it is ready.'
        if self.kind == 'script_dir':
            self.diagnose(where, 'folder', f'script_dir=$base/bin/{package}')
        else:
            self.diagnose(where, self.kind, wrong.strip().strip(',').strip("'").partition(' = ')[2])
        self.facts = {'package': package, 'executable': module}

    @staticmethod
    def _entry(name: str, package: str, module: str, function: str) -> str:
        return f"            '{name} = {package}.{module}:{function}',\n"

    @property
    def command(self) -> str:
        """What its user types, after the build."""
        return f'source install/setup.bash\nros2 run {self.package} {self.module}'

    def show_symptom(self) -> None:
        self.run(f'colcon build\n{self.command}')

    def works(self, timeout: float) -> Verdict:
        _, output = self.ask(f'rm -rf build install log\ncolcon build && {self.command}')
        runs = output.rstrip().endswith(f'{self.package}: {self.module} is ready')
        return Verdict(runs, f'ros2 run {"starts" if runs else "does not start"} {self.module}')
