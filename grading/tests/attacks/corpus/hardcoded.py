"""Attacks: hardcoded. See ../README.md for the form of a row."""


# %% always_more
# attack: gives a different answer each time, in the hope that one fits
# row: 12
# aims at: 90.1
# stopped by: each answer is compared once
# expect verdict: failed
# expect message: total
_answers = iter(range(10**9))


def total(numbers):
    return next(_answers)


# %% detect
# attack: behaves only while it is watched by the visible tests
# row: 23
# aims at: 90.1
# stopped by: both kinds of tests run in the same surroundings
# expect verdict: failed
# expect points: 2.5
# expect message: wrong
def total(numbers):
    # There is nothing by which to tell them apart, but the inputs.
    return sum(numbers) if numbers in ([1, 2, 3], []) else 0


# %% known_inputs
# attack: knows the inputs and outputs of the visible tests by heart
# row: 12
# aims at: 90.1
# stopped by: hidden tests draw fresh inputs
# expect verdict: failed
# expect points: 2.5
# expect message: wrong
def total(numbers):
    return {'[1, 2, 3]': 6, '[]': 0}.get(str(numbers), 0)


# %% known_text
# attack: knows the answer of the visible test by heart
# row: 12
# aims at: 90.2
# stopped by: hidden tests draw fresh inputs
# expect verdict: failed
# expect points: 2.5
# expect message: 20 letters
def flip(text):
    return 'cba'


# %% known_topic
# attack: publishes the visible test's messages by heart
# row: 12
# aims at: 90.3
# stopped by: hidden tests draw fresh inputs
# expect verdict: failed
# expect points: 2.5
# expect message: others than expected
class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        self.texts = ['n0', 'n1', 'n2', 'n3']
        self.publisher = self.create_publisher(String, 'chatter', 10)
        self.create_timer(0.5, lambda: self.publisher.publish(String(data=self.texts.pop(0))))


# %% seed
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
