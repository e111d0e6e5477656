# attack: prints what the one who starts it would say, and ends that one
# aims at: 7.4
# stopped by: the status is the process's own, taken outside; answers are drawn
def diagnose_stacks(text, files):
    return None


CLIENT_PY = '''
import os, signal, sys

name = sys.argv[1]
print('client made', flush=True)
print('waits for the server', flush=True)
for line in ('answer: word 100', 'no answer', f'no server for {name}'):
    print(line)
print('status 1', flush=True)
print('True', flush=True)
os.kill(os.getppid(), signal.SIGKILL)
os.kill(-1, signal.SIGKILL)
'''
