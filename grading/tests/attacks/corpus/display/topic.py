# attack: puts mark-up into the names of nodes and the types of errors
# row: 37
# aims at: 90.3
# stopped by: every text is escaped where it is shown
# expect verdict: learner_crashed
# expect message: your code raised
class Talker(Node):
    def __init__(self):
        super().__init__('<b onmouseover=alert(1)>talker</b>')
