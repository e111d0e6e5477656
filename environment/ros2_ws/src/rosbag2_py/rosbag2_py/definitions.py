"""What a bag says of a message type, so that it can be read where the package is not installed: definition and hash."""

import json
import re
from functools import cache
from pathlib import Path
from typing import Any

from ament_index_python.packages import PackageNotFoundError, get_package_share_directory
from ament_index_python.resources import get_resource

_SEPARATOR = '=' * 80
_INCLUDED = re.compile(r'^#include\s+["<]([A-Za-z0-9_/]+)\.idl[">]', re.MULTILINE)


@cache
def definition(name: str) -> str:
    """
    Return the text of a message's definition and, after a line of `=` each, those of the messages that it holds.

    '' where there is none, as for the events of a service, which are generated from the service's definition.
    """
    try:
        return _with_held(name, 'MSG', set())
    except LookupError:
        return ''


def message_text(name: str) -> tuple[str, str]:
    """
    Return in which language a message is defined, `ros2msg` or `ros2idl`, and the text with those that it holds.

    :raises LookupError: if there is no such definition.
    """
    try:
        return 'ros2msg', _with_held(name, 'MSG', set())
    except LookupError:
        return 'ros2idl', _mark(name, 'IDL') + _with_held(name, 'IDL', set())


def service_text(name: str) -> tuple[str, str]:
    """
    Return the text of a service with the messages that it holds, and the language of these: as `message_text`.

    As in stock's texts, the mark of a `.msg` that is missing stays above that of the `.idl`.

    :raises LookupError: if there is no such definition.
    """
    text = _source(name, 'SRV')
    language, parts, done = 'ros2msg', [_mark(name, 'SRV') + text], {name}
    for each in _held(name, 'SRV', text):
        if each in done:
            continue
        done.add(each)
        parts.append(_mark(each, 'MSG'))
        try:
            parts[-1] += _with_held(each, 'MSG', done)
        except LookupError:
            language = 'ros2idl'
            parts.append(_mark(each, 'IDL') + _with_held(each, 'IDL', done))
    return language, '\n'.join(parts)


def _with_held(name: str, form: str, done: set[str]) -> str:
    """Return the text of a definition in one form and, deeper ones first, of those that it holds and are not done."""
    text = _source(name, form)
    parts = [text]
    for each in _held(name, form, text):
        if each not in done:
            done.add(each)
            parts.append(_mark(each, form) + _with_held(each, form, done))
    return '\n'.join(parts)


def _mark(name: str, form: str) -> str:
    return f'{_SEPARATOR}\n{form}: {name}\n'


def _source(name: str, form: str) -> str:
    package, *_, short = name.split('/')
    try:
        listed, prefix = get_resource('rosidl_interfaces', package)
    except (LookupError, ValueError, OSError):
        raise LookupError(name) from None
    files = (Path(prefix, 'share', package, line) for line in listed.splitlines())
    file = next((each for each in files if each.name == f'{short}.{form.lower()}' and each.is_file()), None)
    if file is None:
        raise LookupError(name)
    return file.read_text(encoding='utf-8')


def _held(name: str, form: str, text: str) -> list[str]:
    """Return the names of the messages that a definition holds, as stock writes them into a bag."""
    if form == 'IDL':
        return sorted(set(_INCLUDED.findall(text)))
    from rosidl_adapter.parser import parse_message_string

    package, *_, short = name.split('/')
    parts = re.split(r'^---\s*$', text, flags=re.MULTILINE) if form == 'SRV' else [text]
    types = [field.type for part in parts for field in parse_message_string(package, short, part).fields]
    return sorted({f'{each.pkg_name}/{each.type}' for each in types if each.pkg_name})


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
