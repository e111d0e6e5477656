from grading.variants import Alternative

ALTERNATIVES = [
    Alternative('sets', source='''
def as_text(role, name, info):
    space = '' if info.node_namespace == '/' else info.node_namespace
    policies = info.qos_profile
    return dict(role=role, node=space + '/' + info.node_name, name=name, type=info.topic_type,
                reliability=policies.reliability.name, durability=policies.durability.name)


def read_topics(node):
    topics = [name for name, types in node.get_topic_names_and_types()]
    found = [as_text('publisher', name, info) for name in topics for info in node.get_publishers_info_by_topic(name)]
    found += [as_text('subscription', name, info) for name in topics
              for info in node.get_subscriptions_info_by_topic(name)]
    return [endpoint for endpoint in found if not usual(endpoint)]


def why(end, senders):
    other = next((one for one in senders if one['name'] == end['name']), None)
    if other is None:
        meant = nearest(end['name'], {one['name'] for one in senders if one['type'] == end['type']})
        return {'name': meant} if meant else {'nobody': ''}
    if other['type'] != end['type']:
        return {'type': other['type']}
    order = ['', 'BEST_EFFORT', 'RELIABLE', 'VOLATILE', 'TRANSIENT_LOCAL']
    return {policy: other[policy] for policy in ('reliability', 'durability')
            if order.index(other[policy]) < order.index(end[policy])}


def diagnose_graph(endpoints):
    found = []
    for role, sender, row in (('client', 'server', 'A7.8'), ('subscription', 'publisher', 'A7.6')):
        senders = [end for end in endpoints if end['role'] == sender]
        for end in [end for end in endpoints if end['role'] == role]:
            number = 'A7.10' if (role, end['name']) == ('subscription', '/robot_description') else row
            found += [(number, end['node'] + ' ' + end['name'], *one) for one in why(end, senders).items()]
    return [Finding(*one) for one in found]


def repair_graph(finding):
    topic = finding.where.split(' ')[-1]
    match finding.cause:
        case 'name':
            return ['--remap', topic + ':=' + finding.evidence]
        case 'reliability' | 'durability':
            return ['--param', f'qos_overrides.{topic}.subscription.{finding.cause}:={finding.evidence.lower()}']
    return []
'''),
]
