"""What does not fit in a graph, in words."""

import itertools
import re
from collections.abc import Iterable, Sequence
from difflib import SequenceMatcher

from helpers.kernel.qos import fit, mismatches
from helpers.show.graph.links import Link, Problem

_ALIKE = 0.8  # ratio of difflib from which two parts of names count as nearly the same

_DOES = {
    'publisher': 'publishes on',
    'subscription': 'subscribes to',
    'client': 'asks for',
    'server': 'serves',
    'action client': 'asks for',
    'action server': 'serves',
}
_HAS = _DOES | {'publisher': 'publishes', 'subscription': 'expects'}


def find(nodes: Sequence[str], links: Iterable[Link]) -> list[Problem]:
    """All problems of a graph, most telling ones first.

    :param nodes: fully qualified names; one as often as there are nodes of it.
    """
    by_name: dict[tuple[str, str], list[Link]] = {}
    for link in links:
        by_name.setdefault((link.kind, link.name), []).append(link)
    near = list(_near(by_name))
    explained = {link for problem in near for link in problem.links}
    return [*_types(by_name), *_qos(by_name), *near, *_unserved(by_name, explained), *_servers(by_name), *_twins(nodes)]


def misspelt(one: str, other: str) -> bool:
    """Whether two names differ by so few letters, or by case only, that one may be meant for the other."""
    parts, others = one.lower().split('/'), other.lower().split('/')
    return (
        one != other
        and len(parts) == len(others)
        and all(
            sorted(a) == sorted(b) or SequenceMatcher(None, a, b).ratio() >= _ALIKE
            for a, b in zip(parts, others, strict=True)
        )
    )


def _types(by_name):
    for (kind, name), links in by_name.items():
        wrong = [(a, b) for a, b in _pairs(links) if a.type != b.type]
        for a, b in wrong:
            yield Problem(
                'type',
                f'{name}: {a.node} {_HAS[a.role]} {a.type}, {b.node} {_HAS[b.role]} {b.type}. '
                'Different types are never connected.',
                (a, b),
            )
        types = sorted({link.type for link in links})
        if not wrong and len(types) > 1:
            yield Problem('type', f'The {kind} {name} has {len(types)} types: {", ".join(types)}.', tuple(links))


def _qos(by_name):
    for (kind, name), links in by_name.items():
        for a, b in _pairs(links) if kind == 'topic' else ():
            if a.type == b.type and not fit(a.qos, b.qos):
                reasons = [
                    f'{policy}: {a.node} offers {offered}, {b.node} asks for {asked}'
                    for policy, offered, asked in mismatches(a.qos, b.qos)
                ]
                what = '; '.join(reasons) or f'{a.node} offers less than {b.node} asks for'
                yield Problem('qos', f'{name}, {what}. Nothing is delivered between them.', (a, b))


def _near(by_name):
    """Names with one side only that may be meant for another one: a letter too many, another namespace."""
    for (kind, name), links in by_name.items():
        if len({link.out for link in links}) > 1:
            continue
        for (other_kind, other), others in by_name.items():
            opposite = [link for link in others if link.out != links[0].out and link.type == links[0].type]
            alone = len(opposite) == len(others)
            if other_kind != kind or not opposite or (alone and not links[0].out):
                continue  # if both are alone, the problem is reported for the sender
            # /turtle1/pose and /turtle2/pose are both meant.
            numbered = re.sub(r'\d+', '', name) == re.sub(r'\d+', '', other)
            base = name.rpartition('/')[2] == other.rpartition('/')[2]
            if alone and (base or misspelt(name, other)) or not numbered and misspelt(name, other):
                yield Problem(
                    'name',
                    f'{links[0].node} {_DOES[links[0].role]} {name}, {opposite[0].node} '
                    f'{_DOES[opposite[0].role]} {other}. Is one of the two names wrong?',
                    (*links, *(others if alone else ())),
                )


def _unserved(by_name, explained: set[Link]):
    for (kind, name), links in by_name.items():
        if kind != 'topic' and all(link.out for link in links) and not explained.intersection(links):
            asking = ', '.join(sorted({link.node for link in links}))
            yield Problem('no server', f'Nobody serves the {kind} {name}: {asking} would wait for ever.', tuple(links))


def _servers(by_name):
    for (kind, name), links in by_name.items():
        servers = [link for link in links if kind != 'topic' and not link.out]
        if len(servers) > 1:
            yield Problem(
                'servers',
                f'The {kind} {name} has {len(servers)} servers: '
                f'{", ".join(link.node for link in servers)}. Both answer.',
                tuple(servers),
            )


def _twins(nodes: Sequence[str]):
    for name in sorted(set(nodes)):
        if (count := nodes.count(name)) > 1:
            yield Problem('nodes', f'{count} nodes have the name {name}. Tools take them for one.', nodes=(name,))


def _pairs(links: list[Link]):
    """Each sender with each receiver."""
    return itertools.product([link for link in links if link.out], [link for link in links if not link.out])
