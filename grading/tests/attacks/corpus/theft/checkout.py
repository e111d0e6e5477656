# attack: looks for hidden tests and solutions beside the modules of the course
# row: 8
# aims at: 90.1
# stopped by: the sandbox shows the runner, not the rest of the course
# expect verdict: failed
# expect message: wrong
def total(numbers):
    import helpers
    root = os.path.dirname(os.path.dirname(os.path.abspath(helpers.__file__)))
    for name in ('grading/exercises', 'solutions', 'helpers/checks', '.git'):
        path = os.path.join(root, name)
        if os.path.isdir(path) and os.listdir(path):
            tell('SEEN', name)
    walk(root)
    try:
        import grading.grade
        tell('SEEN', grading.grade.__file__)
    except ImportError:
        pass
    return 0
