"""
The log of a launch: what goes to the screen, and to ``launch.log`` in a directory of its own.

The directory is made below ``$ROS_LOG_DIR``, or ``$ROS_HOME/log``, or ``~/.ros/log``. Where it cannot be
written, the launch goes on without log files and says so.

``$OVERRIDE_LAUNCH_SCREEN_FORMAT`` and ``$OVERRIDE_LAUNCH_LOG_FORMAT`` change the form of the lines.
"""

from __future__ import annotations

import datetime
import logging
import os
import socket
import sys
from collections.abc import Callable

from launch.logging import handlers

DEBUG, INFO, WARNING, ERROR = logging.DEBUG, logging.INFO, logging.WARNING, logging.ERROR

_PLAIN = '[{levelname}] [{name}]: {message}'
_WITH_TIME = '{created:.7f} [{levelname}] [{name}]: {message}'
_RAW = logging.Formatter('{message}', style='{')
_TIMED = logging.Formatter('{created:.7f} {message}', style='{')
_MAIN = 'launch.log'


class _ScreenHandler(handlers.StreamHandler):
    """Writes to what is standard output at that moment."""

    def emit(self, record: logging.LogRecord) -> None:
        self.stream = sys.stdout
        super().emit(record)

    def handleError(self, record: logging.LogRecord) -> None:
        if not isinstance(sys.exc_info()[1], BrokenPipeError):
            super().handleError(record)
            return
        # The reader has gone away, as in "ros2 launch … | head": write to nowhere, and end.
        nowhere = os.open(os.devnull, os.O_WRONLY)
        os.dup2(nowhere, self.stream.fileno())
        os.close(nowhere)
        launch_config.on_screen_lost()


def _formatter(variable: str, kind: str, text: str, style: str | None, names: dict[str, str]) -> logging.Formatter:
    """Return what brings lines into the form that the environment variable says, or else the text or its name."""
    override = os.environ.get(variable)
    if override:
        return logging.Formatter(override.encode('latin1').decode('unicode_escape'), style='{')
    if text in names and style is not None:
        raise ValueError(f'Cannot set a custom format style for the "{text}" {kind} format.')
    return logging.Formatter(names.get(text, text), style=style or '{')


class LaunchConfig:
    """The settings of the log of this process."""

    def __init__(self):
        self._loggers: dict[str, logging.Logger] = {}
        self.file_handlers: dict[str, logging.Handler] = {}
        self.reset()

    def reset(self) -> None:
        """Forget directory, files, formats and handlers; loggers that somebody still has write nothing any more."""
        self.close()
        for logger in self._loggers.values():
            logger.handlers.clear()
        self._log_dir: str | None = None
        self.file_handlers = {}
        # A manager of our own keeps names such as "talker-1" out of the program's loggers.
        self._manager = logging.Manager(logging.RootLogger(logging.INFO))
        self._manager.root.manager = self._manager  # whose cache of levels is forgotten when the level changes
        self._loggers = {}
        self.failure: str | None = None
        self.on_screen_lost: Callable[[], None] = lambda: None
        self.log_handler_factory: Callable[..., logging.Handler] = handlers.WatchedFileHandler
        self.screen_handler: logging.Handler | None = None
        self.set_screen_format('default')
        self.set_log_format('default')

    @property
    def level(self) -> int:
        """The least severity that is logged, unless a logger has one of its own."""
        return self._manager.root.level

    @level.setter
    def level(self, level: int) -> None:
        self._manager.root.setLevel(level)

    @property
    def log_dir(self) -> str | None:
        """The directory of the log files, made when first asked for; None if that is not possible."""
        if self._log_dir is None and self.failure is None:
            try:
                self._log_dir = _make_log_dir()
            except OSError as error:
                self.failure = str(error)
        return self._log_dir

    @log_dir.setter
    def log_dir(self, path: str | None) -> None:
        if path is not None and not os.path.isdir(path):
            raise ValueError(f'{path} is not a directory')
        self._log_dir = path

    def set_screen_format(self, screen_format: str, *, screen_style: str | None = None) -> None:
        """
        Set the form of the lines on the screen, but for what processes print.

        :param screen_format: as ``logging.Formatter`` takes it, or ``default``, or ``default_with_timestamp``
        :param screen_style: the style of the format, ``{`` if None
        :raises ValueError: for a style of one of the two that have names
        """
        names = {'default': _PLAIN, 'default_with_timestamp': _WITH_TIME}
        self._screen_formatter = _formatter(
            'OVERRIDE_LAUNCH_SCREEN_FORMAT', 'screen', screen_format, screen_style, names
        )
        if self.screen_handler is not None:
            self.screen_handler.setFormatter(self._screen_formatter)

    def set_log_format(self, log_format: str, *, log_style: str | None = None) -> None:
        """Set the form of the lines of the log files, as ``set_screen_format``; there is only the name ``default``."""
        self._file_formatter = _formatter(
            'OVERRIDE_LAUNCH_LOG_FORMAT', 'log', log_format, log_style, {'default': _WITH_TIME}
        )
        for handler in self.file_handlers.values():
            if handler.formatter is not _RAW:
                handler.setFormatter(self._file_formatter)

    def get_screen_handler(self) -> logging.Handler:
        """Return the handler of the screen."""
        if self.screen_handler is None:
            self.screen_handler = _ScreenHandler(sys.stdout)
            self.screen_handler.setFormatter(self._screen_formatter)
        return self.screen_handler

    def get_log_file_path(self, file_name: str = _MAIN) -> str | None:
        """Return the path of a log file; None if there is no directory for it."""
        return self.log_dir and os.path.join(self.log_dir, file_name)

    def get_log_file_handler(self, file_name: str = _MAIN) -> logging.Handler:
        """Return the handler of a log file; ``log_handler_factory`` makes it from the path, when first asked for."""
        if file_name not in self.file_handlers:
            path = self.get_log_file_path(file_name)
            handler = self.log_handler_factory(path, encoding='utf-8') if path else handlers.NullHandler()
            handler.setFormatter(self._file_formatter)
            self.file_handlers[file_name] = handler
        return self.file_handlers[file_name]

    def logger(self, name: str) -> logging.Logger:
        """Return the logger ``name``, which passes nothing on to others."""
        logger = self._loggers.get(name)
        if logger is None:
            logger = self._loggers[name] = self._manager.getLogger(name)
            logger.propagate = False
        return logger

    def close(self) -> None:
        """Close the log files."""
        for handler in self.file_handlers.values():
            handler.close()


launch_config = LaunchConfig()


def reset() -> None:
    """Forget directory, files and loggers; the next launch begins anew."""
    launch_config.reset()


def get_logger(name: str = 'launch') -> logging.Logger:
    """Return a logger that writes to the screen and to ``launch.log``."""
    logger = launch_config.logger(name)
    logger.addHandler(launch_config.get_screen_handler())
    logger.addHandler(launch_config.get_log_file_handler())
    return logger


def get_output_loggers(process_name: str, output_config: str | dict) -> tuple[logging.Logger, logging.Logger]:
    """
    Return the loggers for what a process writes to its standard output and its standard error.

    :param output_config: screen, log (standard error to the screen, both to the log), both, own_log, full, or a
        dict of lists of screen, log, own_log under the keys stdout, stderr, both
    :raises ValueError: for any other configuration
    """
    targets = _output_targets(output_config)
    loggers = []
    for source in ('stdout', 'stderr'):
        logger = launch_config.logger(f'{process_name}-{source}')
        logger.setLevel(logging.INFO)  # also if less is logged of the launch itself
        if 'screen' in targets[source]:
            _add_handler(logger, launch_config.get_screen_handler(), _RAW)
        if 'log' in targets[source]:
            _add_handler(logger, launch_config.get_log_file_handler(), _TIMED)
        own = [logger.name] if 'own_log' in targets[source] else []
        for name in [*own, process_name] if 'own_log' in targets['both'] else own:
            handler = launch_config.get_log_file_handler(f'{name}.log')
            handler.setFormatter(_RAW)
            logger.addHandler(handler)
        loggers.append(logger)
    return loggers[0], loggers[1]


def _add_handler(logger: logging.Logger, handler: logging.Handler, formatter: logging.Formatter) -> None:
    """Let a logger write through a handler that others share, in a form of its own."""
    handler.setFormatterFor(logger, formatter)
    logger.addHandler(handler)


def log_launch_config(*, logger: logging.Logger = logging.root) -> None:
    """Say where the log files are."""
    if launch_config.log_dir:
        logger.info(f'All log files can be found below {launch_config.log_dir}')
    else:
        logger.warning(f'There are no log files: {launch_config.failure}; set ROS_LOG_DIR to a writable directory')
    logger.info(f'Default logging verbosity is set to {logging.getLevelName(launch_config.level)}')


def _output_targets(config: str | dict) -> dict[str, set[str]]:
    known = {
        'screen': {'both': ['screen']},
        'log': {'both': ['log'], 'stderr': ['screen']},
        'both': {'both': ['log', 'screen']},
        'own_log': {'both': ['own_log'], 'stdout': ['own_log'], 'stderr': ['own_log']},
        'full': {'both': ['screen', 'log', 'own_log'], 'stdout': ['own_log'], 'stderr': ['own_log']},
    }
    if isinstance(config, str):
        if config not in known:
            raise ValueError(f'{config} is not a valid standard output config i.e. "screen", "log" or "both"')
        config = known[config]
    targets: dict[str, set[str]] = {'stdout': set(), 'stderr': set(), 'both': set()}
    for source, destinations in config.items():
        names = {destinations} if isinstance(destinations, str) else set(destinations)
        if source not in ('stdout', 'stderr', 'both'):
            raise ValueError(f'{source} is not a valid output source i.e. "stdout", "stderr" or "both"')
        if names - {'screen', 'log', 'own_log'}:
            raise ValueError(f'{destinations} is not a valid output destination i.e. "screen", "log" or "own_log"')
        targets[source] |= names
    for source in ('stdout', 'stderr'):
        targets[source] |= targets['both'] - {'own_log'}  # that of both is a file of its own
    return targets


def _make_log_dir() -> str:
    base = os.environ.get('ROS_LOG_DIR') or os.path.join(os.environ.get('ROS_HOME') or '~/.ros', 'log')
    base = os.path.abspath(os.path.expanduser(base))
    stamp = datetime.datetime.now().strftime('%Y-%m-%d-%H-%M-%S-%f')
    path = os.path.join(base, f'{stamp}-{socket.gethostname()}-{os.getpid()}')
    os.makedirs(path)
    latest = os.path.join(base, 'latest')
    if os.path.islink(latest) or not os.path.exists(latest):
        temporary = f'{latest}.{os.getpid()}'
        os.symlink(path, temporary)
        os.replace(temporary, latest)  # at once, as several launches may begin together
    return path
