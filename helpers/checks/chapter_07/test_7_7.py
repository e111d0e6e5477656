"""Visible tests of exercise 7.7, the mystery."""

import pytest

from helpers.checks.chapter_07 import machines
from helpers.checks.chapter_07.cases import FAULTS, Case, named

pytestmark = pytest.mark.exercise('7.7')


@pytest.mark.rules('nothing', 'every-part', 'hidden', 'once', 'ends')
def test_triage(learner):
    """All findings are there, also those that show only after a repair; a case without a fault gives an empty list.

    Ask all six tools, repair, and look again until there is nothing new.
    """
    random = learner.random
    Case(random).triage(learner, 'nothing')
    for part in FAULTS:
        Case(random, {part: (random.choice(FAULTS[part]),)}).triage(learner, 'every-part')
    Case(random, {'graph': ('type', 'nobody')}).triage(learner, 'ends')
    Case(random, {'graph': ('hidden',)}).triage(learner, 'hidden')
    for first in ('unknown', 'two parents', 'not connected'):
        Case(random, {'frames': (first, 'old')}, moves=True).triage(learner, 'hidden')
    Case(random, {'frames': ('unknown', 'not connected', 'old')}, moves=False).triage(learner, 'hidden')


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
        after = case.repaired(learner)
        machines.try_out(learner, case.files, after['files'], case.want)
        case.package.check(after['package'])
        case.robot.check(after['urdf'])
    case.check_graph(after['endpoints'])
    with named('transforms'):
        case.tree.check([after['moving'], after['static']])
    for faults in (['service name', 'both'], ['description durability', 'name']):
        case = Case(random, {'graph': tuple(faults)})
        case.check_graph(case.repaired(learner)['endpoints'])
    for cause, moves in (('two parents', True), ('not connected', False)):
        case = Case(random, {'frames': (cause,)}, moves)
        with named('transforms'):
            after = case.repaired(learner)
            case.tree.check([after['moving'], after['static']])
