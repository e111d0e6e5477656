"""What the tests of exercise 5.5 know of a printer and its queue."""

import math
from contextlib import suppress
from dataclasses import dataclass, field
from itertools import pairwise
from random import Random
from typing import Any

from example_interfaces.action import Fibonacci

from helpers.checks.chapter_05.driving import ENDS
from helpers.checks.chapter_05.kept_results import check_kept
from helpers.checks.chapter_05.two_goals import send_two
from helpers.runner import expect
from helpers.runner.peers import SECOND, Peer
from helpers.runner.verdicts import LearnerCrashed, LearnerError

PAGE = 0.5  # seconds
NEVER = math.inf
LEAST_LINES = 6
MOST_LINES = 120  # places in the learner's lines to which threads come when one goal ends and another one comes


def up_to(count: int) -> list[int]:
    return list(range(1, count + 1))


def near(one: float, other: float) -> bool:
    return abs(one - other) < 1e-6


def seconds(values) -> str:
    return ', '.join(f'{value:g}' for value in values) or 'never'


@dataclass
class Job:
    """One goal of a story: when it is sent and cancelled, in seconds from the beginning of the story.

    What is judged is in `goal`; `begin` and `end` say when it is executed, as the printer's other goals have it.
    """

    name: str
    at: float
    order: int
    client: int = 0
    cancel_at: float = NEVER
    goal: object = None
    begin: float = NEVER
    end: float = NEVER

    @property
    def leaves(self) -> bool:
        """Whether it is cancelled while it waits."""
        return self.cancel_at < self.begin


@dataclass
class Printer:
    """The learner's printer with this number of places, and clients of the test's."""

    learner: object
    places: int
    space: str = ''
    clients: int = 2
    switches: bool = False
    node: object = field(init=False)

    def __post_init__(self):
        name = f'{self.space}/print'
        self.ends = [self.learner.action_client(name, Fibonacci) for _ in range(self.clients)]
        self.node = self.learner.start(
            'Printer', self.places, threads=True, switches=self.switches, remap={'__ns': self.space or '/'}
        )
        self.called = f'Printer({self.places})'

    def check_names(self) -> None:
        """The rule `names`."""
        wanted, client = f'{self.space}/printer', self.ends[0]
        expect(self.node.name == wanted, f'Your node is called {self.node.name}, expected {wanted}.', 'names')
        self.learner.settle()
        expect(
            client.name in client.theirs(),
            f'Your node {self.node.name} has no action server {client.name}: write the name without a leading slash.',
            'names',
        )

    def tell(self, *jobs: Job, rest: float = 0.7) -> None:
        """Let the story happen: send and cancel each goal at its time, and go on until all should have ended."""
        learner, begin = self.learner, self.learner.now / SECOND
        self.jobs, self.begin = list(jobs), begin
        moments = [(job.at, 1, job) for job in jobs]
        moments += [(job.cancel_at, 0, job) for job in jobs if job.cancel_at < NEVER]
        last = 0.0
        for at, kind, job in sorted(moments, key=lambda moment: moment[:2]):
            if at > last:  # goals of one moment are sent together
                learner.run(at - last, step=PAGE)
                last = at
            if kind:
                job.goal = self.ends[job.client].send(order=job.order)
            else:
                job.goal.cancel()
        learner.run(max(0.0, self._latest() - last) + rest, step=PAGE)

    def _latest(self) -> float:
        """When all goals have ended at the latest, if none was accepted that had to be rejected."""
        free = 0.0
        for job in self.jobs:
            if job.order >= 1 and job.goal.accepted is not False and job.cancel_at == NEVER:
                free = max(free, job.at) + PAGE * job.order
            elif job.cancel_at < NEVER:
                free = max(free, job.cancel_at) + PAGE
        return free

    # What is expected

    def judge(self) -> None:
        """Judge every goal of the story, in the order of their sending; the first difference fails the test."""
        self.free = 0.0  # when the printer is free for the next goal
        self.before = ''
        running: list[Job] = []
        printed: list[Job] = []
        for job in self.jobs:
            self._judge_answer(job, running)
            if not job.goal.accepted:
                continue
            job.begin = max(job.at, self.free)
            running.append(job)
            if job.leaves:
                self._judge_leaving(job)
                continue
            self._judge_pages(job)
            printed.append(job)
            self.free, self.before = job.end, job.name
        for job in running:
            self._judge_status(job)
        for before, job in pairwise(printed):
            self._judge_beside(job, before)
        names = {id(job.goal): job.name for job in self.jobs}
        check_kept(
            self.learner,
            [job.goal for job in running if job.goal.status == 'succeeded'],
            lambda goal: f'goal {names[id(goal)]}',
            lambda result: list(result.sequence),
            'end',
        )

    def _told(self, job: Job) -> str:
        before = [one for one in self.jobs[: self.jobs.index(job)] if one.goal.accepted]
        shown = '; '.join(
            f'{one.name}: order {one.order}, at {one.at:g} s'
            + (f', cancelled at {one.cancel_at:g} s' if one.cancel_at < NEVER else '')
            for one in [*before, job]
        )
        return f'{self.called} got these goals ({shown}). Goal {job.name} '

    def _disturbed(self, job: Job, rule: str) -> str:
        """The rule that is broken, if not by another goal's end: `others` after somebody has cancelled."""
        end = NEVER if job.goal.finished is None else job.goal.finished - self.begin
        cancelled = any(one is not job and one.cancel_at < NEVER and one.cancel_at <= end for one in self.jobs)
        return 'others' if cancelled and job.cancel_at == NEVER else rule

    def _judge_answer(self, job: Job, accepted: list[Job]) -> None:
        goal, told = job.goal, self._told(job)
        expect(
            goal.answered is not None,
            f'{told}was not answered. Does a callback hold the lock while it waits?',
            'at-once',
        )
        answered = goal.answered - self.begin
        expect(
            near(answered, job.at),
            f'{told}was answered at {answered:g} s, expected at once. Does a callback hold the lock while it waits?',
            'at-once',
        )
        if job.order < 1:
            expect(not goal.accepted, f'{told}was accepted: there is no such number of pages.', 'orders')
            return
        there = [one for one in accepted if self._ended(one) > job.at]
        waiting = sum(one.begin > job.at for one in there)
        runs = len(there) > waiting
        left = any(one.leaves for one in accepted)
        full = runs and waiting >= self.places
        state = f'{"one goal ran" if runs else "no goal ran"} and {waiting} waited in {self.places} places'
        free = ' A goal that was cancelled while it waited gives its place back.' if left else ''
        expect(
            goal.accepted or full,
            f'{told}was rejected, although {state}.{free}',
            'cancel-waiting' if left else 'places',
        )
        expect(not (goal.accepted and full), f'{told}was accepted, although {state}.', 'places')

    def _ended(self, job: Job) -> float:
        """When a goal has left the printer or its place, at the latest."""
        return min(job.end, job.cancel_at + PAGE) if job.leaves else job.end

    def _judge_cancel(self, job: Job, rule: str) -> None:
        cancel, told = job.goal.cancels[0], self._told(job)
        expect(
            cancel.done and near(cancel.received, cancel.sent),
            f'{told}was not told at once whether it is cancelled. Does a callback hold the lock while it waits?',
            'at-once',
        )
        expect(
            cancel.answer == 'accepted', f'{told}was to be cancelled; the request was answered: {cancel.answer}.', rule
        )

    def _judge_leaving(self, job: Job) -> None:
        """A goal that is cancelled while it waits."""
        goal, told, rule = job.goal, self._told(job), 'cancel-waiting'
        expect(
            not goal.stamps or goal.stamps[0] - self.begin >= job.begin,
            f'{told}had a page at {seconds(stamp - self.begin for stamp in goal.stamps[:1])} s, while another one ran. '
            'One goal runs at a time.',
            'queue',
        )
        self._judge_cancel(job, rule)
        expect(not goal.feedback, f'{told}was cancelled while it waited, and then printed all the same.', rule)
        expect(
            goal.finished is not None,
            f'{told}was cancelled while it waited, and did not end: somebody must look at the goals that wait.',
            rule,
        )
        ended = goal.finished - self.begin
        expect(
            ended <= job.cancel_at + PAGE + 1e-6,
            f'{told}was cancelled while it waited, and ended at {ended:g} s, expected within {PAGE} s: somebody must '
            'look at all goals that wait, in each step, and a goal whose turn comes looks before its first page.',
            rule,
        )
        expect(goal.status == 'canceled', f'{told}{goal.ended}, expected canceled.{goal.why_aborted}', rule)
        pages = list(goal.result.sequence)
        expect(not pages, f'{told}was cancelled while it waited, and its result is {pages}, expected [].', rule)

    def _judge_pages(self, job: Job) -> None:
        """A goal that is executed, to its end or until it is cancelled."""
        goal, told = job.goal, self._told(job)
        due = [job.begin + PAGE * page for page in up_to(job.order) if job.begin + PAGE * page <= job.cancel_at]
        stamps = [round(stamp - self.begin, 6) for stamp in goal.stamps]
        cause = f'when goal {self.before} had ended' if job.begin > job.at else 'at once'
        begins = f'expected to begin at {job.begin:g} s, {cause}'
        queue = self._disturbed(job, 'queue')
        executing = [
            change - self.begin
            for status, change in zip(goal.statuses, goal.changes, strict=True)
            if status in ('executing', 'canceling')
        ]
        early = executing and executing[0] < job.begin - 1e-6
        expect(
            not (stamps and stamps[0] < job.begin + (PAGE - 1e-6 if early else 1e-6) and job.begin > job.at),
            f'{told}had a page at {seconds(stamps[:1])} s, {begins}. One goal runs at a time, in the order in which '
            'they came.',
            queue,
        )
        expect(executing or goal.finished is not None, f'{told}never began, {begins}.', queue)
        if goal.finished is None and job.cancel_at < NEVER:
            self._judge_cancel(job, 'cancel')
            expect(False, f'{told}was cancelled while it ran, and did not end.', 'cancel')
        if executing and job.begin < executing[0] - 1e-6:
            expect(False, f'{told}began at {executing[0]:g} s, {begins}.', queue)
        if job.cancel_at < job.begin + PAGE * job.order:
            self._judge_cancelled(job, len(due))
            due = due[: len(stamps)]
        else:
            self._judge_completed(job, stamps, due)
        expect(
            len(stamps) == len(due),
            f'{told}had {len(stamps)} feedback messages, expected one for each page, {len(due)}.',
            'feedback',
        )
        expect(
            all(map(near, stamps, due)),
            f'{told}had pages at {seconds(stamps)} s, expected at {seconds(due)} s.',
            'pages',
        )
        for number, message in enumerate(goal.feedback, 1):
            expect(
                list(message.sequence) == up_to(number),
                f'{told}had the feedback {list(message.sequence)} when page {number} was there, expected its pages so '
                f'far, {up_to(number)}.',
                'feedback',
            )
        expect(
            job.cancel_at < NEVER or near(job.end, job.begin + PAGE * job.order),
            f'{told}ended at {job.end:g} s, expected at {job.begin + PAGE * job.order:g} s.',
            'pages',
        )

    def _judge_beside(self, job: Job, before: Job) -> None:
        """A goal begins after the end of the one before it; both are said at one moment, one after the other."""
        ended, began = (
            [at for status, at in zip(one.goal.statuses, one.goal.published, strict=True) if status in wanted]
            for one, wanted in ((before, ENDS), (job, ('executing',)))
        )
        expect(
            not ended or not began or ended[0] <= began[0],
            f'{self._told(job)}was executing before goal {before.name} had ended, so two goals ran. First end a goal, '
            'with succeed() or canceled(), and then begin the next one.',
            'queue',
        )

    def _judge_completed(self, job: Job, stamps: list[float], due: list[float]) -> None:
        """A goal that nobody cancels: its pages came at `stamps`, and were to come when `due`, in s."""
        goal, told = job.goal, self._told(job)
        expect(
            goal.status in (None, 'succeeded'),
            f'{told}{goal.ended}, expected succeeded.{goal.why_aborted}',
            self._disturbed(job, 'end'),
        )
        pages = list(goal.result.sequence) if goal.result else None
        expect(
            pages is not None,
            f'{told}did not end; its pages came at {seconds(stamps)} s, expected {seconds(due)} s.',
            'pages',
        )
        expect(
            pages == up_to(job.order),
            f'{told}has the result {pages}, expected {up_to(job.order)}.',
            'end' if not pages else 'pages',
        )
        job.end = goal.finished - self.begin

    def _judge_cancelled(self, job: Job, count: int) -> None:
        """A goal that was cancelled while it ran, when it had so many pages."""
        goal, told, rule = job.goal, self._told(job), 'cancel'
        self._judge_cancel(job, rule)
        job.end = goal.finished - self.begin
        expect(
            job.end <= job.cancel_at + PAGE + 1e-6,
            f'{told}was cancelled while it ran, and ended at {job.end:g} s, expected within {PAGE} s.',
            rule,
        )
        expect(
            goal.status == 'canceled',
            f'{told}was cancelled while it ran, and {goal.ended}, not canceled.{goal.why_aborted}',
            rule,
        )
        pages = list(goal.result.sequence)
        expect(
            pages == up_to(count), f'{told}was cancelled when it had {up_to(count)}, and its result is {pages}.', rule
        )
        expect(len(goal.feedback) <= count, f'{told}sent feedback after the cancel request.', rule)

    def _judge_status(self, job: Job) -> None:
        """What the status says while a goal waits, and when it begins."""
        goal, told = job.goal, self._told(job)
        changes = dict(zip(reversed(goal.statuses), reversed(goal.changes), strict=True))
        executing = changes.get('executing', NEVER) - self.begin
        if job.leaves:
            expect(
                executing == NEVER,
                f'{told}was cancelled while it waited, but it was executing from {executing:g} s on.',
                'status' if executing < job.cancel_at else 'cancel-waiting',
            )
        elif job.cancel_at > job.begin:
            expect(
                executing > job.begin - 1e-6,
                f'{told}was executing from {executing:g} s on, but it waited until {job.begin:g} s. While it waits it '
                'is accepted: call execute() when it begins.',
                'status',
            )
            expect(
                near(executing, job.begin),
                f'{told}began at {job.begin:g} s, and became executing at {seconds([executing])} s.',
                'status',
            )


def drawn_orders(random: Random, count: int, least: int = 1, most: int = 4) -> list[int]:
    """Orders that are not sorted, either way, so that each order of execution shows."""
    while True:
        orders = [random.randint(least, most) for _ in range(count)]
        if orders not in (sorted(orders), sorted(orders, reverse=True)):
            return orders


class Rush(Peer):
    """At an exact moment a goal comes, and one that waits is cancelled: just when another goal ends."""

    def __init__(self, printer: Printer):
        self.printer, self.learner = printer, printer.learner
        self.moment: int | None = None  # ns
        self.line, self.hold = 0, False
        self.came: Any = None  # the goal that it has sent
        self.cancelled: Any = None  # the one that it cancels, if any

    def due(self) -> int | None:
        return self.moment

    def act(self) -> None:
        if self.moment is not None and self.learner.now >= self.moment:
            self.moment = None
            self.printer.node.switch(self.line, self.hold)
            if not self.hold:
                self.cancel()
                self.send()

    def cancel(self) -> None:
        if self.cancelled:
            self.cancelled.cancel()

    def send(self) -> None:
        self.came = self.printer.ends[-1].send(order=1)


def check_switches(printer: Printer, cancel: bool, every: int = 1) -> None:
    """The rule `lock`: goals come just when another one ends, while a thread stands aside at one line after the other.

    :param cancel: a goal waits, too, and is cancelled at the same moment.
    :param every: of the places in the lines only each second one, each third one, and so on, is tried.
    """
    learner = printer.learner
    rush = learner.add(Rush(printer))
    goal, words = printer.ends[0].send(order=1), 'Goals came one after the other. '
    learner.settle()
    begin = learner.now
    # The goal comes first, or while the thread of the one that ends stands still.
    for hold in (False, True):
        for line in range(1, MOST_LINES, every):
            rush.line, rush.hold = line, hold
            rush.cancelled = printer.ends[0].send(order=1) if cancel else None
            rush.moment = begin + round(PAGE * SECOND)
            lines, stood = _pass(printer, rush, words)
            _judge_rush(goal, begin, words)
            words = _words(rush, stood)
            goal, begin = rush.came, _began(rush, begin + round(PAGE * SECOND), words)
            if lines < line:
                break
    learner.run(PAGE, step=PAGE)
    _judge_rush(goal, begin, words)


def _pass(printer: Printer, rush: Rush, words: str) -> tuple[int, str]:
    """Go to the moment of the rush. Returns how many lines began at it, and before which one a thread stood aside."""
    learner, stood = printer.learner, ''
    assert rush.moment is not None  # it has just been set
    try:
        learner.run((rush.moment - learner.now) / SECOND, step=PAGE)
        learner.settle()
        if rush.hold:  # the cancel request is heard first: the answer to the goal may wait for a lock
            rush.cancel()
            learner.settle()
        lines, stood = printer.node.switch(0)
        if rush.hold:
            rush.send()
            learner.settle()
        if rush.cancelled:  # one that begins and is cancelled at one moment may be executed for one page
            learner.run(PAGE, step=PAGE, until=lambda: rush.cancelled.done)
    except LearnerCrashed as error:
        with suppress(LearnerError):
            stood = stood or printer.node.switch(0)[1]
        error.message = f'{_words(rush, stood) if rush.moment is None else words}This happened: {error.message}'
        error.rule = 'lock'
        raise
    return lines, stood


def _judge_rush(goal, begin: int, words: str) -> None:
    """A goal of one page that came just when another one ended; it was to begin at `begin` (ns)."""
    expect(goal.accepted, f'{words}Then the goal that came was rejected, although a place was free.', 'lock')
    expect(goal.finished is not None, f'{words}Then the goal that came was lost: it has not ended.', 'lock')
    pages = list(goal.result.sequence)
    expect(
        goal.status == 'succeeded' and pages == [1],
        f'{words}Then the goal that came {goal.ended} with {pages}, expected succeeded with [1].',
        'lock',
    )
    count = len(goal.feedback)
    expect(count, f'{words}Then the goal that came had no feedback for its only page.', 'lock')
    expect(count == 1, f'{words}Then the goal that came printed its only page {count} times: it ran twice.', 'lock')
    took = goal.finished - begin / SECOND
    expect(near(took, PAGE), f'{words}Then the goal that came ended {took:g} s later, expected {PAGE} s.', 'lock')


def _began(rush: Rush, moment: int, words: str) -> int:
    """When the goal that came has begun (ns): at this moment (ns), or when the cancelled goal has left the printer."""
    left, came = rush.cancelled, rush.came
    if left is None:
        return moment
    expect(
        left.status == 'canceled' and not left.feedback,
        f'{words}Then the cancelled goal was {left.status or "still there"} and had printed {len(left.feedback)} '
        'pages, expected canceled, and none.',
        'lock',
    )
    executing = [change for status, change in zip(came.statuses, came.changes, strict=True) if status == 'executing']
    begin = executing[0] if executing else NEVER
    expect(
        near(begin, moment / SECOND) or near(begin, left.finished),
        f'{words}Then the goal that came did not begin when the printer was free.',
        'lock',
    )
    return round(begin * SECOND)


def check_two_at_once(printer: Printer) -> None:
    """The rule `places`: two goals of one moment, while a goal callback stands aside at one line after the other.

    :param printer: without places, and with threads that can be switched: it accepts one of the two.
    """
    learner, client = printer.learner, printer.ends[0]
    for line in range(1, MOST_LINES):
        accepted, answered, stood = send_two(learner, printer.node, client, line, order=1)
        told = f'{printer.called} got two goals at one moment, when none ran or waited, and {len(accepted)} of them '
        expect(
            len(accepted) < 2,
            f'{told}were accepted: the second one came while the callback of the first stood before {stood}. The look '
            'at the places and the change of the list belong together: with the default callback group, one goal is '
            'accepted after the other.',
            'places',
        )
        expect(accepted, f'{told}were accepted, expected one.', 'places')
        learner.run(2 * PAGE, step=PAGE, until=lambda goal=accepted[0]: goal.done)
        if answered and line >= LEAST_LINES:
            break


def _words(rush: Rush, stood: str) -> str:
    also = ', and one that waited was cancelled' if rush.cancelled else ''
    where = f' One thread stood still before {stood}, or in it, and the others went on.' if stood else ''
    return f'A goal came just when another one ended{also}.{where} '


def check_two_printers(learner) -> None:
    """Two printers of one process, in two namespaces: the goals of one do not wait for those of the other.

    The second one has more places; to the first one comes a goal too many. What one printer does is judged by other
    tests: its goals end here as they do when it is alone.
    """
    long, short, places = learner.random.randint(3, 5), learner.random.randint(1, 2), learner.random.randint(2, 4)
    first = learner.action_client('/left/print', Fibonacci)
    node = _printer_in(learner, '/left')
    jobs = [(first, 0.0, long), (first, 0.1, 1), (first, 0.4, 1)]
    alone = _ends(learner, jobs)
    node.stop()  # what one object keeps from goal to goal is judged by other tests
    second = learner.action_client('/right/print', Fibonacci)
    _printer_in(learner, '/right', beside=_printer_in(learner, '/left'), places=places)
    *both, more = _ends(learner, [*jobs[:2], (second, 0.2, short), (second, 0.3, 1), jobs[2]])
    told = (
        f'A printer got goals of the orders {long} at 0 s and 1 at 0.1 s. A second object of your class, in the same '
        f'program and another namespace, got goals of the orders {short} at 0.2 s and 1 at 0.3 s. '
    )
    hint = 'Keep the queue in self, and in no variable of the class or of the module.'
    expect(
        more is None or alone[2] is not None,
        f'Two objects of your class ran in one program: Printer(1), and then Printer({places}), in another namespace. '
        'The first one accepted a third goal, although one ran and one waited, which it does not do when it is alone. '
        'Keep the number of places in self, and in no variable of the class or of the module.',
        'places',
    )
    expect(
        both[:2] == alone[:2],
        f'{told}The goals of the first one ended at {_times(both[:2])}, expected at {_times(alone[:2])}, as when it is '
        f'alone. {hint}',
        'queue',
    )
    wanted = [round(0.2 + PAGE * order, 6) for order in (short, short + 1)]
    expect(
        both[2:] == wanted or alone[:2] != [PAGE * long, PAGE * (long + 1)],
        f'{told}The goals of the second one ended at {_times(both[2:])}, expected at {_times(wanted)}. {hint}',
        'queue',
    )


def _printer_in(learner, space: str, beside=None, places: int = 1):
    """A printer with this number of places in this namespace."""
    return learner.start('Printer', places, threads=True, beside=beside, remap={'__ns': space})


def _ends(learner, jobs: list[tuple]) -> list[float | None]:
    """When goals end, in seconds after now: each is sent by a client at a time, and has an order."""
    begin, last, goals = learner.now / SECOND, 0.0, []
    for client, at, order in jobs:
        learner.run(at - last, step=PAGE)
        goals.append(client.send(order=order))
        last = at
    learner.run(PAGE * (sum(order for _, _, order in jobs) + 1), step=PAGE)
    return [goal.finished and round(goal.finished - begin, 6) for goal in goals]


def _times(ends: list[float | None]) -> str:
    return ' and '.join('no time' if end is None else f'{end:g} s' for end in ends)


def check_first_page(printer: Printer, draw: Random) -> None:
    """The first goal of a printer's life is cancelled before it has a page; one waits, and another one comes later."""
    first = Job('A', 0.0, draw.randint(1, 4), cancel_at=round(draw.uniform(0.1, 0.4), 2))
    printer.tell(first, Job('B', 0.0, 1, client=1), Job('C', 2.3, draw.randint(1, 3), cancel_at=2.5))
    printer.judge()


def check_at_the_end(printer: Printer, draw: Random) -> None:
    """Two that wait leave during the last page of the goal that runs; then the only goal is cancelled, and one comes.

    While the last page is printed somebody must look at those that wait, too; a cancelled goal leaves a free printer.
    """
    pages, last = draw.randint(1, 2), draw.choice([0.1, 0.2, 0.3])
    # The next one leaves so late that a timer of 0.1 s or more, which looks at those that wait, is not due before the
    # printer is free.
    printer.learner.run(0.03)
    printer.tell(
        Job('K', 0.0, pages),
        Job('L', 0.0, draw.randint(1, 3), client=1, cancel_at=round(PAGE * pages - 0.02, 2)),
        Job('M', 0.0, 3),
        Job('N', 0.0, draw.randint(1, 3), client=1, cancel_at=round(PAGE * (pages - 1) + last, 1)),
    )
    printer.judge()
    pages = draw.randint(1, 3)
    only = Job('O', 0.0, pages, cancel_at=round(PAGE * (pages - 1) + last, 1))  # during its last page
    printer.tell(only, Job('P', round(only.cancel_at + PAGE + 0.2, 1), 2, client=1))
    printer.judge()
