# attack: names modules of its own choice as message types
# row: 30
# aims at: 90.1
# stopped by: only installed interfaces are read
# expect verdict: learner_crashed or failed
# expect message: total
import gc


def total(numbers):
    channel = next(thing for thing in gc.get_objects() if type(thing).__name__ == 'Channel')
    for number in range(2, 40):
        channel.send({'id': number, 'ok': True, 'result': [{'$msg': '../../tmp/evil/msg/Evil', 'cdr': ''},
                                                           {'$msg': 'os/msg/System', 'cdr': ''}]})
    return 0
