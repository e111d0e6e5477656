"""What the learner's side may answer. Whatever else comes is its own doing, and never the tests' fault."""

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


def _names(value) -> bool:
    return isinstance(value, list) and all(isinstance(item, str) for item in value)


def _rows(value) -> bool:
    return isinstance(value, list) and len(value) <= _MAX_ITEMS and all(
        isinstance(row, dict) and {'cell', 'line', 'code'} <= row.keys() for row in value)


def _anything(value) -> bool:
    return True


# By request, what its answer must have; other fields are not looked at.
_ANSWERS = {
    'start': {'index': _count, 'endpoints': _count, 'nodes': _texts},
    'call': {'result': _anything},
    'value': {'result': _anything},
    'listing': {'files': _names},
    'step': {'count': _count, 'reached': _truth, 'next': _moment, 'endpoints': _count, 'waiting': _rows},
}


def check(op: str, answer: dict) -> dict:
    """The answer to a request, if it is one that a worker gives.

    :raises ChannelError: something is missing in it, or is of another kind.
    """
    if 'fault' in answer:
        if not isinstance(answer['fault'], dict) or not isinstance(answer['fault'].get('kind'), str):
            raise ChannelError('a fault without a kind')
        return answer
    if answer.get('ok') is not True:
        raise ChannelError('an answer that is none')
    for key, right in _ANSWERS.get(op, {}).items():
        if key not in answer or not right(answer[key]):
            raise ChannelError(f'an answer to {op} without a usable {key}')
    return answer
