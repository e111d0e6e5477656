# attack: asks the socket to the functions for more than the function
# aims at: 8.4
# stopped by: only the one function is served
TEST_LIMIT = '''
import os, socket

import pytest
import speed.limit


def test_socket():
    end = speed.limit._end
    for line in (b'__import__("os")', b'{"eval": "1"}', b'[{"object": "x"}, {"dict": [[{"list": []}, 1]]}, 0]', b'[' * 5000):
        end.write(line + b'\\n')
        end.flush()
        assert b'raised' in end.readline()
'''
