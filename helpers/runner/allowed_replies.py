"""What the learner's side may answer. Anything else is the learner's program's doing, never an error of the tests."""

from helpers.runner.channel import ChannelError

_TIME = 2**63  # ns
_MAX_ITEMS = 1000  # of a list


def _count(value) -> bool:
    return type(value) is int and 0 <= value < 2**31


def _moment(value) -> bool:
    return value is None or type(value) is int and 0 <= value < _TIME


def _truth(value) -> bool:
    return type(value) is bool


def _texts(value) -> bool:
    return isinstance(value, list) and len(value) <= _MAX_ITEMS and all(isinstance(item, str) for item in value)


def _seconds(value) -> bool:
    return type(value) in (int, float) and 0 <= value < _TIME


def _queues(value) -> bool:
    return (
        isinstance(value, list)
        and len(value) <= _MAX_ITEMS
        and all(
            isinstance(queue, list) and len(queue) == 3 and _texts(queue[:2]) and _count(queue[2]) for queue in value
        )
    )


def _rows(value) -> bool:
    return (
        isinstance(value, list)
        and len(value) <= _MAX_ITEMS
        and all(isinstance(row, dict) and _is_line(row.get('cell'), row.get('line'), row.get('code')) for row in value)
    )


def _is_line(cell, line, code) -> bool:
    return isinstance(cell, str) and (line is None or _count(line)) and isinstance(code, str)


def _anything(value) -> bool:
    return True


# By request, what its answer must have; other fields are not looked at.
_ANSWERS = {
    'start': {'index': _count, 'endpoints': _count, 'nodes': _texts, 'namespaces': _texts},
    'call': {'result': _anything, 'given': _texts, 'defaults': _texts},
    'value': {'result': _anything},
    'switch': {'lines': _count, 'stood': _rows},
    'habits': {'queues': _queues, 'slept': _seconds, 'contexts': _count},
    'step': {
        'count': _count,
        'reached': _truth,
        'next': _moment,
        'endpoints': _count,
        'waiting': _rows,
        'remarks': _texts,
    },
}


def check(op: str, answer: dict) -> dict:
    """The answer to a request, if it is one that a worker gives.

    :raises ChannelError: something is missing in it, or is of another kind.
    """
    if 'error' in answer:
        if not isinstance(answer['error'], dict) or not isinstance(answer['error'].get('kind'), str):
            raise ChannelError('an error without a kind')
        return answer
    if answer.get('ok') is not True:
        raise ChannelError('a reply without a result')
    for key, right in _ANSWERS.get(op, {}).items():
        if key not in answer or not right(answer[key]):
            raise ChannelError(f'an answer to {op} without a usable {key}')
    return answer
