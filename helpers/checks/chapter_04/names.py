"""Relative names in a namespace, for the exercises of chapter 4."""

from helpers.runner import expect


def check_names(learner, space: str, *peers, publisher: str = '', subscription: str = '') -> None:
    """Expect that in a namespace the learner's node has what belongs to the tests' `peers`, and these topics.

    :param peers: servers and clients of the tests. :param publisher, subscription: topics, without the namespace.
    """
    for kind, name in (('subscription', subscription), ('publisher', publisher)):
        if name:
            there = [bool(getattr(learner.endpoints(f'{place}/{name}'), f'{kind}s')) for place in (space, '')]
            _judge(f'{kind} on', space, name, *there)
    for peer in peers:
        name, theirs = peer.name.removeprefix(f'{space}/'), peer.theirs()
        what = 'client for' if peer.kind == 'client' else peer.kind
        _judge(what, space, name, peer.name in theirs, f'/{name}' in theirs)


def _judge(what: str, space: str, name: str, there: bool, absolute: bool) -> None:
    expect(
        there or not absolute,
        f'In the namespace {space} your node has the {what} /{name}, expected {space}/{name}: write the names without '
        'a leading slash.',
        'names',
    )
    expect(
        there,
        f'In the namespace {space} your node has no {what} {space}/{name}. Is the name {name!r} written as on the '
        'card, letter by letter?',
        'names',
    )
