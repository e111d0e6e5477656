"""Charts of the chapters: an empty one to plot into, how long distributions are supported, a battery's charge."""

from collections.abc import Mapping, Sequence

_GREY = '#777777'  # readable on a light and on a dark page
_STYLE = {
    'text.color': _GREY,
    'axes.labelcolor': _GREY,
    'axes.edgecolor': _GREY,
    'xtick.color': _GREY,
    'ytick.color': _GREY,
    'figure.facecolor': 'none',
    'axes.facecolor': 'none',
    'figure.dpi': 80,
}


def figure(height: float = 2.8):
    """Return empty matplotlib axes, as wide as a cell, whose text can be read on light and on dark pages.

    :param height: in inches.
    """
    import matplotlib.pyplot as plt

    plt.rcParams.update(_STYLE)  # also for what is added later, such as a legend
    return plt.subplots(figsize=(7, height))[1]


def show_support(releases: Mapping[str, tuple[str, str, str]], month: str) -> None:
    """Draw a bar for each distribution, from its first to its last month; those supported in ``month`` are green.

    :param releases: from a name to Ubuntu, first month and last month; months are written ``'2024-05'``.
    :param month: where the red line stands.
    """
    axes = figure(2.4)
    for row, (_, first, last) in enumerate(releases.values()):
        begin, end = _year(first), _year(last) + 1 / 12  # the last month counts
        colour = 'tab:green' if first <= month <= last else '#bbbbbb'
        axes.barh(row, end - begin, left=begin, color=colour, height=0.6)
    axes.set_yticks(range(len(releases)), [f'{name} ({row[0]})' for name, row in releases.items()])
    axes.invert_yaxis()
    axes.axvline(_year(month) + 1 / 24, color='tab:red')
    axes.set_frame_on(False)


def show_charge(history: Sequence[tuple[float, str]], low: float, full: float) -> None:
    """Draw a battery's charge minute by minute, green while the robot works and red while it charges.

    :param history: charge from 0 to 1, and state, for each minute; ``'charging'`` is red.
    :param low: below this the robot must charge; a red line.
    :param full: from this on it works again; a green line.
    """
    axes = figure(2.6)
    colours = ['tab:red' if state == 'charging' else 'tab:green' for _, state in history]
    axes.scatter(range(len(history)), [charge for charge, _ in history], 9, colours)
    axes.axhline(low, color='tab:red', lw=1)
    axes.axhline(full, color='tab:green', lw=1)
    axes.set_xlabel('minute')
    axes.set_ylabel('charge')
    axes.set_title('green: working, red: charging', color=_GREY)


def _year(month: str) -> float:
    """``'2024-07'`` is 2024.5."""
    return int(month[:4]) + (int(month[5:7]) - 1) / 12
