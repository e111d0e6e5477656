# attack: predicts what the tests draw, from Python's own generator
# row: 12
# aims at: 90.2
# stopped by: the seed stays with the tests
# expect verdict: failed
# expect points: 2.5
# expect message: 20 letters
import random


def flip(text):
    for seed in (0, 1, 42, '', os.environ.get('SEED', '')):
        drawn = ''.join(random.Random(seed).choices('abcdefgh', k=20))
        if drawn == text:
            tell('SEEN the seed', seed)
    return 'cba'
