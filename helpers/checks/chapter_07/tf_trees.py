"""Exercise 7.6's trees of frames: drawn with their faults, and looked up in a real tf2 buffer."""

from difflib import get_close_matches

from geometry_msgs.msg import TransformStamped
from rclpy.time import Time
from tf2_ros import Buffer, TransformException

from helpers.checks.chapter_07.findings import compare
from helpers.programs.faults.words import misspelt
from helpers.runner import about, expect

CAUSES = ('unknown', 'two parents', 'not connected', 'old')
WHY = {
    'unknown': 'A frame is known if a transform has it as parent or as child, on /tf or on /tf_static.',
    'two parents': 'A frame that is the child of two others: the wrong parent is the one that is neither the target '
    "nor anybody's child.",
    'not connected': 'Go from the source to its parent, and on, until there is none: there the way must end at the '
    'target. The evidence is a frame of another tree, so of none that is below the top frame.',
    'old': 'The newest stamp of each moving transform on the way counts; static ones do not age. More than 1 s is old; '
    'what is ahead of now is not.',
}
_ROOTS, _SENSORS = ('map', 'odom', 'world'), ('laser', 'camera', 'gripper', 'sonar', 'antenna')
_FIXED = ('mast', 'plate', 'bracket', 'housing')
_FAR = 'pedestal'  # a name that is like no other
# Which transforms of the way are old.
_AGED = {'upper': ['platform'], 'lower': ['middle'], 'both': ['platform', 'middle'], 'sensor': ['sensor']}
ASIDE = 'two parents aside'


class _Faults:
    """In what the published transforms differ from the tree; edges are named by their child."""

    def __init__(self):
        self.names: dict[tuple[str, str], str] = {}  # (edge, 'parent' or 'child') -> what is published instead
        self.exchanged: set[str] = set()  # the edges whose parent and child change places
        self.ages: dict[str, float] = {}  # edge -> age of its newest transform, in seconds

    def published(self, parent: str, child: str) -> tuple[str, str]:
        """The parent and the child that are published for an edge."""
        names = self.names.get((child, 'parent'), parent), self.names.get((child, 'child'), child)
        return names[::-1] if child in self.exchanged else names


class FaultyTree:
    """A drawn robot: `moving`, `static`, `target`, `source`, `now`; the `expected` findings, and the `truth`."""

    def __init__(
        self,
        random,
        *causes: str,
        near: bool = True,
        moves: bool | None = None,
        decoy: bool = False,
        third: bool = False,
        aged: str = '',
        loose: bool = False,
    ):
        """:param causes: of `CAUSES`; ASIDE is a frame with two parents that is not on the way. 'not connected' may
            come twice: then the tree is broken in two places.
        :param near: whether the name that was meant can be found, if one is wrong.
        :param moves: whether a transform with wrong names is a moving one; None: as it comes. The sensor's own one
            is static, unless it is old.
        :param decoy: below the sensor there is a frame whose name is nearest to a top frame that is misspelt.
        :param third: with `near` false, the name that is nearest to the top frame is in a third tree.
        :param aged: which transforms are old: a key of `_AGED`; '' draws one.
        :param loose: nobody publishes the transform to the sensor: it is a parent only.
        """
        moves = random.random() < 0.5 if moves is None else moves
        self._random = random
        self.target = random.choice(_ROOTS)
        self.source, other = random.sample(_SENSORS, 2)
        self.now = float(random.randint(100, 900))
        middle = random.choice(['base_footprint', 'base_link', 'chassis'])
        fixed = random.choice(_FIXED)
        # From the target to the sensor: two moving transforms, two static ones; and another sensor.
        edges = [
            (self.target, 'platform', True),
            ('platform', middle, True),
            (middle, fixed, False),
            (fixed, self.source, aged == 'sensor'),
            (middle, other, False),
            *([(self.source, 'lens', False)] if moves or loose else []),
        ]
        numbers = {child: [round(random.uniform(-2.0, 2.0), 2) for _ in range(3)] for _, child, _ in edges}
        self.truth = [
            sum(numbers[child][axis] for child in ('platform', middle, fixed, self.source)) for axis in range(3)
        ]
        self.expected: list[tuple] = []
        faults = self._draw_faults(causes, near, moves, (middle, fixed, other), aged, f'{_FAR}s' if third else '')
        if loose:
            edges = [edge for edge in edges if edge[1] != self.source]
            if not causes:
                self._found(self.source, 'not connected', '')
        edges += self._more_edges(middle, decoy, third)
        self._draw_transforms(edges, numbers, faults, other)

    def _draw_transforms(self, edges: list, numbers: dict, faults: _Faults, other: str) -> None:
        """Draw when each transform was published: `moving` and `static`. `other` is the sensor that is not asked."""
        random = self._random
        self._names: dict[int, tuple[str, str]] = {}  # the right names of each transform, by its id
        self.moving, self.static = [], []
        for parent, child, moving in edges:
            published = faults.published(parent, child)
            # What is not old is at most 1 s old, or comes from a machine whose clock is fast.
            young = random.choice([1.0, random.randint(0, 970) / 1000, -random.randint(1100, 2500) / 1000])
            age = faults.ages.get(child, young)
            # What has come on /tf, the newest one last but for a late one; on /tf_static it came once.
            for back in (4.0, 2.0, 0.6, 0.3, 0.0) if moving else [0.0]:
                # A static one keeps the time of its start, or has none.
                stamp = self.now - (age + back if moving else random.choice([self.now, random.randint(30, 90)]))
                made = _transform(*published, numbers.get(child, [0.1, 0.0, 0.0]), stamp)
                if child in (self.source, other):  # a rotation there does not move the sensor
                    made.transform.rotation.z, made.transform.rotation.w = random.choice([(0.6, 0.8), (-0.8, 0.6)])
                self._names[id(made)] = parent, child
                (self.moving if moving else self.static).append(made)
        # An end of the tree that has stopped, and is not on the way.
        lid = _transform(*faults.published(other, 'lid'), [0.0, 0.0, 0.1], self.now - 30.0)
        self._names[id(lid)] = other, 'lid'
        self.moving.append(lid)
        random.shuffle(self.moving)
        random.shuffle(self.static)

    def _more_edges(self, middle: str, decoy: bool, third: bool) -> list[tuple[str, str, bool]]:
        """Frames whose names are like wrong ones; for the parameters see `__init__`."""
        edges = []
        for _, where, cause, evidence in self.expected:
            if cause == 'not connected' and decoy:
                edges.append((self.source, f'{where}2', False))
            if cause == 'unknown' and evidence:
                edges.append((middle, f'{evidence}2', False))
        return [*edges, (f'{_FAR}s', 'mat', False)] if third else edges

    def _draw_faults(
        self, causes, near: bool, moves: bool, frames: tuple[str, str, str], aged: str, meant: str
    ) -> '_Faults':
        """Draw these faults into the edges to some of the frames, and note what is to be found.

        :param meant: what is nearest to the top frame if `near` is false.
        """
        faults, (middle, fixed, other) = _Faults(), frames
        for cause in causes:
            if cause == 'unknown':
                wrong = self.misspelt(self.source) if near else 'thermometer'
                faults.names[self.source, 'child'] = faults.names['lens', 'parent'] = wrong
                self._found(self.source, 'unknown', wrong if near else '')
            elif cause == 'not connected':
                parent, child = ('platform', middle) if moves else (middle, fixed)
                wrong = self.misspelt(parent) if near else _FAR
                faults.names[child, 'parent'] = wrong
                self._found(wrong, 'not connected', parent if near else meant)
                moves = not moves  # if there is another one, it is elsewhere
            elif cause == 'two parents':
                sensors = [fixed] if ASIDE in causes else [other, fixed]
                exchanged = middle if moves else self._random.choice(sensors)
                faults.exchanged.add(exchanged)
                self._found('platform' if moves else middle, 'two parents', exchanged)
            elif cause == ASIDE:
                faults.exchanged.add('lid')
                self._found(other, 'two parents', 'lid')
            elif cause == 'old':
                for name in _AGED[aged or self._random.choice(['upper', 'lower', 'both'])]:
                    child = {'platform': 'platform', 'middle': middle, 'sensor': self.source}[name]
                    faults.ages[child] = self._random.randint(11, 95) / 10 + self._random.randint(-30, 30) / 1000
                    self._found(child, 'old', f'{faults.ages[child]:.1f}')
        return faults

    @property
    def arguments(self) -> tuple:
        """What the learner's functions get."""
        return self.moving, self.static, self.target, self.source, self.now

    def diagnose(self, learner, expected: list[tuple] | None = None, rule: str = '', transforms=None) -> None:
        """Ask the learner's diagnose_tf, by default about this tree, and fail with words if it finds anything else."""
        moving, static = transforms or (self.moving, self.static)
        edges = [sorted({' → '.join(names_of(one)) for one in part}) for part in (moving, static)]
        given = (
            f'Asked for {self.source} in {self.target}, now = {self.now}.\nmoving: {", ".join(edges[0])}\n'
            f'static: {", ".join(edges[1])}'
        )
        compare(
            learner.call('diagnose_tf', moving, static, *self.arguments[2:]),
            self.expected if expected is None else expected,
            WHY,
            rule,
            given,
        )

    def in_order(self) -> 'FaultyTree':
        """The tree, with moving transforms that have come in the order of their stamps."""
        self.moving.sort(key=lambda one: Time.from_msg(one.header.stamp).nanoseconds)
        return self

    def repaired(self, learner, findings) -> list:
        """Both lists after the learner's repair of these findings."""
        parts = [self.moving, self.static]
        for finding in findings:
            parts = [learner.call('repair_finding', part, list(finding)) for part in parts]
        return parts

    def check(self, repaired) -> None:
        """Fail with words if the sensor cannot be looked up in the repaired transforms, or is elsewhere."""
        fits = (
            isinstance(repaired, list)
            and len(repaired) == 2
            and all(isinstance(part, list) for part in repaired)
            and all(isinstance(one, TransformStamped) for part in repaired for one in part)
        )
        expect(fits, 'repair_tf must return a list of TransformStamped.', 'kept')
        for before, after in zip((self.moving, self.static), repaired, strict=True):
            expect(
                len(before) == len(after), f'repair_tf got {len(before)} transforms and returned {len(after)}.', 'kept'
            )
            moved = [
                one
                for one, other in zip(before, after, strict=True)
                if one.transform != other.transform or one.header.stamp != other.header.stamp
            ]
            expect(
                not moved,
                'The numbers and the stamps of a transform were right: only names are to be '
                'changed, and the order stays.',
                'kept',
            )
        buffer = Buffer()
        for part, static in zip(repaired, (False, True), strict=True):
            for one in sorted(part, key=lambda one: Time.from_msg(one.header.stamp).nanoseconds):
                put = buffer.set_transform_static if static else buffer.set_transform
                put(one, 'test')
        try:
            seen = buffer.lookup_transform(self.target, self.source, Time()).transform.translation
        except TransformException as error:
            expect(False, f'After your repair, tf2 does not find {self.source} from {self.target}: {error}', 'repaired')
        off = max(abs(a - b) for a, b in zip((seen.x, seen.y, seen.z), self.truth, strict=True))
        expect(
            off < 1e-6,
            f'After your repair, tf2 finds {self.source} at ({seen.x:.2f}, {seen.y:.2f}, {seen.z:.2f}), '
            f'expected ({", ".join(f"{value:.2f}" for value in self.truth)}).',
            'repaired',
        )
        self._check_names(repaired)

    def _check_names(self, repaired) -> None:
        """Fail with words if a transform has not the names with which it should have been published."""
        for before, after in zip([*self.moving, *self.static], [*repaired[0], *repaired[1]], strict=True):
            was, now, right = names_of(before), names_of(after), self._names[id(before)]
            what = f'After your repair, the transform {" → ".join(was)} is {" → ".join(now)}, expected '
            if was == right:
                expect(now == right, f'{what}no change: only the wrong frame gets another name.', 'kept')
            expect(
                now == right,
                f'{what}{" → ".join(right)}: a wrong name is to be changed wherever it stands, as parent and as child.',
                'repaired',
            )

    def _found(self, where: str, cause: str, evidence: str) -> None:
        self.expected.append(('no_transform', where, cause, evidence))

    def misspelt(self, name: str) -> str:
        """A wrong spelling for which no other frame could be meant."""
        bases = {'platform', 'base_footprint', 'base_link', 'chassis'}
        others = {*_ROOTS, *_SENSORS, *_FIXED, *bases, 'lid', 'lens'} - {name}
        while True:
            wrong = misspelt(name, self._random)
            if get_close_matches(wrong, [name], 1, 0.78) and not get_close_matches(wrong, others, 1, 0.6):
                return wrong


def judge_other_places(learner) -> None:
    """Causes that are not on the way to the sensor: rules `unknown`, `two-parents` and `not-connected`."""
    with about('unknown'):
        FaultyTree(learner.random, 'unknown', loose=True).diagnose(learner)
        tree = FaultyTree(learner.random, loose=True)
        tree.diagnose(learner, rule='unknown')
        _judge_meant_target(learner, tree)
        _judge_other_letters(learner)
        _judge_silence(learner)
    with about('two-parents'):
        FaultyTree(learner.random, ASIDE).diagnose(learner)
        FaultyTree(learner.random, 'two parents', ASIDE, moves=False).diagnose(learner)
    _judge_usual_roots(learner)
    _judge_meant_names(learner)
    FaultyTree(learner.random, 'not connected', near=False, third=True).diagnose(learner)
    _judge_deep_way(learner)


def _judge_silence(learner) -> None:
    """The rule `unknown`, where nothing has come at all: then no frame is known."""
    source = learner.random.choice(_SENSORS)
    compare(
        learner.call('diagnose_tf', [], [], 'map', source, 9.0),
        [('no_transform', source, 'unknown', '')],
        WHY,
        'unknown',
        f'Asked for {source} in map. Nothing has come, on /tf and on /tf_static: both lists are empty.',
    )


def _judge_deep_way(learner) -> None:
    """A sensor that is many frames below the target: the way up is gone to its end, whatever its length.

    Rules `not-connected` and `old`: the transform at the top is new or old.
    """
    random = learner.random
    names = ['map', *(f'part{number}' for number in range(random.randint(20, 30))), random.choice(_SENSORS)]
    pairs = list(zip(names, names[1:], strict=False))
    static = [_transform(*pair, [0.1, 0.0, 0.0], 0.0) for pair in pairs[1:]]
    random.shuffle(static)
    for age, rule in ((0.5, 'not-connected'), (random.randint(20, 90) / 10, 'old')):
        moving, old = [_transform(*pairs[0], [0.1, 0.0, 0.0], 100.0 - age)], age > 1.0
        with about(rule):
            compare(
                learner.call('diagnose_tf', moving, static, 'map', names[-1], 100.0),
                [('no_transform', names[1], 'old', f'{age:.1f}')] if old else [],
                WHY,
                given=f'The way from {names[-1]} to map goes through {len(names) - 2} frames. map → {names[1]} is '
                f'{age} s old, all others are static.',
            )


def _judge_usual_roots(learner) -> None:
    """A frame with the name of another robot's root is a frame like any other: `two-parents` and `not-connected`."""
    random = learner.random
    target, root = random.sample(_ROOTS, 2)
    source = random.choice(_SENSORS)
    for pairs, finding in (
        ([(target, 'lamp'), (root, 'base_link'), ('base_link', source)], (root, 'not connected', '')),
        ([(target, 'base_link'), (root, 'base_link'), ('base_link', source)], ('base_link', 'two parents', root)),
    ):
        random.shuffle(pairs)
        with about(finding[1].replace(' ', '-')):
            compare(
                learner.call(
                    'diagnose_tf', [], [_transform(*pair, [0.1, 0.0, 0.0], 0.0) for pair in pairs], target, source, 9.0
                ),
                [('no_transform', *finding)],
                WHY,
                given=f'Asked for {source} in {target}; {root} is not the target here. '
                f'static: {", ".join(" → ".join(pair) for pair in pairs)}',
            )


def _judge_meant_names(learner) -> None:
    """The evidence is what `nearest` finds: no name that is only a little alike, but one with the same last part.

    Rules `unknown` and `not-connected`.
    """
    source = learner.random.choice(_SENSORS)
    prefix = learner.random.choice(['left', 'rear', 'base'])  # longer names would not even be a little alike
    for name, meant in ((f'{source}_{prefix}', ''), (f'{prefix}/{source}', f'{prefix}/{source}')):
        for pairs, cause in (([('map', name)], 'unknown'), ([('map', name), (source, 'lens')], 'not connected')):
            asked = source if cause == 'unknown' else 'lens'
            static = [_transform(*pair, [0.1, 0.0, 0.0], 0.0) for pair in pairs]
            with about(cause.replace(' ', '-')):
                compare(
                    learner.call('diagnose_tf', [], static, 'map', asked, 9.0),
                    [('no_transform', source, cause, meant)],
                    {one: f'{why} `nearest` of section 7.2 says which name was meant.' for one, why in WHY.items()},
                    given=f'Asked for {asked} in map. static: {", ".join(" → ".join(pair) for pair in pairs)}',
                )


def _judge_meant_target(learner, tree: FaultyTree) -> None:
    """The rule `unknown`, where the target itself was meant: it is a frame like any other."""
    wrong = tree.misspelt('platform')
    static = [_transform('platform', tree.source, [0.1, 0.0, 0.0], 0.0)]
    compare(
        learner.call('diagnose_tf', [], static, 'platform', wrong, 100.0),
        [('no_transform', wrong, 'unknown', 'platform')],
        WHY,
        'unknown',
        f'Asked for {wrong} in platform. static: platform → {tree.source}',
    )


def _judge_other_letters(learner) -> None:
    """The rule `unknown`, where the frame is there with a capital letter, or with something before its name."""
    source = learner.random.choice(_SENSORS)
    for name in (source.capitalize(), f'/{source}', f'robot/{source}'):
        compare(
            learner.call(
                'diagnose_tf', [], [_transform('platform', name, [0.1, 0.0, 0.0], 0.0)], 'platform', source, 9.0
            ),
            [('no_transform', source, 'unknown', name)],
            WHY,
            'unknown',
            f'Asked for {source} in platform. static: platform → {name}',
        )


def judge_rare_trees(learner) -> None:
    """Trees that are deep, stand still, have no target, or times that do not begin at a second: not for `unknown`.

    An age is just more than 1 s, exactly 1 s, or long; the newest stamp has few nanoseconds.
    """
    random = learner.random
    # Names like that of the top frame, boot: on the way, below the sensor, and beside both.
    chain = ['boot1', *(f'part{number}' for number in range(1, random.randint(7, 12)))]
    source = chain[random.randint(1, 2)]
    static = [_transform(*pair, [0.1, 0.0, 0.0], 0.0) for pair in zip(chain, chain[1:], strict=False)]
    for pair in ((chain[-1], 'boot2'), ('boot', chain[0]), ('boot', 'shelf'), ('shelf', 'boot3')):
        static.append(_transform(*pair, [0.1, 0.0, 0.0], 0.0))
    random.shuffle(static)
    for target, more, meant in (('map', [], ''), ('map', [_transform('map', 'boat', [0.1, 0.0, 0.0], 0.0)], 'boat')):
        with about('not-connected'):
            compare(
                learner.call('diagnose_tf', [], static + more, target, source, 100.0),
                [('no_transform', 'boot', 'not connected', meant)],
                WHY,
                'not-connected',
                f'static: {", ".join(" → ".join(names_of(one)) for one in static + more)}',
            )
    frame = random.choice(chain[3:])
    exchanged = [*static, _transform('lamp', frame, [0.1, 0.0, 0.0], 0.0)]
    random.shuffle(exchanged)
    with about('two-parents'):
        compare(
            learner.call('diagnose_tf', [], exchanged, 'boot', source, 100.0),
            [('no_transform', frame, 'two parents', 'lamp')],
            WHY,
            'two-parents',
            f'Nothing moves. static: {", ".join(" → ".join(names_of(one)) for one in exchanged)}',
        )
    _judge_time_zero(learner, source)
    begin = random.randint(1000, 9000)
    for age, rule in ((1.03, 'old'), (1.0, 'old'), (random.randint(120, 99990) / 10, 'old'), (1.52, 'newest')):
        stamp, back = begin + random.choice([0.05, 0.0625]), random.choice([0.25, 0.5])  # which are exact, or nearly
        now = stamp + age
        moving = [_transform('map', source, [0.1, 0.0, 0.0], one) for one in (stamp - back, stamp, stamp - 2 * back)]
        expected = [('no_transform', source, 'old', f'{now - stamp:.1f}')] if age != 1.0 else []
        if age == 1.0:  # a moment younger: nobody is judged by the last digit of a number
            now -= 1e-4
        with about(rule):
            compare(
                learner.call('diagnose_tf', moving, [], 'map', source, now),
                expected,
                WHY,
                rule,
                f'now = {now}, the stamps of map → {source}: {", ".join(str(one) for one in (stamp - back, stamp))}',
            )


def _judge_time_zero(learner, source: str) -> None:
    """The rule `old`, where the newest stamp is 0.0, as in a simulation that has just begun."""
    now = round(learner.random.uniform(2.0, 9.0), 1)
    with about('old'):
        compare(
            learner.call('diagnose_tf', [_transform('map', source, [0.1, 0.0, 0.0], 0.0)], [], 'map', source, now),
            [('no_transform', source, 'old', f'{now:.1f}')],
            WHY,
            'old',
            f'now = {now}, and the stamp of map → {source}, which came on /tf, is 0.0: the time of a simulation begins '
            'there.',
        )


def judge_names(learner) -> None:
    """A frame gets another name, and no frame whose name is like that: rule `kept`."""
    wrong, right = learner.random.sample(_SENSORS, 2)
    like = [wrong.upper(), wrong.capitalize(), f'{wrong}_2', f'front_{wrong}', f'robot/{wrong}', f'/{wrong}']
    for where, cause, evidence in ((right, 'unknown', wrong), (wrong, 'not connected', right)):
        names = [(wrong, 'lens'), ('mast', wrong), *((one, f'lens{number}') for number, one in enumerate(like))]
        given = [_transform(*pair, [0.1, 0.0, 0.0], 1.5) for pair in names]
        with about('repaired'):
            after = learner.call('repair_finding', given, ['no_transform', where, cause, evidence])
        fits = isinstance(after, list) and all(isinstance(one, TransformStamped) for one in after)
        expect(fits and len(after) == len(given), 'repair_tf must return a list of as many TransformStamped.', 'kept')
        for before, now in zip(names, map(names_of, after), strict=True):
            wanted = tuple(right if name == wrong else name for name in before)
            expect(
                now == wanted,
                f'The frame {wrong} gets the name {right}, letter by letter. After your repair, the transform '
                f'{" → ".join(before)} is {" → ".join(now)}, expected {" → ".join(wanted)}.',
                'repaired' if before != wanted else 'kept',
            )
        nothing = learner.call('repair_finding', [], ['no_transform', where, cause, evidence])
        expect(
            nothing == [],
            f'Nothing came on one of the topics: repair_tf got an empty list and returned {nothing!r}, expected [].',
            'kept',
        )


def _transform(parent: str, child: str, numbers, stamp: float) -> TransformStamped:
    made = TransformStamped()
    made.header.frame_id, made.child_frame_id = parent, child
    made.header.stamp = Time(nanoseconds=round(stamp * 10**9)).to_msg()
    made.transform.translation.x, made.transform.translation.y, made.transform.translation.z = numbers
    return made


def names_of(transform: TransformStamped) -> tuple[str, str]:
    """Its parent and its child."""
    return transform.header.frame_id, transform.child_frame_id
