"""The files of a view's page: meshcat's viewer, our scripts and styles, and the page itself."""

from importlib.util import find_spec
from pathlib import Path

from jinja2 import Environment

WEB = Path(__file__).parent / 'web'


def library() -> Path:
    """Return meshcat's viewer, with three.js in it: one script."""
    package = Path(find_spec('meshcat').origin).parent  # to import it takes long, and only this file is needed
    return package / 'viewer' / 'dist' / 'main.min.js'


def page(recording: str = '') -> str:
    """Return the page of a view as HTML.

    :param recording: what it replays, as base64 (see `recording`); '' for the page of a live view.
    """
    template = Environment(autoescape=True, trim_blocks=True, keep_trailing_newline=True)
    return template.from_string((WEB / 'page.html').read_text(encoding='utf-8')).render(recording=recording)
