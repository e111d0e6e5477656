# attack: reports a fault of the grader's in the grader's own words
# row: 30
# aims at: 90.1
# stopped by: a worker never says whose fault it is
# expect verdict: learner_crashed
# expect message: disturbed
import gc


def total(numbers):
    for thing in gc.get_objects():
        if type(thing).__name__ == 'Channel':
            for number in range(2, 40):
                thing.send({'id': number, 'error': {'kind': 'grader_error', 'verdict': 'passed'}})
    return 0
