"""A file is written as a whole or not at all."""

import os
import resource
import signal
import stat

import pytest

from environment.setup import whole_file


@pytest.fixture
def little_room():
    """No file of this process may be larger than 4 kB, as on a disk that is nearly full."""
    limits, heard = resource.getrlimit(resource.RLIMIT_FSIZE), signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
    resource.setrlimit(resource.RLIMIT_FSIZE, (4096, limits[1]))
    yield
    resource.setrlimit(resource.RLIMIT_FSIZE, limits)
    signal.signal(signal.SIGXFSZ, heard)


def test_what_does_not_fit_leaves_the_old_file_and_nothing_else(tmp_path, little_room):
    path = tmp_path / 'marks.json'
    whole_file.write(path, 'old')
    with pytest.raises(OSError) as caught:
        whole_file.write(path, 'new' * 4096)
    assert caught.value.filename == str(path)
    assert path.read_text() == 'old' and list(tmp_path.iterdir()) == [path]


def test_a_folder_that_is_not_there_is_named(tmp_path):
    path = tmp_path / 'none' / 'marks.json'
    with pytest.raises(FileNotFoundError) as caught:
        whole_file.write(path, b'new')
    assert caught.value.filename == str(path)


def test_an_interruption_leaves_nothing(tmp_path, monkeypatch):
    def interrupt(descriptor):
        raise KeyboardInterrupt

    monkeypatch.setattr(os, 'fsync', interrupt)
    with pytest.raises(KeyboardInterrupt):
        whole_file.write(tmp_path / 'marks.json', 'new', sync=True)
    assert not list(tmp_path.iterdir())


def test_rights_and_letters(tmp_path):
    path = tmp_path / 'program'
    whole_file.write(path, 'é\ud800', rights=0o750)
    assert path.read_bytes() == 'é?'.encode() and stat.S_IMODE(path.stat().st_mode) == 0o750


def test_update_makes_the_folder_and_leaves_a_file_that_has_the_text(tmp_path):
    path = tmp_path / 'reports' / 'one'
    whole_file.update(path, 'text\ud800')
    before = path.stat()
    whole_file.update(path, 'text\ud800')
    assert path.stat().st_ino == before.st_ino and path.read_text() == 'text?'
    whole_file.update(path, 'other')
    assert path.read_text() == 'other'
