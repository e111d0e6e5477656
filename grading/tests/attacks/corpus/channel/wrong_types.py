# attack: answers with texts in the place of numbers, and numbers in the place of texts
# row: 30
# aims at: 90.3
# stopped by: answers are checked by a schema
# expect verdict: learner_crashed
# expect message: disturbed
import gc


class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        for thing in gc.get_objects():
            if type(thing).__name__ == 'Channel':
                for number in range(2, 200):
                    thing.send({'id': number, 'ok': True, 'index': 'x', 'nodes': 7, 'endpoints': [], 'count': {},
                                'reached': 'yes', 'next': 'soon', 'lines': 5})
