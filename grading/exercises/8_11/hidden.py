"""Hidden tests of exercise 8.11, tests for the robot: right robots, and wrong ones of each kind.

The node of all of them is made from one text. They are run in two parts, which the tests share.
"""

import pytest

from helpers.checks.chapter_08 import steerings
from helpers.checks.chapter_08.noticed import Kind, Planted
from helpers.checks.chapter_08.planted import GIVEN, ROBOT
from helpers.checks.chapter_08.wrong_robots import with_other_attributes

pytestmark = [pytest.mark.exercise('8.11'), pytest.mark.may_take(160)]  # nine robots, three at a time, 40 s each
PARTS = {
    'parameters': """\


class StationKeeper(Node):
    def __init__(self, **options):
        super().__init__('delivery_robot', **options)
        self.state, self.stations = 'idle', {}
        for name, default, low, high in (
                ('max_linear', 0.5, 0.05, 1.0), ('max_angular', 1.0, 0.1, 2.0), ('tolerance', 0.1, 0.02, 0.5),
                ('timeout', 60.0, 1.0, 600.0), ('status_period', 0.5, 0.1, 10.0)):
            self.declare_parameter(name, default, bounded(name, low, high))
""",
    'status': """\
        latched = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
        self.publisher = self.create_publisher(String, 'status', latched)
        self.create_timer(self.value('status_period'), lambda: self.publisher.publish(String(data=self.state)))
""",
    'made': """\
        self.create_service(SetStation, 'set_station', self.on_set_station)

    def value(self, name):
        return self.get_parameter(name).value

    def place(self, name):
        return self.stations.get(name)
""",
    'stations': """\

    def on_set_station(self, request, response):
        response.success = bool(request.name) and math.isfinite(request.x) and math.isfinite(request.y)
        if response.success:
            self.stations[request.name] = request.x, request.y
        else:
            response.message = 'no'
        return response
""",
    'where': """\


class Courier(StationKeeper):
    def __init__(self, **options):
        super().__init__(**options)
        self.motor = self.create_publisher(Twist, 'cmd_vel', 10)
        self.buffer = Buffer()
        self.listener = TransformListener(self.buffer, self)

    def drive(self, linear, angular):
        command = Twist()
        command.linear.x, command.angular.z = float(linear), float(angular)
        self.motor.publish(command)

    def where(self):
        try:
            found = self.buffer.lookup_transform('map', 'base_footprint', Time())
        except TransformException:
            return None
        if self.get_clock().now() - Time.from_msg(found.header.stamp) > Duration(seconds=0.5):
            return None
        place, turn = found.transform.translation, found.transform.rotation
        return place.x, place.y, math.remainder(2 * math.atan2(turn.z, turn.w), math.tau)
""",
    'robot': """\


class DeliveryRobot(Courier):
    def __init__(self, **options):
        super().__init__(**options)
        self.server = ActionServer(self, GoToStation, 'go_to_station', self.execute, goal_callback=self.on_goal,
                                   cancel_callback=lambda goal: CancelResponse.ACCEPT)
""",
    'goal': """\

    def on_goal(self, request):
        if self.state != 'idle' or self.place(request.station) is None or self.where() is None:
            return GoalResponse.REJECT
        self.state = f'driving to {request.station}'
        return GoalResponse.ACCEPT
""",
    'loop': """\

    def execute(self, goal):
        place, step, distance, end = self.place(goal.request.station), 0, -1.0, None
        while end is None:
            self.get_clock().sleep_for(Duration(seconds=0.1))
""",
    'round': """\
            step, pose = step + 1, self.where()
            if pose:
                limits = self.value('max_linear'), self.value('max_angular')
                distance, *velocity = steer(*pose, *place, *limits)
""",
    'cancelled': """\
            if goal.is_cancel_requested:
                end, why = goal.canceled, 'cancelled'
""",
    'lost': """\
            elif pose is None:
                end, why = goal.abort, 'lost'
""",
    'arrived': """\
            elif distance < self.value('tolerance'):
                end, why = goal.succeed, 'arrived'
""",
    'rest': """\
            elif 0.1 * step >= self.value('timeout'):
                end, why = goal.abort, 'too late'
            else:
                self.drive(*velocity)
            if step % 4 == 0:
                goal.publish_feedback(GoToStation.Feedback(distance=distance))
""",
    'stop': """\
        self.drive(0.0, 0.0)
""",
    'idle': """\
        self.state = 'idle'
""",
    'end': """\
        end()
        return GoToStation.Result(distance=distance, message=why)
""",
}
HERE = GIVEN / 'delivery_robot' / 'delivery_robot'
STANDS = {'delivery_robot/steering.py': steerings.variant(), 'delivery_robot/main.py': (HERE / 'main.py').read_text()}


def variant(**parts: str) -> dict[str, str]:
    """The package with the right node, with these parts in place of its own; an empty text leaves a part out."""
    node = 'import time\n' + (HERE / 'robot.py').read_text() + ''.join({**PARTS, **parts}.values())
    return {**STANDS, 'delivery_robot/robot.py': with_other_attributes(node)}


# Before it begins it waits until its clock has gone on: so its first command comes one step of the bench later.
LATE = """\
        clock, accepted = self.get_clock(), self.get_clock().now()
        while clock.now() == accepted and not goal.is_cancel_requested and self.context.ok():
            time.sleep(0.001)
"""
COURSES = {"the course's": variant()}
RIGHT = {
    **COURSES,
    'one that keeps time with a rate, begins to drive a moment later, and has words of its own': variant(
        loop=PARTS['loop']
        .replace('        while', f'{LATE}        rate = self.create_rate(10.0)\n        while')
        .replace('self.get_clock().sleep_for(Duration(seconds=0.1))', 'rate.sleep()'),
        stations=PARTS['stations']
        .replace("'no'", "f'{request.x}, {request.y} is nowhere'")
        .replace(
            '        return response',
            "        response.message = response.message or f'{request.name} is noted'\n        return response",
        ),
        # How a drive ended that did not arrive, it need not say: only the message of an arrival must differ.
        cancelled=PARTS['cancelled'].replace("'cancelled'", "'not there'"),
        lost=PARTS['lost'].replace("'lost'", "'not there'"),
        rest=PARTS['rest'].replace("'too late'", "'not there'"),
        arrived=PARTS['arrived'].replace("'arrived'", "'here I am'"),
    ),
}
STATUS = Kind(
    'status',
    'with a wrong status',
    {
        'that never publishes its status': variant(status=''),
        'that says it is idle while it drives': variant(
            status=PARTS['status'].replace('data=self.state', "data='idle'")
        ),
    },
)
VALUES = Kind(
    'values',
    'that take a place or a parameter which they should refuse',
    {
        'that takes a place which is no number': variant(
            stations=PARTS['stations'].replace(' and math.isfinite(request.x) and math.isfinite(request.y)', '')
        ),
        'that takes a max_linear of 7 m/s': variant(
            parameters=PARTS['parameters'].replace(', bounded(name, low, high)', '')
        ),
    },
)
GOALS = Kind(
    'goals',
    'that take a goal which they should reject, or succeed too early',
    {
        'that drives to a station which nobody has set': variant(
            goal=PARTS['goal'].replace(' or self.place(request.station) is None', ''),
            made=PARTS['made'].replace('.get(name)', '.get(name, (0.0, 0.0))'),
        ),
        'that takes a second goal while it drives': variant(goal=PARTS['goal'].replace("self.state != 'idle' or ", '')),
        'that succeeds before it has arrived': variant(
            arrived=PARTS['arrived'].replace("distance < self.value('tolerance')", 'step >= 5')
        ),
    },
)
ENDS = Kind(
    'ends',
    'that end a drive in the wrong way, or not at all',
    {
        'that does not listen when it is called back': variant(
            cancelled='            if False:\n                pass\n'
        ),
        'whose cancelled goals end as succeeded': variant(
            cancelled=PARTS['cancelled'].replace('goal.canceled', 'goal.succeed')
        ),
        'whose motors run on after a cancel': variant(
            stop="        if why != 'cancelled':\n            self.drive(0.0, 0.0)\n"
        ),
        'that drives on when nobody tells it where it is': variant(lost=''),
        'that takes no goal after a cancelled one': variant(
            idle="        if why != 'cancelled':\n            self.state = 'idle'\n"
        ),
    },
)
NOTHING = {'that does nothing': variant(status='', stop='', goal=PARTS['goal'].replace('ACCEPT', 'REJECT'))}
FIRST = Planted(ROBOT, 'right-robots', RIGHT, NOTHING, (STATUS, VALUES))  # two runs, which the tests share
SECOND = Planted(ROBOT, 'right-robots', COURSES, {}, (GOALS, ENDS))


@pytest.mark.given
@pytest.mark.rules('right-robots')
@pytest.mark.weight(3)
def test_right_robots(learner):
    """Your tests pass with every robot that does what exercises 8.7 to 8.9 say.

    Wait for what must come, with bench.until, and ask for nothing that is not in the specification.
    """
    FIRST.accepts(learner)


@pytest.mark.rules('status')
def test_status(learner):
    """Your tests notice a wrong status, while the robot stands and while it drives."""
    FIRST.rejects(learner, 'status')


@pytest.mark.rules('values')
@pytest.mark.weight(2)
def test_knows(learner):
    """Your tests notice a place and a parameter that should have been refused."""
    FIRST.rejects(learner, 'values')


@pytest.mark.rules('goals')
@pytest.mark.weight(3)
def test_goals(learner):
    """Your tests notice a goal that should have been rejected, and one that ends too early.

    Which goals does exercise 8.9 reject? And when does a goal succeed?
    """
    SECOND.rejects(learner, 'goals')


@pytest.mark.rules('ends', 'right-robots')
@pytest.mark.weight(4)
def test_ends(learner):
    """Your tests notice a drive that ends in the wrong way, or not at all.

    Call the robot back, and let it be lost. How does the goal end, what do the motors do, what about the next goal?
    """
    SECOND.rejects(learner, 'ends')
