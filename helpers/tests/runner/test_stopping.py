"""A session that is stopped ends at once, whatever its tests wait for, and leaves nothing behind."""

import threading

import psutil
import pytest

from helpers import wait_for
from helpers.runner import session, stopping, tests_process
from helpers.tests import small

# As `ros2 launch` does, the program gives what it starts a session of its own.
LAUNCHES = """\
import os, subprocess
def Talker(file):
    child = subprocess.Popen(['sleep', '1000'], start_new_session=True)
    with open(f'{file}.part', 'w') as told:
        print(child.pid, file=told)
    os.rename(f'{file}.part', file)
    time.sleep(1000)
"""
WAITS = """
def test_waits(learner):
    learner.call('Talker', {file!r})
"""
EXERCISES = [small.exercise(number) for number in (1, 2)]


@pytest.fixture
def scratch(tmp_path, monkeypatch):
    """The folder in which a session makes its temporary ones."""
    folder = tmp_path / 'scratch'
    folder.mkdir()
    monkeypatch.setattr('tempfile.tempdir', str(folder))
    monkeypatch.setattr(tests_process, 'folder_for_programs', lambda: str(folder))
    return folder


def judge(visible, ends):
    cells = [cell for exercise in (1, 2) for cell in small.cells(LAUNCHES, exercise)]
    try:
        session.run(cells, EXERCISES, session.Options(visible=visible, processes=2))
    except stopping.Stopped:
        ends.append('stopped')


def test_a_stopped_session_leaves_nothing(tmp_path, scratch):
    files, ends = [tmp_path / f'pid_{number}' for number in (1, 2)], []
    for number, file in enumerate(files, 1):
        visible = small.write_tests(tmp_path, WAITS.format(file=str(file)), number)
    thread = threading.Thread(target=judge, args=(visible, ends))
    thread.start()
    try:
        wait_for(lambda: all(file.exists() for file in files), timeout=60)
    finally:
        stopping.everything(30)
        thread.join(30)
    assert ends == ['stopped']
    assert not psutil.wait_procs([psutil.Process(int(file.read_text())) for file in files], timeout=30)[1]
    assert not list(scratch.iterdir())
