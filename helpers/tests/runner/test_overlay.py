"""The environment of a built workspace, made from what is installed there."""

import ast
import os
import socket
import stat
import sys
import sysconfig
from pathlib import Path

import pytest

from helpers.runner import sourced_environment

PYTHON = f'python{sys.version_info[0]}.{sys.version_info[1]}'
SITE = f'lib/{PYTHON}/site-packages'


def installed(root, *names, package='patrol', **texts):
    """A workspace in which colcon has installed a package with these files."""
    prefix = root / 'install' / package
    for name in (f'share/colcon-core/packages/{package}', *names):
        (prefix / name).parent.mkdir(parents=True, exist_ok=True)
        (prefix / name).write_text(texts.get(name, ''))
    return prefix


def test_an_installed_package_is_found(tmp_path):
    names = f'{SITE}/patrol/route.py', 'lib/libpatrol__c.so', 'bin/tool', 'share/patrol/hook/ament_prefix_path.dsv'
    prefix = installed(tmp_path, *names)
    (tmp_path / 'install' / 'half').mkdir()  # its build has failed
    found = sourced_environment.of(tmp_path, ['patrol'])
    for name in ('AMENT_PREFIX_PATH', 'CMAKE_PREFIX_PATH'):
        assert found[name].split(':')[0] == str(prefix) and 'half' not in found[name]
    assert found['PYTHONPATH'].split(':')[0] == str(prefix / SITE)
    assert (Path(found['LD_LIBRARY_PATH'].split(':')[-1]) / 'libpatrol__c.so').samefile(prefix / 'lib/libpatrol__c.so')
    assert found['PATH'].split(':')[-1] == str(prefix / 'bin')  # behind all tools


@pytest.mark.parametrize(
    ('name', 'is_found'), [('hook/ament_prefix_path.dsv', True), ('local_setup.dsv', True), ('package.dsv', False)]
)
def test_ros_finds_a_package_that_says_so(tmp_path, name, is_found):
    """One of CMakeLists.txt without ament_package() is installed, and `ros2` does not know it."""
    prefix = installed(tmp_path, f'share/patrol/{name}')
    found = sourced_environment.of(tmp_path, ['patrol'])
    assert (str(prefix) in found.get('AMENT_PREFIX_PATH', '').split(':')) == is_found
    assert str(prefix) in found['CMAKE_PREFIX_PATH'].split(':')


def test_a_linked_package_is_found_where_it_was_built(tmp_path):
    installed(tmp_path, f'{SITE}/patrol.egg-link')
    assert f'{tmp_path}/build/patrol' in sourced_environment.of(tmp_path, ['patrol'])['PYTHONPATH'].split(':')


def test_nothing_is_executed(tmp_path):
    """Neither the workspace's setup file nor a hook of a package."""
    installed(tmp_path, 'share/patrol/hook/own.sh', 'share/patrol/package.sh')
    for script in tmp_path.rglob('*.sh'):
        script.write_text('export EVIL=1; touch "$HOME/evil"')
    (tmp_path / 'install' / 'setup.bash').write_text('export EVIL=1')
    assert 'EVIL' not in sourced_environment.of(tmp_path, ['patrol'])


@pytest.mark.parametrize('folder', ['glibc-hwcaps/x86-64-v2', 'tls', 'x86_64'])
def test_only_libraries_of_the_package_are_found(tmp_path, folder):
    """The loader would look for the system's libraries in these folders, too."""
    installed(tmp_path, 'lib/libpatrol__c.so', f'lib/{folder}/libm.so.6')
    place = Path(sourced_environment.of(tmp_path, ['patrol'])['LD_LIBRARY_PATH'].split(':')[-1])
    assert [path.name for path in place.rglob('*')] == ['libpatrol__c.so']


def _socket(path):
    os.chdir(path.parent)  # the name of a socket must be short
    with socket.socket(socket.AF_UNIX) as one:
        one.bind(path.name)


def _device(path):
    if os.geteuid():
        pytest.skip('only root makes devices')
    os.mknod(path, stat.S_IFCHR | 0o600, os.makedev(1, 3))


def _link_to_a_pipe(path):
    os.mkfifo(path.parents[3] / 'elsewhere')
    path.symlink_to(path.parents[3] / 'elsewhere')


PRODUCTS = {
    'pipe': (os.mkfifo, 'no regular file'),
    'socket': (_socket, 'no regular file'),
    'device': (_device, 'no regular file'),
    'link to a pipe': (_link_to_a_pipe, 'leads to no file'),
    'link to a device': (lambda path: path.symlink_to('/dev/zero'), 'leads to no file'),
    'link to itself': (lambda path: path.symlink_to(path.name), 'leads to no file'),
    'folder elsewhere': (lambda path: path.symlink_to('/usr/share'), 'leads to no file'),
}


@pytest.mark.parametrize('place', ['install/patrol/share', 'build/patrol/x', 'src/patrol/patrol'])
@pytest.mark.parametrize('kind', PRODUCTS)
def test_what_others_would_wait_for_is_refused(tmp_path, monkeypatch, kind, place):
    monkeypatch.chdir(tmp_path)
    (tmp_path / place).mkdir(parents=True)
    make, why = PRODUCTS[kind]
    make(tmp_path / place / 'route')
    with pytest.raises(sourced_environment.Shadowed, match=f"'route' when it is built, which.*{why}"):
        sourced_environment.look_at_products(tmp_path)


def test_what_builds_leave_is_accepted(tmp_path):
    """Files, folders, and the links of `colcon build --symlink-install`, of which one may lead nowhere."""
    installed(tmp_path, 'share/patrol/package.xml', 'lib/patrol/drive')
    (tmp_path / 'src/patrol/patrol').mkdir(parents=True)
    (tmp_path / 'src/patrol/setup.py').write_text('')
    (tmp_path / 'build/patrol').mkdir(parents=True)
    for name in ('setup.py', 'patrol', 'gone'):
        (tmp_path / 'build/patrol' / name).symlink_to(tmp_path / 'src/patrol' / name)
    (tmp_path / 'build/patrol/python').symlink_to(sys.executable)
    sourced_environment.look_at_products(tmp_path)
    sourced_environment.look_at_products(tmp_path / 'nowhere')


def test_too_many_products_are_refused(tmp_path, monkeypatch):
    monkeypatch.setattr(sourced_environment, '_MAX_PRODUCTS', 3)
    installed(tmp_path, 'a', 'b', 'c')
    with pytest.raises(sourced_environment.Shadowed, match='more than 3 files'):
        sourced_environment.look_at_products(tmp_path)


@pytest.mark.parametrize(
    ('name', 'why'),
    [
        (f'{SITE}/sitecustomize.py', 'module `sitecustomize`'),
        (f'{SITE}/importlib/__init__.pyc', 'module `importlib`'),
        (f'{SITE}/json.cpython-311-x86_64-linux-gnu.so', 'module `json`'),
        (f'{SITE}/rclpy/__init__.py', 'module `rclpy`'),
        (f'{SITE}/ros2cli/__init__.py', 'module `ros2cli`'),
        (f'{SITE}/pytest.py', 'module `pytest`'),
        (f'local/lib/{PYTHON}/dist-packages/yaml/__init__.py', 'module `yaml`'),
        (f'{SITE}/ros2cli-9.0.dist-info/METADATA', 'installs itself as ros2cli'),
        (f'{SITE}/org/python/core.py', 'module `org`'),
        (f'{SITE}/regex.py', 'module `regex`'),
        (f'{SITE}/ruamel/yaml/__init__.py', 'module `ruamel`'),
        ('lib/libc.so.6', 'library libc.so.6'),
        ('lib/librcl.so', 'library librcl.so'),
    ],
)
def test_what_would_take_the_place_of_the_machines_own_is_refused(tmp_path, name, why):
    installed(tmp_path, name)
    with pytest.raises(sourced_environment.Shadowed, match=why):
        sourced_environment.of(tmp_path, ['patrol'])


def test_a_library_is_not_called_as_a_package_that_nobody_asked_for(tmp_path):
    """What stands as a name in package.xml is the package's own word."""
    installed(tmp_path, 'lib/libnss_systemd.so.2', package='nss')
    with pytest.raises(sourced_environment.Shadowed, match='library libnss_systemd'):
        sourced_environment.of(tmp_path, ['patrol'])


@pytest.mark.one_of(4)
def test_modules_that_tools_would_like_to_have_are_known():
    """Who installs one of these would be in all programs."""
    library = Path(sysconfig.get_path('stdlib'))
    files = [path for path in library.rglob('*.py') if not {'test', 'site-packages'} & set(path.parts)]
    for place in sourced_environment._places():
        for top in sourced_environment._names(place, ''):
            if top.startswith(('_pytest', 'colcon_', 'lark', 'launch', 'packaging', 'rclpy', 'ros2', 'yaml')):
                files += [path for path in (place / top).rglob('*.py') if '__pyinstaller' not in path.parts]
    asked = {name for path in files for name in imported(path)}
    assert len(files) > 1000 and 'usercustomize' in asked  # site.py looks for it, in every version
    missing = asked - sourced_environment._known() - sourced_environment.OPTIONAL - {'__main__', 'test'}
    assert not missing


def imported(path):
    """The first parts of the modules that a program imports."""
    try:
        tree = ast.parse(path.read_bytes())
    except SyntaxError:
        return
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            yield from (alias.name.partition('.')[0] for alias in node.names)
        elif isinstance(node, ast.ImportFrom) and not node.level:
            yield node.module.partition('.')[0]


@pytest.mark.parametrize(
    'name',
    [
        f'{SITE}/patrol/json.py',
        f'{SITE}/patrol_tools/__init__.py',
        f'{SITE}/helpers_of_mine.py',
        f'{SITE}/test/__init__.py',
        f'{SITE}/rclpy/__init__.py',
        f'{SITE}/resource/patrol',
    ],
)
def test_modules_of_its_own_are_not(tmp_path, name):
    """Below the package, for tests, in a package of that name that is being written, in a folder that is none."""
    installed(tmp_path, name, package='rclpy' if 'rclpy' in name else 'patrol')
    sourced_environment.of(tmp_path, ['patrol', 'rclpy'])


@pytest.mark.parametrize('group', ['ros2cli.command', 'colcon_core.verb', 'pytest11'])
def test_an_extension_of_tools_is_refused(tmp_path, group):
    name = f'{SITE}/patrol-0.1.0-py3.11.egg-info/entry_points.txt'
    texts = {name: f'[console_scripts]\nroute = patrol.route:main\n\n[{group}]\nrun = patrol.evil:Run\n'}
    installed(tmp_path, name, **texts)
    with pytest.raises(sourced_environment.Shadowed, match=group):
        sourced_environment.of(tmp_path, ['patrol'])
