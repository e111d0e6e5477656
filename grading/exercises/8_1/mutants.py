from grading.variants import Mutant

BASES = "if function in PLACES and (function != '__init__' or {'Node', 'LifecycleNode'} & set(bases)):"
WORDS = 'return all(WORD.fullmatch(word) for word in words)'
PATTERN = '[a-z][a-z0-9]*(_[a-z0-9]+)*'
# The given `calls`, written as a visitor; a wrong answer adds what it does in a class or a function.
VISITOR = '''
def calls(text):
    visitor = Calls()
    visitor.visit(ast.parse(text))
    return visitor.found


class Calls(ast.NodeVisitor):
    def __init__(self):
        self.bases, self.found = [], []

    def visit_Call(self, node):
        words = {word.arg: value(word.value) for word in node.keywords}
        self.found.append((last_name(node.func), [value(one) for one in node.args], words, self.bases))
        self.generic_visit(node)
'''

MUTANTS = [
    Mutant('absolute_is_fine', old="removeprefix('~/').", new="removeprefix('~/').removeprefix('/').",
           expect='It is absolute', breaks='topic', also='service'),
    Mutant('topics_may_be_absolute', old="name.removeprefix('~/').split('/')",
           new="name.removeprefix('~/').removeprefix('/' if kind == 'topic' else '').split('/')",
           expect='It is absolute', breaks='topic'),
    Mutant('services_are_not_split', old="else name.removeprefix('~/').split('/')",
           new="else name.removeprefix('~/').split('/')[:None if kind == 'topic' else 1]", expect='A word is empty',
           breaks='service'),
    Mutant('clients_are_topics', old="'create_client': ('service'", new="'create_client': ('topic'",
           expect='Expected: the service', breaks='service', also=('keyword', 'topic')),
    Mutant('no_subscriptions',
           old="'create_publisher': ('topic', 1, 'topic'), 'create_subscription': ('topic', 1, 'topic'),",
           new="'create_publisher': ('topic', 1, 'topic'),", expect='Not reported: the topic', breaks='topic',
           also='keyword'),
    Mutant('digits_of_all_alphabets', old=PATTERN, new=r'[a-z][a-z\\d]*(_[a-z\\d]+)*',
           expect='has a digit that is not from 0 to 9', breaks='word', also=('package', 'topic', 'service')),
    Mutant('lifecycle_nodes_by_name', old="'Node': ('node', 0, 'node_name'), '__init__'",
           new="'Node': ('node', 0, 'node_name'), 'LifecycleNode': ('node', 0, 'node_name'), '__init__'",
           expect='It is no text that names a node', breaks='no-text'),
    Mutant('no_tests', old="elif path.endswith('.py'):", new="elif path.endswith('.py') and path[:4] not in ('test', 'laun'):",
           expect='Every file ….py is read', breaks='files'),
    Mutant('no_init', old="elif path.endswith('.py'):", new="elif path.endswith('.py') and not path.endswith('__init__.py'):",
           expect='Every file ….py is read', breaks='files'),
    Mutant('actions_are_services', old="'create_client': ('service', 1, 'srv_name')}",
           new="'create_client': ('service', 1, 'srv_name'), 'ActionServer': ('service', 2, 'action_name')}",
           expect='It is no text that names', breaks='no-text'),
    Mutant('nodes_may_be_private', old="words = [name] if kind in ('package', 'node') else",
           new="words = [name.removeprefix('~').removeprefix('/')] if kind == 'node' else [name] if kind == 'package' else",
           expect='It has a tilde', breaks='word'),
    Mutant('any_underscores', old="WORD = re.compile('[a-z][a-z0-9]*(_[a-z0-9]+)*')",
           new="WORD = re.compile('[a-z][a-z0-9_]*')", expect='two underscores in a row', breaks='word',
           also=('package', 'topic', 'service')),
    Mutant('match_is_enough', old='WORD.fullmatch(word)', new='WORD.match(word)', expect='has a capital letter in it',
           breaks='word', also=('package', 'once', 'topic', 'service')),
    Mutant('dollar_before_line_break', edits=((PATTERN, f'^{PATTERN}$'), (WORDS, WORDS.replace('fullmatch', 'match'))),
           expect='ends with a line break', breaks='word', also=('topic', 'service')),
    Mutant('no_digits', old=PATTERN, new='[a-z]+(_[a-z]+)*', expect='It follows the rule of words', breaks='word',
           also=('topic', 'service')),
    Mutant('a_word_in_another_alphabet', old=PATTERN, new=r'[^\\W\\d_A-Z][^\\W_A-Z]*(_[^\\W_A-Z]+)*',
           expect='has a letter that is not from a to z', breaks='word', also=('package', 'topic', 'service')),
    Mutant('lower_case_is_enough', old=WORDS, new='return all(word and word == word.lower() for word in words)',
           expect='It has a hyphen', breaks='word', also=('topic', 'service', 'package', 'once')),
    Mutant('the_empty_name_is_no_name', old='if isinstance(name, str):', new='if name and isinstance(name, str):',
           expect='It is empty', breaks='word'),
    Mutant('every_super', old=BASES, new='if function in PLACES:', expect='are neither Node nor LifecycleNode',
           breaks='super'),
    Mutant('only_first_base', old="{'Node', 'LifecycleNode'} & set(bases",
           new="bases[:1] in (['Node'], ['LifecycleNode']", expect='among its bases', breaks='super'),
    Mutant('no_lifecycle_nodes', old="{'Node', 'LifecycleNode'} & set(bases", new="{'Node'} & set(bases",
           expect='among its bases', breaks='super'),
    Mutant('any_class_that_ends_with_node', old="{'Node', 'LifecycleNode'} & set(bases)",
           new="any(base.endswith('Node') for base in bases)", expect='are neither Node nor LifecycleNode',
           breaks='super'),
    Mutant('no_super', old=" '__init__': ('node', 0, 'node_name'),", new='', expect='among its bases', breaks='super', also='keyword'),
    Mutant('only_create_node', old=" 'Node': ('node', 0, 'node_name'),", new='', expect='Not reported: the node',
           breaks='node', also='keyword'),
    Mutant('no_keywords', old='keywords.get(keyword)', new='None', expect='It is given as a keyword', breaks='keyword'),
    Mutant('keyword_name', old="keywords.get(keyword)", new="keywords.get(keyword) or keywords.get('name')",
           expect='It is no text that names', breaks='no-text'),
    Mutant('one_keyword_for_all', old="'create_client': ('service', 1, 'srv_name')",
           new="'create_client': ('service', 1, 'topic')", expect='It is given as a keyword', breaks='keyword'),
    Mutant('a_variable_is_a_name', old='if isinstance(name, str):', new="if isinstance(name := str(name), str):",
           expect='It is no text that names', breaks='no-text', also=('node', 'super', 'topic', 'keyword')),
    Mutant('private_is_bad', old=".removeprefix('~/').split", new='.split', expect='may begin with ~/', breaks='topic',
           also='service'),
    Mutant('packages_in_lower_case', old=f"{WORDS} and (kind != 'package' or len(name) > 1)", new='''
           return name == name.lower() and len(name) > 1 if kind == 'package' else all(map(WORD.fullmatch, words))
           ''', expect='It has a hyphen', breaks='package'),
    Mutant('no_keyword_of_super', old="'__init__': ('node', 0, 'node_name')", new="'__init__': ('node', 0, '')",
           expect='It is given as a keyword', breaks='keyword'),
    Mutant('a_number_is_a_name', old='if isinstance(name, str):', new='if name is not None:',
           expect='raised TypeError', breaks='no-text'),
    Mutant('a_tilde_has_no_words', old=WORDS,
           new="return name in ('~', '~/') or all(WORD.fullmatch(word) for word in words)",
           expect='There is no word in it', breaks='topic', also='service'),
    Mutant('short_package', old=") and (kind != 'package' or len(name) > 1)", new=')', expect='It has one character',
           breaks='package'),
    Mutant('three_characters', old='len(name) > 1', new='len(name) > 2', expect='at least two characters',
           breaks='package'),
    Mutant('package_at_the_top_only', old="if path.split('/')[-1] == 'package.xml':", new="if path == 'package.xml':",
           expect='Not reported: the package', breaks='package'),
    Mutant('whatever_ends_with_package_xml', old="if path.split('/')[-1] == 'package.xml':",
           new="if path.endswith('package.xml'):", expect='Only package.xml and files', breaks='files'),
    Mutant('every_other_file', old="elif path.endswith('.py'):",
           new="elif not path.endswith(('.xml', '.cfg', '.bak')):", expect='Only package.xml and files',
           breaks='files'),
    Mutant('twice', edits=(('found = set()', 'found = []'),
            ('found.add((', 'found.append(('),
            ('found |= {(path, *one) for one in names(text)}', 'found += [(path, *one) for one in names(text)]')),
           expect='is in your list 2 times', breaks='once'),
    Mutant('unsorted',
           old='return sorted([path, kind, name] for path, kind, name in found if not is_good(kind, name))',
           new='return [[path, kind, name] for path, kind, name in sorted(found, key=lambda one: one[::-1]) if not is_good(kind, name)]',
           expect='The list is not sorted', breaks='sorted'),
    Mutant('sorted_within_a_file', edits=(('found = set()', 'result = []'),
            ("found.add((path, 'package', ElementTree.fromstring(text).findtext('name').strip()))",
             "found = {(path, 'package', ElementTree.fromstring(text).findtext('name').strip())}"),
            ('found |= {(path, *one) for one in names(text)}', 'found = {(path, *one) for one in names(text)}'),
            ('''
        elif path.endswith('.py'):
            ''', '''
        elif not path.endswith('.py'):
            continue
        else:
            '''),
            ('return sorted([path, kind, name] for path, kind, name in found if not is_good(kind, name))', '''
                result += sorted([path, kind, name] for path, kind, name in found if not is_good(kind, name))
            return result
            ''')), expect='The list is not sorted', breaks='sorted'),
    Mutant('other_methods_of_super', old="'__init__': ('node', 0, 'node_name'),",
           new="'__init__': ('node', 0, 'node_name'), 'start': ('node', 0, 'node_name'),", breaks='super',
           expect='Only super().__init__ names a node'),
    Mutant('actions_count', old="'create_client': ('service', 1, 'srv_name')}",
           new="'create_client': ('service', 1, 'srv_name'), 'ActionClient': ('service', 2, 'action_name')}",
           breaks='no-text', also='service', expect='nothing is wrong with it'),
    Mutant('five_parts_at_most', breaks='word', old="(_[a-z0-9]+)*')", new="(_[a-z0-9]+){0,4}')",
           expect='It follows the rule of words'),
    Mutant('three_words_at_most', breaks='topic', also='service', old='    return all(WORD', new='    return len(words) < 4 and all(WORD',
           expect='It has words that are joined by /'),
    Mutant('a_set', old='return sorted([path, kind, name] for path, kind, name in found if not is_good(kind, name))',
           new='return {(path, kind, name) for path, kind, name in found if not is_good(kind, name)}', breaks='sorted',
           also=('once', 'node', 'topic', 'service', 'super', 'package', 'word', 'keyword', 'no-text', 'files'),
           expect='returned a set, which has no order'),
    Mutant('any_underscores_in_topics', old='all(WORD.fullmatch(word)',
           new="all((WORD if kind in ('package', 'node') else re.compile('[a-z][a-z0-9_]*')).fullmatch(word)",
           expect='two underscores in a row', breaks='topic', also='service'),
    Mutant('identifiers_in_services', old='all(WORD.fullmatch(word)',
           new="all(word.isidentifier() and word == word.lower() if kind == 'service' else WORD.fullmatch(word)",
           expect='(create_', breaks='service'),
    Mutant('no_digits_in_topics', old='all(WORD.fullmatch(word)',
           new="all((WORD if kind in ('package', 'node') else re.compile('[a-z]+(_[a-z]+)*')).fullmatch(word)",
           expect='It has words that are joined by /', breaks='topic', also='service'),
    Mutant('digits_at_the_end', old=PATTERN, new='[a-z]+[0-9]*(_[a-z]+[0-9]*|_[0-9]+)*', expect='It follows the rule of words',
           breaks='word', also=('topic', 'service')),
    Mutant('kinds_by_another_name', old="'create_publisher': ('topic', 1, 'topic')",
           new="'create_publisher': ('publisher', 1, 'topic')", expect='Expected: the topic', breaks='topic',
           also=('keyword', 'once')),
    Mutant('not_in_async_functions', breaks='node', expect='A call counts wherever it stands', imports=VISITOR + """
    def visit_AsyncFunctionDef(self, node):
        pass

    def visit_ClassDef(self, node):
        outer, self.bases = self.bases, [last_name(base) for base in node.bases]
        self.generic_visit(node)
        self.bases = outer
"""),
    Mutant('letters_are_no_topics', breaks='topic', also='service', expect='It has words that are joined by /',
           old="return all(WORD.fullmatch(word) for word in words) and (kind != 'package' or len(name) > 1)",
           new="return all(WORD.fullmatch(word) and (kind == 'node' or len(word) > 1) for word in words)"),
    Mutant('constant_f_strings', breaks='no-text', expect='It is no text that names', imports="""
def value(node):
    if isinstance(node, ast.JoinedStr) and all(isinstance(part, ast.Constant) for part in node.values):
        return ''.join(part.value for part in node.values)
    return node.value if isinstance(node, ast.Constant) else None
"""),
    Mutant('constants_added', breaks='no-text', expect='It is no text that names', imports="""
def value(node):
    if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Add):
        left, right = value(node.left), value(node.right)
        return left + right if left and right else None
    return node.value if isinstance(node, ast.Constant) else None
"""),
    Mutant('one_of_two_texts', breaks='no-text', expect='It is no text that names', imports="""
def value(node):
    return value(node.body) if isinstance(node, ast.IfExp) else node.value if isinstance(node, ast.Constant) else None
"""),
    Mutant('keyword_of_another_function', breaks='keyword', expect='The keyword of a node is node_name',
           old='keywords.get(keyword)',
           new="next((keywords[k] for k in ('node_name', 'topic', 'srv_name') if k in keywords), None)"),
    Mutant('class_is_over_after_another_one', breaks='super', expect='a class in a class has bases of its own', imports=VISITOR + """
    def visit_ClassDef(self, node):
        self.bases = [last_name(base) for base in node.bases]
        self.generic_visit(node)
"""),
    Mutant('keeps_what_it_has_found', breaks='once',
           also=('package', 'node', 'super', 'topic', 'service', 'word', 'keyword', 'no-text', 'files', 'sorted'),
           expect='Begin each call with a new, empty list',
           edits=(('def find_bad_names(files):', 'def find_bad_names(files, found=set()):'), ('    found = set()', ''))),
    Mutant('sorted_as_paths', breaks='sorted', expect='The list is not sorted',
           old="""
           return sorted([path, kind, name] for path, kind, name in found if not is_good(kind, name))
           """, new="""
           from pathlib import PurePosixPath
           return sorted(([path, kind, name] for path, kind, name in found if not is_good(kind, name)),
                         key=lambda one: (PurePosixPath(one[0]), *one[1:]))
           """),
    Mutant('sorted_without_capitals', breaks='sorted', expect='The list is not sorted',
           old='if not is_good(kind, name))', new='if not is_good(kind, name)) and sorted(([path, kind, name] for path, kind, name in found if not is_good(kind, name)), key=lambda one: [part.lower() for part in one])'),
]
