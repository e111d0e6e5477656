"""Runs a chapter's solved notebook in a kernel of its own, in a ROS domain of its own."""

import os
import re
import shutil
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from jupyter_client.kernelspec import KernelSpecManager, NoSuchKernel
from nbclient import NotebookClient
from nbclient.exceptions import CellExecutionError, CellTimeoutError, DeadKernelError
from nbformat import NotebookNode

from grading.authoring import checked
from grading.authoring.chapter import Chapter, SourceCell
from grading.authoring.chapter_errors import AuthoringError
from grading.authoring.kernels import AsyncLocalKernelManager
from helpers.kernel import domains
from helpers.programs.english import ENGLISH

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

    A package in ``folder`` that is somebody's answer to an exercise is as before afterwards.

    :param timeout: longest time of one cell, in seconds.
    :param environment: variables for the kernel beside those of this process.
    :raises AuthoringError: a cell failed or took too long; the message names the line in the source.
    :raises KeyboardInterrupt: Ctrl+C, or a request to end.
    """
    metadata = dict(notebook.metadata)
    client = _Client(
        chapter,
        notebook,
        timeout=timeout,
        kernel_name=kernel_name(),
        kernel_manager_class=AsyncLocalKernelManager,
        record_timing=False,
        extra_arguments=['--log-level=ERROR'],
        resources={'metadata': {'path': str(folder)}},
    )
    with domains.claim() as domain_id, _own_packages(chapter, folder):
        try:
            client.execute(
                env={
                    **os.environ,
                    **ENGLISH,
                    **(environment or {}),
                    'ROS_DOMAIN_ID': str(domain_id),
                    'COURSE_PROGRESS': 'off',
                }
            )
        except Exception as error:
            if client.interrupted:
                raise KeyboardInterrupt from None
            if isinstance(error, CellExecutionError | CellTimeoutError | DeadKernelError):
                raise _explain(error, notebook, chapter, timeout) from None
            raise
    notebook.metadata.clear()
    notebook.metadata.update(metadata)  # nbclient writes the kernel's version there


@contextmanager
def _own_packages(chapter: Chapter, folder: Path) -> Iterator[None]:
    """Put packages that are answers aside, and back in place of what the solutions have made."""
    places = [folder / cell.card.folder for cell in chapter.cells if cell.card is not None and cell.card.folder]
    aside = {place: place.parent.parent / f'{place.name}_put_aside' for place in places}  # outside of src
    for place, other in aside.items():
        if other.exists() and place.exists():  # a run was killed: nobody knows whose the one in place is
            problem = f'{other} was put aside by an execution that did not end'
            raise AuthoringError(chapter.path, None, problem, f'move it back to {place}, or remove one of them')
        if place.exists():
            place.rename(other)
    try:
        yield
    finally:
        for place, other in aside.items():
            shutil.rmtree(place, ignore_errors=True)
            if other.exists():
                other.rename(place)


class _Client(NotebookClient):
    """Runs a chapter's checked statements after their cells; the notebook and its counts know nothing of them."""

    def __init__(self, chapter: Chapter, notebook: NotebookNode, **options):
        super().__init__(notebook, **options)
        self._chapter, self._recording = chapter, not any(cell.checked for cell in chapter.cells)

    @property
    def interrupted(self) -> bool:
        """Whether a signal came. nbclient ends the kernel then, and meets errors of its own in what follows."""
        return '_async_cleanup_kernel_future' in vars(self)  # its attribute from then on

    async def async_execute_cell(self, cell, cell_index, *args, **kwargs):
        if not self._recording:
            self._recording = True
            await self._run(checked.RECORD, self._chapter.cells[0])
        done = await super().async_execute_cell(cell, cell_index, *args, **kwargs)
        source = self._chapter.cells[cell_index]
        if source.checked:
            path = f'{self._chapter.path.parent.name}/{self._chapter.path.name}'
            await self._run(checked.code(source.checked, path, source.checked_line), source)
        return done

    async def _run(self, code: str, source: SourceCell) -> None:
        client: Any = self.kc  # asynchronous, as nbclient starts it
        try:
            reply = await client.execute_interactive(
                code, store_history=False, timeout=self.timeout, output_hook=lambda message: None
            )
        except TimeoutError:
            problem = f'the checked statements took more than {self.timeout:g} s'
            raise AuthoringError(self._chapter.path, source.checked_line, problem, 'wait for nothing in them') from None
        if reply['content']['status'] == 'error':
            said = reply['content']['evalue']
            place = re.match(r'line (\d+): ', said)
            problem = said.removeprefix(place[0]) if place else said
            raise AuthoringError(
                self._chapter.path,
                int(place[1]) if place else source.checked_line,
                f'a checked statement failed with {reply["content"]["ename"]}: {problem}',
                'mend the statement, the cell above it, or what the text says',
            )


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
