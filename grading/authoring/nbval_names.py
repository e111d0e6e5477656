"""A pytest plugin that names nbval's tests by cell id: the numbers of a repeated notebook mean nothing."""


def pytest_itemcollected(item):
    """Rename ``Cell 93`` to ``ex-3-1-second``."""
    cell = getattr(item, 'cell', None)
    if cell is not None and 'id' in cell:
        item.name = cell['id']
        item._nodeid = f'{item.parent.nodeid}::{item.name}'
