"""What a bag says of a message type, so that it can be read where the package is not installed: definition and hash."""

import json
from functools import cache
from pathlib import Path
from typing import Any

from ament_index_python.packages import PackageNotFoundError, get_package_share_directory

_SEPARATOR = '=' * 80


@cache
def definition(name: str) -> str:
    """
    Return the text of a message's definition and, after a line of `=` each, those of the messages that it holds.

    '' where there is none, as for the events of a service, which are generated from the service's definition.
    """
    text = _source(name)
    if text is None:
        return ''
    parts, done, waiting = [text], {name}, _held(name, text)
    while waiting:
        each = waiting.pop(0)
        if each not in done:
            done.add(each)
            held = _source(each)
            if held is None:
                return ''
            package, _, short = each.split('/')
            parts.append(f'{_SEPARATOR}\nMSG: {package}/{short}\n{held}')
            waiting += _held(each, held)
    return '\n'.join(parts)


def _source(name: str) -> str | None:
    package, kind, short = name.split('/')
    try:
        file = Path(get_package_share_directory(package), kind, f'{short}.msg')
    except (PackageNotFoundError, ValueError):
        return None
    return file.read_text(encoding='utf-8') if file.is_file() else None


def _held(name: str, text: str) -> list[str]:
    from rosidl_adapter.parser import parse_message_string

    package, _, short = name.split('/')
    fields = parse_message_string(package, short, text).fields
    return [f'{each.type.pkg_name}/msg/{each.type.type}' for each in fields if each.type.pkg_name]


@cache
def type_hash(name: str) -> str:
    """Return the hash of a type's description, `RIHS01_…`; '' if the package is not installed."""
    package, kind, short = name.split('/')
    base = short.removesuffix('_Event') if kind == 'srv' else short
    try:
        file = Path(get_package_share_directory(package), kind, f'{base}.json')
        hashes = json.loads(file.read_text())['type_hashes']
    except (PackageNotFoundError, ValueError, OSError):
        return ''
    return next((each['hash_string'] for each in hashes if each['type_name'] == name), '')


def message_class(name: str) -> Any:
    """
    Return the class of a message, or of the events of a service, by the name that a bag has for it.

    :raises RuntimeError: if it is not installed.
    """
    if '/srv/' in name and '_Event' in name:
        return service_class(name).Event
    return _import(name, name)


def service_class(event: str) -> Any:
    """
    Return the class of a service by the name that a bag has for its events.

    :raises RuntimeError: if it is not installed.
    """
    return _import(event.partition('_Event')[0], event)


def _import(name: str, told: str) -> Any:
    from rosidl_parser.definition import NamespacedType
    from rosidl_runtime_py.import_message import import_message_from_namespaced_type

    package, kind, short = name.split('/')
    try:
        return import_message_from_namespaced_type(NamespacedType([package, kind], short))
    except (AttributeError, ModuleNotFoundError):
        raise RuntimeError(f"the message type '{told}' is not installed") from None
