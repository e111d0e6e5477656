# attack: replaces json so that every answer is the right one
# row: 4
# aims at: 90.1
# stopped by: the worker's json is not the tests'; an answer is only the learner's word
# expect verdict: failed or learner_crashed
# expect message: 90.1 or wrong or disturbed
import json

json.dumps = lambda value, **kwargs: '{"id": 2, "ok": true, "result": 6, "verdict": "passed"}'


def total(numbers):
    return 0
