"""What the verbs of `ros2 bag` share: their messages, and checks of arguments."""

import argparse
import os
from typing import Any

STORAGES = ('mcap', 'sqlite3')  # as rosbag2_py has them, which a help text need not load
NO_SERVICES = (
    'The node offers no services such as ~/pause: they are services of rosbag2_interfaces. '
    'The keys of this terminal pause and resume.'
)


def print_error(text: str) -> str:
    """Return an error in the form of `ros2 bag`, for the exit."""
    return f'[ERROR] [ros2bag]: {text}'


def print_warn(text: str) -> str:
    """Return a warning in the form of `ros2 bag`."""
    return f'[WARN] [ros2bag]: {text}'


def check_path_exists(value: str) -> str:
    """Return the path of a bag that is there, for argparse."""
    if not os.path.exists(value):
        raise argparse.ArgumentTypeError(f"Bag path '{value}' does not exist!")
    return value


def check_positive_float(value: str) -> float:
    """Convert an argument to a number above 0, for argparse."""
    try:
        number = float(value)
    except ValueError:
        raise argparse.ArgumentTypeError(f'{value} is not the valid type (float)') from None
    if not 0 < number < float('inf'):
        raise argparse.ArgumentTypeError(f'Value {value} is less than or equal to zero.')
    return number


def check_not_negative(value: str) -> float:
    """Convert an argument to a number of at least 0, for argparse."""
    try:
        number = float(value)
    except ValueError:
        raise argparse.ArgumentTypeError(f'{value} is not the valid type (float)') from None
    if not 0 <= number < float('inf'):
        raise argparse.ArgumentTypeError(f'Value {value} is less than zero.')
    return number


def check_not_negative_int(value: str) -> int:
    """Convert an argument to an integer of at least 0, for argparse."""
    try:
        number = int(value)
    except ValueError:
        raise argparse.ArgumentTypeError(f'{value} is not the valid type (int)') from None
    if number < 0:
        raise argparse.ArgumentTypeError(f'Value {value} is less than zero.')
    return number


def full_names(names: list[str]) -> list[str]:
    """Return names of topics or services with the slash that begins each."""
    return [name if name.startswith('/') else f'/{name}' for name in names]


def event_topics(services: list[str]) -> list[str]:
    """Return the topics on which services tell of their requests and answers."""
    from rosbag2_py.describe import SERVICE_EVENTS

    return [f'{name}{SERVICE_EVENTS}' for name in full_names(services)]


def read_qos_overrides(path: str | None) -> dict[str, Any]:
    """
    Return the profiles of a file for `--qos-profile-overrides-path`; none without a path.

    :raises ValueError: if it cannot be read, or is none.
    """
    if path is None:
        return {}
    import yaml
    from rosbag2_py.qos import from_yaml

    try:
        with open(path, encoding='utf-8') as file:
            return from_yaml(yaml.safe_load(file))
    except OSError as error:
        raise ValueError(f"'{path}' cannot be read: {error.strerror}") from None
    except yaml.YAMLError as error:
        raise ValueError(f"'{path}' is not valid YAML: {getattr(error, 'problem', error)}") from None
