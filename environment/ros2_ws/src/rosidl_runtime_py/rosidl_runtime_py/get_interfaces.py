"""Which interfaces are installed, from the ament index, and where their definitions are."""

from collections.abc import Iterable
from pathlib import Path

from ament_index_python import get_resource, get_resources, has_resource

# The definition files of each kind; the index lists a generated .idl beside the .msg or .srv it came from.
_SUFFIXES = {'msg': ('.idl', '.msg'), 'srv': ('.idl', '.srv'), 'action': ('.idl', '.action')}


def get_interface_packages() -> dict[str, str]:
    """Return the packages that define interfaces, each with the prefix it is installed in."""
    return get_resources('rosidl_interfaces')


def get_interfaces(package_names: Iterable[str] = ()) -> dict[str, list[str]]:
    """
    Return the names (`msg/String`, `srv/Empty` …) of the interfaces of some packages.

    :param package_names: the packages; none means all.
    :raises LookupError: if a package is not installed.
    """
    names = list(package_names)
    known = get_interface_packages()
    for name in names:
        if not has_resource('packages', name):
            raise LookupError(f"Unknown package '{name}'")
    return {name: _interfaces_of(name) if name in known else [] for name in (names or known)}


def _interfaces_of(package_name: str) -> list[str]:
    content, _ = get_resource('rosidl_interfaces', package_name)
    found = set()
    for line in content.splitlines():
        kind, _, file_name = line.partition('/')
        stem = file_name.rpartition('.')[0]
        # An underscore marks a part that the generator made, as Fibonacci_Goal.
        if line.endswith(_SUFFIXES.get(kind, ())) and '_' not in stem:
            found.add(f'{kind}/{stem}')
    return sorted(found)


def _of_kind(kind: str, package_names: Iterable[str]) -> dict[str, list[str]]:
    chosen = {
        package: [name for name in names if name.startswith(f'{kind}/')]
        for package, names in get_interfaces(package_names).items()
    }
    return {package: names for package, names in chosen.items() if names}


def get_message_interfaces(package_names: Iterable[str] = ()) -> dict[str, list[str]]:
    """Return the messages of some packages (none: of all), without packages that have none."""
    return _of_kind('msg', package_names)


def get_service_interfaces(package_names: Iterable[str] = ()) -> dict[str, list[str]]:
    """Return the services of some packages (none: of all), without packages that have none."""
    return _of_kind('srv', package_names)


def get_action_interfaces(package_names: Iterable[str] = ()) -> dict[str, list[str]]:
    """Return the actions of some packages (none: of all), without packages that have none."""
    return _of_kind('action', package_names)


def get_interface_path(interface_name: str) -> str:
    """
    Return the path of an interface's definition; without a suffix `.msg`, `.srv`, `.action` come before `.idl`.

    :param interface_name: for example `std_msgs/msg/String` or `std_msgs/msg/String.idl`.
    :raises ValueError: if the name is malformed.
    :raises LookupError: if the package or the interface is not installed.
    """
    parts = interface_name.split('/')
    if len(parts) < 2:
        raise ValueError(f"Invalid name '{interface_name}'. Expected at least two parts separated by '/'")
    if not all(parts):
        raise ValueError(f"Invalid name '{interface_name}'. Must not contain empty parts")
    if '..' in parts:
        raise ValueError(f"Invalid name '{interface_name}'. Must not contain '..'")
    prefix = has_resource('packages', parts[0])
    if not prefix:
        raise LookupError(f"Unknown package '{parts[0]}'")
    path = Path(prefix, 'share', *parts)
    if path.suffix:
        candidates = [path]
    else:
        candidates = [path.with_suffix(f'.{parts[-2]}'), path.with_suffix('.idl')]
    for candidate in candidates:
        if candidate.is_file():
            return str(candidate)
    raise LookupError(f"Could not find the interface '{candidates[-1]}'")
