# attack: replaces the runner's verdicts and its worker
# row: 4
# aims at: 90.1
# stopped by: verdicts are given in another process
# expect verdict: failed
# expect message: wrong
for module in list(sys.modules.values()):
    if getattr(module, '__name__', '').startswith('helpers.runner'):
        for name in ('expect', 'judge', 'clean'):
            if hasattr(module, name):
                setattr(module, name, lambda *args, **kwargs: None)
        for name in ('FAILED', 'TIMEOUT', 'LEARNER_CRASHED', 'GRADER_ERROR'):
            if hasattr(module, name):
                setattr(module, name, 'passed')


def total(numbers):
    return 0
