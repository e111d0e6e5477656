"""Modules are compiled ahead of processes that cannot store what they compile."""

import importlib.util
import os
import sysconfig
from pathlib import Path

from helpers.runner import bytecode


def test_new_and_changed_modules_are_compiled(tmp_path, monkeypatch):
    monkeypatch.setattr(bytecode, 'ROOT', tmp_path)
    (tmp_path / 'helpers' / 'tests').mkdir(parents=True)
    module, broken, test = (tmp_path / 'helpers' / name for name in ('module.py', 'broken.py', 'tests/test_it.py'))
    module.write_text('number = 1\n')
    broken.write_text('number = \n')
    test.write_text('number = 1\n')
    bytecode.store()
    stored = Path(importlib.util.cache_from_source(module))
    before = stored.read_bytes()
    module.write_text('number = 23456\n')
    os.utime(module, (2e9, 2e9))
    bytecode.store()
    assert stored.read_bytes() != before
    assert _compiled(tmp_path) == ['module']


def test_installed_modules_are_compiled_but_those_that_no_program_imports(tmp_path, monkeypatch):
    monkeypatch.setattr(sysconfig, 'get_path', {'purelib': str(tmp_path)}.__getitem__)
    monkeypatch.setenv('PYTHONDONTWRITEBYTECODE', '1')
    for name in ('rclpy/node.py', 'numpy/tests/test_it.py', 'jupyter_server/app.py', 'typing_extensions.py'):
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text('number = 1\n')
    bytecode.store_installed()
    assert _compiled(tmp_path) == ['node', 'typing_extensions']


def test_an_environment_that_cannot_be_written_is_left(tmp_path, monkeypatch):
    monkeypatch.setattr(sysconfig, 'get_path', {'purelib': str(tmp_path)}.__getitem__)
    monkeypatch.setattr(os, 'access', lambda *_: False)  # a folder's mode does not bind root
    (tmp_path / 'module.py').write_text('number = 1\n')
    bytecode.store_installed()
    assert _compiled(tmp_path) == []


def _compiled(folder: Path) -> list[str]:
    return sorted(path.name.partition('.')[0] for path in folder.rglob('*.pyc'))
