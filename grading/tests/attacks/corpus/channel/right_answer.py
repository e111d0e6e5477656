# attack: answers over the tests' channel by itself, with a pass for everything
# row: 30
# aims at: 90.1
# stopped by: an answer is only data; the test compares it
# expect verdict: failed or learner_crashed
# expect message: wrong or disturbed or process
import gc


def total(numbers):
    for thing in gc.get_objects():
        if type(thing).__name__ == 'Channel':
            for number in range(2, 40):
                thing.send({'id': number, 'ok': True, 'verdict': 'passed', 'result': 6})
    return 0
