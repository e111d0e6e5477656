from grading.variants import Mutant

TRIAGE = {'alone': True}
REPAIR = {'alone': True}
LOOP = 'while fresh := [finding for finding in look(case) if finding not in found]:'
GRAPH = "case['endpoints'] = with_arguments(case['endpoints'], finding, repair_graph(finding))"

MUTANTS = [
    Mutant('machine_for_its_sources_only', old="if any(finding.where in ('ros2.list', '.bashrc') for finding in found):",
           new="if any(finding.where == 'ros2.list' for finding in found):", expect='A shell with your .bashrc', breaks='files'),
    Mutant('no_repair_of_who_is_unseen', old="if any(finding.where in ('ros2.list', '.bashrc') for finding in found):",
           new="if any(finding.fault in ('no_source', 'no_ros2', 'no_colcon', 'mixed_distros') for finding in found):",
           expect='A shell with your .bashrc is in domain', breaks='files'),
    Mutant('set_of_findings', old='    return found\n', new='    return set(found)\n', breaks='every-part',
           also=('hidden', 'nothing', 'ends'), expect='returned a set', **TRIAGE),
    Mutant('finds_again', edits=((LOOP, 'for _ in range(4):'), ('found += fresh', 'found += look(case)')),
           breaks='once', expect='more than once', **TRIAGE),
    Mutant('forgets_the_stacks',
           old="*diagnose_graph(case['endpoints']), *diagnose_stacks(case['stacks'], case['programs']),",
           new="*diagnose_graph(case['endpoints']),", breaks='every-part', also='hidden', expect='You did not find `',
           **TRIAGE),
    Mutant('a_finding_too_much', old='    return found\n',
           new="    return found or [Finding('no_source', 'ros2.list', 'missing', '')]\n", breaks='nothing',
           expect='there is no such fault', **TRIAGE),
    Mutant('one_of_each_cause', old='    return found\n', new='''
    return list({finding[:3]: finding for finding in found}.values())
''', breaks='every-part', expect='You did not find', **TRIAGE),
    Mutant('looks_once', old='while fresh', new='if fresh', breaks='hidden', expect='You did not find', **TRIAGE),
    Mutant('two_rounds_only', edits=((LOOP, 'for _ in range(2):'),
                                     ('found += fresh', 'found += [one for one in look(case) if one not in found]')),
           breaks='hidden', expect='You did not find', **TRIAGE),
    Mutant('four_rounds_only', edits=((LOOP, 'for _ in range(4):'),
                                      ('found += fresh', 'found += [one for one in look(case) if one not in found]')),
           breaks='hidden', expect='You did not find', **TRIAGE),
    Mutant('keeps_six_of_the_old_ones', old='found += fresh', new='found = fresh + found[:6]', breaks='hidden',
           expect='You did not find', **TRIAGE),
    Mutant('all_again_with_the_new_ones', edits=((LOOP, 'while [finding for finding in look(case) if finding not in found]:'),
                                                 ('found += fresh', 'found += look(case)')),
           breaks='once', expect='more than once', **TRIAGE),
    Mutant('one_for_each_place', old='if finding not in found]', new='if finding[:2] not in [one[:2] for one in found]]',
           breaks='hidden', expect='You did not find', **TRIAGE),
    Mutant('stacks_are_no_graph', old=" and finding.cause != 'server'", new='', breaks='every-part', also='hidden',
           expect='IndexError', **TRIAGE),
    Mutant('the_last_repair_counts', edits=((GRAPH, GRAPH.replace("(case['endpoints']", "(before['endpoints']")),
                                           ('found = look(case)', "before, found = dict(case), look(case)\n")),
           breaks='endpoints', expect='is still deaf', **REPAIR),
    Mutant('until_nothing_is_wrong', edits=((LOOP, 'while fresh := look(case):'),
                                            ('found += fresh', 'found += [one for one in fresh if one not in found]')),
           breaks='ends', also='every-part', expect='did not return', **TRIAGE),
    Mutant('repairs_no_graph', old=GRAPH, new='pass', breaks='endpoints', also='hidden', expect='is still deaf',
           **REPAIR),
    Mutant('repairs_no_package', old="'package': repair_package(case['package']), ", new='', breaks='files',
           expect='After your repair', **REPAIR),
    Mutant('static_only', old="'moving', 'static')", new="'static',)", breaks='transforms', also='hidden',
           expect='tf2', **REPAIR),
    Mutant('repairs_until_nothing_is_new', breaks='endpoints', also='transforms', expect='is left for the next round', edits=(
        ('def repair_case(case):', 'def one_round(case):'), ('case = repair_case(case)', 'case = one_round(case)'),
        ('def triage(case):', """
def repair_case(case):
    known = []
    while fresh := [finding for finding in look(case) if finding not in known]:
        known += fresh
        case = one_round(case)
    return case


def triage(case):
""")), **REPAIR),
    Mutant('returns_no_case', old='    return case\n', new='', breaks='new-case', expect='repair_case returned None',
           also=('files', 'endpoints', 'transforms', 'hidden', 'every-part', 'ends', 'once', 'nothing'), **REPAIR),
    Mutant('what_the_table_names', old='    return case\n', new="""
    return {key: case[key] for key in ('files', 'want', 'package', 'endpoints', 'stacks', 'programs', 'urdf', 'moving',
                                       'static', 'target', 'source', 'now')}
""", breaks='new-case', expect='The case that repair_case returned lacks note', **REPAIR),
    Mutant('hangs_are_wiped_away', old='    return case\n', new='''
    case['stacks'] = ''
    return case
''', breaks='new-case', expect="has changed 'stacks' of the case", also=('files', 'endpoints', 'transforms'), **REPAIR),
    Mutant('turns_the_clock_back', old="        if finding.fault == 'no_transform':", new='''
        if finding.fault == 'no_transform' and not finding.evidence.isalpha():
            case['now'] = 0.0
        if finding.fault == 'no_transform':
''', breaks='new-case', expect="has changed 'now' of the case",
           also=('files', 'endpoints', 'transforms', 'hidden', 'every-part'), **REPAIR),
    Mutant('offers_what_is_asked_for', old=GRAPH, new="""
        if finding.cause in ('reliability', 'durability'):
            name = finding.where.split()[1]
            case['endpoints'] = [
                {**end, finding.cause: {'reliability': 'RELIABLE', 'durability': 'TRANSIENT_LOCAL'}[finding.cause]}
                if (end['role'], end['name']) == ('publisher', name) else end for end in case['endpoints']]
        else:
            case['endpoints'] = with_arguments(case['endpoints'], finding, repair_graph(finding))
        """, breaks='endpoints', also='hidden', expect='all others stay as they were', **REPAIR),
    Mutant('all_ask_for_less', old='    return case\n', new="""
    case['endpoints'] = [{**end, 'reliability': 'BEST_EFFORT', 'durability': 'VOLATILE'}
                         if end['role'] == 'subscription' else end for end in case['endpoints']]
    return case
""", breaks='endpoints', also=('hidden', 'every-part'), expect='all others stay as they were', **REPAIR),
    Mutant('frames_until_nothing_is_new', old='    return case\n', new="""
    for _ in range(6):
        for finding in diagnose_tf(*[case[key] for key in ('moving', 'static', 'target', 'source', 'now')]):
            case |= {key: repair_tf(case[key], finding) for key in ('moving', 'static')}
    return case
""", breaks='transforms', also='hidden', expect='is left for the next round', **REPAIR),
]
