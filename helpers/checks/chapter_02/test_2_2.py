"""Visible tests of exercise 2.2, repair a package: each of the six faults by itself."""

import pytest

from helpers.checks.chapter_02 import following

pytestmark = pytest.mark.exercise('2.2')


@pytest.mark.rules('entry-point')
def test_entry_point(learner):
    """The entry point follow leads to main of follow.py.

    The right side of an entry point is package.module:function.
    """
    following.judge_entry_point(learner)


@pytest.mark.rules('packages')
def test_python_packages(learner):
    """All Python packages are installed, also the folder filters.

    `packages` in setup.py names each folder that has an __init__.py, with dots; find_packages finds them.
    """
    following.judge_packages(learner)


@pytest.mark.rules('builds')
def test_build(learner):
    """The build prints no warning: setup.py installs the marker and package.xml.

    Look at the first line of data_files in a setup.py that `ros2 pkg create` has made, and at the build's warnings.
    """
    following.judge_build(learner)


@pytest.mark.rules('data')
def test_data_file(learner):
    """The data file is installed where the program looks for it.

    The first part of a line of data_files is the folder below the installation, the second one the list of files.
    """
    following.judge_data(learner)


@pytest.mark.rules('programs')
def test_where_programs_go(learner):
    """Programs go to lib/line_follower, where `ros2 run` looks.

    setup.cfg says it twice: for a plain build, and for --symlink-install.
    """
    following.judge_place(learner)


@pytest.mark.rules('dependencies')
def test_dependencies(learner):
    """package.xml declares what the code imports from other packages, so that it is there when the program runs.

    Compare the import lines of follow.py with package.xml: exec_depend or depend.
    """
    following.judge_dependencies(learner)


@pytest.mark.given
@pytest.mark.rules('rest')
def test_nothing_else(learner):
    """Everything that was right has stayed: names, versions, licence, build type, one program.

    Compare with the texts that were given.
    """
    following.judge_rest(learner)


@pytest.mark.rules('entry-point', 'programs', 'packages', 'data')
def test_it_drives(learner):
    """`ros2 run line_follower follow` prints `forward 0.20 m/s, turn -0.08 rad/s`.

    Build, run, read the last line of the error, and go on.
    """
    following.judge_drive(learner)
