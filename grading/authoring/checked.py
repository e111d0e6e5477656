"""Checked statements: assertions about a demonstration, which run in the same kernel directly after its cell.

The build and CI run them, no notebook shows them. In the source they are a code cell with ``:checked: true`` directly
below the demonstration::

    ```{code-cell} ipython3
    :checked: true
    assert received == ['hello']
    assert 'incompatible' in printed
    ```

They see all names of the notebook, and `printed`, the text that the cell above has printed and displayed. What they
assign is gone afterwards, so that no other cell can rely on it. The solved notebook keeps them in the metadata of the
demonstration.

This module runs inside the kernel; nothing is imported here that the notebook itself might not have imported.
"""

from IPython import get_ipython

KEY = 'checked'  # of a cell's metadata
_LATE = 5.0  # s in which log lines of the cell above may still come: they take a pipe and a thread of the kernel's
_now: list[str] = []  # the texts of the cell that runs
_before: list[str] = []  # and of the one before it


def code(source: str, path: str = '', line: int = 1) -> str:
    """Return the code that runs the statements `source`, which begin in `line` of `path`, in a kernel."""
    return f'from grading.authoring.checked import run as _run_checked\n_run_checked({source!r}, {path!r}, {line})'


RECORD = 'from grading.authoring.checked import record as _record\n_record()'


def record() -> None:
    """Take down from now on what each cell prints and displays."""
    session = get_ipython().kernel.session
    if hasattr(session, 'send_unrecorded'):
        return
    session.send_unrecorded = send = session.send

    def recording(stream, msg_or_type, content=None, *args, **kwargs):
        kind = msg_or_type if isinstance(msg_or_type, str) else msg_or_type.get('msg_type')
        _note(kind, content if isinstance(msg_or_type, str) else msg_or_type.get('content'))
        return send(stream, msg_or_type, content, *args, **kwargs)

    session.send = recording


def run(source: str, path: str, line: int) -> None:
    """Run the statements; all of them again if one does not hold and late text of the cell above arrives.

    :raises AssertionError: one does not hold; its message has the statement, and what the cell above has printed.
    """
    import ast
    import time

    tree = ast.increment_lineno(ast.parse(source), line - 1)
    end = time.monotonic() + _LATE
    while True:
        printed = ''.join([*_before, *_now])
        try:
            _run(tree, path, printed)
            return
        except AssertionError:
            while printed == ''.join([*_before, *_now]):
                if time.monotonic() > end:
                    raise
                time.sleep(0.01)


def _run(tree, path: str, printed: str) -> None:
    import ast

    names = {**get_ipython().user_ns, 'printed': printed}
    for statement in tree.body:
        try:
            exec(compile(ast.Module([statement], []), path or '<checked>', 'exec'), names)
        except AssertionError as error:
            said = f' ({error})' if str(error) else ''
            raise AssertionError(
                f'line {statement.lineno}: {ast.unparse(statement)}{said}; printed: {printed!r}'
            ) from None


def _note(kind: str, content: dict | None) -> None:
    """Take down one message of the kernel."""
    if kind == 'execute_input':  # the next cell begins
        _before[:] = _now
        _now.clear()
    elif kind == 'stream' and content:
        _now.append(content['text'])
    elif kind in ('execute_result', 'display_data') and content:
        _now.append(f'{content["data"].get("text/plain", "")}\n')
    elif kind == 'error' and content:
        _now.append(f'{content["ename"]}: {content["evalue"]}\n')
