"""What is fresh and what is stale."""

import json
import os
import shutil

import pytest

from environment.setup import kernel, overlay
from environment.setup.installed import Installed
from environment.setup.layout import Layout
from environment.setup.stamps import Stamps, digest, digest_tree
from environment.setup.steps import VERSION, Setup
from environment.setup.underlay import Underlay
from environment.tests.conftest import add_package


def test_digest_tells_parts_apart():
    assert digest('ab', 'c') != digest('a', 'bc')


def test_digest_of_a_tree_sees_names_contents_and_modes(tmp_path):
    (tmp_path / 'a').write_text('1')
    seen = {digest_tree(tmp_path)}
    (tmp_path / 'a').write_text('2')
    seen.add(digest_tree(tmp_path))
    (tmp_path / 'a').chmod(0o755)
    seen.add(digest_tree(tmp_path))
    (tmp_path / 'a').rename(tmp_path / 'b')
    seen.add(digest_tree(tmp_path))
    assert len(seen) == 4
    (tmp_path / '__pycache__').mkdir()
    (tmp_path / '__pycache__' / 'a.pyc').touch()
    assert digest_tree(tmp_path) in seen


def test_stamps(tmp_path):
    stamps = Stamps(tmp_path / 'stamps')
    assert stamps.read('a') == ''
    assert stamps.names() == []
    stamps.write('a', '1')
    stamps.write('a', '2')
    assert stamps.read('a') == '2'
    assert stamps.names() == ['a']
    stamps.remove('a')
    stamps.remove('a')
    assert stamps.read('a') == ''


def test_a_changed_package_makes_its_dependents_stale(checkout: Layout):
    add_package(checkout, 'apart')
    before = overlay.keys(overlay.discover(checkout.sources), 'f')
    (checkout.sources / 'lower' / 'code.py').write_text('changed')
    after = overlay.keys(overlay.discover(checkout.sources), 'f')
    assert {name for name in before if before[name] != after[name]} == {'lower', 'upper'}
    (checkout.sources / 'upper' / 'code.py').write_text('changed')
    last = overlay.keys(overlay.discover(checkout.sources), 'f')
    assert {name for name in after if after[name] != last[name]} == {'upper'}
    assert not set(overlay.keys(overlay.discover(checkout.sources), 'g').values()) & set(last.values())


def test_packages_in_a_circle_are_told(checkout: Layout):
    shutil.rmtree(checkout.sources / 'lower')
    add_package(checkout, 'lower', 'upper')
    with pytest.raises(ValueError, match='lower -> upper -> lower'):
        overlay.keys(overlay.discover(checkout.sources), 'f')


def test_ignored_directories_hold_no_packages(checkout: Layout):
    (checkout.sources / 'upper' / 'COLCON_IGNORE').touch()
    assert list(overlay.discover(checkout.sources)) == ['lower']


def test_uninstall_removes_what_was_installed_and_nothing_else(tmp_path):
    prefix, build = tmp_path / 'prefix', tmp_path / 'build'
    ours = (
        'share/p/gone.txt',
        'share/p/hook/path.sh',
        'share/colcon-core/packages/p',
        'lib/p-1.egg-info/PKG-INFO',
        'lib/p/code.py',
        'lib/p/__pycache__/code.cpython-311.pyc',
    )
    for name in (*ours, 'share/other/kept.txt', 'lib/shared.so'):
        (prefix / name).parent.mkdir(parents=True, exist_ok=True)
        (prefix / name).touch()
    outside = tmp_path / 'outside.txt'
    outside.touch()
    build.mkdir()
    (prefix / 'share' / 'p' / 'empty').mkdir()  # what setup.py lists of a glob that found nothing
    (build / 'install_manifest.txt').write_text(f'{prefix}/share/p/empty\n{prefix}/share/p/gone.txt\n{outside}\n')
    (build / 'install.log').write_text(f'{prefix}/lib/p/code.py\n{prefix}/lib/p-1.egg-info\n{prefix}/lib/never.py\n')
    installed = Installed(tmp_path / 'lists', prefix)
    installed.write('p', installed.of_build('p', build))
    assert set(installed.read('p')) == set(ours[:-1])
    installed.uninstall('p')
    (prefix / 'share' / 'p' / 'empty').rmdir()
    assert sorted(str(path.relative_to(prefix)) for path in prefix.rglob('*') if path.is_file()) == [
        'lib/shared.so',
        'share/other/kept.txt',
    ]
    assert not (prefix / 'lib' / 'p').exists()
    assert outside.exists()
    assert installed.names() == []


@pytest.fixture
def made(checkout: Layout, tmp_path):
    """The set-up of `checkout` with every step done, as far as stamps can tell."""
    python = tmp_path / 'python3.12'
    python.touch()
    (checkout.prefix / 'bin').mkdir(parents=True)
    checkout.python.symlink_to(python)
    site = checkout.prefix / 'lib' / 'python3.12' / 'site-packages'
    site.mkdir(parents=True)
    setup = Setup(checkout, Underlay(), {})
    facts = {'setup': VERSION, 'prefix': str(checkout.prefix), 'python': str(python), 'underlay': 'wheels', 'asked': ''}
    setup.stamps.write('venv', json.dumps({**facts, 'version': '3.12'}))
    foundation = setup.foundation(setup.lock())
    setup.stamps.write('requirements', digest(setup.lock()))
    setup.stamps.write('relocation', foundation)
    setup.stamps.write('backports', setup.backports_key(foundation))
    setup.stamps.write('kernel', setup.kernel_key())
    for name, key in overlay.keys(setup.packages(), foundation).items():
        setup.stamps.write(f'package.{name}', key)
    (checkout.prefix / 'setup.bash').touch()
    (checkout.prefix / 'local_setup.bash').write_text(f'_colcon_python_executable="{python}"\n')
    kernel.install(checkout)
    assert setup.stale() == []
    return setup


def test_a_changed_lock(made: Setup):
    made.layout.requirements.write_text('ros-jazzy-rclpy==1\nnumpy==2\nrich==4\n')
    assert made.stale() == ['requirements']
    made.layout.requirements.write_text('ros-jazzy-rclpy==2\nnumpy==2\nrich==3\n')
    assert made.stale() == ['requirements', 'relocation', 'backports', 'package.lower', 'package.upper']


def test_a_changed_package(made: Setup):
    (made.layout.sources / 'upper' / 'code.py').write_text('changed')
    assert made.stale() == ['package.upper']


def test_a_removed_and_a_new_package(made: Setup):
    shutil.rmtree(made.layout.sources / 'upper')
    assert made.stale() == ['package.upper']
    made.stamps.remove('package.upper')
    add_package(made.layout, 'more')
    assert made.stale() == ['package.more']


def test_an_interrupted_installation(made: Setup):
    made.stamps.write('requirements.started', '1')
    assert made.stale() == ['venv']


def test_a_moved_course(made: Setup):
    elsewhere = made.layout.root.with_name('elsewhere')
    made.layout.root.rename(elsewhere)
    assert Setup(Layout(elsewhere), Underlay(), {}).stale() == ['venv']


def test_another_python(made: Setup, tmp_path):
    asked = {'COURSE_PYTHON': str(tmp_path / 'python3.12')}
    assert Setup(made.layout, Underlay(), asked).stale() == []
    assert Setup(made.layout, Underlay(), {'COURSE_PYTHON': '/other/python'}).stale() == ['venv']


def test_a_system_python_that_was_replaced(made: Setup, tmp_path):
    made.layout.python.unlink()
    made.layout.python.symlink_to(tmp_path / 'python3.13')
    assert made.stale() == ['venv']


def test_setup_scripts_that_ask_the_wrong_python(made: Setup):
    (made.layout.prefix / 'local_setup.bash').write_text(f'_colcon_python_executable="{made.layout.python}"\n')
    assert made.stale() == ['setup.bash']


def test_another_underlay(made: Setup, stock):
    assert Setup(made.layout, Underlay((stock('jazzy', 'rclpy'),)), {}).stale() == ['venv']


def test_packages_of_a_stock_ros_are_left_out(checkout: Layout, stock):
    setup = Setup(checkout, Underlay((stock('jazzy', 'rclpy', 'lower'),)), {})
    assert list(setup.packages()) == ['upper']
    assert setup.lock() == 'numpy==2\nrich==3\n'


def test_every_kernel_starts_without_pytests_variable(made: Setup):
    spec = json.loads((made.layout.prefix / 'share/jupyter/kernels/course/kernel.json').read_text())
    assert spec['argv'][:3] == ['env', '-u', 'PYTEST_CURRENT_TEST']
    assert spec['argv'][3] == str(made.layout.python)
    assert os.path.exists(made.layout.site_packages() / 'course.pth')
