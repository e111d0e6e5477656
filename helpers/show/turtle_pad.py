"""The turtle's picture with arrow buttons, as a widget: the kernel sends what it shows, and hears what is pressed.

The arrow keys do the same as the buttons, but only while the view has the focus: elsewhere they scroll the page.
"""

from collections.abc import Callable
from pathlib import Path

import anywidget
import traitlets

_WEB = Path(__file__).parent / 'web'
# What turtlesim's turtle_teleop_key sends: m/s and rad/s.
_SPEEDS = {'up': (2.0, 0.0), 'down': (-2.0, 0.0), 'left': (0.0, 2.0), 'right': (0.0, -2.0)}


class TurtlePad(anywidget.AnyWidget):
    """A picture and four arrows.

    :param picture: an SVG.
    :param drive: called with a linear velocity in m/s and an angular one in rad/s when an arrow is pressed. It runs
        in the thread that handles the browser's messages.
    """

    _esm = _WEB / 'turtle_pad.js'
    _css = _WEB / 'turtle_pad.css'
    picture = traitlets.Unicode().tag(sync=True)

    def __init__(self, picture: str, drive: Callable[[float, float], None]):
        super().__init__(picture=picture)
        self._drive = drive
        self.shown = False  # whether a browser has drawn it
        self.on_msg(self._on_page)

    def _on_page(self, widget, content, buffers) -> None:
        if not isinstance(content, dict):
            return
        self.shown = self.shown or content.get('shown') is True
        speeds = _SPEEDS.get(content.get('press'))
        if speeds is not None:
            self._drive(*speeds)
