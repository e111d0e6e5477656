"""A way around a deadlock at the end of a kernel, which ipykernel (7.4.0) has with and without ROS.

``IPKernelApp.close`` ends the thread that publishes output, and then waits for the control thread. If the
control thread is just about to publish that it has served the shutdown request, it waits for the thread that has ended:
on a busy machine, about one restart in a hundred hung. Here the control thread ends first.
"""

import atexit
import sys

_LONGEST = 5.0  # s; Jupyter kills a kernel that takes longer


def register() -> None:
    """End the control thread at exit, before ipykernel's own exit handler: the handler registered last runs first."""
    atexit.register(_end_control_thread)


def _end_control_thread() -> None:
    kernelapp = sys.modules.get('ipykernel.kernelapp')
    if kernelapp is None or not kernelapp.IPKernelApp.initialized():
        return
    thread = getattr(kernelapp.IPKernelApp.instance(), 'control_thread', None)
    if thread is not None and thread.is_alive():
        thread.stop()
        thread.join(_LONGEST)
