"""Services, actions and models for tests: endpoints that act by themselves while simulated time passes."""

from helpers.runner.verdicts import WiringError

SECOND = 1_000_000_000
# What every node brings, and the tests' own nodes: not the learner's.
_BUILT_IN = (
    'describe_parameters',
    'get_parameter_types',
    'get_parameters',
    'get_type_description',
    'list_parameters',
    'set_parameters',
    'set_parameters_atomically',
)


class Peer:
    """A partner of the learner's program; `Learner.add` takes it in.

    In each round of a step the learner's side first lets every peer `act`, then runs the learner's nodes, and goes on
    as long as a peer is `due` at this moment. So a peer may answer at once or at an exact later time.
    """

    def due(self) -> int | None:
        """The simulated time (ns) at which the peer wants to act next; None: never, unless something reaches it."""
        return None

    def act(self) -> None:
        """Do what is due by now; afterwards `due` is later than now, or None."""

    def check(self) -> None:
        """Raise WiringError if the learner's counterpart is there and can never be connected."""

    def hints(self) -> list[str]:
        """What a failed test may add: sentences on a counterpart that is missing."""
        return []

    def close(self) -> None:
        """Leave the graph."""


class Named(Peer):
    """A peer that meets its counterpart under a name with a type: a service, an action.

    `kind` is the learner's counterpart in a learner's words, `preposition` goes between it and its name, and `ask` is
    the graph function of a node that lists the counterparts of one node.
    """

    kind, preposition = '', ''

    def __init__(self, learner, name: str, type_text: str, strict: bool):
        """`type_text` as in example_interfaces/srv/AddTwoInts. `strict`: another type there fails the test."""
        self.learner, self.type, self.strict = learner, type_text, strict
        self.name = learner.node.resolve_service_name(name)

    def ask(self, node: str, namespace: str) -> list[tuple[str, list[str]]]:
        """(name, types) of the counterparts that one node of the learner's has."""
        raise NotImplementedError

    def theirs(self) -> dict[str, list[str]]:
        """All counterparts of this kind that the learner's nodes have: types by name."""
        found: dict[str, list[str]] = {}
        for node, namespace in self.learner.own_nodes():
            try:
                there = self.ask(node, namespace)
            except Exception:  # noqa: BLE001 - the node has gone: there is nothing to tell
                continue
            for name, types in there:
                found.setdefault(name, []).extend(types)
        return found

    def check(self) -> None:
        types = self.theirs().get(self.name, [])
        if self.strict and types and self.type not in types:
            raise WiringError(
                f'{self.name} must have the type {self.type}; your {self.kind} there has the type '
                f'{types[0]}. Two sides of different types are never connected.',
                'type',
            )

    def hints(self) -> list[str]:
        theirs = self.theirs()
        if self.name in theirs:
            return []
        others = ', '.join(
            f'{name} ({types[0]})' for name, types in sorted(theirs.items()) if name.rpartition('/')[2] not in _BUILT_IN
        )
        instead = f'; it has one {self.preposition} {others}' if others else ''
        return [f'Your program has no {self.kind} {self.preposition} {self.name}{instead}.']
