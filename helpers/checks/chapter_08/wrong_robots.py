"""Robots for exercise 8.11: the learner's own one, and the same spoilt in twelve ways, for its visible tests.

What spoils a robot stands behind the learner's classes, in their module. It changes what they see of rclpy, and the
methods that the cards of 8.7 to 8.9 name, in the class in which they stand: so a StationKeeper and a Courier that tests
make by themselves are spoilt, too. It is the same text for all of these robots, right ones among them: only the
conditions in it differ. When it is disguised, numbers are drawn with which they are computed. So no name, no size and
no constant tells what is spoilt.
"""

from random import Random

from rclpy.node import Node

from helpers.checks.chapter_08 import deliveries
from helpers.checks.chapter_08.noticed import Kind, Planted
from helpers.checks.chapter_08.planted import OWN, ROBOT
from helpers.runner import disguise

_WAYS = 'silent idle any_place any_value moon two early deaf succeeded runs_on blind offended still'.split()
_YES, _NO = '1 < 2', '2 < 1'  # `helpers.runner.disguise` computes the same with drawn numbers
# Besides: a drive begins only when the node's clock has gone on, so that its first command comes one step of the bench
# later. How it has ended, why a place was refused, and what a parameter is, is said in other words, and where nothing
# was said, there is a word. All drives that do not arrive end with the same words. That is right all the same.
_BEHIND = """

import copy
import inspect
import time

import rclpy.action
from action_msgs.msg import GoalStatus


def through(callback, before, after):
    async def later(*arguments):
        instead = before(*arguments)
        return after(await callback(*arguments)) if instead is None else instead

    def now(*arguments):
        instead = before(*arguments)
        return after(callback(*arguments)) if instead is None else instead

    return later if inspect.iscoroutinefunction(callback) else now


def turned(answer):
    answer.message = answer.message[::-1] or 'noted'
    return answer


def described(name, value=None, descriptor=None, *others):
    if descriptor is not None:
        descriptor = copy.copy(descriptor)
        descriptor.description = descriptor.description[::-1] or 'noted'
    return name, value, descriptor, *others


class ActionServer(rclpy.action.ActionServer):
    def __init__(self, node, *others, **options):
        self.of = node
        node.called_back = False
        super().__init__(node, *others, **options)

    def register_goal_callback(self, callback):
        super().register_goal_callback(callback and through(callback, self.on_goal, lambda answer: answer))

    def register_cancel_callback(self, callback):
        super().register_cancel_callback(callback and through(callback, self.on_cancel, self.after_cancel))

    def register_execute_callback(self, callback):
        super().register_execute_callback(through(callback, self.on_execute, self.after_execute))

    def on_goal(self, request):
        if {moon}:
            self.of.stations.setdefault(request.station, (0.0, 0.0))
        if {two} and self.of.state != 'idle':
            return rclpy.action.GoalResponse.ACCEPT
        if {offended} and self.of.called_back:
            return rclpy.action.GoalResponse.REJECT

    def on_cancel(self, goal):
        if {deaf}:
            return rclpy.action.CancelResponse.REJECT

    def after_cancel(self, answer):
        self.of.called_back = answer == rclpy.action.CancelResponse.ACCEPT
        return answer

    def on_execute(self, goal):
        self.executed = goal
        clock, accepted = self.of.get_clock(), self.of.get_clock().now()
        while clock.now() == accepted and not goal.is_cancel_requested and self.of.context.ok():
            time.sleep(0.001)
        if {succeeded}:
            goal.canceled = goal.succeed

    def after_execute(self, result):
        if self.executed.status != GoalStatus.STATUS_SUCCEEDED:
            result.message = 'not there'
        return turned(result)


_steer, _rounds = steer, []


def steer(*arguments, **named):
    result = _steer(*arguments, **named)
    _rounds.append(result)
    if {early} and len(_rounds) > 5:
        result = 0.0, *result[1:]
    return result


def publishing(given):
    def create_publisher(self, msg_type, topic, *others, **options):
        if {silent} and topic == 'status':
            topic = 'nothing'
        publisher = given(self, msg_type, topic, *others, **options)
        if {idle} and topic == 'status':
            publish = publisher.publish
            publisher.publish = lambda message: publish(String(data='idle'))
        return publisher

    return create_publisher


def accepted(response):
    if {any_place}:
        response.success = True
    return turned(response)


def serving(given):
    def create_service(self, srv_type, name, callback, *others, **options):
        if name == 'set_station' and getattr(callback, '__func__', None) is not StationKeeper.on_set_station:
            callback = through(callback, lambda *arguments: None, accepted)
        return given(self, srv_type, name, callback, *others, **options)

    return create_service


def declaring(given):
    def declare_parameters(self, namespace, parameters, *others, **options):
        parameters = [described(*one) if len(one) > 2 else one for one in parameters]
        if {any_value}:
            parameters = [one[:2] for one in parameters]
        return given(self, namespace, parameters, *others, **options)

    return declare_parameters


def driving(given):
    def drive(self, linear, angular):
        if {still} or {runs_on} and getattr(self, 'called_back', False) and linear == angular == 0.0:
            return
        given(self, linear, angular)

    return drive


def seeing(given):
    def where(self):
        place = given(self)
        if {blind}:
            place = self.seen = place or getattr(self, 'seen', None)
        return place

    return where


StationKeeper.create_publisher = publishing(StationKeeper.create_publisher)
StationKeeper.on_set_station = through(StationKeeper.on_set_station, lambda *arguments: None, accepted)
StationKeeper.create_service = serving(StationKeeper.create_service)
StationKeeper.declare_parameters = declaring(StationKeeper.declare_parameters)
for kind in (Courier, DeliveryRobot):
    if 'drive' in vars(kind):
        kind.drive = driving(kind.drive)
    if 'where' in vars(kind):
        kind.where = seeing(kind.where)
"""


def _spoilt(*ways: str) -> str:
    """What stands behind the robot, so that it is spoilt in these ways."""
    text = _BEHIND
    for way in _WAYS:
        text = text.replace(f'{{{way}}}', _YES if way in ways else _NO)
    return text


_KINDS = (
    (
        'status',
        'with a wrong status',
        {'whose status never comes': 'silent', 'that says it is idle while it drives': 'idle'},
    ),
    (
        'values',
        'that take a place or a parameter which they should refuse',
        {'that takes a place which is no number': 'any_place', 'that takes a max_linear of 7 m/s': 'any_value'},
    ),
    (
        'goals',
        'that take a goal which they should reject, or succeed too early',
        {
            'that drives to a station which nobody has set': 'moon',
            'that takes a second goal while it drives': 'two',
            'that succeeds before it has arrived': 'early',
        },
    ),
    (
        'ends',
        'that end a drive in the wrong way, or not at all',
        {
            'that does not listen when it is called back': 'deaf',
            'whose cancelled goals end as succeeded': 'succeeded',
            'whose motors run on after a cancel': 'runs_on',
            'that drives on when nobody tells it where it is': 'blind',
            'that takes no goal after a cancelled one': 'offended',
        },
    ),
)

OTHER_WORDS = (
    'your own, which begins to drive a moment later, has other words in its messages, and other names where no card '
    'gives one'
)
# The names that the cards and the given lines of 8.7 to 8.9 give.
GIVEN_NAMES = {'state', 'stations', 'value', 'place', 'on_set_station', 'motor', 'drive', 'where'}


def with_other_attributes(node: str) -> str:
    """The module of a robot, with other names for what no card names.

    Tests that ask for what only the learner's own robot has notice nothing with such a one.
    """
    return disguise.with_other_attributes(node, GIVEN_NAMES | set(dir(Node)), Random(node))


def spoilt(learner) -> Planted:
    """The learner's own robot, as it is and spoilt."""
    own = deliveries.modules(learner)
    other = with_other_attributes(own[deliveries.NODE])

    def behind(*ways: str) -> dict[str, str]:
        return {**own, deliveries.NODE: other + _spoilt(*ways)}

    kinds = tuple(
        Kind(rule, words, {name: behind(way) for name, way in robots.items()}) for rule, words, robots in _KINDS
    )
    return Planted(
        ROBOT,
        'right-robots',
        {OWN: own, OTHER_WORDS: behind()},
        {'whose status never comes, and whose motors never run': behind('silent', 'still')},
        kinds,
        told=True,
    )
