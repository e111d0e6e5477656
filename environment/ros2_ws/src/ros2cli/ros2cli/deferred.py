"""Names that a module offers, as upstream's does, and that are imported when somebody asks for them.

They need rclpy or all messages, which a help text must not load.
"""

from collections.abc import Callable, Mapping
from importlib import import_module
from typing import Any


def attributes_from(defined_in: Mapping[str, str], *, module: str) -> Callable[[str], Any]:
    """Return the `__getattr__` (PEP 562) of the module called `module`: each name comes from the module it maps to."""

    def get_attribute(name: str) -> Any:
        if name not in defined_in:
            raise AttributeError(f'module {module!r} has no attribute {name!r}')
        return getattr(import_module(defined_in[name]), name)

    return get_attribute
