"""The error of a launch file that cannot be loaded."""

from __future__ import annotations


class InvalidLaunchFileError(Exception):
    """
    A launch file cannot be loaded.

    :param extension: the format that its name tells, '' if that is not known
    :param likely_errors: what each attempt to read it raised; the first is also ``__cause__``
    """

    def __init__(self, extension: str = '', *, likely_errors: list[Exception] | None = None):
        if not extension or not likely_errors:
            text = 'The launch file may have a syntax error, or its format is unknown'
        else:
            count = 'multiple exceptions' if len(likely_errors) > 1 else 'exception'
            text = f'Caught {count} when trying to load file of format [{extension}]:'
            text += ''.join(f'\n - {type(error).__name__}: {error}' for error in likely_errors)
            self.__cause__ = likely_errors[0]
        super().__init__(text)
