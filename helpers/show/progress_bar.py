"""A progress bar for an action: live while feedback comes, still in the saved notebook, a line of text elsewhere."""

import html
import threading

_WIDTH = 20  # characters of the bar as text


class Bar:
    """What Jupyter shows of a `ProgressBar` at one moment."""

    def __init__(self, label: str, share: float, note: str):
        self.label, self.share, self.note = label, share, note

    def __str__(self) -> str:
        full = round(self.share * _WIDTH)
        return f'{self.label} [{"#" * full}{"." * (_WIDTH - full)}] {self.share:4.0%}  {self.note}'.rstrip()

    __repr__ = __str__

    def _repr_mimebundle_(self, include=None, exclude=None) -> dict[str, str]:
        label, note = html.escape(self.label), html.escape(self.note)
        return {
            'text/plain': str(self),
            'text/html': f'<div>{label} <progress value="{self.share:.3f}" max="1"></progress> '
            f'{self.share:.0%} &nbsp;{note}</div>',
        }


class ProgressBar:
    """Show how far something is, in the output of this cell.

    ::

        bar = ProgressBar('counting')
        client.send_goal_async(goal, lambda message: bar.update(len(message.feedback.sequence) / 10))
        …
        bar.update(1.0, 'succeeded')

    Callbacks of background nodes may call `update`, in any thread. Outside of a notebook each new tenth is printed.
    """

    def __init__(self, label: str = ''):
        from IPython import get_ipython

        self._label = label
        self._lock = threading.Lock()
        self._handle = None
        self._printed = -1
        self.share = 0.0  #: how far it is, 0 … 1
        self.note = ''
        self._in_notebook = get_ipython() is not None
        self.update(0.0)

    def update(self, share: float, note: str = '') -> None:
        """Show a new state.

        :param share: 0 … 1; what is outside is shown as the nearest of both.
        :param note: a few words beside the bar, such as the status.
        """
        with self._lock:
            self.share, self.note = min(1.0, max(0.0, share)), note
            self._show()

    def _show(self) -> None:
        bar = Bar(self._label, self.share, self.note)
        if self._handle is not None:
            self._handle.update(bar)
        elif self._in_notebook:
            from IPython.display import display

            self._handle = display(bar, display_id=True)
        elif int(10 * self.share) != self._printed or self.note:
            self._printed = int(10 * self.share)
            print(bar)

    def __repr__(self) -> str:
        return str(Bar(self._label, self.share, self.note))
