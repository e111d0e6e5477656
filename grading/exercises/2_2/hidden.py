"""Hidden tests of exercise 2.2, repair a package: each of the six faults by itself."""

import pytest

from helpers.checks.chapter_02 import following
from helpers.checks.chapter_02.test_2_2 import (  # noqa: F401 - they draw other inputs here
    test_build,
    test_data_file,
    test_dependencies,
    test_entry_point,
    test_nothing_else,
    test_python_packages,
    test_where_programs_go,
)

pytestmark = pytest.mark.exercise('2.2')


@pytest.mark.rules('entry-point', 'programs', 'data')
def test_other_gains(learner):
    """After a build with --symlink-install, `ros2 run line_follower follow` prints what follows from its data file.

    setup.cfg says twice where programs go: for a plain build, and for --symlink-install.
    """
    following.judge_linked(learner)
