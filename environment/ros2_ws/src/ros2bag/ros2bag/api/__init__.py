"""What the verbs of `ros2 bag` share: their messages, and checks of arguments."""

import argparse
import os
from typing import IO, Any

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


def input_bag(uri: str, storage_id: str = '', *more: str) -> tuple[str, str]:
    """Return the arguments of -i: a bag, and the kind of its files; raises ArgumentTypeError if it is none."""
    if more:
        raise argparse.ArgumentTypeError(f'-i takes a bag and a storage, not {len(more) + 2} arguments')
    if storage_id not in ('', *STORAGES):
        raise argparse.ArgumentTypeError(f"the storage '{storage_id}' is not known; there are {', '.join(STORAGES)}")
    return uri, storage_id


def check_positive_float(value: str) -> float:
    """Convert an argument to a number above 0, for argparse."""
    try:
        number = float(value)
    except ValueError:
        raise argparse.ArgumentTypeError(f'{value} is not the valid type (float)') from None
    if not 0 < number < float('inf'):
        raise argparse.ArgumentTypeError(f'{value} is not in the valid range (> 0.0)')
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


class OpenedFile:
    """Opens the file that an argument names, for argparse; what cannot be opened is refused as upstream does."""

    def __call__(self, path: str) -> IO[str]:
        """Return the file, open to be read."""
        try:
            return open(path, encoding='utf-8')
        except OSError as error:
            raise argparse.ArgumentTypeError(f"can't open '{path}': {error}") from None


def read_qos_overrides(file: IO[str] | None) -> dict[str, Any]:
    """
    Return the profiles of a file for `--qos-profile-overrides-path`, and close it; none without a file.

    :raises ValueError: if it is no YAML, or holds no profiles.
    """
    if file is None:
        return {}
    import yaml

    try:
        with file:
            return convert_yaml_to_qos_profile(yaml.safe_load(file))
    except yaml.YAMLError as error:
        raise ValueError(f"'{file.name}' is not valid YAML: {getattr(error, 'problem', error)}") from None


def convert_yaml_to_qos_profile(qos_profile_dict: Any) -> dict[str, Any]:
    """
    Return the profiles by topic of a file of QoS overrides.

    :raises ValueError: if it is no mapping of topics to policies, or names what there is not.
    """
    if not isinstance(qos_profile_dict, dict) or not all(isinstance(each, dict) for each in qos_profile_dict.values()):
        raise ValueError('a file of QoS overrides is a mapping from each topic to its policies')
    return {topic: interpret_dict_as_qos_profile(policies) for topic, policies in qos_profile_dict.items()}


def interpret_dict_as_qos_profile(qos_profile_dict: dict[str, Any]) -> Any:
    """
    Return the profile that has these policies.

    :raises ValueError: if there is no such policy or value, or neither history nor depth are given.
    """
    from rclpy.qos import (
        InvalidQoSProfileException,
        QoSDurabilityPolicy,
        QoSHistoryPolicy,
        QoSLivelinessPolicy,
        QoSProfile,
        QoSReliabilityPolicy,
    )

    kinds = {
        'history': QoSHistoryPolicy,
        'reliability': QoSReliabilityPolicy,
        'durability': QoSDurabilityPolicy,
        'liveliness': QoSLivelinessPolicy,
    }
    arguments: dict[str, Any] = {}
    for name, value in qos_profile_dict.items():
        if name in ('deadline', 'lifespan', 'liveliness_lease_duration'):
            arguments[name] = dict_to_duration(value)
        elif name in kinds:
            try:
                arguments[name] = kinds[name].get_from_short_key(value)
            except (KeyError, AttributeError):
                known = ', '.join(kinds[name].short_keys())
                raise ValueError(f'`{value}` is no value of `{name}`; possible are {known}.') from None
        elif name in ('depth', 'avoid_ros_namespace_conventions'):
            if not isinstance(value, int) or value < 0:
                raise ValueError(f'`{name}` may not be a negative value.')
            arguments[name] = value
        else:
            raise ValueError(f'Unexpected key `{name}` for QoS profile.')
    try:
        return QoSProfile(**arguments)
    except InvalidQoSProfileException as error:
        raise ValueError(str(error.args[-1])) from None


def dict_to_duration(time_dict: dict[str, int] | None) -> Any:
    """
    Return the duration that has these seconds and nanoseconds; one of 0 for none.

    :raises ValueError: if one of the two is missing, or it is negative.
    """
    from rclpy.duration import Duration

    if not time_dict:
        return Duration()
    if not isinstance(time_dict, dict) or not {'sec', 'nsec'} <= time_dict.keys():
        raise ValueError('Time overrides must include both seconds (sec) and nanoseconds (nsec).')
    duration = Duration(seconds=time_dict['sec'], nanoseconds=time_dict['nsec'])
    if duration.nanoseconds < 0:
        raise ValueError('Time duration may not be a negative value.')
    return duration
