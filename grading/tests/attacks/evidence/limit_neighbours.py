# attack: looks for the other programs on the disk and in the memory of others
# aims at: 8.4
# stopped by: each program is alone in its place
TEST_LIMIT = '''
import os


def test_neighbours():
    there = []
    for root in ('/home', '/tmp', '/dev/shm', '/proc'):
        for folder, _, names in os.walk(root):
            there += [os.path.join(folder, name) for name in names if name == 'limit.py' or name.endswith('.txt')]
    mine = [path for path in there if 'limit' in path]
    right = [path for path in mine if 'isnan' in open(path).read()]
    assert len(mine) == 1 and (right or '00' in os.getcwd())
'''
