"""Robots for exercise 8.11: the learner's own one, and the same spoilt in twelve ways, for its visible tests.

What spoils a robot stands behind the learner's classes, in their module. It changes what they see of rclpy, and the
methods that the cards of 8.7 to 8.9 name.
"""

from helpers.checks.chapter_08 import deliveries
from helpers.checks.chapter_08.noticed import Kind, Planted
from helpers.checks.chapter_08.planted import OWN, ROBOT

_CLASS = '\n\nclass DeliveryRobot(DeliveryRobot):\n'
# An action server whose callbacks go through on_goal, on_cancel and on_execute.
_SERVER = """

import rclpy.action


class ActionServer(rclpy.action.ActionServer):
    def __init__(self, node, action_type, name, execute_callback, **options):
        self.spoilt = node
        node.called_back = False
        if 'goal_callback' in options:
            options['goal_callback'] = self._goal(options['goal_callback'])
        if 'cancel_callback' in options:
            options['cancel_callback'] = self._cancel(options['cancel_callback'])
        super().__init__(node, action_type, name, self._execute(execute_callback), **options)

    def register_goal_callback(self, callback):
        super().register_goal_callback(self._goal(callback))

    def register_cancel_callback(self, callback):
        super().register_cancel_callback(self._cancel(callback))

    def register_execute_callback(self, callback):
        super().register_execute_callback(self._execute(callback))

    def _goal(self, callback):
        return callback and (lambda request: on_goal(self.spoilt, callback, request))

    def _cancel(self, callback):
        return callback and (lambda goal: on_cancel(self.spoilt, callback, goal))

    def _execute(self, callback):
        return lambda goal: on_execute(callback, goal)


def on_goal(node, callback, request):
    return callback(request)


def on_cancel(node, callback, goal):
    answer = callback(goal)
    node.called_back = answer == rclpy.action.CancelResponse.ACCEPT
    return answer


def on_execute(callback, goal):
    return callback(goal)
"""
_SILENT = (
    _CLASS
    + """
    def create_publisher(self, msg_type, topic, *others, **options):
        return super().create_publisher(msg_type, 'nothing' if topic == 'status' else topic, *others, **options)
"""
)
_IDLE = (
    _CLASS
    + """
    def create_publisher(self, msg_type, topic, *others, **options):
        publisher = super().create_publisher(msg_type, topic, *others, **options)
        if topic == 'status':
            publish = publisher.publish
            publisher.publish = lambda message: publish(String(data='idle'))
        return publisher
"""
)
_ANY_PLACE = (
    _CLASS
    + """
    def create_service(self, srv_type, name, callback, *others, **options):
        def answer(request, response):
            response = callback(request, response)
            response.success = True
            return response

        return super().create_service(srv_type, name, answer if name == 'set_station' else callback, *others, **options)
"""
)
_ANY_VALUE = (
    _CLASS
    + """
    def declare_parameter(self, name, value=None, descriptor=None, *others, **options):
        return super().declare_parameter(name, value)

    def declare_parameters(self, namespace, parameters, *others, **options):
        return [super(DeliveryRobot, self).declare_parameter(one[0], one[1]) for one in parameters]
"""
)
_MOON = (
    _SERVER
    + """

def on_goal(node, callback, request):
    node.stations.setdefault(request.station, (0.0, 0.0))
    return callback(request)
"""
)
_TWO = (
    _SERVER
    + """

def on_goal(node, callback, request):
    running = node.state != 'idle'
    return rclpy.action.GoalResponse.ACCEPT if running else callback(request)
"""
)
_EARLY = """

_steer, _rounds = steer, []


def steer(*arguments):
    distance, linear, angular = _steer(*arguments)
    _rounds.append(distance)
    return 0.0 if len(_rounds) > 5 else distance, linear, angular
"""
_DEAF = (
    _SERVER
    + """

def on_cancel(node, callback, goal):
    return rclpy.action.CancelResponse.REJECT
"""
)
_SUCCEEDED = (
    _SERVER
    + """

def on_execute(callback, goal):
    goal.canceled = goal.succeed
    return callback(goal)
"""
)
_RUNS_ON = (
    _SERVER
    + _CLASS
    + """
    def drive(self, linear, angular):
        if not (self.called_back and linear == angular == 0.0):
            super().drive(linear, angular)
"""
)
_BLIND = (
    _CLASS
    + """
    def where(self):
        self.seen = super().where() or getattr(self, 'seen', None)
        return self.seen
"""
)
_OFFENDED = (
    _SERVER
    + """

def on_goal(node, callback, request):
    return rclpy.action.GoalResponse.REJECT if node.called_back else callback(request)
"""
)
_KINDS = (
    (
        'status',
        'with a wrong status',
        {'whose status never comes': _SILENT, 'that says it is idle while it drives': _IDLE},
    ),
    (
        'values',
        'that take a place or a parameter which they should refuse',
        {'that takes a place which is no number': _ANY_PLACE, 'that takes a max_linear of 7 m/s': _ANY_VALUE},
    ),
    (
        'goals',
        'that take a goal which they should reject, or succeed too early',
        {
            'that drives to a station which nobody has set': _MOON,
            'that takes a second goal while it drives': _TWO,
            'that succeeds before it has arrived': _EARLY,
        },
    ),
    (
        'ends',
        'that end a drive in the wrong way, or not at all',
        {
            'that does not listen when it is called back': _DEAF,
            'whose cancelled goals end as succeeded': _SUCCEEDED,
            'whose motors run on after a cancel': _RUNS_ON,
            'that drives on when nobody tells it where it is': _BLIND,
            'that takes no goal after a cancelled one': _OFFENDED,
        },
    ),
)


# Right all the same: how a drive has ended, and why a place was refused, is said in other words.
_OTHER_WORDS = (
    """

import inspect

import rclpy.action


def reworded(callback):
    async def later(*arguments):
        return turned(await callback(*arguments))

    def now(*arguments):
        return turned(callback(*arguments))

    return later if inspect.iscoroutinefunction(callback) else now


def turned(answer):
    answer.message = answer.message[::-1]
    return answer


class ActionServer(rclpy.action.ActionServer):
    def register_execute_callback(self, callback):
        super().register_execute_callback(reworded(callback))
"""
    + _CLASS
    + """
    def create_service(self, srv_type, name, callback, *others, **options):
        answer = reworded(callback) if name == 'set_station' else callback
        return super().create_service(srv_type, name, answer, *others, **options)
"""
)
OTHER_WORDS = 'your own, with other words in its messages'


def spoilt(learner) -> Planted:
    """The learner's own robot, as it is and spoilt."""
    own = deliveries.modules(learner)

    def behind(text: str) -> dict[str, str]:
        return {**own, deliveries.NODE: own[deliveries.NODE] + text}

    kinds = tuple(
        Kind(rule, words, {name: behind(text) for name, text in programs.items()}) for rule, words, programs in _KINDS
    )
    return Planted(
        ROBOT,
        'right-robots',
        {OWN: own, OTHER_WORDS: behind(_OTHER_WORDS)},
        {
            'whose status never comes, and whose motors never run': behind(
                _SILENT + _CLASS + '    def drive(self, linear, angular):\n        pass\n'
            )
        },
        kinds,
        told=True,
    )
