"""Functions on the tests' side: whatever a program on the other side sends is no error of the tests."""

import json
import socket
import threading

import pytest

from helpers.runner.functions import Served


@pytest.fixture
def served():
    found = Served(lambda *arguments: list(arguments))
    yield found
    found.close()


@pytest.fixture(autouse=True)
def raised(monkeypatch):
    """No thread may end with an exception."""
    found: list = []
    monkeypatch.setattr(threading, 'excepthook', found.append)
    yield
    assert not found


def asked(served: Served, line: bytes) -> bytes:
    """What comes back for a line; nothing if the connection has ended."""
    with socket.socket(fileno=socket.dup(served.other)) as end:
        end.settimeout(10)
        end.sendall(line + b'\n')
        return end.recv(65536)


def test_a_call(served):
    assert json.loads(asked(served, b'[1, {"tuple": [2]}]')) == {'result': {'list': [1, {'tuple': [2]}]}}


@pytest.mark.parametrize(
    'line',
    [
        b'[{"dict": [[{"list": []}, 1]]}]',  # a list as a key
        b'[{"dict": [[{"dict": []}, 1]]}]',
        b'[{"dict": [1]}]',
        b'5',
        b'null',
        b'no JSON',
        b'[' * 100_000,
        b'[' + b'9' * 5000 + b']',
        b'\xff',
    ],
    ids=lambda line: ascii(line[:40]),
)
def test_what_is_no_call_ends_the_connection(served, line):
    assert asked(served, line) == b''
    served.close()
