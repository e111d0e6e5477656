from grading.variants import Alternative

ALTERNATIVES = [
    Alternative('ast', source=r'''
import ast


def functions(text):
    return [part.name for part in ast.parse(text).body if isinstance(part, ast.FunctionDef)]


def cause(files, value):
    module, *names = value.split(':')
    if '/' in value or module.split('.')[-1] == 'py':
        return 'file'
    path = '/'.join(module.split('.')) + '.py'
    if path not in files:
        return 'module'
    return '' if names and names[0] in functions(files[path]) else 'function'


def diagnose_package(files):
    programs = entry_points(files['setup.py'])
    return [Finding('A7.4', program, why, value) for program, value in programs.items() if (why := cause(files, value))]


def repair_package(files):
    lines = files['setup.py'].split('\n')
    package = [name for name in files if '__init__' in name][0].split('/')[0]
    for finding in diagnose_package(files):
        for number, line in enumerate(lines):
            if line.strip().strip('\'"').split('=')[0].strip() == finding.where:
                public = [name for name in functions(files[f'{package}/{finding.where}.py']) if name[0] != '_']
                lines[number] = f'            "{finding.where}={package}.{finding.where}:{public[0]}",'
    return files | {'setup.py': '\n'.join(lines)}
'''),
]
