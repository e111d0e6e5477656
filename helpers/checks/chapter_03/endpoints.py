"""What several exercises of chapter 3 say of a node: its name, its topics, the settings of their queues."""

from helpers.runner import expect


def robot(random) -> str:
    """A namespace, drawn: in it an absolute name is seen at once."""
    return f'/robot{random.randint(2, 99)}'


def check_name(node, wanted: str, rule: str) -> None:
    """A started node has this name, whatever its namespace."""
    name = node.name.rpartition('/')[2]
    expect(
        name == wanted,
        f'Your node has the name {name!r}, expected {wanted!r}: the name goes to super().__init__.',
        rule,
    )


def check_topic(learner, kind: str, namespace: str, name: str, rule: str) -> None:
    """The learner's nodes have a `kind` ('publisher' or 'subscription') on the relative topic `name`.

    Several subscriptions share the work between them; there is one publisher.
    """

    def count(topic: str) -> int:
        return len(getattr(learner.endpoints(topic), f'{kind}s'))

    there = count(f'{namespace}/{name}')
    expect(
        there or not namespace or not count(f'/{name}'),
        f'In the namespace {namespace} your {kind} stays on /{name}: a relative name has no leading slash.',
        rule,
    )
    expect(there, f'Your node has no {kind} on the topic {name}.', rule)
    one = there == 1 or kind == 'subscription'
    expect(one, f'Your node has {there} {kind}s on the topic {name}, expected one.', rule)


def check_queue(learner, kind: str, topic: str, depth: int, rule: str) -> None:
    """Each of the learner's endpoints on `topic` is reliable, volatile and of this depth, as the number alone gives."""
    for endpoint in getattr(learner.endpoints(topic), f'{kind}s'):
        expect(
            endpoint.reliable, f'Your {kind} on {topic} is BEST_EFFORT; the number {depth} alone gives RELIABLE.', rule
        )
        expect(
            not endpoint.latched,
            f'Your {kind} on {topic} is TRANSIENT_LOCAL; the number {depth} alone gives VOLATILE.',
            rule,
        )
        limits = ', '.join(f'{policy} {value}' for policy, value in endpoint.limits.items())
        expect(
            not limits, f'Your {kind} on {topic} has the policy {limits}; the number {depth} alone gives none.', rule
        )
    found = learner.depths(kind, topic)
    _check_depth(found, kind, topic, depth, rule)


def check_latched(learner, kind: str, topic: str, depth: int, rule: str) -> None:
    """Each of the learner's endpoints on `topic` is reliable, latched and of this depth."""
    for endpoint in getattr(learner.endpoints(topic), f'{kind}s'):
        expect(
            endpoint.latched,
            f'Your {kind} on {topic} is VOLATILE: who comes late gets nothing. Use TRANSIENT_LOCAL on both sides.',
            rule,
        )
        expect(endpoint.reliable, f'Your {kind} on {topic} is BEST_EFFORT; it must be RELIABLE.', rule)
        check_lifespan(endpoint, rule)
    found = learner.depths(kind, topic)
    _check_depth(found, kind, topic, depth, rule)


def check_lifespan(endpoint, rule: str) -> None:
    """What a latched publisher has said does not expire: the test need not wait for it."""
    expect(
        'lifespan' not in endpoint.limits,
        f'Your {endpoint.kind} on {endpoint.topic} has the lifespan {endpoint.limits.get("lifespan")}: who comes later '
        'than that gets nothing.',
        rule,
    )


def check_nothing_else(learner, topics: set[str], rule: str) -> None:
    """The learner's nodes publish on these topics only, beside those of every node."""
    usual = {'/rosout', '/parameter_events'}
    others = ', '.join(sorted(learner.published() - topics - usual))
    expect(not others, f'Your node also publishes on {others}: that is one topic too many.', rule)


def _check_depth(found: list[int], kind: str, topic: str, depth: int, rule: str) -> None:
    """The depths that were found are this one."""
    expect(
        0 not in found,
        f'The queue of your {kind} on {topic} keeps everything (KEEP_ALL) or has the depth 0, expected {depth}.',
        rule,
    )
    expect(
        set(found) == {depth},
        f'The queue of your {kind} on {topic} has the depth {found[0] if found else 0}, expected {depth}.',
        rule,
    )
