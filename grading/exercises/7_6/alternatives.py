from grading.variants import Alternative

# With the numbers that faults had before they had names.
ALTERNATIVES = [
    Alternative('walks', source='''
def names(transform):
    return transform.header.frame_id, transform.child_frame_id


def diagnose_tf(moving, static, target, source, now):
    edges = {names(transform) for transform in list(moving) + list(static)}
    frames = {frame for edge in edges for frame in edge}
    children = {child for _, child in edges}
    if source not in frames:
        return [Finding('A7.12', source, 'unknown', nearest(source, sorted(frames)))]
    double = {child for child in children if sum(edge[1] == child for edge in edges) == 2}
    if double:
        return [Finding('A7.12', child, 'two parents', parent) for parent, child in sorted(edges)
                if child in double and parent not in children and parent != target]
    parent_of, frame, way = {child: parent for parent, child in edges}, source, []
    while frame in parent_of:
        way.append(frame)
        frame = parent_of[frame]
    if frame != target:
        def top(one):
            return top(parent_of[one]) if one in parent_of else one
        return [Finding('A7.12', frame, 'not connected', nearest(frame, [f for f in frames if top(f) != frame]))]
    found = []
    for frame in way:
        ages = [now - t.header.stamp.sec - t.header.stamp.nanosec * 1e-9 for t in moving if t.child_frame_id == frame]
        if ages and min(ages) > 1:
            found.append(Finding('A7.12', frame, 'old', '%.1f' % min(ages)))
    return found


def repair_tf(transforms, finding):
    transforms = copy.deepcopy(transforms)
    rename = {'unknown': {finding.evidence: finding.where}, 'not connected': {finding.where: finding.evidence},
              'two parents': {finding.evidence: finding.where, finding.where: finding.evidence}}.get(finding.cause, {})
    for transform in transforms:
        mine = finding.cause != 'two parents' or names(transform) == (finding.evidence, finding.where)
        if finding.evidence and mine:
            parent, child = names(transform)
            transform.header.frame_id, transform.child_frame_id = rename.get(parent, parent), rename.get(child, child)
    return transforms
'''),
]
