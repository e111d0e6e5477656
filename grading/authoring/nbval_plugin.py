"""A pytest plugin for nbval. conftest.py loads it whenever nbval runs, so that the plain command passes:

    pytest --nbval -n 4 solutions

Outputs are English and compared without what differs from run to run, a semicolon hides a value as in JupyterLab, the
cells of one notebook stay in one kernel, tests have the names of their cells (the numbers of the cells of a repeated
notebook mean nothing), kernels have sockets of their own, and several workers begin with what takes longest.
"""

import os
import tempfile

import nbval.kernel
import pytest
from nbval.plugin import IPyNbCell, IPyNbFile

from grading.authoring import outputs, repeated
from grading.authoring.kernels import LocalKernelManager
from helpers import paths
from helpers.programs.english import ENGLISH

nbval.kernel.KernelManager = LocalKernelManager  # nbval has no option for it
PREPARE = 'from grading.authoring import semicolons\nsemicolons.honour()\ndel semicolons'
PATIENCE = 60.0  # s, for a kernel that has just started


class NamedCell(IPyNbCell):
    """One cell, reported as ``ex-3-1-second`` instead of ``Cell 93``."""

    def reportinfo(self):
        """Return path, line and the text of the report's heading."""
        return self.path, 0, f'{self.parent.name}::{self.name}'


class NamedNotebook(IPyNbFile):
    """One notebook."""

    def setup(self):
        """Start the kernel and prepare it."""
        super().setup()
        sent = self.kernel.execute_cell_input(PREPARE, allow_stdin=False)
        self.kernel.await_reply(sent, timeout=PATIENCE)
        self.kernel.await_idle(sent, PATIENCE)

    def collect(self):
        """Yield the tests that nbval would, under their cells' ids."""
        for item in super().collect():
            yield NamedCell.from_parent(
                self, name=item.cell.get('id', item.name), cell_num=item.cell_num, cell=item.cell, options=item.options
            )


@pytest.hookimpl(wrapper=True)
def pytest_collect_file(file_path, parent):
    """Put NamedNotebook in the place of nbval's class."""
    collectors = yield
    return [
        NamedNotebook.from_parent(parent, path=file_path) if type(collector) is IPyNbFile else collector
        for collector in collectors
    ]


def pytest_configure(config):
    """Let kernels speak English, and nbval compare as the build does, unless the command line says how."""
    os.environ.update(ENGLISH)
    if config.option.nbval_sanitize_with is None:
        file = tempfile.NamedTemporaryFile('w', prefix='course-nbval-', suffix='.cfg', encoding='utf-8')
        config.add_cleanup(file.close)
        file.write(outputs.nbval_config(paths.ROOT))
        file.flush()
        config.option.nbval_sanitize_with = file.name
    if getattr(config.option, 'loadscopereorder', False):  # there is xdist; it would begin with those of most cells
        config.option.loadscopereorder = False


@pytest.hookimpl(trylast=True)  # after conftest's own order, which is that of tests
def pytest_collection_modifyitems(items):
    """Begin in an order in which no notebook is left to run alone at the end, with the processors idle."""
    last = repeated.TWICE[-1]
    twice = {item.path for item in items if item.name.endswith(f'-{last}')}
    places = {chapter: place for place, chapter in enumerate(repeated.ORDER)}
    items.sort(key=lambda item: (item.path not in twice, places.get(item.path.name[:2], len(places))))


@pytest.hookimpl(optionalhook=True)
def pytest_xdist_make_scheduler(config, log):
    """Give all cells of a notebook to one worker; xdist's own default would spread them over several kernels."""
    from xdist.scheduler import LoadFileScheduling

    return LoadFileScheduling(config, log) if config.getvalue('dist') in ('load', 'loadscope') else None
