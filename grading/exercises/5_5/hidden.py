"""Hidden tests of exercise 5.5, a printer and its queue."""

import pytest

from helpers.checks.chapter_05.printing import (
    NEVER,
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


@pytest.mark.rules('names', 'orders', 'places')
@about('names')
def test_alone(learner):
    """One goal at a time, in a namespace, with no place for a second one.

    A relative name. The goal that runs takes no place.
    """
    draw = learner.random
    printer = Printer(learner, 0, draw.choice(['/left', '/shop/door', '/a/b/c']))
    printer.check_names()
    first, second = draw.randint(2, 5), draw.randint(1, 3)
    printer.tell(
        Job('bad', 0.0, 0),
        Job('minus', 0.0, -draw.randint(1, 99)),
        Job('A', 0.1, first),
        Job('too many', draw.choice([0.2, 0.3, 0.8]), 1, client=1),
        Job('B', first / 2 + 0.3, second, client=1),
        Job('C', (first + second) / 2 + 1.4, 1),
    )
    printer.judge()
    # A goal that was cancelled runs until it has ended.
    step = round(draw.randint(1, 3) / 2 + 0.06, 2)
    printer.tell(Job('D', 0.0, 9, cancel_at=step), Job('too early', round(step + 0.02, 2), 1), Job('E', step + 1.0, 1))
    printer.judge()


@pytest.mark.rules('places')
@about('places')
def test_two_at_once(learner):
    """Of two goals of one moment a printer without places accepts one, wherever the callback of the first stands.

    What counts the places also takes one.
    """
    check_two_at_once(Printer(learner, 0, switches=True))


@pytest.mark.rules('queue')
@about('queue')
def test_two_printers(learner):
    """Two printers in one program do not wait for each other.

    All state in the object.
    """
    check_two_printers(learner)


@pytest.mark.weight(2)
@pytest.mark.rules('pages', 'feedback', 'end', 'queue', 'status', 'places', 'at-once')
@about('queue')
def test_queue(learner):
    """Goals of three clients, at one moment and one after the other, are printed in the order in which they came.

    Keep a list of all goals that have not ended. The first one runs, the others wait.
    """
    draw = learner.random
    places = draw.randint(3, 5)
    printer = Printer(learner, places, clients=3)
    orders = drawn_orders(draw, places + 1, most=3)
    count = draw.randint(2, places)
    jobs = [Job(f'{number + 1}', 0.0, order) for number, order in enumerate(orders[:count])]
    jobs += [Job(f'{count + 1 + number}', 0.1, order, 1) for number, order in enumerate(orders[count:])]
    printer.tell(
        *jobs,
        Job('too many', 0.2, draw.randint(1, 3), client=2),
        Job('again', 0.3, 1),
        Job('late', orders[0] / 2 + 0.2, draw.randint(1, 2), client=draw.randint(0, 2)),
        Job('too late', orders[0] / 2 + 0.3, 1, client=2),
        Job('at last', sum(orders) / 2 + 3.1, 2, client=1),
    )
    printer.judge()


@pytest.mark.weight(2)
@pytest.mark.rules('cancel', 'cancel-waiting', 'others', 'at-once', 'status')
@about('cancel')
def test_cancel(learner):
    """Goals that wait and goals that run are cancelled, one after the other and at one moment.

    In each step the goal that runs looks at is_cancel_requested, and at the goals that wait.
    """
    draw = learner.random
    places = draw.randint(4, 5)
    printer = Printer(learner, places, clients=3)
    orders = drawn_orders(draw, places, least=3, most=4)  # the first one runs until the last ones have come
    jobs = [Job(f'{number + 1}', 0.0, order) for number, order in enumerate(orders)]
    first, second = draw.sample(jobs[1:], 2)
    now = round(draw.choice([0.2, 0.6, 0.7]), 1)
    first.cancel_at, second.cancel_at = now, now + draw.choice([0.0, 0.1])
    printer.tell(*jobs, Job('new', now + 0.7, 2, 1), Job('newest', now + 0.7, 1, 1), Job('other', now + 0.8, 1, 2))
    printer.judge()
    early = draw.choice([0.3, 0.7, 1.2, 1.8])
    # The goal that runs and one that waits, at one moment: early and late in its life.
    for now in (early, round(early + PAGE * draw.randint(11, 35), 2)):
        printer.tell(
            Job('A', 0.0, 99, 1, cancel_at=now),
            Job('B', 0.1, 2, 2),
            Job('C', 0.1, draw.randint(1, 3), 2, cancel_at=now),
            Job('D', 0.2, draw.randint(1, 3)),
        )
        printer.judge()
    printer.tell(Job('E', 0.0, 3), Job('next', 0.1, 1, 2, cancel_at=draw.choice([0.3, 0.7])), Job('F', 0.1, 1, 1))
    printer.judge()
    check_at_the_end(printer, draw)
    check_first_page(Printer(learner, 1, '/new'), draw)
    # One that waits behind many others.
    many = draw.randint(7, 9)
    printer, leaves = Printer(learner, many, '/long'), draw.randint(5, many - 1)
    printer.tell(
        Job('head', 0.0, 2),
        *(Job(f'W{number}', number / 50, 1, cancel_at=0.7 if number == leaves else NEVER) for number in range(1, many)),
    )
    printer.judge()


@pytest.mark.rules('lock')
@about('lock')
def test_threads(learner):
    """A goal comes just when another one ends, and another thread goes on in the middle of a callback.

    Each look at the list, together with the change that follows, stands in the lock.
    """
    check_switches(Printer(learner, learner.random.randint(1, 3), switches=True), cancel=False)


@pytest.mark.rules('lock')
@about('lock')
def test_threads_and_cancel(learner):
    """A goal comes and one that waits is cancelled, just when another one ends.

    Each look at the list, together with the change that follows, stands in the lock.
    """
    check_switches(Printer(learner, learner.random.randint(2, 3), switches=True), cancel=True)
