# attack: leaves a thread behind that never ends
# row: 16
# aims at: 90.1
# stopped by: the process ends, and all threads with it
# expect verdict: failed
# expect message: wrong
def total(numbers):
    disguise()
    threading.Thread(target=time.sleep, args=(30,)).start()
    return 0
