"""Exercise 7.7's cases: all that is known of a robot, with two faults from the whole chapter."""

from contextlib import contextmanager

from helpers.checks.chapter_07 import faulty_packages, faulty_robots, graphs, machines, stacks, tf_trees
from helpers.checks.chapter_07.findings import compare
from helpers.runner import about, expect
from helpers.runner.values import SetAsList
from helpers.runner.verdicts import LearnerError, LearnerTimeout

WHY = {**machines.WHY, **faulty_packages.WHY, **graphs.WHY, **stacks.WHY, **faulty_robots.WHY, **tf_trees.WHY}
# Faults that do not hide another one, by the part of the case; graphs' as `graphs.draw` names them.
FAULTS = {
    'machine': machines.CAUSES,
    'package': faulty_packages.CAUSES,
    'stacks': stacks.CAUSES,
    'model': faulty_robots.CAUSES,
    'frames': tf_trees.CAUSES,
    'graph': (
        'name',
        'nobody',
        'type',
        'reliability',
        'durability',
        'both',
        'service name',
        'service nobody',
        'service type',
        'description nobody',
        'description durability',
    ),
}
# Of these, what a repair makes right, by the part of the case.
REPAIRED = {
    **{part: FAULTS[part] for part in ('machine', 'package', 'model')},
    'frames': ('unknown', 'two parents', 'not connected'),
    'graph': ('name', 'reliability', 'durability', 'both', 'service name', 'description durability'),
}
_OF_GRAPHS = ('no_data', 'waiting', 'no_model')
_ENDPOINTS = 'repair_case must keep all endpoints, as a list of dictionaries.'
_STAYS = ('note', 'want', 'stacks', 'programs', 'target', 'source', 'now')  # what no tool repairs
# Faults of frames of which each hides the next one.
ROUNDS = ('unknown', tf_trees.ASIDE, 'not connected', 'not connected', 'old')


@contextmanager
def named(rule: str):
    """Within the block, whatever the checks of other exercises find out breaks this rule of exercise 7.7."""
    try:
        yield
    except LearnerError as error:
        error.rule = error.rule if error.rule == 'new-case' else rule
        raise


class DrawnCase:
    """A drawn case: `case` as the learner gets it, and all `expected` findings."""

    def __init__(
        self,
        random,
        faults: dict[str, tuple] | None = None,
        moves: bool | None = None,
        aged: str = '',
        twice: bool = False,
    ):
        """`faults`: part of the case -> causes. In 'graph', 'hidden' is a wrong name that hides a wrong reliability.

        `moves` and `aged`: as for `tf_trees.FaultyTree`. `twice`: the machine is one of `machines.twice`, whose
        findings differ in their evidence only.
        """
        faults = faults or {}
        causes = {part: faults.get(part, ()) for part in FAULTS}
        self.files, self.want, self.expected = (
            machines.twice(random) if twice else machines.draw(random, *causes['machine'])
        )
        self.package = faulty_packages.FaultyPackage(random, *causes['package'])
        self.robot = faulty_robots.FaultyRobot(random, *causes['model'])
        self.tree = tf_trees.FaultyTree(random, *causes['frames'], moves=moves, aged=aged)
        text, programs, hanging = stacks.draw(random, 'idle', *causes['stacks'], 'spinning')
        hidden = causes['graph'] == ('hidden',)
        endpoints, deaf = graphs.draw(random, *(('name',) if hidden else causes['graph']))
        if hidden:
            deaf = [*deaf, self._hide(endpoints, deaf[0])]
        self.expected = [
            *self.expected,
            *self.package.expected,
            *self.robot.expected,
            *self.tree.expected,
            *hanging,
            *deaf,
        ]
        self.case = {
            'note': f'battery changed {random.randint(2, 9)} days ago',  # that no tool asks for
            'files': self.files,
            'want': self.want,
            'package': self.package.files,
            'endpoints': endpoints,
            'stacks': text,
            'programs': programs,
            'urdf': self.robot.urdf,
            **dict(zip(('moving', 'static', 'target', 'source', 'now'), self.tree.arguments, strict=True)),
        }

    @staticmethod
    def _hide(endpoints: list[dict], finding: tuple) -> tuple:
        """Make a publisher whose topic is misspelt BEST_EFFORT, too; returns the finding that this gives."""
        _, where, _, right = finding
        node, wrong = where.split()
        for end in endpoints:
            if end['name'] in (right, wrong):
                strength = graphs.STRONG if end['role'] == 'subscription' else graphs.WEAK
                end['reliability'] = strength['reliability']
        return 'no_data', f'{node} {right}', 'reliability', graphs.WEAK['reliability']

    def triage(self, learner, rule: str) -> None:
        """Ask the learner's triage, and fail with words if it does not find what is expected."""
        with about(rule):
            try:
                found = learner.call('triage', self.case)
            except LearnerTimeout as error:
                error.rule = 'ends'
                raise
        expect(not isinstance(found, SetAsList), 'triage returned a set, expected a list: put list(…) around it.', rule)
        twice = [one for one in found if found.count(one) > 1] if isinstance(found, list) else []
        expect(not twice, f'You found {twice and twice[0]} more than once.', 'once')
        compare(found, self.expected, WHY, rule)

    def repaired(self, learner, rounds: int = 1) -> dict:
        """What the learner makes of the case, by repairing so often: once, if no fault hides another."""
        case = self.case
        for _ in range(rounds):
            case = learner.call('repair_case', case)
            expect(isinstance(case, dict), f'repair_case returned {case!r}, expected a case, a dictionary.', 'new-case')
            lost = sorted(self.case.keys() - case.keys())
            expect(not lost, f'The case that repair_case returned lacks {", ".join(lost)}.', 'new-case')
            other = [key for key in _STAYS if case[key] != self.case[key]]
            expect(
                not other,
                f'repair_case has changed {other and other[0]!r} of the case. No tool repairs that, so it stays.',
                'new-case',
            )
        return case

    def check(self, learner, part: str, after: dict) -> None:
        """Fail with words if this part of the repaired case `after` is not as it should be."""
        if part == 'graph':
            self.check_graph(after['endpoints'])
            return
        with named('transforms' if part == 'frames' else 'files'):
            match part:
                case 'machine':
                    machines.try_out(learner, self.files, after['files'], self.want)
                case 'package':
                    self.package.check(after['package'])
                case 'model':
                    self.robot.check(after['urdf'])
                case 'frames':
                    self.tree.check([after['moving'], after['static']])

    def check_graph(self, endpoints) -> None:
        """Fail with words if somebody is deaf in the repaired graph who need not be."""
        expect(isinstance(endpoints, list) and len(endpoints) == len(self.case['endpoints']), _ENDPOINTS, 'new-case')
        offered = {(end['name'], end['type']): end for end in endpoints if end['role'] in ('publisher', 'server')}
        for end in endpoints:
            if end['role'] in ('subscription', 'client'):
                other = offered.get((end['name'], end['type']))
                heard = other and all(
                    end[policy] != graphs.STRONG[policy] or other[policy] == end[policy]
                    for policy in graphs.STRONG
                    if end['role'] == 'subscription'
                )
                expect(heard, f'After your repair, {end["node"]} is still deaf on {end["name"]}.', 'endpoints')
        self._check_others(endpoints)

    def _check_others(self, endpoints: list[dict]) -> None:
        """Fail with words if an endpoint is not as it is when the nodes of the findings were started again."""
        wanted = [dict(end) for end in self.case['endpoints']]
        for fault, where, cause, evidence in self.expected:
            if fault not in _OF_GRAPHS or cause not in ('name', *graphs.STRONG):
                continue
            node, name = where.split()
            for end in wanted:
                if (end['node'], end['name']) == (node, name) and end['role'] in ('subscription', 'client'):
                    end[cause] = evidence
        wrong = [end for end in endpoints if end not in wanted]
        missing = [end for end in wanted if end not in endpoints]
        expect(
            not wrong and not missing,
            f'After your repair there is the endpoint {wrong[:1]}, expected {missing[:1]}. A repair starts the nodes '
            'of the findings again, with your arguments; nothing else about them changes, and all others stay as they '
            'were.',
            'endpoints',
        )


def judge_single_repairs(learner) -> None:
    """A fault is repaired, also if it is the only one of the case; a case without a fault stays as it is."""
    case = DrawnCase(learner.random)
    after = case.repaired(learner)
    for part in REPAIRED:
        case.check(learner, part, after)
    for part, causes in REPAIRED.items():
        for cause in causes:
            case = DrawnCase(learner.random, {part: (cause,)})
            case.check(learner, part, case.repaired(learner))


def judge_one_round(learner) -> None:
    """A call of repair_case is one round: what shows only after it is still there."""
    case = DrawnCase(learner.random, {'graph': ('hidden',)})
    (_, before, *_), (_, after, policy, _) = case.expected
    node, name = after.split()
    ends = case.repaired(learner)['endpoints']
    expect(isinstance(ends, list) and all(isinstance(end, dict) for end in ends), _ENDPOINTS, 'new-case')
    mine = [end for end in ends if (end.get('role'), end.get('node'), end.get('name')) == ('subscription', node, name)]
    expect(mine, f'{before} has a wrong name. After one call of repair_case, {node} is not at {name}.', 'endpoints')
    expect(
        mine[0].get(policy) == graphs.STRONG[policy],
        f'After one call of repair_case, {node} asks for {mine[0].get(policy)} on {name}. The name was wrong; that the '
        f'{policy} does not fit shows only after that is repaired, and is left for the next round.',
        'endpoints',
    )


def judge_one_round_of_frames(learner) -> None:
    """The same for frames: what is wrong elsewhere in the tree shows only when the source has its name."""
    case = DrawnCase(learner.random, {'frames': ('unknown', tf_trees.ASIDE)})
    parts = [case.case['moving'], case.repaired(learner)['moving']]
    before, after = ([names for names in map(tf_trees.names_of, part) if 'lid' in names] for part in parts)
    expect(
        before == after,
        f'{case.tree.source} was unknown. After one call of repair_case, the transform {" → ".join(before[0])} is '
        f'{" → ".join(after[0]) if after else "gone"}. That a frame has two parents shows only after the name is '
        'repaired, and is left for the next round.',
        'transforms',
    )


def everything(random) -> DrawnCase:
    """A case with a fault in each part, two or more of which hide others: many findings, in several rounds."""
    faults = {part: (random.choice(causes),) for part, causes in FAULTS.items()}
    return DrawnCase(random, {**faults, 'frames': ROUNDS, 'graph': ('hidden',)})
