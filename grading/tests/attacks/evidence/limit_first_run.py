# attack: counts the runs, to pass in the first one
# aims at: 8.4
# stopped by: places are new, and their order is drawn
TEST_LIMIT = '''
import os, time


def test_first():
    first = True
    for place in ('/tmp/seen', os.path.expanduser('~/seen'), '/dev/shm/seen', '../seen'):
        first &= not os.path.exists(place)
        try:
            open(place, 'w').close()
        except OSError:
            pass
    assert first
'''
