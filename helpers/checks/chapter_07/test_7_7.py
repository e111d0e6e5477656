"""Visible tests of exercise 7.7, the mystery."""

import pytest

from helpers.checks.chapter_07 import machines
from helpers.checks.chapter_07.cases import FAULTS, ROUNDS, Case, everything, named
from helpers.checks.chapter_07.tf_trees import ASIDE

pytestmark = pytest.mark.exercise('7.7')


@pytest.mark.rules('nothing', 'every-part', 'hidden', 'once', 'ends')
def test_triage(learner):
    """All findings are there, also those that show only after a repair; a case without a fault gives an empty list.

    Ask all six tools, repair, and look again until there is nothing new.
    """
    random = learner.random
    Case(random).triage(learner, 'nothing')
    for number in range(max(map(len, FAULTS.values()))):  # each fault of each part, in one case with others
        faults = {part: (causes[number % len(causes)],) for part, causes in FAULTS.items()}
        Case(random, faults).triage(learner, 'every-part')
    Case(random, twice=True).triage(learner, 'every-part')
    Case(random, {'graph': ('type', 'nobody')}).triage(learner, 'ends')
    Case(random, {'graph': ('hidden',)}).triage(learner, 'hidden')
    for first in ('unknown', 'two parents', 'not connected'):
        Case(random, {'frames': (first, 'old')}, moves=True, aged='both').triage(learner, 'hidden')
    Case(random, {'frames': ROUNDS, 'graph': ('type',)}).triage(learner, 'hidden')
    everything(random).triage(learner, 'hidden')


@pytest.mark.rules('files', 'endpoints', 'transforms', 'new-case')
def test_repair(learner):
    """After some rounds of repair_case everything that can be repaired is right.

    `{**case, 'urdf': …}` is a new dictionary with one entry changed.
    """
    random = learner.random
    case = Case(
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
        machines.try_out(learner, case.files, after['files'], case.want)
        case.package.check(after['package'])
        case.robot.check(after['urdf'])
    case.check_graph(after['endpoints'])
    with named('transforms'):
        case.tree.check([after['moving'], after['static']])
    case = Case(random, {'machine': ('release',)})  # nothing else is wrong
    with named('files'):
        machines.try_out(learner, case.files, case.repaired(learner)['files'], case.want)
    for faults in (['service name', 'both'], ['description durability', 'name']):
        case = Case(random, {'graph': tuple(faults)})
        case.check_graph(case.repaired(learner)['endpoints'])
    for causes, moves in ((['two parents'], True), (['two parents', ASIDE], False), (['not connected'], False)):
        case = Case(random, {'frames': tuple(causes)}, moves)
        with named('transforms'):
            after = case.repaired(learner)
            case.tree.check([after['moving'], after['static']])
