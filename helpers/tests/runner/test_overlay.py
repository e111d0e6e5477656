"""The environment of a built workspace, made from what is installed there."""

import sys

import pytest

from helpers.runner import overlay

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
    prefix = installed(tmp_path, f'{SITE}/patrol/route.py', 'lib/libpatrol__c.so', 'bin/tool')
    (tmp_path / 'install' / 'half').mkdir()  # its build has failed
    found = overlay.of(tmp_path, ['patrol'])
    for name in ('AMENT_PREFIX_PATH', 'CMAKE_PREFIX_PATH'):
        assert found[name].split(':')[0] == str(prefix) and 'half' not in found[name]
    assert found['PYTHONPATH'].split(':')[0] == str(prefix / SITE)
    assert found['LD_LIBRARY_PATH'].split(':')[-1] == str(prefix / 'lib')
    assert found['PATH'].split(':')[-1] == str(prefix / 'bin')  # behind all tools


def test_a_linked_package_is_found_where_it_was_built(tmp_path):
    installed(tmp_path, f'{SITE}/patrol.egg-link')
    assert f'{tmp_path}/build/patrol' in overlay.of(tmp_path, ['patrol'])['PYTHONPATH'].split(':')


def test_nothing_is_executed(tmp_path):
    """Neither the workspace's setup file nor a hook of a package."""
    installed(tmp_path, 'share/patrol/hook/own.sh', 'share/patrol/package.sh')
    for script in tmp_path.rglob('*.sh'):
        script.write_text('export EVIL=1; touch "$HOME/evil"')
    (tmp_path / 'install' / 'setup.bash').write_text('export EVIL=1')
    assert 'EVIL' not in overlay.of(tmp_path, ['patrol'])


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
        ('lib/libc.so.6', 'library libc.so.6'),
        ('lib/librcl.so', 'library librcl.so'),
    ],
)
def test_what_would_take_the_place_of_the_machines_own_is_refused(tmp_path, name, why):
    installed(tmp_path, name)
    with pytest.raises(overlay.Shadowed, match=why):
        overlay.of(tmp_path, ['patrol'])


@pytest.mark.parametrize(
    'name',
    [f'{SITE}/patrol/json.py', f'{SITE}/test/__init__.py', f'{SITE}/rclpy/__init__.py', f'{SITE}/resource/patrol'],
)
def test_modules_of_its_own_are_not(tmp_path, name):
    """Below the package, for tests, in a package of that name that is being written, in a folder that is none."""
    installed(tmp_path, name, package='rclpy' if 'rclpy' in name else 'patrol')
    overlay.of(tmp_path, ['patrol', 'rclpy'])


@pytest.mark.parametrize('group', ['ros2cli.command', 'colcon_core.verb', 'pytest11'])
def test_an_extension_of_tools_is_refused(tmp_path, group):
    name = f'{SITE}/patrol-0.1.0-py3.11.egg-info/entry_points.txt'
    texts = {name: f'[console_scripts]\nroute = patrol.route:main\n\n[{group}]\nrun = patrol.evil:Run\n'}
    installed(tmp_path, name, **texts)
    with pytest.raises(overlay.Shadowed, match=group):
        overlay.of(tmp_path, ['patrol'])
