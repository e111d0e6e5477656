"""What `./course --help` says while the environment is not ready: the commands themselves need it to be imported.

Names and sentences are read from the sources of the command line, not repeated here.
"""

import ast
from collections.abc import Iterator
from pathlib import Path

from environment.setup.layout import Layout

_WORDS = ('-h', '--help')
_NOTHING = (
    'Nothing is set up yet in this folder. The first command that you give, such as ./course lab, first does',
    'what ./course setup does: it makes the folder .venv with Python, ROS 2 Jazzy and Jupyter (1 GB; up to 310',
    'MB come from PyPI).',
)
_OUT_OF_DATE = (
    'The folder .venv is not complete, or it is older than the course. The first command that you give, such as',
    './course lab, first does what ./course setup does: it brings .venv up to date, and keeps what is still right.',
)


def asked(arguments: list[str]) -> bool:
    """Whether the arguments ask only what there is: none, `--help`, or `COMMAND --help`."""
    return not arguments or arguments[0] in _WORDS or arguments[1:] in (['-h'], ['--help'])


def commands(root: Path) -> Iterator[tuple[str, str]]:
    """(name, first sentence) of each command of this edition, in the order of the command line's own help."""
    tree = ast.parse((root / 'helpers' / 'cli' / 'app.py').read_text(encoding='utf-8'))
    names = {
        node.targets[0].id: ast.literal_eval(node.value)
        for node in tree.body
        if isinstance(node, ast.Assign) and isinstance(node.value, ast.Tuple)
    }
    for half, listed in (('helpers', names['LEARNER']), ('grading', names['INSTRUCTOR'])):
        for name in listed:
            module = root / half / 'cli' / f'{name}.py'
            if module.is_file():
                yield name, _sentence(module, name)


def _sentence(module: Path, name: str) -> str:
    for node in ast.parse(module.read_text(encoding='utf-8')).body:
        if isinstance(node, ast.FunctionDef) and node.name == name:
            return ' '.join((ast.get_docstring(node) or '').partition('\n\n')[0].split())
    return ''


def text(root: Path) -> str:
    """The whole answer."""
    lines = [f'  {name:<9}{sentence}' for name, sentence in commands(root)]
    return '\n'.join(
        (
            'Usage: ./course COMMAND [ARGUMENTS]',
            '',
            'The ROS 2 course: notebooks, checks and submissions.',
            '',
            *(_OUT_OF_DATE if Layout(root).prefix.is_dir() else _NOTHING),
            'It says how far it is, and goes on where it was if you interrupt it. After that every command starts at',
            'once, and has a --help of its own.',
            '',
            'Commands:',
            *lines,
        )
    )
