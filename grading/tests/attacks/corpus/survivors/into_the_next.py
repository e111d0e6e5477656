# attack: leaves a daemon behind that waits for the next test, to answer in it
# row: 16
# aims at: 90.3
# stopped by: what a program has started ends before the next one starts
# expect verdict: failed
# expect message: messages came
class Talker(Node):
    def __init__(self):
        for pid in filter(str.isdigit, os.listdir('/proc')):
            try:
                with open(f'/proc/{pid}/comm') as file:
                    if COOKIE in file.read():
                        tell('SEEN the daemon of the test before')
            except OSError:
                pass
        if os.fork() == 0:
            os.setsid()
            if os.fork() == 0:
                linger()
            os._exit(0)
        super().__init__('talker')
