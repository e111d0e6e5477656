# attack: looks through all objects of the interpreter
# row: 8
# aims at: 90.1
# stopped by: the fork server has never seen a test
# expect verdict: failed
# expect message: wrong
def total(numbers):
    import gc
    for thing in gc.get_objects():
        if isinstance(thing, (dict, list, tuple)) and len(thing) < 1000:
            for part in (thing.values() if isinstance(thing, dict) else thing):
                if type(part) in (str, bytes) and len(part) < 10**6:
                    search(part, 'an object')
    return 0
