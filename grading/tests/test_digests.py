"""A mark is up to date while its key is the same: what changes the key, and what does not."""

import os
import shutil

import pytest

from grading import learners_edition
from grading.course import Course
from helpers import paths

BOTH = ('helpers', 'grading', 'environment')


@pytest.fixture(scope='module')
def tree(tmp_path_factory):
    """A copy of what a key could depend on."""
    root = tmp_path_factory.mktemp('tree')
    for name in learners_edition.files(paths.ROOT, ()):
        if name.startswith(BOTH) and 'tests/browser' not in name:
            (root / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(paths.ROOT / name, root / name)
    return root


def keys(root):
    course = Course(Course.here().exercises, root / 'helpers' / 'checks', root / 'grading' / 'exercises')
    return course.digests_at(root)


def test_the_copy_has_the_keys_of_this_checkout(tree):
    assert keys(tree) == Course.here().digests


def any_file(tree, pattern):
    return next(path for path in sorted(tree.glob(pattern)) if path.is_file())


def changed(tree, path):
    """The exercises whose key differs while a file has other content."""
    before, content = keys(tree), path.read_bytes()
    path.write_bytes(content + b'\n')
    try:
        return {exercise for exercise, key in keys(tree).items() if key != before[exercise]}
    finally:
        path.write_bytes(content)


@pytest.mark.parametrize(
    'pattern',
    [
        'helpers/runner/*.py',
        'helpers/runner/*.xml',
        'helpers/exercises/*.py',
        'helpers/programs/faults/words.py',
        'helpers/kernel/domains.py',
        'helpers/__init__.py',
        'grading/sandbox/*.py',
        'grading/unit.py',
        'grading/submission.py',
        'grading/course.py',
        'environment/requirements.lock',
        'environment/ros2_ws/src/*/package.xml',
        'environment/ros2_ws/src/mujoco_world/**/*.py',
        'environment/ros2_ws/src/turtlesim/**/*.py',
        'environment/ros2_ws/src/mujoco_world/**/*.xml',
        'helpers/checks/chapter_02/builds.py',
        'helpers/checks/*/given/**/*.cfg',
        'helpers/checks/*/given/**/*.yaml',
        'helpers/checks/*/given/**/resource/*',
        'helpers/checks/*/given/**/package.xml',
    ],
)
def test_what_all_marks_depend_on(tree, pattern):
    assert changed(tree, any_file(tree, pattern)) == set(keys(tree))


@pytest.mark.parametrize('pattern', ['helpers/checks/chapter_03/test_3_1.py', 'grading/exercises/3_1/hidden.py'])
def test_what_one_mark_depends_on(tree, pattern):
    assert changed(tree, any_file(tree, pattern)) == {'3.1'}


@pytest.mark.parametrize(
    'pattern',
    [
        'grading/README.md',
        'grading/bench/*.py',
        'grading/reports/templates/*',
        'grading/exercises/3_1/mutants.py',
        'grading/exercises/3_1/alternatives.py',
        'grading/tests/*.py',
        'helpers/tests/*.py',
        'helpers/cli/*.py',
        'helpers/show/views/web/*',
        'environment/README.md',
        'environment/ros2_ws/**/*.md',
        'helpers/checks/exercises.json',
    ],
)
def test_what_no_mark_depends_on(tree, pattern):
    assert changed(tree, any_file(tree, pattern)) == set()


def test_a_program_that_may_not_be_executed_any_more(tree):
    path = any_file(tree, 'helpers/checks/*/given/**/package.xml')
    before, mode = keys(tree), path.stat().st_mode
    os.chmod(path, mode ^ 0o100)
    assert keys(tree) != before
    os.chmod(path, mode)
    assert keys(tree) == before
