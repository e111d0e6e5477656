"""Two goals of one moment, while a thread of the learner's program stands aside: for exercises 5.5 and 8.9."""


def send_two(learner, node, client, line: int, **fields) -> tuple[list, bool, str]:
    """Send two goals with these fields; a thread that comes to this place in the learner's lines waits meanwhile.

    :param client: an action client of the test's, for a server of `node`, which was started with `switches`.
    :param line: the number of the place, from 1 on.
    :return: the accepted goals, whether both were answered while it waited, and before which line it stood.
    """
    node.switch(line, hold=True)
    both = client.send(**fields), client.send(**fields)
    client.patient = False  # who stands aside gives no answer
    learner.settle()
    learner.settle()  # the second one may come a bit later
    answered = all(goal.accepted is not None for goal in both)
    _, stood = node.switch(0)
    client.patient = True
    learner.settle()
    return [goal for goal in both if goal.accepted], answered, stood
