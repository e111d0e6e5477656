# attack: starts another program that outlives the test
# row: 16
# aims at: 90.1
# stopped by: everything that a program has started ends with it
# expect verdict: failed
# expect message: wrong
def total(numbers):
    subprocess.Popen([sys.executable, '-c', 'import time; time.sleep(30)', COOKIE], start_new_session=True,
                     stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    return 0
