"""A process of the learner's program in which a test has made nodes."""

from typing import TYPE_CHECKING

from helpers.runner.program_process import ProgramProcess

if TYPE_CHECKING:
    from helpers.runner.learner import Learner

UNSEEN = '(a name that nobody else sees)'


class StartedNodes:
    """What `learner.start` gives: one process with the learner's node in it."""

    def __init__(self, learner: 'Learner', process: ProgramProcess, index: int, nodes: list[str]):
        self.learner, self.process, self.index = learner, process, index
        self.nodes = nodes  # fully qualified names

    @property
    def name(self) -> str:
        """The fully qualified name of the (first) node. What its own process says counts only if the graph has it."""
        name = self.nodes[0] if self.nodes else ''
        return name if not name or self.learner.is_in_graph(name) else UNSEEN

    @property
    def output(self) -> str:
        """What this process has printed and logged so far."""
        return self.process.output.text

    def call(self, method: str, *args, **kwargs):
        """Call a method of the learner's object; arguments and result as in `learner.call`."""
        return self.process.call(method, args, kwargs, self.learner.timeouts.call, self.index)

    def switch(self, line: int, hold: bool = False) -> tuple[int, str]:
        """Let another thread go on in the middle of a callback, as real threads do; for `start(…, switches=True)`.

        The thread that comes to the place with the number `line` stands aside until nothing else can go on at that
        moment of simulated time. Places are before each line of the learner's, and in it before each store,
        and after each call and each store; they are counted over all callbacks from now on. 0: none stands aside.

        :param hold: it stands aside until the next call at least, so that a test can send something meanwhile.
        :returns: to how many places threads have come since the last call, and the line at which one stood aside
            ('' for none).
        """
        answer = self.process.ask('switch', self.learner.timeouts.call, line=line, hold=hold)
        stood = [f'{row["cell"]}, line {row["line"]}: `{row["code"]}`' for row in answer['stood'][-1:]]
        return answer['lines'], ''.join(stood)

    def stop(self) -> None:
        """End this process; its nodes leave the graph."""
        self.learner.settle()
        self.process.stop()
        self.learner.forget(self.process)
