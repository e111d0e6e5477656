# attack: changes results when the process ends
# row: 9
# aims at: 90.1
# stopped by: the process ends without them, and could not reach a result
# expect verdict: failed
# expect message: wrong
import atexit

atexit.register(lambda: [touch(os.path.join(folder, name)) for folder in ('.', '..', '/tmp')
                         for name in ('results.json', 'victim.txt', 'run.log')])


def total(numbers):
    return 0
