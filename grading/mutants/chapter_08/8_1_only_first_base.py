# expect: Look at the bases of the class
# rejected by: test_nodes
# Exercise 8.1: a linter for names
import re
from xml.etree import ElementTree

WORD = re.compile('[a-z][a-z0-9]*(_[a-z0-9]+)*')
PLACES = {  # function: kind, number of the argument, its keyword
    'create_node': ('node', 0, 'node_name'), 'Node': ('node', 0, 'node_name'), '__init__': ('node', 0, 'node_name'),
    'create_publisher': ('topic', 1, 'topic'), 'create_subscription': ('topic', 1, 'topic'),
    'create_service': ('service', 1, 'srv_name'), 'create_client': ('service', 1, 'srv_name')}


def is_good(kind, name):
    words = [name] if kind in ('package', 'node') else name.removeprefix('~/').split('/')
    return all(WORD.fullmatch(word) for word in words) and (kind != 'package' or len(name) > 1)


def names(text):
    for function, arguments, keywords, bases in calls(text):
        if function in PLACES and (function != '__init__' or bases[:1] in (['Node'], ['LifecycleNode'])):
            kind, number, keyword = PLACES[function]
            name = arguments[number] if number < len(arguments) else keywords.get(keyword)
            if isinstance(name, str):
                yield kind, name


def find_bad_names(files):
    found = set()
    for path, text in files.items():
        if path.split('/')[-1] == 'package.xml':
            found.add((path, 'package', ElementTree.fromstring(text).findtext('name').strip()))
        elif path.endswith('.py'):
            found |= {(path, *one) for one in names(text)}
    return sorted([path, kind, name] for path, kind, name in found if not is_good(kind, name))
