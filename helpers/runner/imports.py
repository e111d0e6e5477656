"""From where a name is imported that a program uses and nothing defines: after a NameError.

Looked up are the modules of rclpy and tf2, the interfaces that are installed, and what beginners take from Python.
"""

import importlib
from collections.abc import Iterable
from contextlib import suppress
from functools import cache
from types import ModuleType

from ament_index_python.packages import get_packages_with_prefixes
from ament_index_python.resources import get_resource, get_resources

from helpers.runner import similar

# Those offer what they define, and those offer what parts of theirs define. The first one that has a name counts.
_MODULES = (
    'rclpy.node',
    'rclpy.qos',
    'rclpy.callback_groups',
    'rclpy.executors',
    'rclpy.duration',
    'rclpy.time',
    'rclpy.clock',
    'rclpy.parameter',
    'rclpy.task',
    'rclpy.event_handler',
    'rclpy.exceptions',
    'math',
    'collections',
    'functools',
    'pathlib',
    'dataclasses',
    'enum',
)
_PACKAGES = ('rclpy.action', 'rclpy.lifecycle', 'tf2_ros', 'message_filters')
# Of Python's others many have names that a learner gives to own things: queue, string, code.
_WHOLE = frozenset(
    'collections functools itertools json math os pathlib pytest random re rclpy subprocess sys threading time'.split()
)
_ALIASES = {'np': 'numpy', 'plt': 'matplotlib.pyplot'}
_ROSIDL = 'rosidl_interfaces'  # the resource in which a package lists its interfaces: msg/String.msg
_MOST = 3


def lines_for(name: str) -> list[str]:
    """Lines that import `name`, such as ``from rclpy.qos import QoSProfile``: at most three, the likeliest first.

    Empty if no module has it from which a learner would take it.
    """
    if name in _ALIASES:
        return [f'import {_ALIASES[name]} as {name}']
    if name in _WHOLE or name in _packages():
        return [f'import {name}']
    return [f'from {module} import {name}' for module in modules_of(name)]


def modules_of(name: str) -> list[str]:
    """The modules that offer `name`, such as ``rclpy.qos``: at most three, the likeliest first."""
    if len(name) < 2 or name.startswith('_'):
        return []
    modules = [module for module in (*_MODULES, *_PACKAGES) if _offers(module, name)][:1]
    return [*modules, *_interface_modules(name)][:_MOST]


def advice(name: str) -> str:
    """A sentence with the lines that import `name`; '' if there are none."""
    lines = lines_for(name)
    return f'Nothing imports `{name}` here. Write: {" or ".join(lines)}' if lines else ''


def nearest(name: str) -> str:
    """The name that is meant, perhaps, of all that `lines_for` would propose; '' if none is like it."""
    return similar.nearest(name, _offered(), 0.85)


@cache
def _offered() -> frozenset[str]:
    found = {*_WHOLE, *_ALIASES, *_packages()}
    for module in (*_MODULES, *_PACKAGES):
        with suppress(Exception):
            found |= {name for name in dir(importlib.import_module(module)) if _offers(module, name)}
    for package in _packages() and get_resources(_ROSIDL):
        files = [line.partition('/')[2] for line in get_resource(_ROSIDL, package)[0].splitlines()]
        found |= {file.rpartition('.')[0] for file in files if '/' not in file}
    return frozenset(name for name in found if not name.startswith('_'))


def _offers(module: str, name: str) -> bool:
    with suppress(Exception):  # what cannot be imported offers nothing, whatever is wrong with it
        value = getattr(importlib.import_module(module), name, None)
        # A constant does not tell where it is defined.
        here = module in _PACKAGES or getattr(value, '__module__', module) == module
        return value is not None and not isinstance(value, ModuleType) and here
    return False


def _packages() -> Iterable[str]:
    with suppress(OSError):  # no ROS is sourced
        return get_packages_with_prefixes()
    return ()


def _interface_modules(name: str) -> list[str]:
    """The modules of all installed interfaces of this name, such as ``geometry_msgs.msg``; examples come last."""
    found = set()
    for package in _packages() and get_resources(_ROSIDL):
        for line in get_resource(_ROSIDL, package)[0].splitlines():
            kind, _, file = line.partition('/')
            if file.rpartition('.')[0] == name:
                found.add(f'{package}.{kind}')
    return sorted(found, key=lambda module: ('example' in module or 'test_msgs' in module, module))
