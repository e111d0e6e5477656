# attack: fills the disk
# row: 17
# aims at: 90.1
# stopped by: the size of files and of the temporary folders is bounded
# expect verdict: failed or learner_crashed
# expect message: wrong or your program
def total(numbers):
    written = 0
    signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
    for folder in ('/tmp', '/dev/shm', '/var/tmp', os.path.expanduser('~'), os.getcwd(), '/dev', '/run'):
        for number in range(30):
            try:
                with open(os.path.join(folder, f'{COOKIE}-{number}'), 'wb') as file:
                    written += file.write(b'x' * 2**23)
            except OSError:
                break
    for folder in ('/tmp', '/dev/shm', '/var/tmp', os.path.expanduser('~'), os.getcwd(), '/dev', '/run'):
        for number in range(30):
            try:
                os.unlink(os.path.join(folder, f'{COOKIE}-{number}'))
            except OSError:
                pass
    if written > 400 * 2**20:
        tell('SEEN', written, 'bytes of disk')
    return 0
