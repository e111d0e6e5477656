"""Built packages that another copy of the course takes over: moved rightly, and never from other hands."""

import os
import tarfile
from types import SimpleNamespace

import pytest

from environment.setup import cache
from environment.setup.cache import Cache

KEY = 'f' * 64


@pytest.fixture
def folder(tmp_path):
    """A folder for entries that is nobody else's, in one that is."""
    return tmp_path / 'cache'


def group(monkeypatch, *, name: str = 'ada', members: list[str] | None = None, first: bool = True):
    """Let the user be called ada, and the group of the folders be as is said; `first`: it is ada's first group."""
    gid = os.getegid() if first else os.getegid() + 1
    monkeypatch.setattr(cache.pwd, 'getpwuid', lambda uid: SimpleNamespace(pw_name='ada', pw_gid=gid))
    monkeypatch.setattr(cache.grp, 'getgrgid', lambda gid: SimpleNamespace(gr_name=name, gr_mem=members or []))


@pytest.fixture
def first(tmp_path, folder):
    """The cache as the first copy sees it, with a script, a library and a link installed."""
    prefix = tmp_path / 'one' / '.venv'
    (prefix / 'bin').mkdir(parents=True)
    (prefix / 'bin' / 'tool').write_text(f'#!{prefix}/bin/python\n')
    (prefix / 'bin' / 'tool').chmod(0o755)
    (prefix / 'lib').mkdir()
    (prefix / 'lib' / 'a.so').write_bytes(b'\x7fELF\0code')
    (prefix / 'lib' / 'link.so').symlink_to('a.so')
    (prefix / 'lib' / 'b.pyc').write_bytes(b'\0' + os.fsencode(prefix))
    found = Cache(folder, prefix)
    assert found.problem() == ''
    assert not found.directory.exists(), 'to ask makes nothing'
    found.directory.mkdir(mode=0o700)
    return found


PATHS = ['bin/tool', 'lib/a.so', 'lib/b.pyc', 'lib/link.so']


@pytest.fixture
def second(tmp_path, first):
    """The same for another copy, after the first has stored its files."""
    assert first.store(KEY, PATHS)
    prefix = tmp_path / 'two' / '.venv'
    prefix.mkdir(parents=True)
    return Cache(first.directory, prefix)


def test_another_copy_gets_files_with_its_own_paths(second):
    assert second.fetch(KEY) == ['bin/tool', 'lib/a.so', 'lib/link.so']
    assert (second.prefix / 'bin' / 'tool').read_text() == f'#!{second.prefix}/bin/python\n'
    assert os.access(second.prefix / 'bin' / 'tool', os.X_OK)
    assert not os.access(second.prefix / 'lib' / 'a.so', os.X_OK)
    assert (second.prefix / 'lib' / 'link.so').readlink().name == 'a.so'
    assert second.fetch('0' * 64) is None


def test_a_library_that_names_its_place_is_not_stored(first):
    (first.prefix / 'lib' / 'a.so').write_bytes(b'\x7fELF\0' + os.fsencode(first.prefix))
    assert not first.store(KEY, PATHS)
    assert first.size() == (0, 0)


def test_a_damaged_entry_is_no_entry(second):
    entry = next(second.directory.iterdir())
    whole = entry.read_bytes()
    for damaged in (whole[:-1], whole[:2000] + b'!' + whole[2001:], b''):
        entry.write_bytes(damaged)
        assert second.fetch(KEY) is None
    entry.write_bytes(whole)
    assert second.fetch(KEY)


def test_an_entry_that_others_may_write_to_is_no_entry(second):
    entry = next(second.directory.iterdir())
    entry.chmod(0o622)
    assert second.fetch(KEY) is None
    entry.chmod(0o600)
    entry.rename(second.directory / 'elsewhere')
    entry.symlink_to(second.directory / 'elsewhere')
    assert second.fetch(KEY) is None


@pytest.mark.parametrize('mode', [0o777, 0o770, 0o1777])
def test_a_folder_that_others_may_write_to_is_not_used(first, mode, monkeypatch):
    group(monkeypatch, members=['ada', 'bob'])
    first.directory.chmod(mode)
    assert first.problem() == f'others may write to {first.directory}'
    first.directory.chmod(0o700)
    first.directory.parent.chmod(0o777)
    assert first.problem() == f'others may write to {first.directory.parent}'


def test_the_users_own_group_may_write_to_the_folder(first, monkeypatch):
    first.directory.chmod(0o770)
    first.directory.parent.chmod(0o775)
    group(monkeypatch, members=[])
    assert first.problem() == ''
    group(monkeypatch, name='students')
    assert first.problem() == f'others may write to {first.directory}'
    group(monkeypatch, first=False)
    assert first.problem() == f'others may write to {first.directory}'


@pytest.mark.skipif(os.getuid() != 0, reason='only root can give a folder away')
def test_the_folder_of_another_user_is_not_used(first):
    os.chown(first.directory, 65534, -1)
    assert 'others may write to' in first.problem()


def test_an_entry_cannot_leave_the_prefix(second, monkeypatch):
    pack = Cache._pack

    def evil(self, paths):
        gettarinfo = tarfile.TarFile.gettarinfo

        def renamed(archive, name, arcname):
            member = gettarinfo(archive, name, arcname)
            member.name = '../../outside'
            return member

        monkeypatch.setattr(tarfile.TarFile, 'gettarinfo', renamed)
        return pack(self, paths)

    monkeypatch.setattr(Cache, '_pack', evil)
    (second.prefix / 'x').touch()
    assert second.store('e' * 64, ['x'])
    assert second.fetch('e' * 64) is None
    assert not (second.prefix / '../../outside').exists()


def test_an_unusual_path_builds_for_itself(tmp_path, folder):
    for name in ('a clone', 'a"b', 'x' * 120):
        assert Cache(folder, tmp_path / name).problem()


def test_a_file_in_the_way_is_told(tmp_path):
    (tmp_path / 'cache').write_text('')
    assert str(tmp_path / 'cache') in Cache(tmp_path / 'cache', tmp_path / 'p').problem()


def test_what_was_not_used_for_longest_goes_first(second):
    (second.prefix / 'x').write_bytes(b'x' * 50_000)
    for number, key in enumerate('abc'):
        second.store(key * 64, ['x'])
        os.utime(second.directory / f'{key * 64}.packed', (number, number))
    assert second.fetch('a' * 64)  # and so it was used just now
    one = (second.directory / f'{"a" * 64}.packed').stat().st_size
    second.prune(limit=int(2.5 * one))
    assert second.fetch('a' * 64)
    assert second.fetch('b' * 64) is None
    assert second.size()[1] <= 2.5 * one


@pytest.mark.parametrize(
    ('environ', 'expected'),
    [
        ({'HOME': '/home/ada'}, '/home/ada/.cache/ros2-course'),
        ({'HOME': '/home/ada', 'XDG_CACHE_HOME': '/var/ada'}, '/var/ada/ros2-course'),
        ({'HOME': '/home/ada', 'XDG_CACHE_HOME': 'relative'}, '/home/ada/.cache/ros2-course'),
    ],
)
def test_where_it_is(environ, expected):
    assert str(cache.folder(environ)) == expected
