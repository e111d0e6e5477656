"""A widget in the output of a cell, and a still picture wherever no widget can be shown.

One output has both forms. A front end shows the widget if it knows widgets and the notebook is trusted; a page made
from the notebook, nbval, and a notebook that somebody else has run show the still.
"""

from typing import Any

VIEW = 'application/vnd.jupyter.widget-view+json'


class WidgetOutput:
    """Show a widget (of ipywidgets) in the output of the running cell, until `close`.

    :param widget: its comm is open while it is shown.
    :param still: what stands in its place otherwise; has ``_repr_mimebundle_``, as Jupyter wants it.
    """

    def __init__(self, widget: Any, still: Any):
        from IPython.display import display

        self.widget = widget
        _hear_at_once(widget)
        self._handle = display(_Both(widget, still), display_id=True)

    def close(self, still: Any) -> None:
        """Put a still in the place of the widget, and forget the widget."""
        self._handle.update(still)
        self.widget.close()


def _hear_at_once(widget: Any) -> None:
    """Have what the browser says handled while a cell runs, too.

    JupyterLab sends it to a subshell (a thread of the kernel) for that. But ipykernel 7.4 hands it to the thread whose
    cell has last changed the widget, where it would wait for the end of the cell. For a widget of ours it shall not:
    what handles its messages needs no particular thread. Other versions do not look at the attribute.
    """
    for part in (widget, *getattr(widget, 'children', ())):
        if part.comm is not None:
            part.comm._reply_subshell_for = lambda data, default: default


class _Both:
    def __init__(self, widget, still):
        self._model, self._still = widget.model_id, still

    def _repr_mimebundle_(self, include=None, exclude=None) -> dict:
        view = {'version_major': 2, 'version_minor': 0, 'model_id': self._model}
        return {**self._still._repr_mimebundle_(), VIEW: view}

    def __repr__(self) -> str:
        return repr(self._still)
