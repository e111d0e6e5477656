"""Mends of upstream's that came after the ROS wheels were made, put into the installed packages."""

from pathlib import Path

from environment.setup import action_client
from environment.setup.relocation import replace

MODULE = '_course_action_client'
_TAIL = f'\n\nfrom {MODULE} import mend  # noqa: E402 - ros2/rclpy#1123\n\nmend(ActionClient)\n'


def text() -> str:
    """All that these mends are made of: when it changes, they are due again."""
    return Path(action_client.__file__).read_text() + _TAIL


def apply(site: Path) -> bool:
    """Mend rclpy's action client in `site` (site-packages), unless it has a lock of its own; whether it did.

    A second call writes the same again.
    """
    client = site / 'rclpy' / 'action' / 'client.py'
    if not client.is_file():
        return False
    old = client.read_text()
    if 'Lock()' in old:
        return False
    (site / f'{MODULE}.py').write_text(Path(action_client.__file__).read_text())
    replace(client, (old.partition(_TAIL)[0] + _TAIL).encode())
    return True
