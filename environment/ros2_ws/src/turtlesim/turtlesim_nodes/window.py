"""A window that shows the world, where the machine has a display and Python has tkinter."""

import os
import sys

from turtlesim_nodes.shape import polygons
from turtlesim_nodes.world import PIXELS, Trail, World, to_pixels


class NoWindowError(RuntimeError):
    """No window can be opened here; the text says why."""


class Window:
    """
    The window ``TurtleSim``.

    :raises NoWindowError: if there is no display or no tkinter
    """

    def __init__(self, world: World):
        if sys.platform.startswith('linux') and not (os.environ.get('DISPLAY') or os.environ.get('WAYLAND_DISPLAY')):
            raise NoWindowError('there is no display')
        try:
            import tkinter
        except ImportError:
            raise NoWindowError("Python's tkinter is missing (on Ubuntu: sudo apt install python3-tk)") from None
        try:
            self._root = tkinter.Tk()
        except tkinter.TclError as error:
            raise NoWindowError(str(error)) from None
        self._error = tkinter.TclError
        self.closed = False
        self._world = world
        self._lines: dict[int, tuple[Trail, int, int]] = {}  # id of a trail: the trail, its last corner, its item
        self._root.title('TurtleSim')
        self._root.resizable(False, False)
        self._root.protocol('WM_DELETE_WINDOW', self.close)
        self._canvas = tkinter.Canvas(self._root, width=PIXELS, height=PIXELS, highlightthickness=0)
        self._canvas.pack()

    def close(self) -> None:
        """Close the window; harmless if it is closed."""
        if not self.closed:
            self.closed = True
            self._root.destroy()

    def show(self) -> None:
        """Draw the world as it is now and let the window answer the mouse."""
        if self.closed:
            return
        try:
            self._canvas.configure(background='#{:02x}{:02x}{:02x}'.format(*self._world.background))
            self._show_trails()
            self._canvas.delete('turtle')
            for name in sorted(self._world.turtles):
                for fill, corners in polygons(self._world.turtles[name]):
                    flat = [value for corner in corners for value in to_pixels(*corner)]
                    self._canvas.create_polygon(*flat, fill=fill, tags='turtle')
            self._root.update()
        except self._error:
            self.closed = True  # the display has gone away

    def _show_trails(self) -> None:
        current = {id(trail): trail for trail in self._world.trails}
        for key in [key for key in self._lines if key not in current]:
            self._canvas.delete(self._lines.pop(key)[2])
        for key, trail in current.items():
            end = trail.points[-1]
            if key in self._lines and self._lines[key][1] == end:
                continue
            if key in self._lines:
                self._canvas.delete(self._lines[key][2])
            flat = [value for point in trail.points for value in to_pixels(*point)]
            color = '#{:02x}{:02x}{:02x}'.format(*trail.color)
            flat = flat if len(flat) > 2 else flat * 2
            item = self._canvas.create_line(*flat, fill=color, width=trail.width, capstyle='projecting')
            self._lines[key] = (trail, end, item)
