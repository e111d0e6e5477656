"""Waiting until the nodes that spin in the background have nothing left to do, without a clock."""

import time

from helpers.kernel.executors import activity, observers
from helpers.kernel.handles import handles, raise_pending

_ROUNDS = 100  # callbacks; nodes that answer each other without end would never be idle
_BUSY = 1.0  # s for which a callback may keep the others waiting; one that waits for time to pass never returns
_count = 0  # callbacks that have run


def settle(timeout: float = 5.0, *, views: bool = False) -> None:
    """Return when every callback that is due now, and what it set off, has run.

    It sees the nodes of this process only. What other processes send may still be on its way.

    :param timeout: seconds; after that it returns in any case.
    :param views: wait for the nodes of views, too (their names begin with an underscore).
    :raises CallbackError: a callback raised.
    """
    __tracebackhide__ = True
    deadline = time.monotonic() + timeout
    mine = [
        handle
        for handle in handles()
        if handle.running and (views or any(not node.get_name().startswith('_') for node in handle.nodes))
    ]
    for _ in range(_ROUNDS):
        before = _count
        for handle in mine:
            handle.pass_round(max(0.0, deadline - time.monotonic()), _BUSY)
        raise_pending()
        if _count == before or time.monotonic() > deadline:
            return


def _observe(moment: str, work) -> None:
    global _count
    if moment == 'finish' and work.entity is not None:
        with activity:
            _count += 1


observers.append(_observe)
