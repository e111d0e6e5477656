"""
The handlers of Python's ``logging`` and ``logging.handlers``, each with a formatter for each logger.

``launch_config.log_handler_factory`` is one of these classes, or makes one from a path:

    launch_config.log_handler_factory = lambda path, encoding: handlers.RotatingFileHandler(path, maxBytes=10**6)
"""

from __future__ import annotations

import logging
import logging.handlers


def with_per_logger_formatting(cls: type[logging.Handler]) -> type[logging.Handler]:
    """Return a handler class that can write the records of some loggers in another form."""

    class PerLogger(cls):
        __doc__ = cls.__doc__

        def __init__(self, *args, **kwargs):
            super().__init__(*args, **kwargs)
            self._formatters: dict[str, logging.Formatter] = {}

        def setFormatterFor(self, logger: logging.Logger | str, formatter: logging.Formatter) -> None:
            """Write the records of a logger in a form of their own."""
            self._formatters[getattr(logger, 'name', logger)] = formatter

        def unsetFormatterFor(self, logger: logging.Logger | str) -> None:
            """Write the records of a logger as those of the others."""
            self._formatters.pop(getattr(logger, 'name', logger), None)

        def format(self, record: logging.LogRecord) -> str:
            formatter = self._formatters.get(record.name)
            return super().format(record) if formatter is None else formatter.format(record)

    PerLogger.__name__ = PerLogger.__qualname__ = cls.__name__
    return PerLogger


def __getattr__(name: str) -> type[logging.Handler]:
    found = getattr(logging, name, None) or getattr(logging.handlers, name, None)
    if not (isinstance(found, type) and issubclass(found, logging.Handler)):
        raise AttributeError(f'there is no handler {name} in logging and logging.handlers')
    globals()[name] = made = with_per_logger_formatting(found)  # the same class each time
    return made
