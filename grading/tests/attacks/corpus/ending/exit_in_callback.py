# attack: ends the process in a timer
# row: 1
# aims at: 90.3
# stopped by: only an explicit pass counts
# expect verdict: learner_crashed
# expect message: exit status 0
class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        self.create_timer(0.5, lambda: os._exit(0))
