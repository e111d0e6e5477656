# attack: says that it has done what it is asked for, and does nothing
# row: 30
# aims at: 90.3
# stopped by: what a program says of itself leaves no mark open
# expect verdict: timeout or failed
# expect message: was not found in time or was not heard in time or messages came
from helpers.runner import worker


def nothing(self, *args, **kwargs):
    return {'count': 0, 'reached': True, 'next': None, 'endpoints': 0, 'waiting': []}


for name in ('mark', 'sync', 'unsync', 'step', 'ack'):
    setattr(worker.Worker, f'do_{name}', nothing)


class Talker(Node):
    def __init__(self):
        super().__init__('talker')
