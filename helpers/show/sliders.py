"""Sliders in the output of a cell: what they are moved to goes to a function, what it returns is shown below them.

The widgets are those of ipywidgets. Where no widget can be shown, a still has the values as a table.
"""

import threading
from collections.abc import Callable
from html import escape
from typing import Any, NamedTuple

from helpers.kernel import journal, nodes
from helpers.show.widgets import WidgetOutput

_STEPS = 100  # of a slider, if nothing else is said
_open: list['Sliders'] = []


class Slider(NamedTuple):
    """One slider: a range of numbers, or a choice."""

    low: float | int | None = None
    high: float | int | None = None
    value: Any = None
    unit: str = ''
    choices: tuple = ()  #: instead of a range
    help: str = ''  #: shown when the mouse is over it


class Values:
    """The values of sliders, and the text or picture below them, as Jupyter shows them without widgets."""

    def __init__(self, sliders: dict[str, Slider], values: dict[str, Any], shown: str):
        self._sliders, self._values, self._shown = sliders, values, shown

    def _repr_mimebundle_(self, include=None, exclude=None) -> dict[str, str]:
        rows = ''.join(
            f'<tr><th style="text-align: left">{escape(name)}</th><td>{escape(value)}</td></tr>'
            for name, value in self._rows()
        )
        return {'text/html': f'<table>{rows}</table>{_html(self._shown)}', 'text/plain': str(self)}

    def __str__(self) -> str:
        lines = [f'{name}: {value}' for name, value in self._rows()]
        return '\n'.join(lines if self._shown.startswith('<') else [*lines, *self._shown.splitlines()])

    __repr__ = __str__

    def _rows(self) -> list[tuple[str, str]]:
        return [(name, f'{_number(value)} {self._sliders[name].unit}'.strip()) for name, value in self._values.items()]


class Sliders:
    """Show sliders in the output of this cell; they stay until `stop`, or until this cell or a later one makes others.

    ::

        def turn(roll, pitch, yaw):
            …
            return 'what is shown below'

        Sliders(turn, roll=(-180, 180, 0, '°'), pitch=(-90, 90, 0, '°'), yaw=(-180, 180, 0, '°'))

    :param function: called at once, and each time that a slider has moved, with all values by name. A text that it
        returns is shown below (one that begins with ``<`` is HTML); an exception, too. After the first call it runs in
        the thread that handles the browser's messages, one call after the other.
    :param owners: nodes that end with the sliders, and they with the first of them that ends.
    :param ranges: for each slider (low, high), (low, high, first value) or (low, high, first value, unit); two
        integers make a slider of integers. A list is a choice. A `Slider` says all.
    :raises Exception: what the function raises in its first call.
    """

    def __init__(self, function: Callable[..., str | None], /, *owners, **ranges):
        self._function, self._owners = function, owners
        self._lock = threading.Lock()
        self._sliders = {name: _slider(given) for name, given in ranges.items()}
        self.values = {name: slider.value for name, slider in self._sliders.items()}  #: by name, as they are now
        self._text = ''
        self._widgets: dict[str, Any] = {}
        self._output: WidgetOutput | None = None
        for other in _open.copy():
            other.stop()
        self.show(function(**self.values))
        _open.append(self)
        if journal.in_kernel():
            self._open_widgets()

    def show(self, text: str | None) -> None:
        """Show another text, or HTML, below the sliders. Any thread may call it."""
        self._text = text or ''
        if self._output is not None:
            self._shown.value = _html(self._text)

    def stop(self) -> None:
        """End them; a still with the last values stays. Idempotent."""
        if self in _open:
            _open.remove(self)
            for node in self._owners:
                nodes.destroy(node)
            if self._output is not None:
                output, self._output = self._output, None
                output.close(self._still())
                for widget in (*self._widgets.values(), self._shown):
                    widget.close()

    def __enter__(self) -> 'Sliders':
        return self

    def __exit__(self, kind, error, tb) -> None:
        self.stop()

    def __repr__(self) -> str:
        return repr(self._still())

    def _ipython_display_(self) -> None:
        """As the last line of a cell they show nothing more: they are shown already."""

    def _still(self) -> Values:
        return Values(self._sliders, self.values, self._text)

    def _open_widgets(self) -> None:
        import ipywidgets

        self._widgets = {name: _widget(name, slider) for name, slider in self._sliders.items()}
        self._shown = ipywidgets.HTML(_html(self._text))
        for name, widget in self._widgets.items():
            widget.observe(lambda change, name=name: self._on_move(name, change['new']), 'value')
        self._output = WidgetOutput(ipywidgets.VBox([*self._widgets.values(), self._shown]), self._still())

    def _on_move(self, name: str, value) -> None:
        with self._lock:
            self.values[name] = value
            try:
                self.show(self._function(**self.values))
            except Exception as error:  # nobody waits for this call: the page must tell
                self.show(f'{type(error).__name__}: {error}')


def _slider(given) -> Slider:
    if isinstance(given, Slider):
        slider = given
    elif isinstance(given, list):
        slider = Slider(choices=tuple(given))
    else:
        slider = Slider(*given)
    if slider.value is None:
        slider = slider._replace(value=slider.choices[0] if slider.choices else slider.low)
    return slider


def _widget(name: str, slider: Slider):
    import ipywidgets

    about: dict[str, Any] = {
        'description': f'{name} [{slider.unit}]' if slider.unit else name,
        'tooltip': slider.help,
        'style': {'description_width': '7em'},
        'layout': {'width': '30em'},
    }
    if slider.choices:
        return ipywidgets.Dropdown(options=slider.choices, value=slider.value, **about)
    bounds = {'min': slider.low, 'max': slider.high, 'value': slider.value}
    if all(isinstance(number, int) for number in bounds.values()):
        return ipywidgets.IntSlider(**bounds, **about)
    step = (slider.high - slider.low) / _STEPS
    return ipywidgets.FloatSlider(**bounds, step=step, readout_format='.3g', **about)


def _number(value) -> str:
    return f'{value:.4g}' if isinstance(value, float) else str(value)


def _html(text: str) -> str:
    if text.startswith('<'):
        return text
    return f'<pre style="margin: 4px 0; line-height: 1.4">{escape(text)}</pre>' if text else ''


def _on_destroy(node) -> None:
    for sliders in _open.copy():
        if any(node is owner for owner in sliders._owners):
            sliders.stop()


nodes.before_destroy.append(_on_destroy)
