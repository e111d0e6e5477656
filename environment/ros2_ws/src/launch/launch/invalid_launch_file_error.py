"""The error of a launch file that cannot be loaded."""


class InvalidLaunchFileError(Exception):
    """A launch file cannot be loaded; ``__cause__`` says why."""

    def __init__(self, extension: str = '', *, likely_errors: list[Exception] | None = None):
        if not extension or not likely_errors:
            text = 'The launch file may have a syntax error, or its format is unknown'
        else:
            text = f'Caught exception when trying to load file of format [{extension}]: {likely_errors[0]}'
            self.__cause__ = likely_errors[0]
        super().__init__(text)
