"""The repair of the build machine's paths."""

import os

import pytest

from environment.setup.relocation import Places, let_scripts_ask, repair, scripts_ask

MACHINE = '/opt/python/cp312-cp312'
EXPORT = f'{MACHINE}/include/python3.12;{MACHINE}/lib/python3.12/site-packages/numpy/_core/include'
PREFIX = '/project/build/temp.linux-x86_64-cpython-312/install'


@pytest.fixture
def places(tmp_path):
    prefix = tmp_path / 'a b' / '.venv'
    cmake = prefix / 'share' / 'std_msgs' / 'cmake'
    cmake.mkdir(parents=True)
    (cmake / 'pyExport.cmake').write_text(f'INTERFACE_INCLUDE_DIRECTORIES "{EXPORT}"\n')
    (cmake / 'other.cmake').write_text('untouched\n')
    (prefix / 'share' / 'std_msgs' / 'local_setup.sh').write_text(f': ${{AMENT_CURRENT_PREFIX:="{PREFIX}"}}\n')
    parents = prefix / 'share' / 'ament_index' / 'resource_index' / 'parent_prefix_path'
    parents.mkdir(parents=True)
    (parents / 'std_msgs').write_text('/opt/python/cp312-cp312')
    return Places(prefix, tmp_path / 'include', tmp_path / 'numpy')


def test_every_path_becomes_the_real_one(places):
    assert repair(places) == 3
    cmake = places.prefix / 'share' / 'std_msgs' / 'cmake' / 'pyExport.cmake'
    assert cmake.read_text() == f'INTERFACE_INCLUDE_DIRECTORIES "{places.include};{places.numpy}"\n'
    script = (places.prefix / 'share' / 'std_msgs' / 'local_setup.sh').read_text()
    assert script == f': ${{AMENT_CURRENT_PREFIX:="{places.prefix}"}}\n'
    index = places.prefix / 'share' / 'ament_index' / 'resource_index'
    assert (index / 'parent_prefix_path' / 'std_msgs').read_text() == ''


def test_a_second_repair_changes_nothing(places):
    repair(places)
    assert repair(places) == 0


def test_the_installers_cache_stays_as_it_is(places, tmp_path):
    installed = places.prefix / 'share' / 'std_msgs' / 'cmake' / 'pyExport.cmake'
    cached = tmp_path / 'cached'
    os.link(installed, cached)
    repair(places)
    assert EXPORT in cached.read_text()
    assert EXPORT not in installed.read_text()


def test_an_unknown_path_of_the_build_machine_is_told(places):
    (places.prefix / 'share' / 'std_msgs' / 'cmake' / 'other.cmake').write_text('/project/build/elsewhere')
    with pytest.raises(RuntimeError, match='other.cmake'):
        repair(places)


def test_setup_scripts_ask_the_base_interpreter(places, tmp_path):
    (places.prefix / 'setup.bash').touch()
    script = places.prefix / 'local_setup.bash'
    script.write_text(f'  _colcon_python_executable="{places.prefix}/bin/python"\n')
    base = tmp_path / 'python3.12'
    assert not scripts_ask(places.prefix, base)
    let_scripts_ask(places.prefix, base)
    assert scripts_ask(places.prefix, base)
    assert script.read_text() == f'  _colcon_python_executable="{base}"\n'
