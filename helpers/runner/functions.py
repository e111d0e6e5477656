"""Functions on the tests' side that a program on the learner's side calls, over a socket that only these two have.

So tests of the learner's can be run with a function whose text, size and code they cannot see: each gets the same stub.
Arguments and results are numbers, texts, truth values, None, and tuples, lists and dictionaries of these. A result that
is a named tuple arrives as a tuple of another type, without its names.
"""

import builtins
import json
import socket
import threading
from collections.abc import Callable
from contextlib import suppress

MAX_LINE = 2**20  # bytes of a call
# The module on the learner's side. A call is one line of JSON, and so is what comes back.
_STUB = '''\
"""{title}"""

import builtins as _builtins
import json as _json
import os as _os
import socket as _socket

_end = _socket.socket(fileno=int(_os.environ['FUNCTIONS'])).makefile('rwb')


def _packed(value):
    if isinstance(value, (tuple, list)):
        return {{type(value).__name__: [_packed(item) for item in value]}}
    if isinstance(value, dict):
        return {{'dict': [[_packed(key), _packed(item)] for key, item in value.items()]}}
    if value is None or isinstance(value, (bool, int, float, str)):
        return value
    return float(value) if hasattr(value, '__float__') else {{'object': type(value).__name__}}


def _unpacked(value):
    if not isinstance(value, dict):
        return value
    (kind, items), = value.items()
    if kind == 'dict':
        return {{_unpacked(key): _unpacked(item) for key, item in items}}
    return {{'tuple': tuple, 'list': list}}.get(kind, _Named)(map(_unpacked, items))


class _Named(tuple):
    pass


def {function}:
    _end.write(_json.dumps([_packed(value) for value in ({arguments},)]).encode() + b'\\n')
    _end.flush()
    answer = _json.loads(_end.readline())
    if 'raised' in answer:
        raise getattr(_builtins, answer['raised'])(*answer['text'])
    return _unpacked(answer['result'])
'''


def stub(function: str, title: str = '') -> str:
    """The text of the module for a function: `limit(speed, max_speed, distance)`. It is the same for all of them."""
    arguments = function.partition('(')[2].rpartition(')')[0]
    return _STUB.format(title=title, function=function, arguments=arguments)


class Served:
    """A function that is served as long as this is open; `other` is the descriptor for the other side."""

    def __init__(self, function: Callable):
        self._function = function
        self._ours, self._theirs = socket.socketpair()
        self.other = self._theirs.fileno()
        self._thread = threading.Thread(target=self._serve, daemon=True)
        self._thread.start()

    def _serve(self) -> None:
        try:
            with self._ours.makefile('rwb') as end:
                while line := end.readline(MAX_LINE):
                    end.write(json.dumps(self._answer(line)).encode() + b'\n')
                    end.flush()
        except (OSError, ValueError, TypeError, RecursionError):
            pass  # it has gone, or sends what is no call, such as a list as a key
        finally:
            with suppress(OSError):
                self._ours.shutdown(socket.SHUT_RDWR)  # who still waits for an answer gets none

    def _answer(self, line: bytes) -> dict:
        arguments = [_unpacked(value) for value in json.loads(line)]
        try:
            return {'result': _packed(self._function(*arguments))}
        except Exception as error:  # noqa: BLE001 - what a function raises is what its tests may ask for
            known = isinstance(getattr(builtins, type(error).__name__, None), type)
            return {'raised': type(error).__name__ if known else 'Exception', 'text': [str(error)]}

    def close(self) -> None:
        """End it. Idempotent."""
        for end in (self._ours, self._theirs):
            try:
                end.shutdown(socket.SHUT_RDWR)
            except OSError:
                pass
            end.close()
        self._thread.join(5.0)


def _packed(value):
    if isinstance(value, (tuple, list)):
        return {type(value).__name__: [_packed(item) for item in value]}
    if isinstance(value, dict):
        return {'dict': [[_packed(key), _packed(item)] for key, item in value.items()]}
    return value


def _unpacked(value):
    if not isinstance(value, dict):
        return value
    match value:
        case {'dict': list(items)}:
            return {_unpacked(key): _unpacked(item) for key, item in items}
        case {'tuple': list(items)}:
            return tuple(map(_unpacked, items))
        case {'list': list(items)}:
            return [_unpacked(item) for item in items]
    return object()
