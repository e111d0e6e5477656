# attack: writes results and gradebooks where it can
# row: 9
# aims at: 90.1
# stopped by: the sandbox sees no result; they are written after its end
# expect verdict: failed
# expect message: wrong
def total(numbers):
    end = time.monotonic() + 1
    for root in (os.getcwd(), '..', '/tmp', '/home', '/root', '/mnt', '/srv'):
        for folder, _, names in os.walk(root):
            if time.monotonic() > end:
                break
            for name in names:
                if name.startswith(('results', 'report', 'gradebook', 'victim', 'run.log', 'job.json')):
                    touch(os.path.join(folder, name))
    return 0
