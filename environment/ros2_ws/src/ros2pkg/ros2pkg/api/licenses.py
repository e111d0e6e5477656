"""The licences that `ros2 pkg create` has the text of, by SPDX identifier (and ament's BSD-2.0)."""

import datetime
from pathlib import Path

IDENTIFIERS = (
    'Apache-2.0',
    'BSL-1.0',
    'BSD-2.0',
    'BSD-2-Clause',
    'BSD-3-Clause',
    'GPL-3.0-only',
    'LGPL-3.0-only',
    'MIT',
    'MIT-0',
)


def get_license_text(identifier: str, holder: str) -> str | None:
    """Return the text, with this year and the holder of the copyright filled in; None if it is not one of these."""
    if identifier not in IDENTIFIERS:
        return None
    path = Path(__file__).parent.parent / 'licenses' / f'{identifier}.txt'
    year = str(datetime.date.today().year)
    return path.read_text(encoding='utf-8').replace('@year', year).replace('@holder', holder)
