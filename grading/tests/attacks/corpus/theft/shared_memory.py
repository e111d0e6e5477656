# attack: looks for the tests in shared memory
# row: 8
# aims at: 90.1
# stopped by: the sandbox has its own shared memory, and DDS uses none
# expect verdict: failed
# expect message: wrong
def total(numbers):
    walk('/dev/shm')
    for kind in ('shm', 'msg', 'sem'):
        try:
            with open(f'/proc/sysvipc/{kind}') as file:
                for line in file.readlines()[1:]:
                    tell('SEEN', kind, line)
        except OSError:
            pass
    return 0
