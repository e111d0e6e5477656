"""Where units of work are done: in threads of the grader, or on a Dask cluster. Both give futures of `concurrent`.

The local one is a plain thread pool. A unit spends its time in child processes of its own, so that threads lose
nothing, and a Dask cluster on this machine would only add its start: 0.6 s of import and 0.7 s for two workers.
"""

import concurrent.futures
import contextlib
import functools
from collections import deque
from collections.abc import Callable, Iterator

from grading import unit as units
from grading.unit import Outcome, Unit

CONNECT = 10.0  # seconds to wait for a scheduler
NO_WORKERS = 60.0  # seconds without any worker until the run stops
_POLL = 5.0


class ClusterError(Exception):
    """The cluster cannot be used; the message names the remedy."""


class Local:
    """`jobs` units at a time, in threads."""

    def __init__(self, jobs: int):
        self.jobs = jobs
        self._pool = concurrent.futures.ThreadPoolExecutor(jobs)

    def submit(self, unit: Unit, say: Callable[[str], None]) -> concurrent.futures.Future:
        """Have a unit graded; `say` is told, in the unit's thread, of each test that has finished."""
        return self._pool.submit(units.perform, unit, say)

    def capacity(self) -> int:
        """How many units it takes at a time."""
        return self.jobs

    def close(self) -> None:
        """Take no more units, and drop those that have not begun."""
        self._pool.shutdown(wait=False, cancel_futures=True)  # an interrupted run does not wait for the rest


class Cluster:
    """As many units at a time as an existing Dask cluster takes."""

    def __init__(self, address: str):
        """:raises ClusterError: no scheduler answers, or it has no workers."""
        import distributed

        try:
            self._client = distributed.Client(address, timeout=CONNECT, set_as_default=False)
        except (OSError, ValueError, TypeError) as error:
            raise ClusterError(
                f'no Dask scheduler answers at {address} ({error or type(error).__name__}): start one '
                'with ./course shell -- dask scheduler'
            ) from None
        self.address, self.jobs = address, 1  # the cluster's cores are its own business
        if not self._threads():
            self._client.close()
            raise ClusterError(
                f'the Dask scheduler at {address} has no workers: start some with '
                f'./course shell -- dask worker {address}'
            )
        self._executor = self._client.get_executor(pure=False)

    def submit(self, unit: Unit, say: Callable[[str], None]) -> concurrent.futures.Future:
        """Have a unit graded by a worker. `say` is told nothing: the tests finish on another machine."""
        return self._executor.submit(units.perform, unit)

    def capacity(self) -> int:
        """How many units it takes at a time: the threads of all workers.

        No more are sent, so that none waits at a worker that another one may bring down.

        :raises ClusterError: the scheduler is gone, or all workers are, for longer than NO_WORKERS.
        """
        try:
            if not (threads := self._threads()):
                self._client.wait_for_workers(1, timeout=NO_WORKERS)
                threads = self._threads()
        except TimeoutError:
            raise ClusterError(
                f'the Dask cluster at {self.address} has no workers any more; start some. What is '
                'graded is kept: run again'
            ) from None
        except (OSError, ValueError, RuntimeError, concurrent.futures.CancelledError):
            threads = 0
        if self._client.status != 'running':
            raise ClusterError(f'the Dask scheduler at {self.address} has gone; what is graded is kept: run again')
        return max(1, threads)

    def close(self) -> None:
        with contextlib.suppress(Exception):  # the scheduler may have gone
            self._executor.shutdown(wait=False)
        self._client.close(timeout=CONNECT)

    def _threads(self) -> int:
        return sum(worker['nthreads'] for worker in self._client.scheduler_info(n_workers=-1)['workers'].values())


def perform(
    work: dict[str, Unit], executor: Local | Cluster, say: Callable[[str, str], None]
) -> Iterator[tuple[str, Outcome]]:
    """Do the units of `work` (by learner), and give each outcome as it comes.

    What fails is tried once more, and is then a grader's fault. `say` is told learner and test.

    :raises units.Mismatch: a machine of the cluster has another version of the course.
    :raises ClusterError: the cluster is lost.
    """
    running: dict[concurrent.futures.Future, str] = {}
    again: set[str] = set()
    waiting = deque(work)
    while waiting or running:
        capacity = executor.capacity()
        while waiting and len(running) < capacity:
            learner = waiting.popleft()
            running[executor.submit(work[learner], functools.partial(say, learner))] = learner
        done, _ = concurrent.futures.wait(running, _POLL, concurrent.futures.FIRST_COMPLETED)
        for future in done:
            learner = running.pop(future)
            try:
                yield learner, future.result()
            except units.Mismatch:
                raise
            except (Exception, concurrent.futures.CancelledError) as error:
                if learner in again or type(error).__name__ == 'KilledWorker':  # the scheduler has retried that one
                    text = f'{type(error).__name__}: {error}'
                    yield learner, units.fault(work[learner], f'not graded: {text}')
                else:
                    again.add(learner)
                    waiting.appendleft(learner)
