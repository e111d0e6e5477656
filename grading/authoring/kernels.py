"""Managers of kernels that are reached by sockets in a folder of their own.

With TCP, jupyter_client asks the system for free ports and closes them before the kernel opens them: kernels that start
at the same time in several processes can get the same one, and then one of them dies before its first answer.
"""

import tempfile

from jupyter_client.connect import ConnectionFileMixin
from jupyter_client.manager import AsyncKernelManager, KernelManager


class _LocalSockets(ConnectionFileMixin):
    def __init__(self, **options):
        self._folder = tempfile.TemporaryDirectory(prefix='course-kernel-')  # the path of a socket must be short
        super().__init__(transport='ipc', ip=f'{self._folder.name}/kernel', **options)

    def cleanup_connection_file(self) -> None:
        """Remove the connection file, the sockets and their folder: the kernel has ended, and is not restarted."""
        super().cleanup_connection_file()
        self._folder.cleanup()


class LocalKernelManager(_LocalSockets, KernelManager):
    """A KernelManager whose kernel is reached by sockets in a folder of its own."""


class AsyncLocalKernelManager(_LocalSockets, AsyncKernelManager):
    """An AsyncKernelManager whose kernel is reached by sockets in a folder of its own."""
