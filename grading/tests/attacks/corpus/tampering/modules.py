# attack: puts modules of its own in the place of pytest, conftest and helpers
# row: 5
# aims at: 90.1
# stopped by: nothing that the worker writes is where the tests look for modules
# expect verdict: failed
# expect message: wrong
for name in ('conftest.py', 'pytest.py', 'sitecustomize.py', 'usercustomize.py', 'rclpy.py', 'json.py'):
    for folder in ('.', '..', os.path.expanduser('~'), *sys.path):
        try:
            with open(os.path.join(folder or '.', name), 'x') as file:
                file.write('import os; os.environ["TAKEN"] = "1"\n')
            if not os.path.abspath(folder).startswith(('/tmp', os.path.expanduser('~'))):
                tell('TOUCHED', folder, name)
                os.unlink(os.path.join(folder, name))
        except OSError:
            pass


def total(numbers):
    return 0
