# attack: leaves a daemon behind that waits for the next test, to answer in it
# row: 16
# aims at: 90.3
# stopped by: what a program has started ends before the next one starts
# expect verdict: failed
# expect message: messages came
class Talker(Node):
    def __init__(self):
        if os.fork() == 0:
            os.setsid()
            if os.fork() == 0:
                linger()
            os._exit(0)
        if any(COOKIE in open(f'/proc/{pid}/comm').read() for pid in map(int, filter(str.isdigit, os.listdir('/proc')))
               if os.path.exists(f'/proc/{pid}/comm') and time.time() - os.stat(f'/proc/{pid}').st_mtime > 0.5):
            tell('SEEN the daemon of the test before')
        super().__init__('talker')
