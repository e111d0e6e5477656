# attack: says that its next timer is due in a thousand years, and before all time
# row: 30
# aims at: 90.3
# stopped by: the tests keep their own clock; answers are checked by a schema
# expect verdict: failed or learner_crashed
# expect message: messages came or disturbed
import gc


class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        self.create_timer(0.5, self.tick)

    def tick(self):
        for thing in gc.get_objects():
            if type(thing).__name__ == 'Channel':
                for number in range(2, 200):
                    thing.send({'id': number, 'ok': True, 'index': 0, 'nodes': ['/talker'], 'endpoints': 0,
                                'count': -1, 'reached': True, 'next': -10**30 if number % 2 else 10**30,
                                'waiting': []})
