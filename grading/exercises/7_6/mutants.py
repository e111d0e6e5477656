from grading.variants import Mutant

TREE = {'breaks': 'not-connected'}
OLD = {'breaks': 'old'}
NEWEST = 'newest[child] = max(newest.get(child, 0.0), stamp.sec + stamp.nanosec / 1e9)'
NAMES = 't.header.frame_id, t.child_frame_id = (new if name == old else name for name in (parent, child))'

MUTANTS = [
    Mutant('the_target_is_not_meant', old='nearest(source, frames))]', new='nearest(source, frames - {target}))]',
           expect='Asked for', breaks='unknown'),
    Mutant('no_unknown', old='if source not in frames:', new='if not frames:', breaks='unknown', also='order',
           expect='You did not find `no_transform`, cause `unknown`'),
    Mutant('unknown_only_with_evidence', old='if source not in frames:', expect='You did not find',
           new='if source not in frames and nearest(source, frames):', breaks='unknown'),
    Mutant('unknown_without_evidence', old="'unknown', nearest(source, frames))", new="'unknown', '')",
           breaks='unknown', also='order', expect='your evidence is'),
    Mutant('no_two_parents', old='        return twice\n', new='        return []\n', breaks='two-parents',
           also='order', expect='You did not find `no_transform`, cause `two parents`'),
    Mutant('names_of_any_case', old=NAMES, new=NAMES.replace('name == old', 'name.lower() == old.lower()'), breaks='kept',
           expect='letter by letter'),
    Mutant('two_parents_of_what_moves', old='if twice := [',
           new="if twice := [finding for finding in [", edits=((' for parent in both if parent != target and parent not in parents]:',
           ' for parent in both if parent != target and parent not in parents] if finding.where in newest]:'),),
           breaks='two-parents', expect='You did not find `no_transform`, cause `two parents`'),
    Mutant('right_parent_is_wrong', old='!= target and parent not in parents', new='in parents or parent == target',
           breaks='two-parents', also='order', expect='the wrong parent is the one'),
    Mutant('both_parents', old=' if parent != target and parent not in parents]', new=']', breaks='two-parents',
           also='order', expect='there is no such fault'),
    Mutant('no_not_connected',
           old="return [Finding('no_transform', way[-1], 'not connected', nearest(way[-1], frames - tree))]", new='return []',
           also=('order', 'unknown'), expect='You did not find `no_transform`, cause `not connected`', **TREE),
    Mutant('own_tree_counts', old='nearest(way[-1], frames - tree)', new='nearest(way[-1], frames)',
           expect='your evidence is', **TREE),
    Mutant('children_only_left_out', old='nearest(way[-1], frames - tree)',
           new='nearest(way[-1], [f for f in frames if way[-1] not in (f, *parents.get(f, ()))])',
           expect='so of none that is below', **TREE),
    Mutant('tree_below_the_source', old='tree = {way[-1]}', new='tree = {source}', expect='your evidence is', **TREE),
    Mutant('tree_without_the_way', old='nearest(way[-1], frames - tree)', new='nearest(way[-1], frames - tree | set(way))',
           expect='your evidence is', **TREE),
    Mutant('source_instead_of_top', old="Finding('no_transform', way[-1], 'not", new="Finding('no_transform', source, 'not",
           also='order', expect='your `where` is', **TREE),
    Mutant('no_old', old='> 1.0]', new='> 1e9]', also='newest', expect='More than 1 s is old', **OLD),
    Mutant('buffer_of_ten_seconds', old='> 1.0]', new='> 10.0]', also='newest', expect='More than 1 s is old', **OLD),
    Mutant('every_old_frame', old='frame in way', new='frame in newest', also='newest',
           expect='there is no such fault', **OLD),
    Mutant('static_ones_age', old='for t in moving):', new='for t in [*moving, *static]):', also='newest',
           expect='static ones do not age', **OLD),
    Mutant('age_as_a_number', old="f'{now - newest[frame]:.1f}'", new='str(now - newest[frame] + 1e-9)', also='newest',
           expect='your evidence is', **OLD),
    Mutant('stamp_instead_of_age', old="f'{now - newest[frame]:.1f}'", new="f'{newest[frame]:.1f}'", also='newest',
           expect='your evidence is', **OLD),
    Mutant('latest_message_only', old=NEWEST, new='newest[child] = stamp.sec + stamp.nanosec / 1e9', breaks='newest',
           also='old', expect='The newest stamp of each moving transform'),
    Mutant('first_message_only', old=NEWEST, new='newest.setdefault(child, stamp.sec + stamp.nanosec / 1e9)',
           breaks='newest', also='old', expect='The newest stamp of each moving transform'),
    Mutant('whole_seconds', old='stamp.sec + stamp.nanosec / 1e9)', new='stamp.sec)', breaks='newest', also='old',
           expect='The newest stamp of each'),
    Mutant('old_in_any_case',
           old="return [Finding('no_transform', way[-1], 'not connected', nearest(way[-1], frames - tree))]", new='''
        return [Finding('no_transform', way[-1], 'not connected', nearest(way[-1], frames - tree)),
                *[Finding('no_transform', frame, 'old', f'{now - newest[frame]:.1f}') for frame in way
                  if frame in newest and now - newest[frame] > 1.0]]
''', breaks='order', expect='there is no such fault'),
    Mutant('two_parents_first', old='if source not in frames:',
           new='if source not in frames and max(map(len, parents.values()), default=0) < 2:', breaks='order',
           expect='You did not find `no_transform`, cause `unknown`'),
    Mutant('inverts_the_numbers', old='t.header.frame_id, t.child_frame_id = child, parent', new='''
        t.header.frame_id, t.child_frame_id = child, parent
        t.transform.translation.x *= -1
        ''', breaks='kept', expect='The numbers and the stamps'),
    Mutant('drops_the_wrong_one', old='    return transforms\n', new='''
    return [t for t in transforms if cause != 'two parents' or t.child_frame_id != where]
''', breaks='kept', expect='transforms and returned'),
    Mutant('known_as_a_child_only', old='frames = set(parents).union(*parents.values())', new='frames = set(parents)',
           breaks='unknown', also='not-connected', expect='`no_transform`, cause'),
    Mutant('on_the_way_only', old='if len(both) > 1', new='if len(both) > 1 and above(parents, source, child)',
           imports='''
def above(parents, frame, other):
    return frame == other or any(above(parents, one, other) for one in parents.get(frame, ()))
''', breaks='two-parents', also='order', expect='You did not find `no_transform`, cause `two parents`'),
    Mutant('first_of_two_parents', old='return twice', new='return twice[:1]', breaks='two-parents',
           expect='You did not find `no_transform`, cause `two parents`'),
    Mutant('in_the_tree_of_the_target', edits=(
           ("return [Finding('no_transform', way[-1], 'not connected', nearest(way[-1], frames - tree))]", '''
            below = [frame for frame in frames if frame == target or target in parents.get(frame, ())]
            return [Finding('no_transform', way[-1], 'not connected', nearest(way[-1], below))]
            '''),), expect='your evidence is', also='order', **TREE),
    Mutant('not_the_sensor_itself', old=":.1f}') for frame in way", new=":.1f}') for frame in way[1:]",
           expect='You did not find `no_transform`, cause `old`', **OLD),
    Mutant('at_one_second', old='> 1.0]', new='>= 1.0]', also='newest', expect='there is no such fault', **OLD),
    Mutant('age_is_cut_off', old="f'{now - newest[frame]:.1f}'", new="f'{(now - newest[frame]) // 0.1 / 10:.1f}'",
           also='newest', expect='your evidence is', **OLD),
    Mutant('renames_parts_of_names', old=NAMES,
           new='t.header.frame_id, t.child_frame_id = (name.replace(old, new) for name in (parent, child))',
           breaks='kept', also='repaired', expect='only the wrong frame gets another name'),
    Mutant('exchanges_all_above', old='(parent, child) == (evidence, where)', new='child == where',
           breaks='repaired', also='kept', expect='After your repair'),
    Mutant('renames_the_child_alone', old=NAMES,
           new='''
           t.child_frame_id = new if child == old else child
           t.header.frame_id = new if (parent, cause) == (old, 'not connected') else parent
           ''',
           breaks='repaired', expect='wherever it stands, as parent and as child'),
    Mutant('renames_children_only', old=NAMES, new='t.child_frame_id = new if child == old else child',
           breaks='repaired', expect='wherever it stands, as parent and as child'),
    Mutant('renames_the_wrong_way', old="(evidence, where) if cause == 'unknown' else (where, evidence)",
           new='(where, evidence)', breaks='repaired', expect='tf2 does not find'),
    Mutant('exchanges_nothing', old='t.header.frame_id, t.child_frame_id = child, parent', new='pass',
           breaks='repaired', expect='tf2'),
    Mutant('renames_to_nothing', old='for t in transforms if evidence else []:', new='for t in transforms:',
           breaks='nothing', expect='cannot be repaired here'),
    Mutant('makes_old_ones_new', old='    return transforms\n', new='''
    for t in transforms:
        if cause == 'old' and t.child_frame_id == where:
            t.header.stamp.sec += 10
    return transforms
''', breaks='nothing', expect='cannot be repaired here'),
    Mutant('ahead_of_now', old='now - newest[frame] > 1.0]', new='abs(now - newest[frame]) > 1.0]', breaks='old',
           also=('newest', 'order'), expect='what is ahead of now is not'),
    Mutant('four_levels_down', old='for _ in parents:', new='for _ in range(4):', breaks='not-connected',
           expect='none that is below the top frame'),
    Mutant('a_target_that_is_unknown', old='if source not in frames:', breaks='not-connected', also='unknown',
           new="""
    if frames and target not in frames:
        return [Finding('no_transform', target, 'unknown', nearest(target, frames))]
    if source not in frames:
""", expect='cause `not connected`'),
    Mutant('a_little_more_is_not_old', old='now - newest[frame] > 1.0]', new='round(now - newest[frame], 1) > 1.0]',
           breaks='old', expect="evidence '1.0'"),
    Mutant('two_digits_of_age', old="f'{now - newest[frame]:.1f}'", new="f'{now - newest[frame]:.2g}'", breaks='old',
           also=('newest', 'order'), expect='your evidence is'),
    Mutant('known_in_any_letters', old='if source not in frames:', new='if source.lower() not in {frame.lower() for frame in frames}:',
           breaks='unknown', expect='You did not find `no_transform`, cause `unknown`'),
    Mutant('sorts_what_it_was_given', old='parents, newest = {}, {}', breaks='kept', also='nothing', expect='the order stays',
           new='parents, newest, _ = {}, {}, moving.sort(key=lambda t: (t.header.stamp.sec, t.header.stamp.nanosec))'),
    Mutant('something_must_have_come', old='frames = set(parents).union(*parents.values())', breaks='unknown',
           new='frames = set.union(set(parents), *parents.values()) if min(parents) else set()', expect='empty'),
    Mutant('six_steps_up', old='while way[-1] in parents:', new='while way[-1] in parents and len(way) < 7:',
           breaks='not-connected', also='old', expect='goes through'),
    Mutant('slashes_do_not_count', old='frames = set(parents).union(*parents.values())',
           new="frames = {frame.strip('/') for frame in set(parents).union(*parents.values())}", breaks='unknown',
           expect='You did not find `no_transform`, cause `unknown`'),
    Mutant('a_little_alike_above', old='nearest(way[-1], frames - tree)',
           new="(get_close_matches(way[-1], sorted(frames - tree), 1) or [''])[0]",
           expect='says which name was meant', **TREE),
    Mutant('no_last_part', old='nearest(way[-1], frames - tree)',
           new="(get_close_matches(way[-1], sorted(frames - tree), 1, 0.75) or [''])[0]",
           expect='says which name was meant', **TREE),
    Mutant('a_little_alike', old='nearest(source, frames))]',
           new="(get_close_matches(source, sorted(frames), 1) or [''])[0])]", breaks='unknown',
           expect='says which name was meant'),
    Mutant('roots_by_name', old='if way[-1] != target:', new="if way[-1] not in ('map', 'odom', 'world', target):",
           expect='is not the target here', **TREE),
    Mutant('right_parents_by_name', old='parent != target and', new="parent not in ('map', 'odom', 'world') and",
           breaks='two-parents', expect='is not the target here'),
    Mutant('static_ones_with_a_stamp_age', old='for t in moving):',
           new='for t in [*moving, *(one for one in static if one.header.stamp.sec)]):', also='newest',
           expect='static ones do not age', **OLD),
    Mutant('rotations_are_lost', old='    return transforms\n', new='''
    for t in transforms:
        t.transform.rotation.z, t.transform.rotation.w = 0.0, 1.0
    return transforms
''', breaks='kept', also='nothing', expect='The numbers and the stamps'),
    Mutant('time_zero_is_no_time', old='if frame in newest and', new='if newest.get(frame) and',
           expect='You did not find `no_transform`, cause `old`', breaks='old'),
    Mutant('no_slashes', old='transforms = copy.deepcopy(transforms)', new="""
        transforms = copy.deepcopy(transforms)
        for t in transforms:
            t.header.frame_id, t.child_frame_id = t.header.frame_id.lstrip('/'), t.child_frame_id.lstrip('/')
        """, expect='letter by letter', breaks='kept'),
    Mutant('nothing_of_nothing', old='transforms = copy.deepcopy(transforms)', new="""
        transforms = copy.deepcopy(transforms)
        if not transforms:
            return None
        """, expect='repair_tf got an empty list', breaks='kept'),
]
