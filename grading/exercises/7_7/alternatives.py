from grading.variants import Alternative

ALTERNATIVES = [
    Alternative('recursive', source='''
def parts(case):
    yield diagnose_machine(case['files'], case['want'])
    yield diagnose_package(case['package'])
    yield diagnose_graph(case['endpoints'])
    yield diagnose_stacks(case['stacks'], case['programs'])
    yield diagnose_model(case['urdf'])
    yield diagnose_tf(case['moving'], case['static'], case['target'], case['source'], case['now'])


def repair_case(case):
    machine, package, graph, _, model, frames = parts(case)
    better = copy.deepcopy(case)
    if machine:
        better['files'] = repair_machine(case['files'], case['want'])
    if package:
        better['package'] = repair_package(case['package'])
    for finding in graph:
        better['endpoints'] = with_arguments(better['endpoints'], finding, repair_graph(finding))
    if model:
        better['urdf'] = repair_model(case['urdf'])
    for finding in frames:
        better['moving'], better['static'] = (repair_tf(better[key], finding) for key in ('moving', 'static'))
    return better


def triage(case, known=()):
    fresh = [finding for part in parts(case) for finding in part if finding not in known]
    if not fresh:
        return list(known)
    return triage(repair_case(case), [*known, *fresh])
'''),
    # The numbers are those that faults had before they had names.
    Alternative('numbers', edits=(
        ("if finding.fault == 'no_transform':", "if finding.row in {'A7.12'}:"),
        ("elif finding.fault in ('no_data', 'waiting', 'no_model') and",
         "elif finding[0] in ('A7.6', 'A7.8', 'A7.10') and finding != ('A7.8', '', 'server', '') and"),
    )),
]
