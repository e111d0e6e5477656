"""Namespaces of nodes."""


def join_namespace(base: str, namespace: str) -> str:
    """Return ``namespace`` below ``base``, absolute; one that begins with / stands for itself; '' means none."""
    joined = namespace if namespace.startswith('/') else '/'.join(part for part in (base.rstrip('/'), namespace) if part)
    if not joined:
        return ''
    return '/' + joined.strip('/')
