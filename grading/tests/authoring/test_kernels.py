"""Kernels of the build and of nbval get no TCP ports, which another kernel could be given at the same time, too."""

import ast
from pathlib import Path

import nbformat
from nbclient import NotebookClient

from grading.authoring import nbval_plugin
from grading.authoring.kernels import AsyncLocalKernelManager, LocalKernelManager

WHERE = 'import ipykernel, json\nwhere = json.loads(ipykernel.get_connection_info())\nwhere["transport"], where["ip"]'


def test_nbval_starts_kernels_on_sockets_of_their_own_and_leaves_none():
    manager, client = nbval_plugin.nbval.kernel.start_new_kernel(kernel_name='python3')
    try:
        folder = Path(manager.ip).parent
        assert client.transport == 'ipc' and len(list(folder.iterdir())) == 5
    finally:
        client.stop_channels()
        manager.shutdown_kernel(now=True)
    assert not folder.exists()


def test_the_build_runs_notebooks_on_sockets_of_their_own():
    notebook = nbformat.v4.new_notebook(cells=[nbformat.v4.new_code_cell(WHERE)])
    NotebookClient(notebook, kernel_name='python3', kernel_manager_class=AsyncLocalKernelManager).execute()
    transport, place = ast.literal_eval(notebook.cells[0].outputs[0]['data']['text/plain'])
    assert transport == 'ipc' and Path(place).parent.name.startswith('course-kernel-')


def test_a_kernel_that_is_restarted_keeps_its_sockets():
    manager = LocalKernelManager(kernel_name='python3')
    manager.start_kernel()
    try:
        manager.restart_kernel(now=True)
        client = manager.client()
        client.start_channels()
        client.wait_for_ready(timeout=60)
        client.stop_channels()
    finally:
        manager.shutdown_kernel(now=True)
    assert not Path(manager.ip).parent.exists()
