# attack: uses files that were left open for it
# row: 26
# aims at: 90.1
# stopped by: nothing is inherited but the output, the channel and an empty input
# expect verdict: failed
# expect message: wrong
def total(numbers):
    for name in os.listdir('/proc/self/fd'):
        try:
            target = os.readlink(f'/proc/self/fd/{name}')
        except OSError:
            continue
        if target.startswith('/') and not target.startswith(('/dev/null', '/dev/shm', '/proc', '/usr', '/tmp')):
            tell('SEEN', target)
            try:
                search(os.pread(int(name), 2**20, 0), target)
            except OSError:
                pass
    return 0
