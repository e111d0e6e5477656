"""How a command runs as in a new terminal."""

import subprocess

import pytest

from helpers.programs import terminals


@pytest.mark.parametrize('name', ['course', 'Jörg', 'ROS学习', 'a$HOME b`c'])
def test_the_installation_is_sourced_wherever_it_is(tmp_path, monkeypatch, name):
    setup = tmp_path / name / 'setup.bash'
    setup.parent.mkdir()
    setup.write_text('sourced=yes\n')
    monkeypatch.setattr(terminals, 'underlay', lambda: setup)
    done = subprocess.run(terminals.shell('echo "$sourced"'), capture_output=True, text=True, check=True)
    assert (done.stdout, done.stderr) == ('yes\n', '')
