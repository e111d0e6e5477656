"""Modules are compiled ahead of processes that cannot store what they compile."""

import importlib.util
import os
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
    assert [path.name.partition('.')[0] for path in tmp_path.rglob('*.pyc')] == ['module']
