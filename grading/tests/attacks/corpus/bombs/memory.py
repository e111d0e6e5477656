# attack: takes memory until there is none
# row: 17
# aims at: 90.1
# stopped by: the memory of a process is bounded
# expect verdict: learner_crashed or timeout
# expect message: MemoryError or more memory or did not return
def total(numbers):
    held = []
    for _ in range(12):  # at most 6 GB, of which the pages are not touched
        held.append(bytearray(500 * 2**20))
    return 0
