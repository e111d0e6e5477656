"""Namespaces of nodes as text."""

from __future__ import annotations


def is_namespace_absolute(namespace: str) -> bool:
    """Return whether a namespace begins at the root."""
    return namespace.startswith('/')


def is_root_namespace(namespace: str) -> bool:
    """Return whether a namespace is the root itself."""
    return namespace == '/'


def make_namespace_absolute(namespace: str | None) -> str | None:
    """Return a namespace as one that begins at the root; None stays None."""
    if namespace is None or is_namespace_absolute(namespace):
        return namespace
    return f'/{namespace}'


def prefix_namespace(base: str | None, namespace: str | None, return_absolute_ns: bool = True) -> str | None:
    """
    Return ``namespace`` below ``base``; an absolute one stands for itself, and None for none.

    :param return_absolute_ns: whether the result shall begin at the root
    """
    if base is None or namespace is None or is_namespace_absolute(namespace):
        joined = base if namespace is None else namespace
    else:
        joined = '/'.join(part for part in (base.rstrip('/'), namespace) if part)
        if is_namespace_absolute(base):
            joined = '/' + joined.lstrip('/')
    if joined and not is_root_namespace(joined):
        joined = joined.rstrip('/')
    return make_namespace_absolute(joined) if return_absolute_ns else joined
