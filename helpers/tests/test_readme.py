"""helpers/README.md says in which module each name that a notebook imports is, and what each folder is for."""

import importlib
import re

import helpers
from helpers import paths

FOLDER = paths.ROOT / 'helpers'
TABLE = dict(re.findall(r'^\| `(\w+)` \| `([\w/.]+)` \|', (FOLDER / 'README.md').read_text(), re.MULTILINE))


def test_it_lists_all_names():
    assert set(TABLE) == {*helpers._HOME, *helpers._MODULES}
    assert list(TABLE) == sorted(TABLE, key=str.lower)


def test_each_name_is_in_the_module_that_it_says():
    for name, path in TABLE.items():
        assert (FOLDER / path).exists(), path
        module = 'helpers.' + path.removesuffix('.py').strip('/').replace('/', '.')
        found = getattr(helpers, name)
        assert getattr(found, '__module__', None) == module or found is importlib.import_module(module), (name, module)


def test_notebooks_import_no_other_names():
    for notebook in sorted(paths.NOTEBOOKS.glob('[0-9][0-9]_*.ipynb')):
        text = notebook.read_text(encoding='utf-8')
        assert not re.findall(r'^ *"(?:from|import) helpers\.', text, re.MULTILINE), notebook.name
        imports = ', '.join(re.findall(r'^ *"from helpers import ([\w, ]+)', text, re.MULTILINE))
        used = {*re.findall(r'\w+', imports), *re.findall(r'\bhelpers\.(\w+)', text)}
        assert used <= set(TABLE), (notebook.name, used - set(TABLE))


def test_it_lists_all_folders():
    said = re.findall(r'^\| `(\w+)` \| [A-Z]', (FOLDER / 'README.md').read_text(), re.MULTILINE)
    there = {path.name for path in FOLDER.iterdir() if path.is_dir() and path.name != '__pycache__'}
    assert set(said) == there
