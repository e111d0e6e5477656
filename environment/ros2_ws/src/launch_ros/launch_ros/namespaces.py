"""Namespaces of nodes."""


def join_namespace(base: str, namespace: str) -> str:
    """Return ``namespace`` below ``base``, absolute; one that begins with / stands for itself; '' means none."""
    parts = [namespace] if namespace.startswith('/') else [base.rstrip('/'), namespace]
    joined = '/'.join(part for part in parts if part)
    if not joined:
        return ''
    return '/' + joined.strip('/')
