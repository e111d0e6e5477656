# expect: You did not find A7.
# rejected by: test_beyond_repair
# alone: it uses the answers of the other exercises
# Exercise 7.7: the mystery
def look(case):
    transforms = [case[key] for key in ('moving', 'static', 'target', 'source', 'now')]
    return [*diagnose_machine(case['files'], case['want']), *diagnose_package(case['package']),
            *diagnose_graph(case['endpoints']),
            *diagnose_model(case['urdf']), *diagnose_tf(*transforms)]


def repair_case(case):
    case = {**case, 'package': repair_package(case['package']), 'urdf': repair_model(case['urdf'])}
    found = look(case)
    if any(finding.where in ('ros2.list', '.bashrc') for finding in found):
        case['files'] = repair_machine(case['files'], case['want'])
    for finding in found:
        if finding.row == 'A7.12':
            case |= {key: repair_tf(case[key], finding) for key in ('moving', 'static')}
        elif finding.row in ('A7.6', 'A7.8', 'A7.10') and finding.cause != 'server':
            case['endpoints'] = with_arguments(case['endpoints'], finding, repair_graph(finding))
    return case


def triage(case):
    found = []
    while fresh := [finding for finding in look(case) if finding not in found]:
        found += fresh
        case = repair_case(case)
    return found
