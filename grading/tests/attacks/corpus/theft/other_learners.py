# attack: reads other learners' work and results
# row: 8
# aims at: 90.1
# stopped by: the sandbox shows no submission
# expect verdict: failed
# expect message: wrong
def total(numbers):
    end = time.monotonic() + 1
    for root in ('/tmp', '/home', '/root', '/mnt', '/srv', '/var/tmp'):
        for folder, _, names in os.walk(root):
            if time.monotonic() > end:
                break
            for name in names:
                if name.startswith(('zoe', 'gradebook')):
                    tell('SEEN', os.path.join(folder, name))
    return 0
