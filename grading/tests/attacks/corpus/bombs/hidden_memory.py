# attack: takes memory that no process shows as its own: files in memory, shared and given up again, segments
# row: 16
# aims at: 90.1
# stopped by: kinds of memory that cannot be counted are refused; the others are counted
# expect verdict: failed
# expect message: gives 0
import mmap


def total(numbers):
    libc = ctypes.CDLL(None, use_errno=True)
    for size in (2**30, 2**20):
        try:
            os.close(os.memfd_create(COOKIE))
            tell('SEEN', 'memfd')
        except OSError:
            pass
        try:
            taken = mmap.mmap(-1, size, mmap.MAP_SHARED | mmap.MAP_ANONYMOUS)
            tell('SEEN', 'shared memory')
            taken.close()
        except (OSError, ValueError):
            pass
        if libc.shmget(0, ctypes.c_size_t(size), 0o1600) != -1:
            tell('SEEN', 'segment')
    return 0
