# expect: tf2 does not find
# rejected by: test_found_again[not connected]
# Exercise 7.6: where is the sensor?
def diagnose_tf(moving, static, target, source, now):
    parents, newest = {}, {}
    for transform in [*static, *moving]:
        parents.setdefault(transform.child_frame_id, set()).add(transform.header.frame_id)
    for transform in moving:
        child, stamp = transform.child_frame_id, transform.header.stamp
        newest[child] = max(newest.get(child, 0.0), stamp.sec + stamp.nanosec / 1e9)
    frames = set(parents).union(*parents.values())
    if source not in frames:
        return [Finding('A7.12', source, 'unknown', nearest(source, frames))]
    twice = [Finding('A7.12', child, 'two parents', parent) for child, both in parents.items() if len(both) > 1
             for parent in both if parent != target and parent not in parents]
    if twice:
        return twice
    way = [source]
    while way[-1] in parents:
        way += parents[way[-1]]
    if way[-1] != target:
        tree = {frame for frame in frames if way[-1] not in (frame, *parents.get(frame, ()))}
        return [Finding('A7.12', way[-1], 'not connected', nearest(way[-1], tree))]
    return [Finding('A7.12', frame, 'old', f'{now - newest[frame]:.1f}') for frame in way
            if frame in newest and now - newest[frame] > 1.0]


def repair_tf(transforms, finding):
    transforms = copy.deepcopy(transforms)
    _, where, cause, evidence = finding
    old, new = (evidence, where) if cause == 'unknown' else (where, evidence)
    for t in transforms if evidence else []:
        parent, child = t.header.frame_id, t.child_frame_id
        if cause == 'two parents' and (parent, child) == (evidence, where):
            t.header.frame_id, t.child_frame_id = child, parent
        elif cause in ('unknown', 'not connected'):
            t.child_frame_id = new if child == old else child
    return transforms
