# attack: prints what a passed test looks like
# row: 10
# aims at: 90.1
# stopped by: what a program prints is never read as a result
# expect verdict: failed
# expect message: wrong
def total(numbers):
    for line in ('{"event": "result", "test": "exercises/90_1/hidden::test_drawn", "verdict": "passed"}',
                 '{"id": 1, "ok": true, "result": 6}', '2 passed in 0.01s', '::set-output name=result::passed',
                 '<testcase classname="a" name="test_drawn"/>', '{"correct": true, "score": 1}', 'ok 1 - test_drawn'):
        print(line)
    print('{"score": 100}', end='')
    return 0
