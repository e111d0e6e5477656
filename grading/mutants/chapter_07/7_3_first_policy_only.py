# expect: You did not find
# rejected by: test_policies
# Exercise 7.3: who does not hear whom
def read_topics(node):
    found = []
    for name, _ in node.get_topic_names_and_types():
        for role, ends in (('publisher', node.get_publishers_info_by_topic(name)),
                           ('subscription', node.get_subscriptions_info_by_topic(name))):
            found += [{'role': role, 'node': f"{end.node_namespace.rstrip('/')}/{end.node_name}", 'name': name,
                       'type': end.topic_type, 'reliability': end.qos_profile.reliability.name,
                       'durability': end.qos_profile.durability.name} for end in ends]
    return [endpoint for endpoint in found if not usual(endpoint)]


def diagnose_graph(endpoints):
    found = []
    for end in endpoints:
        sender = {'subscription': 'publisher', 'client': 'server'}.get(end['role'])
        senders = [e for e in endpoints if e['role'] == sender]
        there = [e for e in senders if e['name'] == end['name']]
        strong = {'reliability': 'RELIABLE', 'durability': 'TRANSIENT_LOCAL'}
        faults = [(key, there[0][key]) for key in strong if there and end[key] == strong[key] != there[0][key]][:1]
        if not there:
            near = nearest(end['name'], [e['name'] for e in senders if e['type'] == end['type']])
            faults = [('name', near) if near else ('nobody', '')]
        elif there[0]['type'] != end['type']:
            faults = [('type', there[0]['type'])]
        row = 'A7.8' if end['role'] == 'client' else 'A7.10' if end['name'] == '/robot_description' else 'A7.6'
        found += [Finding(row, f"{end['node']} {end['name']}", *fault) for fault in faults if sender]
    return found


def repair_graph(finding):
    name, cause, value = finding.where.split()[1], finding.cause, finding.evidence
    if cause in ('reliability', 'durability'):
        return ['-p', f'qos_overrides.{name}.subscription.{cause}:={value.lower()}']
    return ['-r', f'{name}:={value}'] if cause == 'name' else []
