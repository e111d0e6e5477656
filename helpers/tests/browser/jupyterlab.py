"""JupyterLab on a copy of the notebooks, and a page of headless Chromium that works in it as a learner does."""

import os
import re
import shutil
import signal
import socket
import subprocess
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from importlib.util import find_spec
from pathlib import Path

import pytest

from environment.setup import facts
from helpers import paths
from helpers.cli import lab
from helpers.exercises import start_page
from helpers.tests.browser import failure_traces

_found = facts.browser()
CHROMIUM = _found.text if _found.ok else None
# Marks of the tests that need them. Neither belongs to the course, so a learner's machine may have none.
NEEDED = [
    pytest.mark.skipif(not CHROMIUM, reason=f'no Chromium for the tests in a browser; {_found.remedy}'),
    pytest.mark.skipif(
        not find_spec('playwright'),
        reason='no Playwright for the tests in a browser; run: .venv/bin/pip install -r environment/browser.lock',
    ),
]
# No display, no GPU; and no connections of the browser's own. WebGL is computed by SwiftShader, which is slow: so pages
# are composed without it.
FLAGS = [
    '--no-sandbox',
    '--use-gl=angle',
    '--use-angle=swiftshader',
    '--enable-unsafe-swiftshader',
    '--disable-gpu-compositing',
    '--disable-quic',
    '--no-first-run',
    '--disable-background-networking',
    '--disable-component-update',
    '--disable-sync',
]
# ms, for one step and for a whole notebook. Ample, as the machine may have much else to do; only failures wait so long.
PATIENCE = 120_000
LONG = 600_000
MOST_TABS = 200  # so many presses reach everything of the start page


def copy_notebooks(folder: Path) -> Path:
    """The learner's notebooks with their figures and the start page, in a folder of their own."""
    for path in paths.NOTEBOOKS.glob('*.ipynb'):
        shutil.copy2(path, folder)
    shutil.copytree(paths.NOTEBOOKS / 'figures', folder / 'figures')
    for name, _ in start_page.PAGES:
        shutil.copy2(paths.NOTEBOOKS / name, folder)
    start_page.write(folder)
    return folder


@contextmanager
def served(folder: Path, private: Path, file: str = start_page.FILE) -> Iterator[str]:
    """Serve `folder` with the arguments of `./course lab`; yields the address of `file` in JupyterLab, with its token.

    `private`: where Jupyter keeps its settings and its memory of open tabs, and where its log goes.
    """
    log = private / 'lab.log'
    failure_traces.also(log)
    folders = {f'JUPYTER_{name}_DIR': str(private / name) for name in ('RUNTIME', 'CONFIG', 'DATA')}
    environment = {**os.environ, **folders, 'JUPYTERLAB_WORKSPACES_DIR': str(private / 'workspaces')}
    lab.use_own_kernel(environment)
    with socket.socket() as probe:
        probe.bind(('127.0.0.1', 0))
        port = probe.getsockname()[1]
    # The last one, so that a test can ask JupyterLab whether all cells have run.
    arguments = [*lab.arguments(port, True, True, f'/lab/tree/{file}', folder), '--LabApp.expose_app_in_browser=True']
    with (
        log.open('w') as output,
        subprocess.Popen(
            [sys.executable, *arguments], cwd=folder, env=environment, stdout=output, stderr=subprocess.STDOUT
        ) as server,
    ):
        try:
            yield _address(server, log, port)
        finally:
            server.send_signal(signal.SIGTERM)
            try:
                server.wait(30)
            except subprocess.TimeoutExpired:
                server.kill()


def _address(server: subprocess.Popen, log: Path, port: int, patience: float = PATIENCE / 1000) -> str:
    end = time.monotonic() + patience
    while time.monotonic() < end and server.poll() is None:
        if found := re.search(rf'http://127\.0\.0\.1:{port}/\S+', log.read_text()):
            with socket.socket() as probe:
                if probe.connect_ex(('127.0.0.1', port)) == 0:
                    return found[0]
        time.sleep(0.1)
    raise RuntimeError(f'JupyterLab did not start: {log.read_text()[-2000:]}')


def wait_for_file(path: Path, patience: float = PATIENCE / 1000) -> None:
    """Until there is a file.

    :raises TimeoutError: it does not come.
    """
    end = time.monotonic() + patience
    while not path.exists():
        if time.monotonic() > end:
            raise TimeoutError(f'{path} does not come')
        time.sleep(0.1)


class Learner:
    """Someone at the keyboard. `page`: a Playwright page that shows JupyterLab.

    JupyterLab draws only the cells near the visible part; so whatever concerns a cell scrolls to it first.
    """

    def __init__(self, page):
        self.page = failure_traces.watch(page)
        self._started: dict = {}  # by cell: its index, and its count before
        page.set_default_timeout(PATIENCE)

    def open(self, address: str, workspace: str = 'default') -> None:
        """Open the start page, in a workspace of that name: JupyterLab remembers the tabs of each one."""
        self.page.goto(address.replace('/lab/', f'/lab/workspaces/{workspace}/', 1))
        self.page.locator('.jp-RenderedMarkdown h1').first.wait_for()

    def open_notebook(self, address: str) -> None:
        """Open the notebook at this address, and wait for its kernel.

        In a workspace of its own: else JupyterLab brings back another notebook's tab, which may come to the front.
        """
        name = address.partition('?')[0].rpartition('/')[2].partition('.')[0]
        self.page.goto(address.replace('/lab/', f'/lab/workspaces/{name}/', 1))
        self.page.locator('.jp-NotebookPanel:not(.lm-mod-hidden)').first.wait_for()
        self.wait_until_idle()

    def open_terminal(self) -> None:
        """Menu: File, New, Terminal; it has the keyboard then. Terminals that are open already stay as they are."""
        before = self.page.evaluate(_TERMINALS)
        self.page.get_by_role('menuitem', name='File', exact=True).click()
        for entry in ('New', 'Terminal'):
            self.page.locator('.lm-Menu-itemLabel').get_by_text(entry, exact=True).click()
        opened = self.page.wait_for_function(f'before => ({_TERMINALS})().find(id => !before.includes(id))', arg=before)
        self.page.locator(f'#{opened.json_value()} .xterm-screen').click()

    def type_lines(self, text: str) -> None:
        """Type lines into the terminal, each with Enter."""
        for line in text.split('\n'):
            self.page.keyboard.insert_text(line)
            self.page.keyboard.press('Enter')

    def restart(self) -> None:
        """Restart the kernel of the notebook: 0, 0, and Enter in the dialog."""
        self.page.evaluate(_NOTE_RESTART)
        for key in ('Escape', '0', '0'):
            self.page.keyboard.press(key)
        self.page.locator('.jp-Dialog .jp-mod-accept').click()
        self.page.wait_for_function('window.restarted')
        self.wait_until_idle()

    def follow(self, link: str) -> None:
        """Follow a link of the start page that leads to a notebook, by Tab and Enter, and wait for its kernel."""
        for _ in range(MOST_TABS):
            self.page.keyboard.press('Tab')
            if self.page.evaluate(_FOCUSED).startswith(link):
                break
        else:
            raise LookupError(f'Tab does not reach a link {link!r}')
        self.page.keyboard.press('Enter')
        self.page.locator('.jp-NotebookPanel:not(.lm-mod-hidden)').first.wait_for()
        self.wait_until_idle()

    def start_all(self) -> None:
        """Menu: Run, Run All Cells."""
        self.page.get_by_role('menuitem', name='Run', exact=True).click()
        self.page.get_by_role('menuitem', name='Run All Cells', exact=True).click()

    def wait_until_all_ran(self) -> None:
        """Until the last cell has run, or one has failed: JupyterLab does not run those below."""
        self.page.wait_for_function(_ALL_RUN, timeout=LONG)
        self.wait_until_idle()

    def wait_until_idle(self) -> None:
        """Until the kernel has started and has nothing to do. A cell that is run before is silently not run."""
        self.page.wait_for_function(_IDLE)

    def write(self, cell: str, source: str) -> None:
        """Replace the text of the cell with this id, typing it character by character.

        :raises ValueError: the cell has another text afterwards, since the editor added something.
        """
        index = self._go_to(cell)
        keyboard = self.page.keyboard
        for key in ('Escape', 'Enter', 'Control+A', 'Delete'):
            keyboard.press(key)
        for number, line in enumerate(source.split('\n')):
            if number:
                for key in ('Enter', 'Shift+Home', 'Delete'):  # the editor indents by itself
                    keyboard.press(key)
            keyboard.type(line)
        written = self.page.evaluate(_SOURCE, index)
        if written != source:
            raise ValueError(f'typed {source!r}, the cell shows {written!r}')

    def add(self, source: str) -> str:
        """Write a cell below the active one, run it and return its id."""
        self.page.keyboard.press('Escape')
        before = len(self.sources())
        self.page.keyboard.press('b')
        self.page.wait_for_function(_MORE_THAN, arg=before)
        cell = self.page.evaluate(_ACTIVE)
        self._active.locator('.cm-content').click()
        self.page.keyboard.insert_text(source)
        self.run(cell)
        return cell

    def run(self, cell: str) -> None:
        """Run the cell with this id by Shift+Enter, and wait for its end."""
        self.start(cell)
        self.wait_until_ran(cell)

    def start(self, cell: str) -> None:
        """Run the cell with this id by Shift+Enter."""
        index = self._go_to(cell)
        self._started[cell] = index, self.page.evaluate(_COUNT, index)
        self.page.evaluate(_LEAVE_VIEW)
        self.page.keyboard.press('Escape')
        self.page.keyboard.press('Shift+Enter')

    def wait_until_ran(self, cell: str) -> None:
        """Until the cell that was started has ended."""
        self.page.wait_for_function(_RAN_AGAIN, arg=[*self._started.pop(cell)])

    def sees(self, cell: str, text) -> None:
        """Wait until the output of the cell with this id shows `text`, a string or a pattern.

        :raises AssertionError: it does not come; the message has what is there.
        """
        from playwright.sync_api import expect

        expect(self.output(cell)).to_contain_text(text, use_inner_text=True, timeout=PATIENCE)

    def output(self, cell: str):
        """What is below the cell with this id, as a Playwright locator; good until another cell is active."""
        self._go_to(cell)
        return self._active.locator('.jp-Cell-outputArea')

    def save(self) -> None:
        self.page.keyboard.press('Escape')
        self.page.keyboard.press('Control+S')
        self.page.wait_for_function(_SAVED)

    def sources(self) -> dict[str, str]:
        """Source by cell id, of the notebook as it is now."""
        return dict(self.page.evaluate(_SOURCES))

    def outputs(self) -> dict[str, list]:
        """Outputs (as nbformat has them) by cell id."""
        return dict(self.page.evaluate(_OUTPUTS))

    def _go_to(self, cell: str) -> int:
        index = self.page.evaluate(_ACTIVATE, cell)
        if index < 0:
            raise LookupError(f'the notebook has no cell {cell!r}')
        self.page.wait_for_function(_DRAWN, arg=index, polling=200)
        self._active.scroll_into_view_if_needed()
        return index

    @property
    def _active(self):
        return self.page.locator('.jp-NotebookPanel:not(.lm-mod-hidden) .jp-Cell.jp-mod-active')


# JupyterLab shows its application as `jupyterapp` only when asked to (--expose-app-in-browser).
_NOTEBOOK = 'window.jupyterapp.shell.currentWidget.content'
_IDLE = """() => {
    const context = window.jupyterapp.shell.currentWidget.sessionContext;
    const kernel = context?.session?.kernel;
    return context?.isReady && kernel?.connectionStatus === "connected" && kernel.status === "idle";
}"""
_ALL_RUN = f"""() => {{
    const cells = {_NOTEBOOK}.widgets.map(cell => cell.model).filter(model => model.type === "code");
    const stops = model => !(model.getMetadata("tags") ?? []).includes("raises-exception")
        && model.outputs.toJSON().some(output => output.output_type === "error");
    return cells.every(model => model.executionCount !== null && model.executionState !== "running")
        || cells.some(stops);
}}"""
_NOTE_RESTART = """() => {
    window.restarted = false;
    const context = window.jupyterapp.shell.currentWidget.sessionContext;
    context.statusChanged.connect((_, status) => { window.restarted ||= status.includes("starting"); });
}"""
# Who has clicked into a view (an iframe) has the keyboard there.
_LEAVE_VIEW = f'() => {{ if (document.activeElement?.tagName === "IFRAME") {_NOTEBOOK}.activate(); }}'
_COUNT = f'(index) => {_NOTEBOOK}.widgets[index].model.executionCount'
# JupyterLab sets the new number when all output has come.
_RAN_AGAIN = f"""([index, before]) => {{
    const count = {_NOTEBOOK}.widgets[index].model.executionCount;
    return count !== null && count !== before;
}}"""
_SOURCE = f'(index) => {_NOTEBOOK}.widgets[index].model.sharedModel.getSource()'
_TERMINALS = '() => [...document.querySelectorAll(".jp-Terminal")].map(terminal => terminal.id)'
_FOCUSED = '() => document.activeElement?.tagName === "A" ? document.activeElement.textContent : ""'
_MORE_THAN = f'(count) => {_NOTEBOOK}.widgets.length > count'
_ACTIVE = f'() => {_NOTEBOOK}.activeCell.model.id'
_SAVED = '() => !window.jupyterapp.shell.currentWidget.context.model.dirty'
_SOURCES = f'() => {_NOTEBOOK}.widgets.map(cell => [cell.model.id, cell.model.sharedModel.getSource()])'
_OUTPUTS = f"""() => {_NOTEBOOK}.widgets.filter(cell => cell.model.type === "code")
    .map(cell => [cell.model.id, cell.model.outputs.toJSON()])"""
# On a busy machine JupyterLab may forget to scroll to a cell that is far away, and then does not draw it.
_DRAWN = f"""(index) => {{
    const notebook = {_NOTEBOOK};
    if (notebook.widgets[index].node.isConnected) return true;
    notebook.scrollToItem(index, "center");
    return false;
}}"""
_ACTIVATE = f"""(id) => {{
    const notebook = {_NOTEBOOK};
    const index = notebook.widgets.findIndex(cell => cell.model.id === id);
    if (index >= 0) {{ notebook.activeCellIndex = index; notebook.deselectAll(); }}
    return index;
}}"""
