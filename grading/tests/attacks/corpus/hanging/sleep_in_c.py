# attack: sleeps in a C function, where no Python signal arrives
# row: 14
# aims at: 90.1
# stopped by: the process is ended from outside
# expect verdict: timeout
# expect message: did not return
def total(numbers):
    libc = ctypes.PyDLL(None)  # keeps the interpreter's lock: no other thread of Python's can run
    libc.sleep(60)
