# attack: writes into process 1 of its sandbox, which no filter and no limit would hold
# row: 29
# aims at: 90.1
# stopped by: nobody can write into process 1, and it is under the filter, too
# expect verdict: failed
# expect message: gives 0
import errno


def total(numbers):
    for name in ('mem', 'environ', 'maps', 'fd', 'cwd', 'root', 'auxv', 'syscall'):
        try:
            if name in ('fd',):
                os.listdir('/proc/1/fd')
            elif name in ('cwd', 'root'):
                os.readlink(f'/proc/1/{name}')
            else:
                open(f'/proc/1/{name}', 'rb').read(16)
        except OSError:
            continue
        tell('SEEN', name)
    touch('/proc/1/mem')
    touch('/keep')
    if 'Seccomp:\t2' not in open('/proc/1/status').read():
        tell('SEEN', 'no filter')
    return 0
