# attack: prints millions of lines
# row: 18
# aims at: 90.1
# stopped by: of what is printed a bounded part is kept
# expect verdict: failed or timeout
# expect message: total
def total(numbers):
    for _ in range(200):
        os.write(1, b'\n' * 2**20)
    return 0
