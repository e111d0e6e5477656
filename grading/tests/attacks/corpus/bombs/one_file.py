# attack: writes one huge file
# row: 17
# aims at: 90.1
# stopped by: the size of a file is bounded
# expect verdict: learner_crashed or failed
# expect message: File too large or SIGXFSZ or No space
def total(numbers):
    with open(f'/tmp/{COOKIE}-huge', 'wb') as file:
        os.unlink(file.name)
        for _ in range(64):
            file.write(b'x' * 2**22)
    return 0
