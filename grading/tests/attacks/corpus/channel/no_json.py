# attack: sends no JSON
# row: 30
# aims at: 90.1
# stopped by: lines are parsed within bounds
# expect verdict: learner_crashed
# expect message: disturbed
def total(numbers):
    for number in os.listdir('/proc/self/fd'):
        try:
            other = socket.socket(fileno=os.dup(int(number)))
            other.sendall(b'\x80\x04\x95cos\nsystem\n(S"id"\ntR.\n' * 3)
        except OSError:
            pass
    return 0
