"""`mixed_distros`: two distributions in one environment."""

from helpers.programs.faults import words
from helpers.programs.faults.fault import Fault, Verdict
from helpers.programs.faults.machine import BASHRC, SETUP
from helpers.programs.faults.shells import bashrc

_OLDER = (('humble', '3.10', '0.14.0'), ('iron', '3.10', '0.15.3'), ('foxy', '3.8', '0.9.5'))
_JAZZY = f'source ~/{SETUP.format(distro="jazzy")}\n'
# The setup file of the older distribution: it puts its folders before those that are there, and says what ROS says.
_OLD_SETUP = """\
old=~/opt/ros/{distro}
if [ -n "$ROS_DISTRO" ] && [ "$ROS_DISTRO" != {distro} ]; then
  echo "ROS_DISTRO was set to '$ROS_DISTRO' before. Please make sure that the environment does not mix paths from \\
different distributions." >&2
fi
export ROS_DISTRO={distro}
export AMENT_PREFIX_PATH=$old:$AMENT_PREFIX_PATH
export CMAKE_PREFIX_PATH=$old:$CMAKE_PREFIX_PATH
export PYTHONPATH=$old/lib/python{python}/site-packages:$PYTHONPATH
"""
_CMAKE = """\
cmake_minimum_required(VERSION 3.16)
project({package} NONE)
find_package(ament_cmake REQUIRED)
install(FILES map.yaml DESTINATION share/${{PROJECT_NAME}})
ament_package()
"""
_MANIFEST = """\
<?xml version="1.0"?>
<package format="3">
  <name>{package}</name>
  <version>0.1.0</version>
  <description>The map of a building.</description>
  <maintainer email="you@example.org">you</maintainer>
  <license>Apache-2.0</license>
  <buildtool_depend>ament_cmake</buildtool_depend>
  <export>
    <build_type>ament_cmake</build_type>
  </export>
</package>
"""


class MixedDistros(Fault):
    """A build breaks, because modules of an older distribution are found first.

    Kinds: ``both`` (two setup files are sourced), ``workspace`` (the setup file of an old workspace leads to the old
    distribution), ``pythonpath`` (a variable is set by hand). The older distribution is a stand-in with the few files
    that matter.
    """

    name, title = 'mixed_distros', 'colcon build breaks deep inside of ROS'
    kinds = ('both', 'workspace', 'pythonpath')
    machine = 'home'

    def plan(self) -> None:
        draw = self.random
        self.old = draw.choice(_OLDER)
        distro, python, _ = self.old
        self.package, self.old_workspace = f'{draw.choice(words.ROOMS)}_map', f'{draw.choice(words.ROBOTS)}_ws'
        line = {
            'both': f'source ~/{SETUP.format(distro=distro)}\n',
            'workspace': f'source ~/{self.old_workspace}/install/setup.bash\n',
            'pythonpath': f'export PYTHONPATH=~/opt/ros/{distro}/lib/python{python}/site-packages:$PYTHONPATH\n',
        }[self.kind]
        state = draw.getstate()  # the same harmless lines in both
        file = f'{self.machine}/{BASHRC}'
        self.files = {
            file: bashrc(draw, _JAZZY, line),
            f'{self.machine}/ros2_ws/src/{self.package}/CMakeLists.txt': _CMAKE.format(package=self.package),
        }
        draw.setstate(state)
        self.repaired = {file: bashrc(draw, _JAZZY)}
        self.task = 'In a new terminal, colcon build should build the workspace ~/ros2_ws with Jazzy.'
        self.diagnose(file, 'other', line.strip())
        self.facts = {'distro': distro}

    def prepare(self) -> None:
        distro, python, version = self.old
        home = self.home(self.machine)
        home.install()
        home.write(SETUP.format(distro=distro), _OLD_SETUP.format(distro=distro, python=python))
        home.write(f'opt/ros/{distro}/local_setup.bash', '')  # by which colcon knows a prefix
        home.write(f'{self.old_workspace}/install/setup.bash', f'source ~/{SETUP.format(distro=distro)}\n')
        module = f'opt/ros/{distro}/lib/python{python}/site-packages/ament_package'
        home.write(f'{module}/__init__.py', f"__version__ = '{version}'\n")
        home.write(f'{module}/templates.py', '# What Jazzy looks for is not in this version.\n')
        top = f'ros2_ws/src/{self.package}'
        home.write(f'{top}/package.xml', _MANIFEST.format(package=self.package))
        home.write(f'{top}/map.yaml', 'resolution: 0.05\n')

    def show_symptom(self) -> None:
        self.run('cd ros2_ws\ncolcon build')

    def works(self, timeout: float) -> Verdict:
        status, _ = self.ask('[ "$ROS_DISTRO" = jazzy ] && cd ros2_ws && rm -rf build install log && colcon build')
        return Verdict(status == 0, f'{self.package} {"is" if status == 0 else "is not"} built with Jazzy')
