"""Notices of copyright and licences in source files."""

from ament_copyright.licenses import LICENSES, License


def get_licenses() -> dict[str, License]:
    """Return the licences that are known, by their short names, in the order of these."""
    return dict(sorted(LICENSES.items()))
