# attack: makes namespaces and mounts of its own
# row: 28
# aims at: 90.1
# stopped by: the system calls for it are not allowed
# expect verdict: failed
# expect message: wrong
def total(numbers):
    libc = ctypes.CDLL(None, use_errno=True)
    child = os.fork()
    if child == 0:
        for flag, name in ((0x10000000, 'user'), (0x00020000, 'mount'), (0x40000000, 'network'), (0x20000000, 'pid')):
            if libc.unshare(flag) == 0:
                tell('SEEN namespace', name)
        if libc.mount(b'none', b'/tmp', b'tmpfs', 0, None) == 0:
            tell('SEEN mount')
        if libc.syscall(321, 0, 0, 0) >= 0:
            tell('SEEN bpf')
        os._exit(0)
    os.waitpid(child, 0)
    return 0
