"""What a fork server imports before a program that needs it begins."""

import subprocess
import sys

import pytest

from helpers import paths
from helpers.runner import preloading


def cell(source):
    return {'source': source}


@pytest.mark.parametrize(
    'source, named',
    [
        ('import matplotlib.pyplot as plt', ['matplotlib.pyplot']),
        ('if True:\n    from tf2_ros import Buffer', ['tf2_ros']),
        ('from helpers import check, wait_for', ['helpers.check', 'helpers.wait_for']),
        ('from helpers import (\n    check,\n    wait_for as wait,\n)', ['helpers.check', 'helpers.wait_for']),
        ('# from helpers import check', []),
        ('import tf2_ros_of_mine\nimport this', []),
        ('from helpers import no_such_name', []),
    ],
)
def test_named(source, named):
    assert preloading.on_demand([cell('x = 1'), cell(source)]) == named


def test_only_what_may_be_named_is_imported():
    """A request names modules; those of the learner's own choice are not run in the server."""
    wanted = ['rosbags.rosbag2', 'helpers.check', 'helpers.no_such_name', 'this', 'helpers.runner.tester']
    code = f"""
import sys
from helpers.runner import preloading
preloading.warm_up_for({wanted})
names = ['rosbags.rosbag2', 'helpers.exercises.exercise_check', 'this', 'helpers.runner.tester']
print([name for name in names if name in sys.modules])
"""
    done = subprocess.run([sys.executable, '-c', code], capture_output=True, text=True, cwd=paths.ROOT, check=True)
    assert done.stdout == "['rosbags.rosbag2', 'helpers.exercises.exercise_check']\n"
