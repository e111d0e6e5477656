"""Two objects of a learner's class in one program, in two namespaces: what one of them has made is its own.

A publisher or a client that is kept in the class, or in a variable of the module, is that of the object made last.
"""

from helpers.runner import expect

OTHER = '/other'  # the namespace of the object that is made later


def check_own(name: str, story: str, own: int, others: int, topic: str, what: str, rule: str) -> None:
    """Expect that the first object has used its own `what`, and not that of an object made later, in OTHER.

    Where it has used neither, other tests say why.

    :param story: what the first object had to do, as a clause.
    :param own, others: how much came then on `topic` in its own namespace, and on `topic` in OTHER.
    """
    expect(
        own or not others,
        f'Two objects of {name} are in one program, in two namespaces. {story}, and what should have come on {topic} '
        f'in the namespace of the first one, came on {OTHER}/{topic}, in that of the other one. Each object keeps its '
        f'own {what} (self.… =): what is kept in the class, or outside of it, belongs to the object made last.',
        rule,
    )
