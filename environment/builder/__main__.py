"""`python -m environment.builder COLCON'S ARGUMENTS`: `colcon build` into one prefix, with a quarter of the work.

colcon starts four interpreters for each Python package, and sources the prefix three times. A package of interfaces
starts fifteen. Here one server (`server`) runs them; the prefix is sourced already, as the set-up's variables say.
"""

import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path
from types import SimpleNamespace

from environment.builder import server


def main(arguments: list[str]) -> int:
    """Run colcon with these arguments; returns its exit status."""
    folder = Path(tempfile.mkdtemp(prefix='course-build-'))  # not below .venv: a socket's path is short
    try:
        socket = folder / 'python'
        server.start(socket)
        client = [
            getattr(sys, '_base_executable', sys.executable),
            '-IS',
            str(Path(__file__).with_name('client.py')),
            str(socket),
        ]
        os.environ['COURSE_RULE_LAUNCHER'] = ' '.join(f'"{part}"' for part in client)  # for python_interfaces.cmake
        os.environ.setdefault('MAKEFLAGS', '-j')  # else colcon tells Ninja to hold back while the machine is busy
        _patch_colcon(client)
        from colcon_core.command import main as colcon

        return colcon(argv=arguments)
    finally:
        shutil.rmtree(folder, ignore_errors=True)


def _patch_colcon(client: list[str]) -> None:
    """Let colcon's tasks ask the server, and take the variables of this process for those of the prefix."""
    import colcon_cmake.task.cmake.build as cmake
    import colcon_core.task.python.build as python
    import colcon_python_setup_py.package_identification.python_setup_py as setup_py
    import colcon_ros.task.ament_python.build as ament_python
    from colcon_core.environment_variable import EnvironDict

    async def environment(task_name, build_base, dependencies):
        os.makedirs(build_base, exist_ok=True)  # as colcon does, for the script that it writes here
        return EnvironDict(os.environ)

    async def available_commands(self, path, env):
        return {'develop', 'egg_info'}  # setuptools has both; the lock holds it below version 80

    def run(command, **options):
        return subprocess.run([*client, *command], **options)

    for module in (cmake, python, ament_python):
        module.get_command_environment = environment
    setup_py.subprocess = SimpleNamespace(**{**vars(subprocess), 'run': run})
    python._PYTHON_CMD = [*client, *python._PYTHON_CMD]
    python.PythonBuildTask._get_available_commands = available_commands


if __name__ == '__main__':
    sys.exit(main(sys.argv[1:]))
