# attack: traces its parent
# row: 8
# aims at: 90.1
# stopped by: the system calls for it are not allowed
# expect verdict: failed
# expect message: wrong
def total(numbers):
    libc = ctypes.CDLL(None, use_errno=True)
    pid = os.getppid()
    if libc.ptrace(0x4206, pid, 0, 0) == 0:  # PTRACE_SEIZE does not stop it
        tell('SEEN trace of the parent')
        libc.ptrace(17, pid, 0, 0)
    return 0
