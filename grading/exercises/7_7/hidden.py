"""Hidden tests of exercise 7.7, the mystery. Both faults are drawn, and all the rest."""

import pytest

from helpers.checks.chapter_07 import machines
from helpers.checks.chapter_07.cases import (
    FAULTS,
    ROUNDS,
    DrawnCase,
    everything,
    judge_one_round,
    judge_one_round_of_frames,
    judge_single_repairs,
    named,
)
from helpers.checks.chapter_07.tf_trees import ASIDE
from helpers.runner import expect, waiting

pytestmark = pytest.mark.exercise('7.7')


def find(learner, faults, rule):
    DrawnCase(learner.random, faults).triage(learner, rule)


@pytest.mark.rules('nothing')
def test_healthy_case(learner):
    """A case without a fault gives an empty list.

    Each of your six tools gives one for its part.
    """
    find(learner, {}, 'nothing')
    faulty = DrawnCase(learner.random, {'machine': ('key',), 'package': FAULTS['package'][:1], 'graph': ('type',)})
    with waiting('ends'):
        found = learner.call('triage', faulty.case)
    expect(found != [], 'A case with three faults gives an empty list, too.', 'nothing')


@pytest.mark.rules('every-part', 'once')
@pytest.mark.weight(3)
def test_two_faults(learner):
    """Two faults from different parts of the case are both found, and nothing else.

    Every part of the case is asked.
    """
    for _ in range(3):
        parts = learner.random.sample(sorted(FAULTS), len(FAULTS))
        for pair in zip(parts[::2], parts[1::2], strict=True):
            find(learner, {part: (learner.random.choice(FAULTS[part]),) for part in pair}, 'every-part')
    DrawnCase(learner.random, twice=True).triage(learner, 'every-part')
    for fault in ('both', 'service name', 'description durability'):
        find(learner, {'graph': (fault,), 'stacks': ('server',)}, 'every-part')


@pytest.mark.rules('hidden')
@pytest.mark.weight(2)
def test_hidden_by_a_name(learner):
    """A misspelt topic hides that the QoS does not fit, either: both are found.

    Look, repair, and look again.
    """
    for _ in range(3):
        find(learner, {'graph': ('hidden',)}, 'hidden')


@pytest.mark.rules('hidden')
@pytest.mark.weight(2)
def test_hidden_frames(learner):
    """A wrong name in the tree of frames hides that a broadcaster has stopped: both are found.

    Repair both lists of transforms, and look again.
    """
    for first in ('unknown', 'two parents', 'not connected'):
        DrawnCase(learner.random, {'frames': (first, 'old')}, moves=True, aged='both').triage(learner, 'hidden')


@pytest.mark.rules('hidden')
def test_many_rounds(learner):
    """Many faults may hide one another: all are found.

    Go on as long as there is something new.
    """
    for _ in range(2):
        find(learner, {'frames': ROUNDS, 'graph': ('type',)}, 'hidden')
    everything(learner.random).triage(learner, 'hidden')


@pytest.mark.rules('ends', 'once', 'every-part', 'hidden')
def test_beyond_repair(learner):
    """What nobody can repair from outside is found once, and triage comes to an end.

    Go on only while there is something new.
    """
    find(learner, {'graph': ('type', 'nobody')}, 'ends')
    find(learner, {'stacks': learner.random.sample(FAULTS['stacks'], 2)}, 'every-part')
    # In the second round the callback is found again, beside what was hidden.
    find(learner, {'graph': ('hidden',), 'stacks': ('server',)}, 'hidden')


@pytest.mark.rules('files', 'new-case')
@pytest.mark.weight(2)
def test_repaired_machine(learner):
    """The repaired case has a machine on which a shell finds everything, and a package with right entry points.

    repair_machine and repair_package.
    """
    case = DrawnCase(
        learner.random,
        {'machine': (learner.random.choice(machines.CAUSES[3:]), 'release'), 'package': ('module', 'function')},
    )
    with named('files'):
        after = case.repaired(learner)
    for part in ('machine', 'package'):
        case.check(learner, part, after)


@pytest.mark.rules('files', 'endpoints', 'transforms', 'new-case')
def test_single_repairs(learner):
    """A fault that is the only one of the case is repaired, whichever it is.

    Each tool repairs its part.
    """
    judge_single_repairs(learner)


@pytest.mark.rules('endpoints', 'new-case')
@pytest.mark.weight(2)
def test_repaired_graph(learner):
    """In the repaired case everybody hears what they should, also after two repairs.

    repair_graph gives the arguments, with_arguments the graph.
    """
    judge_one_round(learner)
    for faults in (['hidden'], ['service name', 'both'], ['description durability', 'name']):
        case = DrawnCase(learner.random, {'graph': tuple(faults)})
        case.check(learner, 'graph', case.repaired(learner, 1 + (faults == ['hidden'])))


@pytest.mark.rules('transforms', 'files')
@pytest.mark.weight(2)
def test_repaired_frames(learner):
    """In the repaired case tf2 finds the sensor, and the model can be simulated.

    repair_tf for both lists, and repair_model.
    """
    judge_one_round_of_frames(learner)
    for causes, moves in (
        (['unknown'], None),
        (['two parents'], True),
        (['two parents', ASIDE], False),
        (['not connected'], False),
    ):
        case = DrawnCase(
            learner.random, {'frames': tuple(causes), 'model': (learner.random.choice(FAULTS['model']),)}, moves
        )
        with named('transforms'):
            after = case.repaired(learner)
        for part in ('frames', 'model'):
            case.check(learner, part, after)
