# attack: takes the fork server's control socket from its parent
# row: 26
# aims at: 90.1
# stopped by: the system calls for it are not allowed
# expect verdict: failed
# expect message: wrong
def total(numbers):
    libc = ctypes.CDLL(None, use_errno=True)
    pidfd = libc.syscall(434, os.getppid(), 0)
    if pidfd >= 0:
        for number in range(3, 20):
            taken = libc.syscall(438, pidfd, number, 0)
            if taken >= 0:
                tell('SEEN descriptor', number, 'of the parent')
    return 0
