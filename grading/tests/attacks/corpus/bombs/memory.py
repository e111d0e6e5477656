# attack: takes memory until there is none
# row: 17
# aims at: 90.1
# stopped by: the memory of a process is bounded
# expect verdict: learner_crashed
# expect message: MemoryError
def total(numbers):
    held = []
    for _ in range(120):  # at most 6 GB, of which the pages are not touched
        held.append(bytearray(50 * 2**20))
    return 0
