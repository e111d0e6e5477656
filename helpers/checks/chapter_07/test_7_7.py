"""Visible tests of exercise 7.7, the mystery."""

import pytest

from helpers.checks.chapter_07 import machines
from helpers.checks.chapter_07.cases import (
    FAULTS,
    REPAIRED,
    ROUNDS,
    DrawnCase,
    everything,
    judge_one_round,
    judge_one_round_of_frames,
    judge_single_repairs,
    named,
)
from helpers.checks.chapter_07.tf_trees import ASIDE

pytestmark = pytest.mark.exercise('7.7')


@pytest.mark.rules('nothing', 'every-part', 'hidden', 'once', 'ends')
def test_triage(learner):
    """All findings are there, also those that show only after a repair; a case without a fault gives an empty list.

    Ask all six tools, repair, and look again until there is nothing new.
    """
    random = learner.random
    DrawnCase(random).triage(learner, 'nothing')
    for number in range(max(map(len, FAULTS.values()))):  # each fault of each part, in one case with others
        faults = {part: (causes[number % len(causes)],) for part, causes in FAULTS.items()}
        DrawnCase(random, faults).triage(learner, 'every-part')
    DrawnCase(random, twice=True).triage(learner, 'every-part')
    DrawnCase(random, {'graph': ('type', 'nobody')}).triage(learner, 'ends')
    DrawnCase(random, {'graph': ('hidden',)}).triage(learner, 'hidden')
    for first in ('unknown', 'two parents', 'not connected'):
        DrawnCase(random, {'frames': (first, 'old')}, moves=True, aged='both').triage(learner, 'hidden')
    DrawnCase(random, {'frames': ROUNDS, 'graph': ('type',)}).triage(learner, 'hidden')
    everything(random).triage(learner, 'hidden')


@pytest.mark.rules('files', 'endpoints', 'transforms', 'new-case')
def test_repair(learner):
    """After some rounds of repair_case everything that can be repaired is right.

    `{**case, 'urdf': …}` is a new dictionary with one entry changed.
    """
    random = learner.random
    case = DrawnCase(
        random,
        {
            'machine': (random.choice(machines.CAUSES[3:]), 'release'),
            'package': ('module',),
            'model': (random.choice(FAULTS['model']),),
            'graph': ('hidden',),
            'frames': ('unknown',),
        },
    )
    with named('files'):
        after = case.repaired(learner, 2)
    for part in REPAIRED:
        case.check(learner, part, after)
    judge_single_repairs(learner)
    judge_one_round(learner)
    judge_one_round_of_frames(learner)
    for faults in (('service name', 'both'), ('description durability', 'name')):
        case = DrawnCase(random, {'graph': faults})
        case.check(learner, 'graph', case.repaired(learner))
    for causes, moves in ((('two parents',), True), (('two parents', ASIDE), False), (('not connected',), False)):
        case = DrawnCase(random, {'frames': causes}, moves)
        with named('transforms'):
            after = case.repaired(learner)
        case.check(learner, 'frames', after)
