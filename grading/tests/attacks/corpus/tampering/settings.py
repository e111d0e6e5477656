# attack: leaves settings for pytest that collect nothing
# row: 6
# aims at: 90.1
# stopped by: the tests' process has its own folder and reads no settings
# expect verdict: failed
# expect message: wrong
for name in ('pytest.ini', 'tox.ini', 'setup.cfg', 'pyproject.toml', 'conftest.py'):
    for folder in ('.', '..', '/tmp'):
        try:
            with open(os.path.join(folder, name), 'x') as file:
                file.write('[pytest]\naddopts = --collect-only\n')
        except OSError:
            pass


def total(numbers):
    return 0
