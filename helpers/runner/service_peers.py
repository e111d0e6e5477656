"""Services between a test and the learner's program, in lock-step with simulated time.

`ClientPeer` calls the learner's service; `ServicePeer` answers the learner's client as a test's script wants it.
"""

import itertools
from collections.abc import Callable, Iterator
from dataclasses import dataclass

from rclpy.service import Service

from helpers.runner.peers import SECOND, Named
from helpers.runner.values import type_name
from helpers.runner.verdicts import ExpectationFailed


@dataclass
class Call:
    """One request of the test's client. `sent` and `received` are simulated seconds."""

    request: object
    sent: float
    response: object = None
    received: float | None = None  # None: not answered yet

    @property
    def done(self) -> bool:
        """Whether the response has come."""
        return self.received is not None


class ClientPeer(Named):
    """A client of the test's for a service of the learner's; made by `learner.client`."""

    kind, preposition = 'service', 'on'

    def __init__(self, learner, name: str, srv_type, strict: bool = True):
        super().__init__(learner, name, type_name(srv_type), strict)
        self.srv_type = srv_type
        self.calls: list[Call] = []
        self._client = learner.node.create_client(srv_type, name)

    def ask(self, node: str, namespace: str):
        return self.learner.node.get_service_names_and_types_by_node(node, namespace)

    def send(self, request=None, **fields) -> Call:
        """Send a request (or one with these fields) and return at once; `settle` or `run` brings the response.

        Several calls may be outstanding. Fails the test if the learner's program has no such service.
        """
        request = self.srv_type.Request(**fields) if request is None else request
        self.learner.connect()
        if not self._client.service_is_ready():
            raise ExpectationFailed('A service is missing.')  # the hints say which
        call = Call(request, self.learner.now / SECOND)
        self.calls.append(call)
        self._client.call_async(request).add_done_callback(lambda future: self._answered(call, future))
        self.learner.unsettled = True
        return call

    def call(self, request=None, *, timeout: float = 0.0, **fields):
        """Send a request and return the response.

        `timeout`: seconds of simulated time until the answer must be there; 0: it must come at once. Fails the test
        otherwise.
        """
        call = self.send(request, **fields)
        self.learner.settle()
        self.learner.run(timeout, until=lambda: call.done)
        if not call.done:
            within = f'within {timeout:g} s' if timeout else 'at once'
            raise ExpectationFailed(
                f'Your service {self.name} did not answer {within}. Its callback must return '
                'the response, and everything it waits for must be able to run.'
            )
        return call.response

    def _answered(self, call: Call, future) -> None:
        call.response, call.received = future.result(), self.learner.now / SECOND

    def close(self) -> None:
        self.learner.node.destroy_client(self._client)


class ServicePeer(Named):
    """A server of the test's for a client of the learner's; made by `learner.serve`.

    `requests` and `stamps` (simulated seconds) record what came; `answer` and `delay` may be changed at any time.
    """

    kind, preposition = 'client', 'for'

    def __init__(self, learner, name: str, srv_type, answer, delay, strict: bool = True):
        super().__init__(learner, name, type_name(srv_type), strict)
        self.srv_type, self.answer, self.delay = srv_type, answer, delay
        self.requests: list = []
        self.stamps: list[float] = []
        self._numbers = itertools.count()
        self._waiting: list[tuple[int, int, object, object]] = []  # due (ns), number, response, header
        self._service: Service | None = None
        self.start()

    def ask(self, node: str, namespace: str):
        return self.learner.node.get_client_names_and_types_by_node(node, namespace)

    def start(self) -> None:
        """Enter the graph, again after a `stop`."""
        service = self.learner.node.create_service(self.srv_type, self.name, lambda request, response: request)
        # rclpy answers with what the callback returns: here the request, so that it can be answered at its time.
        service.send_response = self._take
        self._service = service
        self.learner.rewired()

    def stop(self) -> None:
        """Leave the graph. What was not answered yet never will be."""
        self.close()
        self.learner.rewired()

    def close(self) -> None:
        self._waiting.clear()
        if self._service is not None:
            self.learner.node.destroy_service(self._service)
            self._service = None

    def _take(self, request, header) -> None:
        self.requests.append(request)
        self.stamps.append(self.learner.now / SECOND)
        delay = self.delay(request) if callable(self.delay) else self.delay
        response = self._response(request)
        if response is not None:
            self._waiting.append((self.learner.now + round(delay * SECOND), next(self._numbers), response, header))

    def _response(self, request):
        answer = self.answer
        if isinstance(answer, Iterator):
            answer = next(answer, None)
        if isinstance(answer, Callable):
            answer = answer(request)
        return self.srv_type.Response(**answer) if isinstance(answer, dict) else answer

    def due(self) -> int | None:
        return min((due for due, *_ in self._waiting), default=None)

    def act(self) -> None:
        ready = sorted(entry for entry in self._waiting if entry[0] <= self.learner.now)
        self._waiting = [entry for entry in self._waiting if entry not in ready]
        for _, _, response, header in ready:
            assert self._service is not None  # a server that leaves forgets what waits
            type(self._service).send_response(self._service, response, header)
