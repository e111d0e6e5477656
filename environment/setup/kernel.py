"""Ties the environment to the course: import path, start-up hook, Jupyter kernel, JupyterLab's settings."""

import json
import os
from pathlib import Path

from environment.setup import startup
from environment.setup.layout import Layout

HOOK = '_course_startup'
KERNEL = 'course'
EXTENSION = 'helpers.exercises.cell_errors'  # explains errors of cells, such as names that a restart has taken away
PROFILE = Path(__file__).with_name('fastdds.xml')
SETTINGS = Path(__file__).with_name('jupyterlab.json')  # what JupyterLab does unless its user says otherwise


def install(layout: Layout) -> None:
    """Write `course.pth`, the start-up hook, Fast DDS's profile, the kernelspec and JupyterLab's settings.

    A second call changes nothing.
    """
    site = layout.site_packages()
    # A copy, as a sandbox may show the environment without the repository.
    (site / f'{HOOK}.py').write_text(Path(startup.__file__).read_text())
    # Named so that it runs before ros_wheels_bootstrapper.pth, whose guard it looks after.
    # The root by a relative path: in a terminal with the locale C, a Python 3.11 could not read one with an umlaut.
    root = os.path.relpath(layout.root, site)
    (site / 'course.pth').write_text(f'{root}\nimport {HOOK}; {HOOK}.start()\n')
    copies = {PROFILE: startup.PROFILE, SETTINGS: 'share/jupyter/lab/settings/overrides.json'}
    for source, target in copies.items():
        (layout.prefix / target).parent.mkdir(parents=True, exist_ok=True)
        (layout.prefix / target).write_text(source.read_text())
    directory = layout.prefix / 'share' / 'jupyter' / 'kernels' / KERNEL
    directory.mkdir(parents=True, exist_ok=True)
    (directory / 'kernel.json').write_text(json.dumps(kernelspec(layout), indent=1) + '\n')


def kernelspec(layout: Layout) -> dict:
    """The kernel `course`. Under pytest (nbval) PYTEST_CURRENT_TEST would reach the kernel and change libraries."""
    command = ['env', '-u', 'PYTEST_CURRENT_TEST', str(layout.python), '-m', 'ipykernel_launcher']
    return {
        'argv': [*command, '-f', '{connection_file}', f'--ext={EXTENSION}'],
        'display_name': 'ROS 2 course',
        'language': 'python',
        'metadata': {'debugger': True},
    }
