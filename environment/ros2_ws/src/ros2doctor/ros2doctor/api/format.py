"""How warnings, errors and reports are printed."""

import sys
from typing import Any


def doctor_warn(msg: str) -> None:
    """Print a warning with the place in the source that it comes from."""
    caller = sys._getframe(1)
    sys.stderr.write(f'{caller.f_code.co_filename}: {caller.f_lineno}: UserWarning: {msg}\n')


def doctor_error(msg: str) -> None:
    """Print an error with the place in the source that it comes from."""
    caller = sys._getframe(1)
    sys.stderr.write(f'{caller.f_code.co_filename}: {caller.f_lineno}: UserWarning: ERROR: {msg}\n')


def format_print(report: Any) -> None:
    """Print a report; the values stand in a column."""
    print(f'\n   {report.name}')
    width = max((len(name) for name, _ in report.items), default=0) + 4
    for name, value in report.items:
        print(f'{name.ljust(width)}: {value}')
