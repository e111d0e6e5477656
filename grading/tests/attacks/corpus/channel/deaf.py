# attack: says that it is deaf, in the words of the worker
# row: 30
# aims at: 90.3
# stopped by: what a program says of itself leaves no mark open
# expect verdict: timeout
# expect message: did not hear in time
from helpers.runner import worker


def deaf(self, *args, **kwargs):
    raise worker.RequestError('deaf')


worker.Worker.do_step = worker.Worker.do_sync = deaf


class Talker(Node):
    def __init__(self):
        super().__init__('talker')
