"""What the HTML pages share: the template environment with its one sink, and a few filters.

Every value that a template prints goes through `finalize`: control characters become visible, and Jinja escapes the
rest. A page loads nothing and runs nothing: its styles are its own, and its policy forbids all else.
"""

import re

from jinja2 import Environment, PackageLoader, StrictUndefined
from markupsafe import Markup, escape

from grading.reports.safe import visible

LONGEST = 6000  # characters of one folded text, such as what a program printed
_CODE = re.compile(r'`([^`\n]+)`')


def _finalize(value: object) -> object:
    if isinstance(value, Markup):
        return value
    return '' if value is None else visible(str(value))


def points(value: float | None) -> str:
    """A number of points, at most two decimals; – if it is unknown."""
    return '–' if value is None else f'{round(value, 2):g}'


def rough(value: float | None) -> str:
    """A number of points for a glance, at most one decimal; – if it is unknown."""
    return '–' if value is None else f'{round(value, 1):g}'


def plural(count: int, noun: str) -> str:
    """'1 test', '2 tests'."""
    return f'{count} {noun}' if count == 1 else f'{count} {noun}s'


def prose(text: str) -> Markup:
    """One line of text; what stands between backticks is shown as code."""
    parts = _CODE.split(visible(text))
    return Markup('').join(
        Markup('<code>{}</code>').format(part) if number % 2 else escape(part) for number, part in enumerate(parts)
    )


def shorten(text: str, limit: int = LONGEST) -> str:
    """The beginning and the end of a long text."""
    if len(text) <= limit:
        return text
    half = limit // 2
    return f'{text[:half]}\n… {len(text) - 2 * half} characters are left out …\n{text[-half:]}'


_ENVIRONMENT = Environment(
    loader=PackageLoader('grading.reports', 'templates'),
    autoescape=True,
    trim_blocks=True,
    lstrip_blocks=True,
    undefined=StrictUndefined,
    finalize=_finalize,
)
_ENVIRONMENT.filters |= {'points': points, 'rough': rough, 'prose': prose, 'shorten': shorten}
_ENVIRONMENT.globals |= {'plural': plural}


def render(template: str, **values: object) -> str:
    """A page from a template of `templates/`."""
    return _ENVIRONMENT.get_template(template).render(**values)
