# attack: makes hundreds of thousands of empty files
# row: 17
# aims at: 90.1
# stopped by: each call is waited for within a bound; its folder is memory of its own
# expect verdict: failed or learner_crashed or timeout
# expect message: total or raised
def total(numbers):
    folder = f'/tmp/{COOKIE}-many'
    os.mkdir(folder)
    try:
        for number in range(20000):
            os.close(os.open(f'{folder}/{number}', os.O_CREAT | os.O_WRONLY))
    finally:
        import shutil
        shutil.rmtree(folder, ignore_errors=True)
    return 0
