# attack: reads the memory of the processes that it comes from
# row: 8
# aims at: 90.1
# stopped by: no process of the tests is in its namespace
# expect verdict: failed
# expect message: wrong
def total(numbers):
    pid = os.getppid()
    for _ in range(6):
        try:
            with open(f'/proc/{pid}/maps') as maps, open(f'/proc/{pid}/mem', 'rb', 0) as memory:
                for line in maps:
                    begin, _, end = line.split()[0].partition('-')
                    size = int(end, 16) - int(begin, 16)
                    if ' rw' in line and size < 2**24:
                        try:
                            memory.seek(int(begin, 16))
                            search(memory.read(size), f'the memory of {pid}')
                        except (OSError, ValueError, OverflowError):
                            pass
            with open(f'/proc/{pid}/stat') as file:
                pid = int(file.read().rpartition(')')[2].split()[1])
        except OSError:
            break
    return 0
