"""Makes nbval's kernel keep a value to itself where a cell ends with ``;``, as in JupyterLab.

IPython looks for the semicolon in its history, and nbval executes without one (``store_history=False``).
"""

from IPython import get_ipython


def honour() -> None:
    """Let IPython look at the running cell instead."""
    shell = get_ipython()
    running = ['']
    shell.events.register('pre_run_cell', lambda info: running.__setitem__(0, info.raw_cell or ''))
    shell.displayhook.quiet = lambda: shell.displayhook.semicolon_at_end_of_expression(running[0])
