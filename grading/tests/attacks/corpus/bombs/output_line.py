# attack: prints one line of 300 MB
# row: 18
# aims at: 90.1
# stopped by: of what is printed a bounded part is kept
# expect verdict: failed or timeout
# expect message: total
# expect page: the rest is left out
def total(numbers):
    for _ in range(300):
        os.write(2, b'x' * 2**20)
    return 0
