"""The ways to ROS, on made-up machines."""

import subprocess

import pytest

from environment.setup import routes

NOBLE = 'NAME="Ubuntu"\nVERSION_ID="24.04"\n'


def system(tmp_path, release=NOBLE, *files):
    """A root file system with these files."""
    (tmp_path / 'etc/apt/sources.list.d').mkdir(parents=True)
    (tmp_path / 'etc/os-release').write_text(release)
    for name, text in files:
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(text)
    return tmp_path


def engine(images='', status=0):
    return lambda argv, **options: subprocess.CompletedProcess(argv, status, images, '')


def names(steps):
    return [step.name for step in steps]


def test_apt_on_a_fresh_noble_needs_everything(tmp_path):
    route = routes.apt(system(tmp_path), 'x86_64')
    assert route.possible and not route.ready
    assert names(route.missing) == ['key of packages.ros.org', 'apt source', 'ros-jazzy-desktop', 'ros-dev-tools']
    assert 'ros2-apt-source' in route.missing[0].remedy


@pytest.mark.parametrize(
    'source',
    [
        ('etc/apt/sources.list.d/ros2.sources', 'URIs: http://packages.ros.org/ros2/ubuntu'),
        ('etc/apt/sources.list.d/ros2.list', 'deb https://mirrors.tuna.tsinghua.edu.cn/ros2/ubuntu noble main'),
    ],
)
def test_apt_that_is_done(tmp_path, source):
    root = system(
        tmp_path,
        NOBLE,
        source,
        ('usr/share/keyrings/ros2-archive-keyring.gpg', ''),
        ('opt/ros/jazzy/setup.bash', ''),
        ('usr/bin/colcon', ''),
        ('etc/apt/sources.list.d/other.list', 'deb http://archive.ubuntu.com/ubuntu noble main'),
    )
    route = routes.apt(root, 'aarch64')
    assert route.ready and not route.missing
    assert source[0].rpartition('/')[2] in [step.text for step in route.steps]


@pytest.mark.parametrize(
    ('release', 'machine'),
    [
        ('NAME="Ubuntu"\nVERSION_ID="22.04"\n', 'x86_64'),
        ('NAME="Debian GNU/Linux"\nVERSION_ID="12"\n', 'x86_64'),
        ('', 'x86_64'),
        (NOBLE, 'riscv64'),
    ],
)
def test_apt_is_for_one_ubuntu_only(tmp_path, release, machine):
    route = routes.apt(system(tmp_path, release), machine)
    assert not route.possible and not route.ready


def test_container():
    assert names(routes.container({}, lambda name: None).missing) == ['Docker or Podman']
    here = lambda name: f'/usr/bin/{name}' if name == 'podman' else None  # noqa: E731
    assert names(routes.container({}, here, engine(status=125)).missing) == ['it answers']
    assert names(routes.container({}, here, engine('debian:12\n')).missing) == ['an image']
    assert routes.container({}, here, engine('debian:12\nosrf/ros:jazzy-desktop\n')).ready


def test_an_engine_that_hangs_is_one_that_does_not_answer():
    def hangs(argv, **options):
        raise subprocess.TimeoutExpired(argv, 10)

    assert names(routes.container({}, lambda name: name, hangs).missing) == ['it answers']


def test_conda(tmp_path):
    assert len(routes.conda({}, lambda name: None).missing) == 2
    (tmp_path / 'conda-meta').mkdir()
    (tmp_path / 'conda-meta' / 'ros-jazzy-rclpy-7.1.9-py312.json').touch()
    assert routes.conda({'CONDA_PREFIX': str(tmp_path)}, lambda name: name).ready


def test_the_report_says_what_this_machine_needs():
    from helpers import routes as report

    found = report()
    assert [route.name for route in found][0] == 'apt packages' and len(found) == 4
    text, html = repr(found), found._repr_html_()
    for route in found:
        assert route.name in text
        for step in route.missing:
            assert step.name in text and step.remedy in text
    assert html.count('✓') == sum(step.ok for route in found for step in route.steps)
    assert "this course's own prefix: ready" in text, 'these tests run in it'
