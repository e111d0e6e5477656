"""What a failed test in a browser leaves behind: a picture of each page, what its console said, JupyterLab's log."""

import re
import shutil
from pathlib import Path

from helpers import paths

FOLDER = paths.ROOT / 'build' / 'browser'
PATIENCE = 30_000  # ms, for one picture

_IDLE_TALK = re.compile(r'to activate\.$')

_consoles: dict = {}  # by page
_logs: list[Path] = []


def watch(page):
    """Note what the console of this Playwright page says, until it is closed. Returns the page."""
    lines = _consoles.setdefault(page, [])
    # JupyterLab has hundreds of plugins, and tells of each one that is slow to activate.
    page.on(
        'console', lambda message: _IDLE_TALK.search(message.text) or lines.append(f'{message.type}: {message.text}')
    )
    page.on('pageerror', lambda error: lines.append(f'uncaught: {error}'))
    page.on('close', lambda closed: _consoles.pop(closed, None))
    return page


def also(log: Path) -> None:
    """Keep this file too."""
    _logs.append(log)


def keep(test: str) -> list[str]:
    """Write everything into FOLDER, under the name of the test; returns the files, relative to the repository."""
    FOLDER.mkdir(parents=True, exist_ok=True)
    name = re.sub(r'\W+', '_', test).strip('_')
    kept = []
    for number, (page, lines) in enumerate(list(_consoles.items()), 1):
        picture, console = (FOLDER / f'{name}-{number}.{kind}' for kind in ('png', 'txt'))
        try:
            page.screenshot(path=picture, timeout=PATIENCE)
            kept.append(picture)
        except Exception as error:  # whatever it is, it must not hide why the test failed
            lines.append(f'no picture: {error}')
        console.write_text('\n'.join([page.url, *lines]) + '\n', encoding='utf-8')
        kept.append(console)
    for log in filter(Path.is_file, _logs):
        kept.append(Path(shutil.copy(log, FOLDER / f'{name}-{log.name}')))
    return [path.relative_to(paths.ROOT).as_posix() for path in kept]
