from grading.variants import Alternative

ALTERNATIVES = [
    Alternative('regular_expression_for_the_whole_name', source='''
import re
import xml.etree.ElementTree as ET

W = r'[a-z](?:_?[a-z0-9])*'
RULES = {'package': rf'{W}(?<=..)', 'node': W, 'topic': rf'(~/)?{W}(/{W})*', 'service': rf'(~/)?{W}(/{W})*'}


def name_of(call):
    function, arguments, keywords, bases = call
    if function in ('create_publisher', 'create_subscription'):
        return 'topic', (arguments + [None, None])[1] or keywords.get('topic')
    if function in ('create_service', 'create_client'):
        return 'service', (arguments + [None, None])[1] or keywords.get('srv_name')
    if function in ('Node', 'create_node') or function == '__init__' and ('Node' in bases or 'LifecycleNode' in bases):
        return 'node', arguments[0] if arguments else keywords.get('node_name')
    return 'node', None


def find_bad_names(files):
    result = []
    for path, text in files.items():
        candidates = []
        if path == 'package.xml' or path.endswith('/package.xml'):
            candidates = [('package', ET.fromstring(text).find('name').text)]
        if path.endswith('.py'):
            candidates = [name_of(call) for call in calls(text)]
        for kind, name in candidates:
            if isinstance(name, str) and not re.fullmatch(RULES[kind], name) and [path, kind, name] not in result:
                result.append([path, kind, name])
    result.sort()
    return result
'''),
]
