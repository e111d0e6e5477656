"""Which ROS the course stands on, decided from a shell's variables and made-up prefixes."""

import pytest

from environment.setup import underlay
from environment.setup.errors import PreflightError


def sourced(prefix, distro='jazzy'):
    return {'ROS_DISTRO': distro, 'AMENT_PREFIX_PATH': str(prefix)}


def test_nothing_sourced_means_wheels():
    assert not underlay.find({}).stock


def test_sourced_jazzy_is_used(stock):
    prefix = stock('jazzy', 'rclpy', 'tf2_msgs')
    found = underlay.find(sourced(prefix))
    assert found.prefixes == (prefix,)
    assert found.provides('tf2_msgs')
    assert not found.provides('turtlesim')


def test_workspaces_on_top_of_jazzy_count_too(stock):
    workspace, jazzy = stock('ws', 'turtlesim'), stock('jazzy', 'rclpy')
    found = underlay.find(sourced(f'{workspace}:{jazzy}'))
    assert found.prefixes == (workspace, jazzy)
    assert found.provides('turtlesim')


def test_the_courses_own_environment_is_no_stock_ros(stock):
    prefix = stock('.venv', 'rclpy')
    (prefix / 'pyvenv.cfg').touch()
    assert not underlay.find(sourced(prefix)).stock


def test_jazzy_without_rclpy_is_not_enough(stock):
    assert not underlay.find(sourced(stock('jazzy', 'std_msgs'))).stock


def test_a_prefix_that_is_gone_is_not_used(tmp_path):
    assert not underlay.find(sourced(tmp_path / 'gone')).stock


def test_robostack_is_found_without_its_activation_script(stock):
    prefix = stock('conda', 'rclpy')
    (prefix / 'conda-meta').mkdir()
    (prefix / 'conda-meta' / 'ros-jazzy-rclpy-7.1.4-0.json').touch()
    assert underlay.find({'CONDA_PREFIX': str(prefix)}).prefixes == (prefix,)


def test_conda_without_ros_is_not_used(stock):
    assert not underlay.find({'CONDA_PREFIX': str(stock('conda', 'rclpy'))}).stock


def test_another_distribution_is_refused_in_one_line(stock):
    with pytest.raises(PreflightError) as refusal:
        underlay.find(sourced(stock('humble', 'rclpy'), 'humble'))
    assert 'humble' in refusal.value.what
    assert '\n' not in str(refusal.value)


def test_ros_1_is_refused(tmp_path):
    with pytest.raises(PreflightError, match='noetic'):
        underlay.find({'ROS_DISTRO': 'noetic', 'ROS_PACKAGE_PATH': str(tmp_path)})


def test_a_leftover_name_of_a_distribution_does_no_harm():
    assert not underlay.find({'ROS_DISTRO': 'humble'}).stock


def test_its_interpreter_is_the_one_rclpy_was_built_for(stock):
    apt = underlay.Underlay((stock('jazzy', 'rclpy', python='python3.12'),))
    assert apt.interpreters()[0] == '/usr/bin/python3.12'
    conda = stock('conda', 'rclpy', python='python3.11')
    (conda / 'bin').mkdir()
    (conda / 'bin' / 'python3.11').touch()
    assert underlay.Underlay((conda,)).interpreters()[0] == str(conda / 'bin' / 'python3.11')


def test_name_and_parse_are_inverse(stock):
    for found in (underlay.Underlay(), underlay.Underlay((stock('a'), stock('b')))):
        assert underlay.parse(str(found)) == found


def test_the_lock_without_wheels_keeps_everything_else_with_its_hashes():
    before = '# top\nrich==3 \\\n    --hash=sha256:aa\n    # via typer\n'
    wheel = 'ros-rcl==9 \\\n    --hash=sha256:bb\n'
    after = 'uv==1 \\\n    --hash=sha256:cc\n'
    assert underlay.without_ros_wheels(before + wheel + after) == before + after
