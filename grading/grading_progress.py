"""Shows how a run of `grade` goes: a line for all, one for each submission that is being graded, and the marks."""

import threading

from rich.console import Console
from rich.progress import BarColumn, MofNCompleteColumn, Progress, SpinnerColumn, TaskID, TextColumn, TimeElapsedColumn

from grading.grading_run import RunListener
from grading.record import Record


class ShownProgress(RunListener):
    """A context manager: shows progress while it is entered."""

    def __init__(self, console: Console):
        self.console = console
        self._lines: dict[str, tuple[TaskID, int]] = {}  # by learner: task, tests that have finished
        self._lock = threading.Lock()
        self._all = Progress(
            SpinnerColumn(),
            TextColumn('{task.description}', markup=False),
            BarColumn(),
            MofNCompleteColumn(),
            TimeElapsedColumn(),
            console=console,
        )
        self._total: TaskID | None = None

    def __enter__(self) -> 'ShownProgress':
        self._all.start()
        return self

    def __exit__(self, *_) -> None:
        self._all.stop()

    def begun(self, todo: int, all_of_them: int) -> None:
        """Grading begins: so many submissions of all are new or changed."""
        self.console.print(f'{todo} of {all_of_them} submissions to grade', markup=False)
        if todo:
            self._total = self._all.add_task('submissions', total=todo)

    def tested(self, learner: str, test: str) -> None:
        """A test of a learner's submission has finished; from any thread."""
        with self._lock:
            known = self._lines.get(learner)
            task, count = known or (self._all.add_task(learner, total=None), 0)
            self._lines[learner] = task, count + 1
            self._all.update(task, completed=count + 1, description=f'{learner}: {_exercise(test)}')

    def finished(self, record: Record, fresh: bool, changes: list[str]) -> None:
        """A learner's submission is done; `fresh`: it was graded now. `changes`: what is not as it was, in words."""
        with self._lock:
            known = self._lines.pop(record.learner, None)
            if known is not None:
                self._all.remove_task(known[0])
            if fresh and self._total is not None:
                self._all.advance(self._total)
        if fresh or changes:
            score = 'open' if record.score is None else f'{record.score:g}'
            self.console.print(f'{record.learner}: {score} of {record.points:g}, {record.status}', markup=False)
        for change in changes:
            self.console.print(f'    {change}', markup=False)


def _exercise(test: str) -> str:
    """`3_2` of `exercises/3_2/hidden::test_name`, `test_3_2` of `checks/chapter_03/test_3_2::test_name`."""
    *_, folder, file = test.partition('::')[0].split('/')
    return folder if file == 'hidden' else file
