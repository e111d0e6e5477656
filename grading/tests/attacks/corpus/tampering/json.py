# attack: replaces json so that every answer is the right one
# row: 4
# aims at: 90.1
# stopped by: the worker's json is not the tests'; an answer is only the learner's word
# expect verdict: failed
# expect message: wrong
import json

_dumps = json.dumps


def total(numbers):
    json.dumps = lambda value, **options: _dumps({**value, 'ok': True, 'result': 6, 'verdict': 'passed'}, **options)
    return 0
