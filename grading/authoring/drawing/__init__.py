"""Drawing the course's figures: a sheet, what lies on it, and a test of what overlaps.

A figure is a file `solutions/figures/NAME.py`: `ALT`, its alternative text, and `draw()`, which returns a `Sheet`::

    from grading.authoring.drawing import Sheet

    ALT = 'A talker sends messages to a listener over the topic chatter.'


    def draw():
        sheet = Sheet('A topic', height=100)
        talker = sheet.box(40, 30, 120, 40, 'talker')
        listener = sheet.box(540, 30, 120, 40, 'listener')
        sheet.arrow(talker, listener, '`chatter`')
        return sheet

Lengths are pixels of a sheet 700 pixels wide; x grows to the right, y downwards. In texts, `` `spin()` `` is set as
code and ``**now**`` bold; `NOTE` is the size of what explains. `faults.found` says which texts overlap something.
"""

from grading.authoring.drawing.parts import Lanes, Plot, queue, stack
from grading.authoring.drawing.sheet import Sheet
from grading.authoring.drawing.sheet_geometry import Rectangle
from grading.authoring.drawing.style import NOTE

__all__ = ['NOTE', 'Lanes', 'Plot', 'Rectangle', 'Sheet', 'queue', 'stack']
