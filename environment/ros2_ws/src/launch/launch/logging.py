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

DEBUG, INFO, WARNING, ERROR = logging.DEBUG, logging.INFO, logging.WARNING, logging.ERROR

_PLAIN = '[{levelname}] [{name}]: {message}'
_WITH_TIME = '{created:.7f} [{levelname}] [{name}]: {message}'
_RAW = logging.Formatter('{message}', style='{')
_TIMED = logging.Formatter('{created:.7f} {message}', style='{')
_MAIN = 'launch.log'


class _ScreenHandler(logging.StreamHandler):
    """Writes to what is standard output at that moment."""

    def __init__(self, formatter: logging.Formatter):
        super().__init__(sys.stdout)
        self.setFormatter(formatter)

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
        self.level = logging.INFO
        self._log_dir: str | None = None
        self._files: dict[tuple[str, bool], logging.Handler] = {}
        # A manager of our own keeps names such as "talker-1" out of the program's loggers.
        self._manager = logging.Manager(logging.RootLogger(logging.WARNING))
        self._loggers: dict[str, logging.Logger] = {}
        self.failure: str | None = None
        self.on_screen_lost: Callable[[], None] = lambda: None
        self._screen: logging.Handler | None = None
        self.set_screen_format('default')
        self.set_log_format('default')

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
        if self._screen is not None:
            self._screen.setFormatter(self._screen_formatter)

    def set_log_format(self, log_format: str, *, log_style: str | None = None) -> None:
        """Set the form of the lines of ``launch.log``, as ``set_screen_format``; there is only the name ``default``."""
        self._file_formatter = _formatter(
            'OVERRIDE_LAUNCH_LOG_FORMAT', 'log', log_format, log_style, {'default': _WITH_TIME}
        )
        if (_MAIN, False) in self._files:
            self._files[_MAIN, False].setFormatter(self._file_formatter)

    def get_screen_handler(self) -> logging.Handler:
        """Return the handler of the screen."""
        if self._screen is None:
            self._screen = _ScreenHandler(self._screen_formatter)
        return self._screen

    def get_log_file_path(self, file_name: str = _MAIN) -> str | None:
        """Return the path of a log file; None if there is no directory for it."""
        return self.log_dir and os.path.join(self.log_dir, file_name)

    def get_log_file_handler(self, file_name: str = _MAIN) -> logging.Handler:
        """Return the handler of a log file."""
        return self._file(file_name, False, self._file_formatter)

    def output_handler(self, file_name: str = _MAIN) -> logging.Handler:
        """Return the handler for what processes print: in ``launch.log`` with the time, elsewhere as it is."""
        return self._file(file_name, True, _TIMED if file_name == _MAIN else _RAW)

    def _file(self, name: str, of_processes: bool, formatter: logging.Formatter) -> logging.Handler:
        # Two handlers may append to one file, as each writes whole lines.
        handler = self._files.get((name, of_processes))
        if handler is None:
            path = self.get_log_file_path(name)
            handler = logging.FileHandler(path, encoding='utf-8', delay=True) if path else logging.NullHandler()
            handler.setFormatter(formatter)
            self._files[name, of_processes] = handler
        return handler

    def logger(self, name: str, handlers: list[logging.Handler]) -> logging.Logger:
        """Return the logger ``name``, with these handlers only."""
        logger = self._loggers.get(name)
        if logger is None:
            logger = self._loggers[name] = self._manager.getLogger(name)
            logger.propagate = False
            for handler in handlers:
                logger.addHandler(handler)
        logger.setLevel(self.level)
        return logger

    def set_level(self, level: int) -> None:
        """Set the least severity that is logged."""
        self.level = level
        for logger in self._loggers.values():
            logger.setLevel(level)

    def close(self) -> None:
        """Close the log files."""
        for handler in self._files.values():
            handler.close()


launch_config = LaunchConfig()


def reset() -> None:
    """Forget directory, files and loggers; the next launch begins anew."""
    launch_config.close()
    launch_config.__init__()


def get_logger(name: str = 'launch') -> logging.Logger:
    """Return a logger that writes to the screen and to ``launch.log``."""
    return launch_config.logger(name, [launch_config.get_screen_handler(), launch_config.get_log_file_handler()])


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
        handlers: list[logging.Handler] = []
        if 'screen' in targets[source]:
            handlers.append(_ScreenHandler(_RAW))
        if 'log' in targets[source]:
            handlers.append(launch_config.output_handler())
        if 'own_log' in targets[source]:
            handlers.append(launch_config.output_handler(f'{process_name}-{source}.log'))
        if 'own_log' in targets['both']:
            handlers.append(launch_config.output_handler(f'{process_name}.log'))
        loggers.append(launch_config.logger(f'{process_name}-{source}', handlers))
        loggers[-1].setLevel(logging.INFO)
    return loggers[0], loggers[1]


def log_launch_config(*, logger: logging.Logger) -> None:
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
