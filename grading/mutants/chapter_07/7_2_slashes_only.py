# expect: no `/`, no `.py`
# rejected by: test_one_program[file]
# Exercise 7.2: a program that is not found
def diagnose_package(files):
    found = []
    for program, value in entry_points(files['setup.py']).items():
        module, _, function = value.partition(':')
        text = files.get(module.replace('.', '/') + '.py')
        if '/' in value:
            found.append(Finding('A7.4', program, 'file', value))
        elif text is None:
            found.append(Finding('A7.4', program, 'module', value))
        elif not re.search(rf'^def {function}\(', text, re.MULTILINE):
            found.append(Finding('A7.4', program, 'function', value))
    return found


def repair_package(files):
    setup = files['setup.py']
    package = next(name for name in files if name.endswith('/__init__.py')).split('/')[0]
    for finding in diagnose_package(files):
        program = finding.where
        function = re.search(r'^def ([a-z]\w*)\(', files[f'{package}/{program}.py'], re.MULTILINE)[1]
        setup = re.sub(rf"(['\"])({program})\s*=[^'\"]*", rf'\1\2 = {package}.{program}:{function}', setup)
    return {**files, 'setup.py': setup}
