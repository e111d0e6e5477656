"""Visible tests of exercise 5.5, a printer and its queue."""

import pytest

from helpers.checks.chapter_05.printing import (
    PAGE,
    Job,
    Printer,
    check_at_the_end,
    check_first_page,
    check_switches,
    check_two_at_once,
    check_two_printers,
    drawn_orders,
)
from helpers.runner import about

pytestmark = [pytest.mark.exercise('5.5'), pytest.mark.wiring(type='names', namespace='names')]


@pytest.mark.rules('names', 'orders', 'pages', 'feedback', 'end', 'queue', 'status', 'places', 'at-once')
@about('queue')
def test_queue(learner):
    """Goals of two clients are printed one after the other, in their order; what finds no place is rejected.

    Keep a list of all goals that have not ended. The first one runs, the others wait.
    """
    draw = learner.random
    places, space = draw.randint(2, 3), draw.choice(['/left', '/shop/door'])
    printer = Printer(learner, places, space)
    printer.check_names()
    orders = drawn_orders(draw, places + 1)
    burst = [Job('ABCD'[number], 0.0, order) for number, order in enumerate(orders)]
    last = sum(orders[:-1]) / 2  # now the last of them begins
    printer.tell(
        *burst,
        Job('too many', 0.1, 1),
        *(Job(name, orders[0] / 2 + at, 1, client=1) for name, at in (('late', 0.1), ('too late', 0.2))),
        Job('bad', last + 0.1, -draw.randint(1, 2**31), client=1),  # now that places are free
        Job('none', last + 0.2, 0),
        Job('last', last + 0.3, 2),
        Job('later', sum(orders) / 2 + 2.2, draw.randint(21, 25)),
    )
    printer.judge()


@pytest.mark.rules('places')
@about('places')
def test_no_place(learner):
    """In a printer without places nobody waits: a goal is rejected while another one runs.

    0 is a number like any other: `places or 2` is 2.
    """
    printer = Printer(learner, 0)
    # The last one comes when the goal that runs is cancelled, and has not ended yet.
    cancelled = Job('C', 2.2, 4, cancel_at=2.2 + PAGE + 0.05)
    printer.tell(
        Job('A', 0.0, 2), Job('too many', 0.2, 1), Job('B', 1.3, 1), cancelled, Job('too early', 2.2 + PAGE + 0.07, 1)
    )
    printer.judge()


@pytest.mark.rules('places')
@about('places')
def test_two_at_once(learner):
    """Of two goals of one moment a printer without places accepts one, wherever the callback of the first stands.

    What counts the places also takes one: in one callback, or in callbacks of one mutually exclusive group.
    """
    check_two_at_once(Printer(learner, 0, switches=True))


@pytest.mark.rules('places')
@about('places')
def test_many_places(learner):
    """In a printer with many places as many goals wait.

    The number of places is the argument of the constructor.
    """
    places = learner.random.randint(11, 13)
    printer = Printer(learner, places)
    # One after the other: a service keeps ten requests of one moment.
    printer.tell(*(Job(f'A{number}', number / 50, 1) for number in range(places + 1)), Job('too many', 0.4, 1))
    printer.judge()


@pytest.mark.rules('cancel-waiting')
@about('cancel-waiting')
def test_far_behind(learner):
    """Also a goal that waits behind many others can leave.

    In each step the goal that runs looks at all that wait.
    """
    count = learner.random.randint(6, 8)
    printer = Printer(learner, count)
    jobs = [Job(f'A{number}', number / 50, 1) for number in range(count)]
    printer.tell(Job('first', 0.0, 2), *jobs[1:], Job('last', 0.4, 1, cancel_at=0.7))
    printer.judge()


@pytest.mark.rules('queue')
@about('queue')
def test_two_printers(learner):
    """Two objects of your class in one program are two printers: a goal of one does not wait for the other.

    Keep the list of the goals in an attribute of self.
    """
    check_two_printers(learner)


@pytest.mark.rules('cancel', 'cancel-waiting', 'others', 'at-once')
@about('cancel')
def test_cancel(learner):
    """Goals that wait and goals that run are cancelled, and the others do not notice.

    In each step the goal that runs looks at is_cancel_requested, and at the goals that wait.
    """
    draw = learner.random
    printer = Printer(learner, 3)
    check_first_page(printer, draw)
    now = round(draw.choice([0.55, 0.7, 1.1]), 2)
    # Neighbours leave at one moment, behind one that stays; then all their places are free.
    printer.tell(
        Job('A', 0.0, 4),
        Job('B', 0.0, 3),
        Job('C', 0.0, 2, cancel_at=now),
        Job('D', 0.1, 1, client=1, cancel_at=now),
        *(Job(name, round(now + 0.7, 2), 1, client=1) for name in ('E', 'F', 'too many')),
    )
    printer.judge()
    # The first one that waits leaves; then the goal that runs is cancelled, just after one of its steps.
    now = PAGE * draw.randint(2, 4) + 0.05
    many = draw.randint(101, 5000)
    printer.tell(
        Job('G', 0.0, many, cancel_at=now),
        Job('H', 0.1, 2, client=1, cancel_at=round(now - draw.choice([0.7, 0.8]), 2)),
        Job('I', 0.1, 1),  # behind it two keep their order
        Job('J', 0.1, 2),
    )
    printer.judge()
    # The same late in the life of a goal.
    now = PAGE * draw.randint(14, 30) + 0.05
    printer.tell(
        Job('K', 0.0, many, cancel_at=now),
        Job('L', 0.1, 2, client=1, cancel_at=round(now - draw.choice([1.2, 1.3]), 2)),
        Job('M', 0.1, 1),
    )
    printer.judge()
    check_at_the_end(printer, draw)


@pytest.mark.rules('lock')
@about('lock')
def test_threads(learner):
    """A goal comes just when another one ends, and another thread goes on in the middle of a callback.

    Each look at the list, together with the change that follows, stands in the lock.
    """
    check_switches(Printer(learner, 2, switches=True), cancel=False)


@pytest.mark.rules('lock')
@about('lock')
def test_threads_and_cancel(learner):
    """A goal comes and one that waits is cancelled, just when another one ends.

    Look at is_cancel_requested once, inside the lock, and keep what you have seen: it may change between two looks.
    """
    check_switches(Printer(learner, 2, switches=True), cancel=True, every=3)
