from grading.variants import Mutant

CAUSE = {'also': 'all'}
FUNCTION = {**CAUSE, 'breaks': 'function'}
MODULE = {**CAUSE, 'breaks': 'module'}
REPLACE = 'setup = re.sub(rf"([\'\\"])({program})\\s*=[^\'\\"]*", rf\'\\1\\2 = {package}.{program}:{function}\', setup)'

MUTANTS = [
    Mutant('first_program_only', old='    return found\n', new='    return found[:1]\n', breaks='all',
           expect='You did not find'),
    Mutant('no_file', old="if '/' in value or module.endswith('.py'):", new="if not value:", breaks='file',
           expect='no `/`, no `.py`', **CAUSE),
    Mutant('slashes_only', old="if '/' in value or module.endswith('.py'):", new="if '/' in value:", breaks='file',
           expect='no `/`, no `.py`', **CAUSE),
    Mutant('right_side_ends_in_py', old="module.endswith('.py')", new="value.endswith('.py')", breaks='file',
           expect='no `/`, no `.py`', **CAUSE),
    Mutant('no_module', old="found.append(Finding('no_program', program, 'module', value))", new='pass',
           expect='looked up among the files', **MODULE),
    Mutant('module_without_package', old="text = files.get(module.replace('.', '/') + '.py')",
           new="text = next((text for name, text in files.items() if name.endswith('/' + module.split('.')[-1] + '.py')), None)",
           expect='looked up among the files of the package', **MODULE),
    Mutant('module_as_evidence', old="Finding('no_program', program, 'module', value)",
           new="Finding('no_program', program, 'module', module)", expect='your evidence is', **MODULE),
    Mutant('where_is_the_package', old="Finding('no_program', program, 'module', value)",
           new="Finding('no_program', module.split('.')[0], 'module', value)", expect='your `where` is', **MODULE),
    Mutant('no_function', old="found.append(Finding('no_program', program, 'function', value))", new='pass',
           expect='stands at the left margin', **FUNCTION),
    Mutant('methods_count', old="(rf'^def {function", new=r"(rf'^\s*def {function", expect='a method, a class',
           **FUNCTION),
    Mutant('beginnings_count', old=r"(rf'^def {function}\(', text", new="(rf'^def {function}', text",
           expect='a longer name that only begins so', **FUNCTION),
    Mutant('none_named_is_right', old='elif not re.search', new='elif function and not re.search',
           expect='is named after a colon', **FUNCTION),
    Mutant('only_main_is_right', old=r"re.search(rf'^def {function}\(', text, re.MULTILINE):",
           new="function == 'main':", expect='there is no such fault', **FUNCTION),
    Mutant('coroutines_count', old="(rf'^def {function", new=r"(rf'^(async )?def {function", expect='an `async def`',
           **FUNCTION),
    Mutant('classes_count', old=r"(rf'^def {function}\(', text", new=r"(rf'^(def {function}\(|class {function}\b)', text",
           expect='a method, a class', **FUNCTION),
    Mutant('small_and_capital_letters', old='text, re.MULTILINE):', new='text, re.MULTILINE | re.IGNORECASE):',
           expect='stands at the left margin', **FUNCTION),
    Mutant('repairs_names_that_end_so', old='({program})', new=r'(\w*{program})', breaks='kept',
           expect='After your repair, re'),
    Mutant('loses_a_comma', old=REPLACE,
           new="setup = re.sub(rf\"(['\\\"]){program}\\s*=.*\", f\"'{program} = {package}.{program}:{function}'\", setup)",
           breaks='repaired', also='kept', expect='After your repair'),
    Mutant('changes_the_rest', old="return {**files, 'setup.py': setup}",
           new="return {**files, 'setup.py': setup.replace('zip_safe=True', 'zip_safe=False')}", breaks='kept',
           expect='something else is changed'),
    Mutant('python_files_alone', old="return {**files, 'setup.py': setup}",
           new="return {name: text for name, text in {**files, 'setup.py': setup}.items() if name.endswith('.py')}",
           breaks='kept', expect='README.md is missing'),
    Mutant('repairs_nothing', old="return {**files, 'setup.py': setup}", new='return dict(files)', breaks='repaired',
           expect='After your repair'),
    Mutant('repair_by_value', old=REPLACE,
           new="setup = setup.replace(finding.evidence, f'{package}.{program}:{function}')", breaks='repaired',
           also='kept', expect='After your repair'),
    Mutant('always_main', old=REPLACE, new=REPLACE.replace('{function}', 'main'), breaks='repaired',
           expect='After your repair'),
    Mutant('repairs_the_first', old='for finding in diagnose_package(files):',
           new='for finding in diagnose_package(files)[:1]:', breaks='repaired', expect='After your repair'),
    Mutant('setup_alone', old="return {**files, 'setup.py': setup}", new="return {'setup.py': setup}", breaks='kept',
           expect='must return all files'),
    Mutant('every_program_gets_main', old="return {**files, 'setup.py': setup}", new='''
    for program, value in entry_points(files['setup.py']).items():
        if program not in [finding.where for finding in diagnose_package(files)]:
            setup = setup.replace(value, value.partition(':')[0] + ':main_')
    return {**files, 'setup.py': setup}
''', breaks='kept', expect='After your repair'),
    Mutant('py_anywhere', old="module.endswith('.py')", new="'.py' in value", expect='there is no such fault',
           breaks='file', also=('module', 'function', 'all', 'kept', 'repaired')),
]
