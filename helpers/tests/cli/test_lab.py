"""JupyterLab: its port, and that it really serves the notebooks."""

import json
import os
import re
import signal
import socket
import subprocess
import sys
import time
import urllib.error
import urllib.request

import nbformat
import pytest

from helpers import paths
from helpers.cli import Refusal, lab
from helpers.tests.real_kernel import Kernel

# Not by the proxy of whoever runs the tests.
DIRECT = urllib.request.build_opener(urllib.request.ProxyHandler({}))


@pytest.fixture
def taken():
    """A port on which somebody listens."""
    with socket.socket() as server:
        server.bind(('127.0.0.1', 0))
        server.listen()
        yield server.getsockname()[1]


def test_a_port_that_is_in_use_is_refused(taken):
    with pytest.raises(Refusal, match=f'port {taken}: address already in use'):
        lab.choose_port(taken)


def test_without_a_wish_the_next_free_port_is_taken(taken, monkeypatch):
    monkeypatch.setattr(lab, 'DEFAULT_PORT', taken)
    assert taken < lab.choose_port(None) < taken + lab.TRIES


def test_a_free_port_is_taken_as_it_is():
    with socket.socket() as probe:
        probe.bind(('127.0.0.1', 0))
        port = probe.getsockname()[1]
    assert lab.choose_port(port) == port


def test_root_must_be_allowed_and_the_browser_left_out():
    assert '--allow-root' not in lab.arguments(1234, False, False)
    assert f'--LabApp.extra_labextensions_path={lab.EXTENSIONS}' in lab.arguments(1234, False, False)
    assert {'--allow-root', '--no-browser'} < set(lab.arguments(1234, True, True))


def test_missing_notebooks_are_named(monkeypatch, tmp_path):
    monkeypatch.setattr(paths, 'NOTEBOOKS', tmp_path / 'notebooks')
    with pytest.raises(Refusal, match='notebooks is missing'):
        lab.lab()


@pytest.mark.parametrize('host', ['nosuch.invalid', '192.0.2.1'])  # the second: RFC 5737, nobody's
def test_an_address_of_another_machine_is_refused(host):
    with pytest.raises(Refusal, match=f'--host {host}: this machine has no such address'):
        lab.choose_port(None, host)


@pytest.mark.parametrize('variable', ['JUPYTER_RUNTIME_DIR', 'JUPYTER_CONFIG_DIR'])
def test_a_home_that_cannot_be_written_to_is_named(monkeypatch, variable):
    monkeypatch.setenv(variable, '/proc/jupyter')
    with pytest.raises(Refusal, match='cannot write to /proc/jupyter .*; run: export HOME'):
        lab.check_private_folders()


@pytest.mark.parametrize(('number', 'said'), [(30, 'run: sudo chown'), (28, 'free some space')])
def test_without_a_new_start_page_the_old_one_is_shown(monkeypatch, tmp_path, capsys, number, said):
    def fail():
        raise OSError(number, os.strerror(number))

    monkeypatch.setattr(paths, 'NOTEBOOKS', tmp_path)
    monkeypatch.setattr(lab.start_page, 'write', fail)
    assert not lab.make_start_page()
    (tmp_path / 'START.md').touch()
    assert lab.make_start_page()
    message, again = capsys.readouterr().err.splitlines()
    assert said in message and message == again


def fetch(address, patience=30.0):
    """Return the JSON at ``address``. The server tells its address a moment before it listens."""
    end = time.monotonic() + patience
    while True:
        try:
            with DIRECT.open(address, timeout=patience) as answer:
                return json.load(answer)
        except urllib.error.URLError as error:
            if not isinstance(error.reason, ConnectionRefusedError) or time.monotonic() > end:
                raise
            time.sleep(0.1)


@pytest.mark.skipif(not paths.NOTEBOOKS.is_dir(), reason='no notebooks are built')
def test_the_notebooks_are_served(tmp_path):
    with socket.socket() as probe:
        probe.bind(('127.0.0.1', 0))
        port = probe.getsockname()[1]
    command = [sys.executable, '-m', 'helpers.cli', 'lab', '--no-browser', '--port', str(port)]
    private = {f'JUPYTER_{name}_DIR': str(tmp_path / name) for name in ('RUNTIME', 'CONFIG', 'DATA')}
    environment = {**os.environ, **private}
    with subprocess.Popen(command, cwd=paths.ROOT, env=environment, stderr=subprocess.PIPE, text=True) as server:
        try:
            address = re.compile(rf':{port}/lab/tree/START.md\?token=(\w+)')
            token = next(match[1] for line in server.stderr if (match := address.search(line)))
            contents = fetch(f'http://127.0.0.1:{port}/api/contents?token={token}')
        finally:
            server.send_signal(signal.SIGTERM)
            server.stderr.read()
    names = {entry['name'] for entry in contents['content']}
    assert {path.name for path in paths.NOTEBOOKS.glob('*.ipynb')} <= names


def test_the_notebooks_kernel_helps_after_a_restart_before_a_cell_has_imported_helpers(domain, tmp_path, monkeypatch):
    """The notebooks name the kernel `python3`, as that is what other front ends have."""
    environ: dict[str, str] = {}
    lab.use_own_kernel(environ)
    for name, value in environ.items():
        monkeypatch.setenv(name, value)
    cells = [nbformat.v4.new_code_cell(source) for source in ('class Talker:\n    pass', 'talker = Talker()')]
    nbformat.write(nbformat.v4.new_notebook(cells=cells), tmp_path / '90_small.ipynb')
    with Kernel(tmp_path) as kernel:
        assert 'from helpers import resume; resume()' in kernel.run('talker = Talker()').stdout
        assert kernel.ok('# Exercise 90.1: a file\n%%answer TEXT note.txt\nto do').stdout == 'Written: note.txt\n'
