"""Runs a chapter's solved notebook in a kernel of its own, in a ROS domain of its own."""

import os
import re
from collections.abc import Mapping
from pathlib import Path

from jupyter_client.kernelspec import KernelSpecManager, NoSuchKernel
from nbclient import NotebookClient
from nbclient.exceptions import CellExecutionError, CellTimeoutError, DeadKernelError
from nbformat import NotebookNode

from grading.authoring.chapter import Chapter
from grading.authoring.errors import AuthoringError
from helpers.kernel import domains

KERNEL = 'course'  # the kernelspec of the set-up; also what nbval uses
CELL_TIMEOUT = 60  # seconds
ANSI = re.compile(r'\x1b\[[0-9;]*m')


def kernel_name() -> str:
    """Return the course's kernelspec, or python3 where the set-up has not installed it."""
    try:
        KernelSpecManager().get_kernel_spec(KERNEL)
    except NoSuchKernel:
        return 'python3'
    return KERNEL


def execute(
    notebook: NotebookNode,
    chapter: Chapter,
    folder: Path,
    timeout: float = CELL_TIMEOUT,
    environment: Mapping[str, str] | None = None,
) -> None:
    """Run all cells of ``notebook``, the solved form of ``chapter``, in ``folder`` and fill in the outputs.

    :param timeout: longest time of one cell, in seconds.
    :param environment: variables for the kernel beside those of this process.
    :raises AuthoringError: a cell failed or took too long; the message names the line in the source.
    """
    metadata = dict(notebook.metadata)
    client = NotebookClient(
        notebook,
        timeout=timeout,
        kernel_name=kernel_name(),
        record_timing=False,
        extra_arguments=['--log-level=ERROR'],
        resources={'metadata': {'path': str(folder)}},
    )
    with domains.claim() as domain_id:
        try:
            client.execute(
                env={**os.environ, **(environment or {}), 'ROS_DOMAIN_ID': str(domain_id), 'COURSE_PROGRESS': 'off'}
            )
        except (CellExecutionError, CellTimeoutError, DeadKernelError) as error:
            raise _explain(error, notebook, chapter, timeout) from None
    notebook.metadata.clear()
    notebook.metadata.update(metadata)  # nbclient writes the kernel's version there


def _explain(error, notebook, chapter, timeout) -> AuthoringError:
    # nbclient numbers the executed cells from 1: the failing one has the highest count, or is the one still without.
    code = [(number, cell) for number, cell in enumerate(notebook.cells) if cell.cell_type == 'code']
    failed = [
        number
        for number, cell in code
        if any(out.output_type == 'error' for out in cell.outputs)
        and 'raises-exception' not in cell.metadata.get('tags', [])
    ]
    running = [number for number, cell in code if cell.execution_count is None]
    index = failed[0] if failed else running[0] if running else code[-1][0]
    cell, identifier = chapter.cells[index], notebook.cells[index].id
    place = f'cell {index + 1} ({identifier})'
    if isinstance(error, CellTimeoutError):
        return AuthoringError(chapter.path, cell.line, f'{place} took more than {timeout:g} s', 'bound its waits')
    if isinstance(error, DeadKernelError):
        return AuthoringError(chapter.path, cell.line, f'{place} ended the kernel', 'find what aborts the process')
    lines = re.findall(r'Cell In\[\d+\], line (\d+)', ANSI.sub('', error.traceback))
    line = cell.source_line(int(lines[0])) if lines else cell.line
    return AuthoringError(
        chapter.path,
        line,
        f'{place} failed with {error.ename}: {error.evalue}',
        'correct it, or tag the cell raises-exception if the error is the lesson',
    )
