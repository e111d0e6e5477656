"""A pytest plugin for nbval: tests have the names of their cells, and kernels have sockets of their own.

The numbers of the cells of a repeated notebook mean nothing.
"""

import nbval.kernel
import pytest
from nbval.plugin import IPyNbCell, IPyNbFile

from grading.authoring.kernels import LocalKernelManager

nbval.kernel.KernelManager = LocalKernelManager  # nbval has no option for it


class NamedCell(IPyNbCell):
    """One cell, reported as ``ex-3-1-second`` instead of ``Cell 93``."""

    def reportinfo(self):
        """Return path, line and the text of the report's heading."""
        return self.path, 0, f'{self.parent.name}::{self.name}'


class NamedNotebook(IPyNbFile):
    """One notebook."""

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
