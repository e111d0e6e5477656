"""Compiles Python modules ahead: processes in a sandbox would compile them anew each time, and store nothing."""

import compileall
import os
import re
import sysconfig
from pathlib import Path

from helpers.paths import ROOT

_FOLDERS = ('helpers', 'grading')  # the second is not in the learner's edition
_NOT_USED = re.compile(r'/tests/')
# Half of all that is installed, and nothing that a program of an exercise imports: what draws, serves notebooks, checks
# types, or works on a cluster, and the extensions of OpenGL, a folder for each vendor. babel, docutils and pygments are
# not among it: setuptools imports them when colcon asks a package for its commands.
_INSTALLED_NOT_USED = re.compile(
    '/(tests?|IPython|PIL|aiohttp|bleach|dask|debugpy|distributed|fontTools|jedi|jupyter[^/]*|matplotlib|mpl_toolkits'
    '|mypyc?|notebook[^/]*|OpenGL/(raw/)?(GL\\w*|WGL)/(?!VERSION/)[A-Z0-9]+|pip|prompt_toolkit|snowballstemmer|tornado'
    '|wcwidth|websockets)/'
)


def store() -> None:
    """Compile the course's modules that have changed since the last time. What cannot be written is left."""
    for folder in _FOLDERS:
        if (ROOT / folder).is_dir():
            compileall.compile_dir(ROOT / folder, quiet=2, rx=_NOT_USED)


def store_installed() -> None:
    """Compile the modules of ROS and of the other packages: seconds the first time, an instant from then on.

    Python stores what an ordinary program imports; but who only grades runs no such program. Nothing happens where the
    environment cannot be written.
    """
    folder = Path(sysconfig.get_path('purelib'))
    if os.access(folder, os.W_OK):
        compileall.compile_dir(folder, quiet=2, rx=_INSTALLED_NOT_USED)


if __name__ == '__main__':
    store()
