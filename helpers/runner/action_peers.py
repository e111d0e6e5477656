"""Actions between a test and the learner's program, in lock-step with simulated time.

`ActionClientPeer` sends goals to the learner's action server, and sees all that it says on the wire;
`ActionServerPeer` is an action server that follows a test's plan, for a client of the learner's.
"""

import time
import uuid
from collections.abc import Callable
from dataclasses import dataclass, field

from action_msgs.msg import GoalStatus, GoalStatusArray
from action_msgs.srv import CancelGoal
from rclpy.action import ActionServer, CancelResponse, GoalResponse
from rclpy.action import graph as action_graph
from rclpy.action.server import GoalEvent, ServerGoalHandle
from rclpy.qos import QoSProfile
from unique_identifier_msgs.msg import UUID

from helpers.runner.peers import SECOND, Named
from helpers.runner.values import type_name
from helpers.runner.verdicts import ExpectationFailed

STATUS = {
    getattr(GoalStatus, f'STATUS_{name.upper()}'): name
    for name in ('unknown', 'accepted', 'executing', 'canceling', 'succeeded', 'canceled', 'aborted')
}
CANCEL = {
    CancelGoal.Response.ERROR_NONE: 'accepted',
    CancelGoal.Response.ERROR_REJECTED: 'rejected',
    CancelGoal.Response.ERROR_UNKNOWN_GOAL_ID: 'unknown goal',
    CancelGoal.Response.ERROR_GOAL_TERMINATED: 'goal has ended',
}
PATIENCE = 0.3  # seconds of wall time
_MANY = QoSProfile(depth=1000)


@dataclass
class Cancel:
    """One cancel request of the test's. `sent` and `received` are simulated seconds."""

    sent: float
    received: float | None = None  # None: not answered yet
    answer: str | None = None  # accepted, rejected, unknown goal, goal has ended
    goals: int = 0  # how many goals are being cancelled

    @property
    def done(self) -> bool:
        """Whether the answer has come."""
        return self.received is not None


@dataclass
class Again:
    """What a server answers when it is asked for the result of an ended goal once more."""

    result: object = None
    status: str | None = None  # succeeded, canceled, aborted; unknown: it keeps the result no longer; None: no answer


@dataclass
class Goal:
    """One goal of the test's client, and what has become of it. Times are simulated seconds."""

    request: object
    sent: float
    client: 'ActionClientPeer' = field(repr=False)
    id: UUID = field(repr=False)
    answered: float | None = None
    accepted: bool | None = None  # None: not answered yet
    feedback: list = field(default_factory=list)  # Feedback messages
    stamps: list[float] = field(default_factory=list)  # when they came
    statuses: list[str] = field(default_factory=list)  # accepted, executing, canceling, …: one after the other
    changes: list[float] = field(default_factory=list)  # when each of these statuses came
    published: list[int] = field(default_factory=list)  # when it was published, as in `Recording`: ns of the machine
    result: object = None
    status: str | None = None  # with the result: succeeded, canceled, aborted
    finished: float | None = None  # when the result came
    cancels: list[Cancel] = field(default_factory=list)
    again: list['Again'] = field(default_factory=list)

    @property
    def done(self) -> bool:
        """Whether the goal was rejected, or its result has come."""
        return self.accepted is False or self.finished is not None

    @property
    def answer(self) -> str:
        """For a message: what the server said when the goal came."""
        if self.accepted is None:
            return 'was not answered (does a callback wait, or call the execute callback itself?)'
        return 'was accepted' if self.accepted else 'was rejected'

    @property
    def ended(self) -> str:
        """For a message: how it has ended."""
        return f'ended as {self.status}' if self.status else 'has not ended'

    @property
    def why_aborted(self) -> str:
        """For the end of a message, where the goal was not to be aborted: how that happens."""
        said = ' Either your code has called abort(), or execute has returned without succeed(), canceled() or abort().'
        return said if self.status == 'aborted' else ''

    def cancel(self) -> Cancel:
        """Ask the server to cancel this goal, and return at once; `settle` or `run` brings the answer."""
        return self.client.cancel(self.id, self)

    def ask_again(self) -> Again:
        """Ask for the result of this goal, which has ended, once more, and return; `settle` brings the answer."""
        return self.client.ask_again(self)


class ActionClientPeer(Named):
    """A client of the test's for an action of the learner's; made by `learner.action_client`."""

    kind, preposition = 'action server', 'for'

    def __init__(self, learner, name: str, action_type, strict: bool = True):
        super().__init__(learner, name, type_name(action_type), strict)
        self.action_type = action_type
        self.goals: list[Goal] = []
        self.cancels: list[Cancel] = []
        self.patient = True  # False: no answer is awaited, because a test holds what would give it
        self._tries: dict = {}  # for how many rounds an answer that should be there has been awaited
        self._by_id: dict[bytes, Goal] = {}
        node, hidden = learner.node, f'{self.name}/_action'
        self._clients = [
            node.create_client(srv_type, f'{hidden}/{ending}')
            for srv_type, ending in (
                (action_type.Impl.SendGoalService, 'send_goal'),
                (action_type.Impl.CancelGoalService, 'cancel_goal'),
                (action_type.Impl.GetResultService, 'get_result'),
            )
        ]
        self._send_goal, self._cancel_goal, self._get_result = self._clients
        # A plain ActionClient drops feedback that comes together with the result: here every message counts.
        self._subscriptions = [
            node.create_subscription(action_type.Impl.FeedbackMessage, f'{hidden}/feedback', self._on_feedback, _MANY),
            node.create_subscription(GoalStatusArray, f'{hidden}/status', self._on_status, _MANY),
        ]

    def ask(self, node: str, namespace: str):
        return action_graph.get_action_server_names_and_types_by_node(self.learner.node, node, namespace)

    def send(self, request=None, **fields) -> Goal:
        """Send a goal (or one with these fields) and return at once; `settle` or `run` brings the answer.

        Several goals may be on their way. Fails the test if the learner's program has no such action server.
        """
        request = self.action_type.Goal(**fields) if request is None else request
        self.learner.connect()
        if not all(client.service_is_ready() for client in self._clients):
            raise ExpectationFailed('An action server is missing.')  # the hints say which
        goal = Goal(request, self.learner.now / SECOND, self, UUID(uuid=list(uuid.uuid4().bytes)))
        self.goals.append(goal)
        self._by_id[bytes(goal.id.uuid)] = goal
        message = self.action_type.Impl.SendGoalService.Request(goal_id=goal.id, goal=request)
        self._send_goal.call_async(message).add_done_callback(lambda future: self._answered(goal, future.result()))
        self.learner.unsettled = True
        return goal

    def cancel(self, goal_id: UUID | None = None, goal: Goal | None = None) -> Cancel:
        """Send a cancel request: for one goal by its id, or for all goals of the server."""
        self.learner.connect()
        cancel = Cancel(self.learner.now / SECOND)
        self.cancels.append(cancel)
        if goal is not None:
            goal.cancels.append(cancel)
        request = CancelGoal.Request()
        request.goal_info.goal_id = goal_id or UUID()  # no id, no stamp: all
        self._cancel_goal.call_async(request).add_done_callback(
            lambda future: self._cancel_answered(cancel, future.result())
        )
        self.learner.unsettled = True
        return cancel

    def ask_again(self, goal: Goal) -> Again:
        """Ask for the result of an ended goal once more: a server keeps it for some time."""
        self.learner.connect()
        again = Again()
        goal.again.append(again)
        self._ask_result(goal, lambda future: self._told_again(again, future.result()))
        self.learner.unsettled = True
        return again

    def _ask_result(self, goal: Goal, then: Callable) -> None:
        request = self.action_type.Impl.GetResultService.Request(goal_id=goal.id)
        self._get_result.call_async(request).add_done_callback(then)

    def _answered(self, goal: Goal, response) -> None:
        goal.accepted, goal.answered = response.accepted, self.learner.now / SECOND
        if goal.accepted:
            self._ask_result(goal, lambda future: self._finished(goal, future.result()))
            self._asked = True

    def _cancel_answered(self, cancel: Cancel, response) -> None:
        cancel.received, cancel.goals = self.learner.now / SECOND, len(response.goals_canceling)
        cancel.answer = CANCEL.get(response.return_code, str(response.return_code))
        if cancel.answer == 'accepted' and not cancel.goals:  # what rclpy answers for a goal that must go on
            cancel.answer = 'rejected'

    def _finished(self, goal: Goal, response) -> None:
        goal.result, goal.finished = response.result, self.learner.now / SECOND
        goal.status = STATUS.get(response.status, str(response.status))

    def _told_again(self, again: Again, response) -> None:
        again.result, again.status = response.result, STATUS.get(response.status, str(response.status))

    def _on_feedback(self, message) -> None:
        goal = self._by_id.get(bytes(message.goal_id.uuid))
        if goal is not None:
            goal.feedback.append(message.feedback)
            goal.stamps.append(self.learner.now / SECOND)

    def _on_status(self, message: GoalStatusArray, info: dict) -> None:
        for entry in message.status_list:
            goal, status = self._by_id.get(bytes(entry.goal_info.goal_id.uuid)), STATUS[entry.status]
            if goal is not None and goal.statuses[-1:] != [status]:
                goal.statuses.append(status)
                goal.changes.append(self.learner.now / SECOND)
                goal.published.append(info['source_timestamp'])

    _asked = False  # the request for a result was sent while the learner's side was idle

    def _overdue(self) -> list:
        """Keys of the answers that a server gives at once: to a goal, to a cancel request, the result of an ended goal.

        rclpy cannot tell when the answers of a service have arrived. One that was lost is sent again after some
        milliseconds, and only then is it in order to let time go on.
        """
        if not self.patient:
            return []
        late = [(id(goal), 'answer') for goal in self.goals if goal.answered is None]
        late += [(id(cancel), 'cancel') for cancel in self.cancels if not cancel.done]
        late += [(id(again), 'again') for goal in self.goals for again in goal.again if again.status is None]
        late += [
            (id(goal), 'result')
            for goal in self.goals
            if goal.finished is None and goal.statuses[-1:] in (['succeeded'], ['canceled'], ['aborted'])
        ]
        return late

    def due(self) -> int | None:
        waits = self._asked or any(self._tries.get(key, 0) < 2 for key in self._overdue())
        return self.learner.now if waits else None

    def act(self) -> None:
        self._asked = False
        late = self._overdue()
        for key in late:
            self._tries[key] = self._tries.get(key, 0) + 1
        if any(self._tries[key] == 2 for key in late):  # not in the first round: the learner's side must act before
            deadline = time.monotonic() + PATIENCE
            while set(self._overdue()) & set(late) and time.monotonic() < deadline:
                self.learner.receive(0.01)

    def close(self) -> None:
        for client in self._clients:
            self.learner.node.destroy_client(client)
        for subscription in self._subscriptions:
            self.learner.node.destroy_subscription(subscription)


@dataclass
class ServedGoal:
    """One goal that has reached the test's server. Times are simulated seconds."""

    request: object
    arrived: float
    handle: ServerGoalHandle | None = field(default=None, repr=False)  # None: rejected
    plan: list = field(default_factory=list, repr=False)  # what is still to come: (due in ns, message)
    cancelled: float | None = None  # when the (first) cancel request came
    finished: float | None = None
    status: str | None = None  # succeeded, canceled, aborted, rejected; None: not ended


class Aborted:
    """In a plan: the end of a goal that the server gives up, with its result."""

    end = 'abort'

    def __init__(self, result=None):
        self.result = result


class Canceled(Aborted):
    """In a plan: the end of a goal that was cancelled, by its client or by somebody else."""

    end = 'canceled'


class ActionServerPeer(Named):
    """An action server of the test's for a client of the learner's; made by `learner.action_server`.

    `late` may name seconds of simulated time by which it accepts ('goal') or answers cancel requests ('cancel') late.
    """

    kind, preposition = 'action client', 'for'

    def __init__(
        self,
        learner,
        name: str,
        action_type,
        plan,
        accept,
        cancel: str,
        cancel_delay: float,
        partial,
        strict: bool = True,
    ):
        super().__init__(learner, name, type_name(action_type), strict)
        self.action_type, self.plan, self.accept = action_type, plan, accept
        self.cancel, self.cancel_delay, self.partial = cancel, cancel_delay, partial
        self.goals: list[ServedGoal] = []
        self.cancel_stamps: list[float] = []  # of all cancel requests, also those for goals that have ended
        self.late: dict[str, float] = {}  # seconds until a request of this kind ('goal', 'cancel') is looked at
        self._held: list[tuple[int, dict]] = []  # due (ns), the request as rclpy gives it
        self._server: _PlannedServer | None = None
        self.said = False  # something was sent while the learner's side was idle
        self.start()

    def ask(self, node: str, namespace: str):
        return action_graph.get_action_client_names_and_types_by_node(self.learner.node, node, namespace)

    def start(self) -> None:
        """Enter the graph, again after a `stop`."""
        self._server = _PlannedServer(self)
        self.learner.rewired()

    def stop(self) -> None:
        """Leave the graph, as a server that crashes: its goals never end."""
        self.close()
        self.learner.rewired()

    def close(self) -> None:
        for served in self.goals:
            served.plan = []
        self._held.clear()
        if self._server is not None:
            self._server.destroy()
            self._server = None

    def asked(self, request) -> GoalResponse:
        """A goal has come."""
        accepted = self.accept(request) if callable(self.accept) else self.accept
        served = ServedGoal(request, self.learner.now / SECOND)
        self.goals.append(served)
        if not accepted:
            served.status, served.finished = 'rejected', served.arrived
        return GoalResponse.ACCEPT if accepted else GoalResponse.REJECT

    def began(self, handle) -> None:
        """A goal has been accepted: plan what will come."""
        served = next(served for served in self.goals if served.handle is None and served.status is None)
        served.handle = handle
        when = self.learner.now
        for delay, message in self.plan(handle.request) if callable(self.plan) else self.plan:
            when += round(delay * SECOND)
            served.plan.append((when, message))

    def asked_to_cancel(self, handle) -> CancelResponse:
        """A cancel request has come for one goal."""
        served = next(served for served in self.goals if served.handle is handle)
        if served.cancelled is None:
            served.cancelled = self.learner.now / SECOND
            if self.cancel == 'accept':
                served.plan = [(self.learner.now + round(self.cancel_delay * SECOND), Canceled(self.partial))]
        return CancelResponse.REJECT if self.cancel == 'reject' else CancelResponse.ACCEPT

    def due(self) -> int | None:
        if self.said:
            return self.learner.now
        return min(
            [served.plan[0][0] for served in self.goals if served.plan] + [due for due, _ in self._held], default=None
        )

    def hold(self, taken: dict) -> dict:
        """Keep the requests that are looked at later; return the others, for which it is time now."""
        self._held += [
            (self.learner.now + round(self.late[kind] * SECOND), {kind: request})
            for kind, request in taken.items()
            if self.late.get(kind)
        ]
        return {kind: request for kind, request in taken.items() if not self.late.get(kind)}

    def tell_early(self, feedback) -> None:
        """Publish this feedback for each goal that still waits for its answer: it may come before that."""
        assert self._server is not None  # a server that has left forgets the goals
        for _, taken in self._held:
            if 'goal' in taken:
                _, request = taken['goal']
                self._server.tell(request.goal_id, feedback)
        self.learner.unsettled = True

    def act(self) -> None:
        self.said = False
        for due, taken in self._held[:]:
            if due <= self.learner.now and self._server is not None:
                self._held.remove((due, taken))
                self._server.look_at(taken)
        while ready := [served for served in self.goals if served.plan and served.plan[0][0] <= self.learner.now]:
            for served in sorted(ready, key=lambda served: served.plan[0][0]):
                self._do(served, served.plan.pop(0)[1])
            self.learner.receive()  # results go out through the executor
            self.said = False

    def _do(self, served: ServedGoal, message) -> None:
        assert served.handle is not None and self._server is not None  # only then has a goal a plan
        if isinstance(message, self.action_type.Feedback):
            served.handle.publish_feedback(message)
            return
        plain = isinstance(message, self.action_type.Result)
        end, result = ('succeed', message) if plain else (message.end, message.result)
        served.plan = []
        served.finished = self.learner.now / SECOND

        def finish(handle):
            if end == Canceled.end and not handle.is_cancel_requested:
                handle._update_state(GoalEvent.CANCEL_GOAL)  # what a request of somebody else does
            getattr(handle, end)()
            served.status = STATUS[handle.status]
            return result or self.action_type.Result()

        self._server.end(served.handle, finish)


class _PlannedServer(ActionServer):
    """An action server whose goals stay in execution until the plan ends them."""

    def __init__(self, server: ActionServerPeer):
        self.server = server
        super().__init__(
            server.learner.node,
            server.action_type,
            server.name,
            lambda handle: None,
            goal_callback=server.asked,
            cancel_callback=server.asked_to_cancel,
        )

    def notify_execute(self, goal_handle, execute_callback) -> None:
        self.server.began(goal_handle)

    def end(self, goal_handle, finish) -> None:
        """End the goal: `finish` sets its state and gives the result."""
        super().notify_execute(goal_handle, finish)

    def tell(self, goal_id: UUID, feedback) -> None:
        """Publish feedback for a goal that has no handle yet."""
        self._handle.publish_feedback(self.action_type.Impl.FeedbackMessage(goal_id=goal_id, feedback=feedback))

    async def execute(self, taken_data):
        await super().execute(self.server.hold(taken_data))

    def look_at(self, taken: dict) -> None:
        """Answer a request that was held."""
        for _ in super().execute(taken).__await__():  # the callbacks are plain functions: there is nothing to wait for
            pass

    def take_data(self):
        self.server.said = True  # each request is answered at once
        data = super().take_data()
        if 'cancel' in data:
            self.server.cancel_stamps.append(self.server.learner.now / SECOND)
        return data
