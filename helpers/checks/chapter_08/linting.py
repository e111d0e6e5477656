"""What the tests of exercise 8.1 share: packages as dictionaries, and the comparison of findings."""

from weakref import WeakKeyDictionary

from helpers.runner import about, expect
from helpers.runner.values import SetAsList

_BEFORE: WeakKeyDictionary = WeakKeyDictionary()  # learner → the texts of the calls before


def package_xml(name: str) -> str:
    """The text of a package.xml for a package with this name."""
    return (
        f'<?xml version="1.0"?>\n<package format="3">\n  <name>{name}</name>\n  <version>0.1.0</version>\n'
        '  <description>A robot</description>\n  <maintainer email="a@example.com">A</maintainer>\n'
        '  <license>Apache-2.0</license>\n</package>\n'
    )


def word(draw) -> str:
    """A word of letters only."""
    return draw.choice(['front', 'rear', 'left', 'upper', 'arm', 'wheel', 'dock']) + draw.choice('abcdefg')


def spoilt(draw) -> dict[str, str]:
    """Words that break the rule → what is wrong with them."""
    one, two = word(draw), word(draw)
    return {
        f'{one}{two.capitalize()}': 'has a capital letter in it',
        one.upper(): 'has capital letters',
        f'{one}-{two}': 'has a hyphen',
        f'{one}__{two}': 'has two underscores in a row',
        f'_{one}': 'begins with an underscore',
        f'{one}_': 'ends with an underscore',
        f'{draw.randint(2, 9)}{one}': 'begins with a digit',
        f'{one} {two}': 'has a space in it',
        f'{one}.{two}': 'has a point in it',
        f'{one}ü{two}': 'has a letter that is not from a to z',
        f'{one}٣': 'has a digit that is not from 0 to 9',
        f'{one}/{two}': 'has a slash, so it is two words',
        f'~{one}': 'has a tilde',
        f'~/{one}': 'begins with ~/, which only topics and services may',
        '': 'is empty',
        f'{one}\n': 'ends with a line break',
    }


def _with_digits(draw) -> list[str]:
    """Good words with digits in the middle, after an underscore, and more than once."""
    one, two = word(draw), word(draw)
    digits = [draw.randint(0, 9) for _ in range(6)]
    return [
        f'{one}{digits[0]}d',
        f'x{digits[1]}y{digits[2]}',
        f'{one}_{digits[3]}d_{two}',
        f'{one}_{digits[4]}_{digits[5]}',
    ]


def bad_names(learner, files: dict[str, str], rule: str = '') -> list[tuple]:
    """What the learner's function reports for these files, as (path, kind, name); `rule`: what an error breaks."""
    with about(rule):
        found = learner.call('find_bad_names', files)
        expect(
            isinstance(found, list) and all(isinstance(one, (list, tuple)) and len(one) == 3 for one in found),
            f'find_bad_names returned {found!r:.200}, expected a list of [path, kind, name].',
            rule,
        )
    expect(
        not isinstance(found, SetAsList),
        'find_bad_names returned a set, which has no order: expected a sorted list.',
        'sorted',
    )
    texts, before = '\n'.join(files.values()), _BEFORE.get(learner, '')
    old = [one[2] for one in found if not _stands_in(texts, one[2]) and _stands_in(before, one[2])]
    expect(
        not old,
        f'Reported: {old and old[0]!r}, which stands in no file of this call, but did in one of an earlier call. Begin '
        'each call with a new, empty list.',
        rule,
    )
    _BEFORE[learner] = f'{before}\n{texts}'
    return [tuple(one) for one in found]


def _stands_in(text: str, name) -> bool:
    return isinstance(name, str) and (name in text or repr(name)[1:-1] in text)


def compare(found: list[tuple], expected: list[tuple], rule: str, why: str = '', why_not: str = '') -> None:
    """Fail with the first finding that is missing or too many; `why` and `why_not` say what the rule makes of it."""

    def shown(finding):
        path, kind, name = finding
        return f'the {kind} {name!r} in {path}'

    missing = [one for one in expected if one not in found]
    if missing:
        others = [one for one in found if one[2] == missing[0][2] and one not in expected]
        expect(not others, f'Reported: {others and shown(others[0])}. Expected: {shown(missing[0])}.', rule)
    expect(not missing, f'Not reported: {missing and shown(missing[0])}. {why}'.strip(), rule)
    extra = [one for one in found if one not in expected]
    expect(
        not extra, f'Reported, though nothing is wrong with it: {extra and shown(extra[0])}. {why_not}'.strip(), rule
    )


def judge(learner, text: str, expected: list[tuple[str, str]], rule: str, why: str = '', why_not: str = '') -> None:
    """Judge one Python file; expected are (kind, name) of its bad names."""
    path = f'{word(learner.random)}.py'
    compare(bad_names(learner, {path: text}, rule), [(path, *one) for one in expected], rule, why, why_not)


def judge_words(learner) -> None:
    """The rule `word`: bad and good words, as names of nodes."""
    draw = learner.random
    wrong = spoilt(draw)
    good = [
        word(draw),
        f'{word(draw)}_{word(draw)}',
        f'{word(draw)}{draw.randint(2, 99)}',
        'a_b_c',
        'x',
        f'{word(draw)}_{draw.randint(2, 9)}',
        '_'.join(word(draw) for _ in range(draw.randint(6, 9))),
        *_with_digits(draw),
    ]
    found = bad_names(learner, {'n.py': ''.join(f'create_node({name!r})\n' for name in [*wrong, *good])}, 'node')
    expect(found, f'create_node({next(iter(wrong))!r}) names a node, and nothing is reported.', 'node')
    for name, why in wrong.items():
        compare([one for one in found if one[2] == name], [('n.py', 'node', name)], 'word', f'It {why}.')
    compare(found, [('n.py', 'node', name) for name in wrong], 'word', why_not='It follows the rule of words.')


def judge_topics(learner, kind: str, functions: tuple[str, str]) -> None:
    """The rule `topic` or `service`: which names are good for it, in both functions."""
    draw = learner.random
    one, two = word(draw), word(draw)
    wrong = {
        f'/{one}': 'It is absolute.',
        f'/{one}/{two}': 'It is absolute.',
        f'{one}//{two}': 'A word is empty.',
        f'{one}/{two}/': 'It ends with a slash.',
        f'~{one}': 'A private name begins with ~/.',
        f'{one}/{two.capitalize()}': 'Its last word begins with a capital letter.',
        f'{one.capitalize()}/{two}': 'Its first word begins with a capital letter.',
        f'~/{one.capitalize()}': 'Its word begins with a capital letter.',
        f'{one}/~/{two}': 'Only at its beginning can ~/ stand.',
        '~': 'There is no word in it.',
        '~/': 'There is no word in it.',
    }
    for bad, why in spoilt(draw).items():
        if not {'/', '~'} & set(bad) and bad:  # these stand above
            wrong |= {f'{bad}/{one}': f'Its first word {why}.', f'{one}/{bad}': f'Its last word {why}.'}
    good = [
        'turtle1/cmd_vel',
        f'front_{draw.randint(2, 9)}/scan',
        *(f'~/{one}/{name}' for name in _with_digits(draw)),
        one,
        'x',
        f'{one}/z',
        f'{one}/{two}',
        f'~/{one}',
        f'~/{one}/{two}',
        f'{one}/{two}/{one}',
        '/'.join(draw.randint(4, 7) * [one]),
    ]
    for function in functions:
        found = bad_names(
            learner, {'t.py': ''.join(f'node.{function}(Type, {n!r}, 10)\n' for n in [*wrong, *good])}, kind
        )
        for name, why in wrong.items():
            compare([one for one in found if one[2] == name], [('t.py', kind, name)], kind, f'({function}) {why}')
        compare(
            found,
            [('t.py', kind, name) for name in wrong],
            kind,
            why_not=f'({function}) It has words that are joined by /, and may begin with ~/.',
        )


def judge_places(learner) -> None:
    """The rule `node`: a call is found wherever in the file it stands."""
    bad = word(learner.random).capitalize()
    judge(
        learner,
        f"""
async def come():
    create_node('{bad}A')
make = lambda: create_node('{bad}B')
def outer():
    def inner():
        return Node('{bad}C')
    return inner
node.create_service(Empty, 'go', lambda request, response: create_node('{bad}D'))
nodes = [create_node('{bad}E') for number in range(2)]
if __name__ == '__main__':
    try:
        with open('log') as log:
            Node('{bad}F')
    finally:
        executor.add_node(create_node('{bad}G', parameters=[Node('{bad}H')]))
""",
        [('node', f'{bad}{letter}') for letter in 'ABCDEFGH'],
        'node',
        'A call counts wherever it stands: in an async function, a lambda, a function in a function, or as an argument '
        'of another call.',
    )


def judge_super(learner) -> None:
    """The rule `super`: in which classes super().__init__ names a node."""
    bad = word(learner.random).capitalize()
    classes = (
        'class A(Node)',
        'class B(rclpy.lifecycle.LifecycleNode)',
        'class C(Mixin, Node)',
        'class D(Node, Mixin)',
        'class E(rclpy.node.Node)',
    )
    inside = '\n    def __init__(self):\n        super().__init__({!r}, namespace="x")\n'
    text = ''.join(f'{head}:{inside.format(bad + head[6])}' for head in classes)
    judge(
        learner,
        text,
        [('node', bad + head[6]) for head in classes],
        'super',
        'It is in super().__init__ of a class that has Node or LifecycleNode among its bases.',
    )
    other = ('class F(Exception)', 'class G(threading.Thread)', 'class H', 'class I(TreeNode)')
    judge(
        learner,
        ''.join(f'{head}:{inside.format(bad + head[6])}' for head in other),
        [],
        'super',
        why_not='The bases of its class are neither Node nor LifecycleNode.',
    )
    judge(
        learner,
        f"""
class Outer(Node):
    def start(self):
        super().start('{bad}J')

    class Inner:
        def __init__(self):
            super().__init__('{bad}K')

    class Helper(Node):
        def __init__(self):
            super().__init__('{bad}L')

    class Lost(Exception):
        pass

    def __init__(self):
        class Timer(threading.Thread):
            def __init__(self):
                super().__init__('{bad}M')

        super().__init__('{bad}N')
""",
        [('node', f'{bad}L'), ('node', f'{bad}N')],
        'super',
        'It is in super().__init__ of a class with the base Node; a class in a class has bases of its own.',
        'Only super().__init__ names a node, and a class in a class has bases of its own.',
    )


def judge_no_text(learner) -> None:
    """The rule `no-text`: what is no name."""
    bad = word(learner.random).capitalize()
    judge(
        learner,
        f'''
"""create_node('{bad}')"""
# self.create_publisher(String, '{bad}', 10)
text = "node.create_service(Empty, '{bad}', None)"
node.create_publisher(String, topic, 10)
node.create_publisher(String, f'{bad}/{{number}}', 10)
node.get_logger().info('{bad}')
node.create_timer(0.5, '{bad}')
node.declare_parameter('{bad}', 1)
node.create_subscription('{bad}', topic, print, 10)
node.create_publisher(String)
create_node(name)
create_node(7)
create_node('{bad}' + suffix)
create_node('{bad}' + '_{bad}')
create_node('{bad}' if simulated else name)
create_node('{bad}'.lower())
create_node('{bad}%d' % number)
create_node(b'{bad}')
create_node(names['{bad}'])
create_node(*['{bad}'])
create_node(f'{bad}')
create_node(f'{{number:{{width}}}}{bad}')
create_node(f'{{"{bad}"}}')
NAME = '{bad}'
node.create_publisher(String, NAME, 10)
ActionClient(node, Fibonacci, '{bad}')
ActionServer(node, Fibonacci, '{bad}', execute)
message_filters.Subscriber(node, Image, '{bad}')
node.count_publishers('{bad}')
node.resolve_topic_name('{bad}')
Parameter('{bad}', Parameter.Type.STRING, '{bad}')
node.declare_parameter('topic', '{bad}')
Node()
LifecycleNode('{bad}')
launched = Node(package='x', executable='{bad}', name='{bad}')
''',
        [],
        'no-text',
        why_not='It is no text that names a node, a topic or a service.',
    )


def judge_keywords(learner) -> None:
    """The rule `keyword`."""
    bad = word(learner.random).capitalize()
    judge(
        learner,
        f'''
create_node(node_name='{bad}A')
Node(namespace='x', node_name='{bad}F')
class Talker(Node):
    def __init__(self):
        super().__init__(node_name='{bad}G')
node.create_publisher(msg_type=String, topic='{bad}B', qos_profile=10)
node.create_subscription(String, callback=print, qos_profile=10,
                         topic="{bad}C")
node.create_client(Empty, srv_name='{bad}D')
node.create_service(srv_name='{bad}E', srv_type=Empty, callback=print)
create_node(topic='{bad}H', srv_name='{bad}I')
node.create_subscription(String, node_name='{bad}J', srv_name='{bad}K')
node.create_client(Empty, node_name='{bad}L', topic='{bad}M')
''',
        [
            ('node', f'{bad}A'),
            ('node', f'{bad}F'),
            ('node', f'{bad}G'),
            ('topic', f'{bad}B'),
            ('topic', f'{bad}C'),
            ('service', f'{bad}D'),
            ('service', f'{bad}E'),
        ],
        'keyword',
        'It is given as a keyword.',
        'The keyword of a node is node_name, that of a topic topic, that of a service srv_name.',
    )


def judge_packages(learner) -> None:
    """The rules `package` and `files`."""
    draw = learner.random
    bad, good = word(draw).capitalize(), f'{word(draw)}_{word(draw)}'
    wrong = {bad: 'begins with a capital letter', draw.choice('abcxyz'): 'has one character'}
    wrong |= {name: why for name, why in spoilt(draw).items() if name == name.strip() != ''}
    for path in ('package.xml', f'src/{good}/package.xml'):
        for name, why in wrong.items():
            compare(
                bad_names(learner, {path: package_xml(name)}, 'package'),
                [(path, 'package', name)],
                'package',
                f'It {why}.',
            )
        for name in (good, draw.choice(['ur', 'go', 'my'])):
            compare(
                bad_names(learner, {path: package_xml(name)}, 'package'),
                [],
                'package',
                why_not='It is one word of at least two characters.',
            )
    compare(
        bad_names(
            learner, {'package.xml': package_xml(good).replace('<name>', f'<!-- <name>{bad}</name> -->\n  <name>')}
        ),
        [],
        'package',
        why_not='It stands in a comment, and not in the element <name>.',
    )
    others = {
        'world.xml': f'<world><name>{bad}</name></world>',
        'README.md': f"create_node('{bad}')",
        'setup.cfg': '[develop]',
        'my_package.xml': package_xml(bad),
        'package.xml.bak': package_xml(bad),
        'launch/happy': f'Node("{bad}")',
        'notes.pyc': f'Node("{bad}")',
        f'{good}.txt': '',
    }
    compare(bad_names(learner, others, 'files'), [], 'files', why_not='Only package.xml and files ….py are read.')
    for path in (f'test/test_{good}.py', f'{good}/__init__.py', 'setup.py', f'launch/{good}.launch.py'):
        compare(
            bad_names(learner, {path: f"create_node('{bad}')"}, 'files'),
            [(path, 'node', bad)],
            'files',
            'Every file ….py is read, whatever its name and its folder are.',
        )


def judge_list(learner) -> None:
    """The rules `once` and `sorted`."""
    draw = learner.random
    letters = draw.sample('ABCDEFGHIJKL', draw.randint(9, 12))
    names = [f'{word(draw).capitalize()}{letter}' for letter in letters]
    names += [f'aa-{draw.randint(2, 9)}', f'{names[0]} a']  # capitals come first, and a name before a longer one
    text = ''.join(f'n.create_publisher(S, "{name}", 1)\ncreate_node("{name}")\n' for name in names * 2)
    good = {f'{word(draw)}{number}.py': f'create_node("{word(draw)}")' for number in range(draw.randint(20, 40))}
    files = {'z/b.py': text, 'a/b.py': text, **good, 'package.xml': package_xml(names[0]), 'a.py': text}
    expected = sorted(
        [
            ('package.xml', 'package', names[0]),
            *(
                (path, kind, name)
                for path in ('z/b.py', 'a/b.py', 'a.py')
                for kind in ('node', 'topic')
                for name in names
            ),
        ]
    )
    found = bad_names(learner, files, 'sorted')
    compare(found, expected, 'once')
    twice = [one for one in found if found.count(one) > 1]
    expect(
        not twice,
        f'{twice and list(twice[0])} is in your list {twice and found.count(twice[0])} times. Each '
        'finding is in it once, however often the name stands in the file.',
        'once',
    )
    expect(
        found == expected,
        f'The list is not sorted: it begins with {list(map(list, found[:3]))}, expected '
        f'{list(map(list, expected[:3]))}.',
        'sorted',
    )
