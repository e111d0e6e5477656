"""Which lines of an output count, apart from those of the middleware."""

from __future__ import annotations

from collections.abc import Callable, Iterable

import ament_index_python
from launch_testing.tools import output


def get_rmw_output_filter(rmw_implementation: str, filter_type: str) -> list[str]:
    """
    Return what a middleware says of its own lines, each a prefix or a pattern; often nothing.

    :param filter_type: ``prefixes`` or ``patterns``
    :raises TypeError: for another one
    """
    if filter_type not in ('prefixes', 'patterns'):
        raise TypeError(f"Unsupported filter_type '{filter_type}', it is either 'prefixes' or 'patterns'")
    resource = f'rmw_output_{filter_type}'
    if not ament_index_python.has_resource(resource, rmw_implementation):
        return []
    return ament_index_python.get_resource(resource, rmw_implementation)[0].splitlines()


def basic_output_filter(
    filtered_prefixes: Iterable[str] | None = None,
    filtered_patterns: Iterable[str] | None = None,
    filtered_rmw_implementation: str | None = None,
) -> Callable[[str], str]:
    """
    Return a function that leaves lines out of a text, see ``launch_testing.tools.basic_output_filter``.

    :param filtered_rmw_implementation: a middleware whose own lines are left out, too
    """
    prefixes = list(output.get_default_filtered_prefixes() if filtered_prefixes is None else filtered_prefixes)
    patterns = list(output.get_default_filtered_patterns() if filtered_patterns is None else filtered_patterns)
    if filtered_rmw_implementation:
        prefixes += get_rmw_output_filter(filtered_rmw_implementation, 'prefixes')
        patterns += get_rmw_output_filter(filtered_rmw_implementation, 'patterns')
    return output.basic_output_filter(prefixes, patterns)
