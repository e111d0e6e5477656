# attack: looks for the tests' lines in linecache and in the loaded modules
# row: 8
# aims at: 90.1
# stopped by: the fork server has never seen a test
# expect verdict: failed
# expect message: wrong
def total(numbers):
    import linecache
    for name, entry in list(linecache.cache.items()):
        search(repr(entry), name)
    for name in list(sys.modules):
        if name.startswith(('test_', '_pytest', 'pytest', 'grading.hidden', 'grading.grade', 'helpers.checks', 'conftest')):
            tell('SEEN', name)
    return 0
