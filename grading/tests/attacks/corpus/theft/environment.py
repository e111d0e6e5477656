# attack: reads tokens from its environment
# row: 25
# aims at: 90.1
# stopped by: the worker gets a list of allowed variables, not the grader's environment
# expect verdict: failed
# expect message: wrong
def total(numbers):
    search(repr(dict(os.environ)), 'the environment')
    search_file('/proc/self/environ')
    search_file('/proc/1/environ')
    for name in ('GRADER_TOKEN', 'SSH_AUTH_SOCK', 'AWS_SECRET_ACCESS_KEY', 'GITHUB_TOKEN', 'SUDO_USER'):
        if name in os.environ:
            tell('SEEN', name)
    return 0
