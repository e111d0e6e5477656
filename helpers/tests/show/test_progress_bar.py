"""The progress bar: as text, in a notebook, outside of one."""

from helpers.show.progress_bar import Bar, ProgressBar


def test_bar_as_text_and_html():
    bar = Bar('a < b', 0.25, 'step 1')
    assert str(bar) == 'a < b [#####...............]  25%  step 1'
    shown = bar._repr_mimebundle_()
    assert shown['text/plain'] == str(bar)
    assert 'a &lt; b' in shown['text/html'] and 'value="0.250"' in shown['text/html']


def test_outside_of_a_notebook_each_tenth_is_printed_once(capsys):
    bar = ProgressBar('count')
    for step in range(101):
        bar.update(step / 100)
    bar.update(7.0, 'succeeded')
    lines = capsys.readouterr().out.splitlines()
    assert len(lines) == 12
    assert lines[0] == 'count [....................]   0%'
    assert lines[-1] == repr(bar) == 'count [####################] 100%  succeeded'


def test_in_a_notebook_one_output_is_updated(monkeypatch):
    import IPython
    import IPython.display

    class Handle:
        shown = []

        def update(self, bar):
            self.shown.append(str(bar))

    monkeypatch.setattr(IPython, 'get_ipython', lambda: object())
    monkeypatch.setattr(IPython.display, 'display', lambda bar, display_id: Handle())
    bar = ProgressBar('turn')
    bar.update(0.5)
    bar.update(-1.0, 'canceled')
    assert Handle.shown == ['turn [##########..........]  50%', 'turn [....................]   0%  canceled']
