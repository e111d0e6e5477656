from grading.variants import Mutant

WHY, NODE = {'seen_by': 'test_why_no_data'}, {'seen_by': 'test_safety_stop'}
SINGLE, ALL = {'rejected_by': 'test_single_reasons', **WHY}, {'rejected_by': 'test_all_reasons', **WHY}
STOP = {'rejected_by': 'test_safety_stop', **NODE}
DEADLINE = "if (offered['deadline'] or float('inf')) > (requested['deadline'] or float('inf')):"
STRENGTH = 'strength[offered[key]] < strength[requested[key]]'

MUTANTS = [
    Mutant('callback_changed', old='distance < 0.5', new='distance <= 0.5', expect='The callback was right',
           breaks='rest', **STOP),
    Mutant('deadline_always_counts', old=DEADLINE, new="if offered['deadline'] != requested['deadline']:",
           expect='The offered period must not be longer', breaks='deadline', also=('no-deadline',), **SINGLE),
    Mutant('deadline_equal_is_too_long', old=DEADLINE,
           new="if requested['deadline'] and (offered['deadline'] or float('inf')) >= requested['deadline']:",
           expect='The offered period must not be longer', breaks='deadline', also=('no-deadline',), **SINGLE),
    Mutant('deadline_other_way_round', old="float('inf')) > (requested['deadline']",
           new="float('inf')) < (requested['deadline']", expect='The offered period must not be longer',
           breaks='deadline', also=('no-deadline', 'all'), **SINGLE),
    Mutant('depth_counts', old='return reasons', new='''
        if offered['depth'] < requested['depth']:
            reasons.append('depth')
        return reasons
        ''', expect='Depth is a private matter', breaks='depth', **SINGLE),
    Mutant('durability_equal_or_not', old=STRENGTH, new='(offered[key] != requested[key] if key == "durability" else '
           + STRENGTH + ')', expect='Different is not incompatible', breaks='durability', **SINGLE),
    Mutant('durability_forgotten', old="for key in ('reliability', 'durability') if", new="for key in ('reliability',) if",
           expect='at least as strong', breaks='durability', also=('all',), **SINGLE),
    Mutant('equal_or_not', old=STRENGTH, new='offered[key] != requested[key]', expect='Different is not incompatible',
           breaks='reliability', also=('durability',), **SINGLE),
    Mutant('first_reason_only', old='return reasons', new='return reasons[:1]', expect='Name every key', breaks='all',
           **ALL),
    Mutant('joined_text', old='return reasons', new="return ', '.join(reasons)", expect='must return a list',
           breaks='list', **SINGLE),
    Mutant('names_by_letters', old='if offered[key] != requested[key]]',
           new='if offered[key].lower() != requested[key].lower()]', expect='letter by letter', breaks='names', **SINGLE),
    Mutant('names_may_end_otherwise', old='if offered[key] != requested[key]]',
           new='if offered[key] not in requested[key]]', expect='only if they are equal', breaks='names',
           also=('all',), **SINGLE),
    Mutant('none_when_all_fits', old='return reasons', new='return reasons or None', expect='gives None, expected []',
           breaks='list', **SINGLE),
    Mutant('nothing_when_the_topic_differs', old='return reasons', new="return ['topic'] if 'topic' in reasons else reasons",
           expect='Name every key', breaks='all', **ALL),
    Mutant('one_profile_for_both', old="(LaserScan, 'scan', self.on_scan, sensor)",
           new="(LaserScan, 'scan', self.on_scan, command)", expect='Ask for no more than is offered', breaks='scan',
           **STOP),
    Mutant('other_way_round', old=STRENGTH, new=STRENGTH.replace('<', '>'), expect='at least as strong',
           breaks='reliability', also=('durability', 'all'), **SINGLE),
    Mutant('reliability_forgotten', old="for key in ('reliability', 'durability') if", new="for key in ('durability',) if",
           expect='at least as strong', breaks='reliability', also=('all',), **SINGLE),
    Mutant('renamed_node', old="super().__init__('safety_stop')", new="super().__init__('stop')",
           expect="expected 'safety_stop'", breaks='rest', **STOP),
    Mutant('scan_latched', old="(LaserScan, 'scan', self.on_scan, sensor)",
           new="(LaserScan, 'scan', self.on_scan, QoSProfile(depth=5, reliability=ReliabilityPolicy.BEST_EFFORT, "
               'durability=DurabilityPolicy.TRANSIENT_LOCAL))', expect='requests TRANSIENT_LOCAL', breaks='scan', **STOP),
    Mutant('scan_reliable', old="(LaserScan, 'scan', self.on_scan, sensor)",
           new="(LaserScan, 'scan', self.on_scan, 5)", expect='requests RELIABLE', breaks='scan', **STOP),
    Mutant('sorted_by_name', old='return reasons', new='return sorted(reasons)', expect='Keep the order', breaks='order',
           **ALL),
    Mutant('stop_best_effort', old=', durability=', new=', reliability=ReliabilityPolicy.BEST_EFFORT, durability=',
           expect='offers BEST_EFFORT', breaks='stop', rejected_by='test_late_driver', **NODE),
    Mutant('stop_deep', old='QoSProfile(depth=1', new='QoSProfile(depth=10', expect='The depth of stop was 1',
           breaks='rest', **STOP),
    Mutant('stop_volatile', old="(Bool, 'stop', command)", new="(Bool, 'stop', 1)", expect='offers VOLATILE',
           breaks='stop', rejected_by='test_late_driver', **NODE),
    Mutant('type_forgotten', old="for key in ('topic', 'type')", new="for key in ('topic',)",
           expect='only if they are equal', breaks='names', also=('all',), **SINGLE),
    Mutant('zero_deadline_is_shortest', old=DEADLINE, new="if offered['deadline'] > requested['deadline']:",
           expect='0.0 is an endless period', breaks='no-deadline', also=('all',), **SINGLE),
    Mutant('zero_deadline_of_the_offer', old=DEADLINE,
           new="if offered['deadline'] > (requested['deadline'] or float('inf')):", expect='0.0 is an endless period',
           breaks='no-deadline', also=('all',), **SINGLE),
    Mutant('zero_deadline_of_the_request', old=DEADLINE,
           new="if (offered['deadline'] or float('inf')) > requested['deadline']:", expect='0.0 is an endless period',
           breaks='no-deadline', **SINGLE),
]
