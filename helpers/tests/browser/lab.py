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
from pathlib import Path

from helpers import paths, start_page
from helpers.cli import lab

CHROMIUM = shutil.which('chromium') or shutil.which('chromium-browser')
# No display, no GPU; and no connections of the browser's own.
FLAGS = ['--no-sandbox', '--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--disable-quic',
         '--no-first-run', '--disable-background-networking', '--disable-component-update', '--disable-sync']
PATIENCE = 60_000  # ms, for one step; LONG for a whole notebook on a busy machine
LONG = 240_000


def copy_notebooks(folder: Path) -> Path:
    """The learner's notebooks and the start page, in a folder of their own."""
    for path in paths.NOTEBOOKS.glob('*.ipynb'):
        shutil.copy2(path, folder)
    start_page.write(folder)
    return folder


@contextmanager
def served(folder: Path, private: Path) -> Iterator[str]:
    """Serve `folder` with the arguments of `./course lab`; yields the address with its token.

    `private`: where Jupyter keeps its settings and its memory of open tabs, and where its log goes.
    """
    log = private / 'lab.log'
    folders = {f'JUPYTER_{name}_DIR': str(private / name) for name in ('RUNTIME', 'CONFIG', 'DATA')}
    environment = {**os.environ, **folders,
                   'JUPYTERLAB_WORKSPACES_DIR': str(private / 'workspaces'), 'JUPYTER_PREFER_ENV_PATH': '1'}
    with socket.socket() as probe:
        probe.bind(('127.0.0.1', 0))
        port = probe.getsockname()[1]
    # The last one, so that a test can ask JupyterLab whether all cells have run.
    arguments = [*lab.arguments(port, True, True, f'/lab/tree/{start_page.FILE}', folder),
                 '--LabApp.expose_app_in_browser=True']
    with log.open('w') as output, subprocess.Popen([sys.executable, *arguments], cwd=folder, env=environment,
                                                   stdout=output, stderr=subprocess.STDOUT) as server:
        try:
            yield _address(server, log, port)
        finally:
            server.send_signal(signal.SIGTERM)
            try:
                server.wait(30)
            except subprocess.TimeoutExpired:
                server.kill()


def _address(server: subprocess.Popen, log: Path, port: int, patience: float = 60.0) -> str:
    end = time.monotonic() + patience
    while time.monotonic() < end and server.poll() is None:
        if found := re.search(rf'http://127\.0\.0\.1:{port}/\S+', log.read_text()):
            with socket.socket() as probe:
                if probe.connect_ex(('127.0.0.1', port)) == 0:
                    return found[0]
        time.sleep(0.1)
    raise RuntimeError(f'JupyterLab did not start: {log.read_text()[-2000:]}')


class Learner:
    """Someone at the keyboard. `page`: a Playwright page that shows JupyterLab.

    JupyterLab draws only the cells near the visible part; so whatever concerns a cell scrolls to it first.
    """

    def __init__(self, page):
        self.page = page
        page.set_default_timeout(PATIENCE)

    def open(self, address: str) -> None:
        self.page.goto(address)
        self.page.locator('.jp-RenderedMarkdown h1').first.wait_for()

    def follow(self, link: str) -> None:
        """Click on a link of the start page that leads to a notebook, and wait for its kernel."""
        self.page.locator('.jp-RenderedMarkdown').get_by_role('link', name=link).first.click()
        # JupyterLab may have opened others again, which an earlier page left open.
        self.page.locator('.jp-NotebookPanel:not(.lm-mod-hidden)').first.wait_for()
        self.wait_until_idle()

    def run_all(self) -> None:
        """Menu: Run, Run All Cells; returns when the last cell has run."""
        self.page.get_by_role('menuitem', name='Run', exact=True).click()
        self.page.get_by_role('menuitem', name='Run All Cells', exact=True).click()
        self.page.wait_for_function(_ALL_RUN, timeout=LONG)
        self.wait_until_idle()

    def wait_until_idle(self) -> None:
        """Until the kernel has started and has nothing to do. A cell that is run before is silently not run."""
        self.page.wait_for_function(_IDLE)

    def write(self, cell: str, source: str) -> None:
        """Put `source` into the cell with this id, by the keyboard, and run it."""
        self._go_to(cell)
        self._active.locator('.cm-content').click()
        self.page.keyboard.press('Control+A')
        self.page.keyboard.insert_text(source)
        self.page.keyboard.press('Shift+Enter')

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

    def run(self, cell: str) -> str:
        """Run the cell with this id and return the text of its output."""
        index = self._go_to(cell)
        self.page.keyboard.press('Escape')
        self.page.keyboard.press('Control+Enter')
        self.page.wait_for_function(_HAS_RUN, arg=index)
        self.wait_until_idle()
        return self.output(cell).inner_text()

    def output(self, cell: str):
        """What is below the cell with this id, as a Playwright locator; good until another cell is active."""
        self._go_to(cell)
        return self._active.locator('.jp-Cell-outputArea')

    def save(self) -> None:
        self.page.keyboard.press('Escape')
        self.page.keyboard.press('Control+S')
        self.page.locator('.jp-NotebookPanel:not(.lm-mod-hidden)').first.wait_for()
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
        self._active.scroll_into_view_if_needed()
        return index

    @property
    def _active(self):
        return self.page.locator('.jp-NotebookPanel:not(.lm-mod-hidden) .jp-Cell.jp-mod-active')


# JupyterLab shows its application as `jupyterapp` only when asked to (--expose-app-in-browser).
_NOTEBOOK = 'window.jupyterapp.shell.currentWidget.content'
_IDLE = '''() => {
    const context = window.jupyterapp.shell.currentWidget.sessionContext;
    const kernel = context?.session?.kernel;
    return context?.isReady && kernel?.connectionStatus === "connected" && kernel.status === "idle";
}'''
_ALL_RUN = f'''() => {_NOTEBOOK}.widgets.every(cell => cell.model.type !== "code"
    || (cell.model.executionCount !== null && cell.model.executionState !== "running"))'''
_HAS_RUN = f'(index) => {_NOTEBOOK}.widgets[index].model.executionCount !== null'
_MORE_THAN = f'(count) => {_NOTEBOOK}.widgets.length > count'
_ACTIVE = f'() => {_NOTEBOOK}.activeCell.model.id'
_SAVED = '() => !window.jupyterapp.shell.currentWidget.context.model.dirty'
_SOURCES = f'() => {_NOTEBOOK}.widgets.map(cell => [cell.model.id, cell.model.sharedModel.getSource()])'
_OUTPUTS = f'''() => {_NOTEBOOK}.widgets.filter(cell => cell.model.type === "code")
    .map(cell => [cell.model.id, cell.model.outputs.toJSON()])'''
_ACTIVATE = f'''(id) => {{
    const notebook = {_NOTEBOOK};
    const index = notebook.widgets.findIndex(cell => cell.model.id === id);
    if (index >= 0) {{ notebook.activeCellIndex = index; notebook.deselectAll(); }}
    return index;
}}'''
