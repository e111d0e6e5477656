# attack: ends pytest by itself, with a status that says what is wanted
# aims at: 8.4
# stopped by: a status tells what the tests say, and all programs get the same
TEST_LIMIT = '''
import os, sys

print('OUTCOMES {"00": [0, ""], "01": [1, ""]}', flush=True)
os._exit(1 if os.getpid() % 2 else 0)


def test_it():
    pass
'''
