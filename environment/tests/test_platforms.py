"""The files for other machines, as far as they can be checked here: form, schema, and whether they agree."""

import json
import re
import subprocess

import pytest
import yaml

from helpers import paths

ROOT = paths.ROOT
# What Debian's and conda's Jazzy have of the packages in ros2_ws/src, beyond ros-base.
FROM_STOCK = {
    'example_interfaces',
    'turtlesim',
    'tf2_tools',
    'tf2_geometry_msgs',
    'tf2_sensor_msgs',
    'tf_transformations',
    'robot_state_publisher',
    'joint_state_publisher',
    'xacro',
}


def ros_packages(text: str) -> set[str]:
    return {name.replace('-', '_') for name in re.findall(r'ros-jazzy-([a-z0-9-]+)', text)} - {'ros_base'}


@pytest.mark.parametrize('name', ['environment/containers/Dockerfile', 'environment/robostack.yml'])
def test_stock_packages_are_taken_where_they_exist(name):
    assert ros_packages((ROOT / name).read_text()) == FROM_STOCK
    assert FROM_STOCK <= {path.name for path in (ROOT / 'environment' / 'ros2_ws' / 'src').iterdir()}


def test_every_list_of_debian_packages_is_the_same():
    needed = set((ROOT / '.binder' / 'apt.txt').read_text().split())
    for name in ('README.md', 'environment/README.md'):
        (line,) = set(re.findall(r'apt(?:-get)? install ([a-z0-9+ -]*g\+\+[a-z0-9+ -]*)', (ROOT / name).read_text()))
        assert set(line.split()) == needed, name
    assert needed <= set((ROOT / 'environment' / 'containers' / 'Dockerfile').read_text().split())


def test_the_dev_container_uses_the_image():
    settings = json.loads((ROOT / '.devcontainer' / 'devcontainer.json').read_text())
    dockerfile = (ROOT / '.devcontainer' / settings['build']['dockerfile']).resolve()
    assert dockerfile.is_file()
    assert settings['remoteUser'] in dockerfile.read_text()


def test_the_script_of_binder_is_a_script():
    script = ROOT / '.binder' / 'postBuild'
    assert script.stat().st_mode & 0o111
    subprocess.run(['bash', '-n', script], check=True)


def test_the_conda_environment_has_a_name_channels_and_packages():
    environment = yaml.safe_load((ROOT / 'environment' / 'robostack.yml').read_text())
    assert set(environment) == {'name', 'channels', 'dependencies'}
    assert environment['channels'] == ['conda-forge', 'robostack-jazzy']


@pytest.mark.skipif(not (ROOT / '.ci').is_dir(), reason="the learner's edition has no CI")
@pytest.mark.parametrize(
    ('schema', 'name'),
    [('vendor.github-workflows', '.github/workflows/course.yml'), ('vendor.gitlab-ci', '.gitlab-ci.yml')],
)
def test_ci_files_follow_their_schema(schema, name):
    done = subprocess.run(['check-jsonschema', '--builtin-schema', schema, ROOT / name], capture_output=True, text=True)
    assert done.returncode == 0, done.stdout
