"""A drawing of what needs what: lines from the chapters of the course to what comes after it."""

from io import BytesIO

import numpy as np


class Picture:
    """A figure of matplotlib that any notebook shows, also one that has not imported pyplot.

    :param text: what is shown where no picture can be.
    """

    def __init__(self, figure, text: str):
        self.figure, self._text = figure, text

    def __repr__(self) -> str:
        return self._text

    def _repr_png_(self) -> bytes:
        file = BytesIO()
        self.figure.savefig(file, format='png', bbox_inches='tight')
        return file.getvalue()


def route_map(chapters: list[str], stacks: dict[str, tuple[int, ...]]) -> Picture:
    """Draw the chapters on the left, the stacks on the right, and a line between two that belong together.

    :param chapters: their names; the first one has the number 1.
    :param stacks: name -> the numbers of the chapters that it needs.
    :return: the drawing; `figure` is that of matplotlib.
    :raises ValueError: a stack needs a chapter that there is not.
    """
    from matplotlib.figure import Figure

    unknown = {number for needed in stacks.values() for number in needed} - set(range(1, len(chapters) + 1))
    if unknown:
        raise ValueError(f'there are {len(chapters)} chapters, and no number {min(unknown)}')
    figure = Figure(figsize=(7, 3.2))
    figure.patch.set_alpha(0)
    axes = figure.add_subplot()
    axes.axis('off')
    axes.set_xlim(-0.4, 1.4)
    for number, name in enumerate(chapters, 1):
        axes.text(-0.03, -number, name, ha='right', va='center', color='#777777')
    along = np.linspace(0, 1, 50)
    bend = along * along * (3 - 2 * along)
    step = (len(chapters) - 1) / max(1, len(stacks) - 1)
    for row, (stack, needed) in enumerate(stacks.items()):
        end = -1 - step * row
        axes.text(1.03, end, stack, va='center', color='#777777', weight='bold')  # to be read on light and dark
        for number in needed:
            axes.plot(along, -number + (end + number) * bend, color=f'C{row}')
    text = '\n'.join(
        f'{stack}: {", ".join(chapters[number - 1] for number in needed)}' for stack, needed in stacks.items()
    )
    return Picture(figure, text)
