"""Hidden tests of exercise 8.1, a linter for names."""

import pytest

from helpers import paths
from helpers.checks.chapter_08.linting import bad_names, compare, package_xml

pytestmark = pytest.mark.exercise('8.1')


def word(draw) -> str:
    return draw.choice(['front', 'rear', 'left', 'upper', 'arm', 'wheel', 'dock']) + draw.choice(['', '2', '10', '_a1'])


def spoilt(draw) -> dict[str, str]:
    """Words that break the rule → what is wrong with them."""
    one, two = word(draw), word(draw)
    return {f'{one}{two.capitalize()}': 'a capital letter in it', one.upper(): 'capital letters',
            f'{one}-{two}': 'a hyphen', f'{one}__{two}': 'two underscores in a row',
            f'_{one}': 'an underscore in front',
            f'{one}_': 'an underscore at the end', f'{draw.randint(2, 9)}{one}': 'a digit in front',
            f'{one} {two}': 'a space', f'{one}.{two}': 'a point', f'{one}ü{two}': 'a letter that is not from a to z',
            '': 'nothing at all', f'{one}\n': 'a line break at its end'}


@pytest.mark.weight(2)
def test_words(learner):
    """A word has letters a to z, digits and single underscores, begins with a letter and ends with no underscore.

    Write the rule as one regular expression, and use fullmatch.
    """
    draw = learner.random
    wrong = spoilt(draw)
    good = [word(draw), f'{word(draw)}_{word(draw)}', 'x', 'a_b_c', 'lidar2d']
    text = ''.join(f'create_node({name!r})\n' for name in [*wrong, *good])
    found = bad_names(learner, {'n.py': text})
    for name, why in wrong.items():
        compare([one for one in found if one[2] == name], [('n.py', 'node', name)], f'It has {why}.')
    compare(found, [('n.py', 'node', name) for name in wrong], 'It follows the rule.')


def test_topics(learner):
    """Each word of a topic is judged; the name is relative, or private with ~/.

    Take ~/ away from the front, and split the rest at each slash. An empty word is no word.
    """
    draw = learner.random
    one, two = word(draw), word(draw)
    wrong = {f'/{one}': 'It is absolute.', f'/{one}/{two}': 'It is absolute.', f'{one}//{two}': 'A word is empty.',
             f'{one}/{two}/': 'It ends with a slash.',
             f'{one}/{two.capitalize()}': 'Its last word has a capital letter.',
             f'{one.capitalize()}/{two}': 'Its first word has a capital letter.',
             f'~/{one.capitalize()}': 'Its word has a capital letter.', f'{one}/2{two}': 'A word begins with a digit.'}
    good = [one, f'{one}/{two}', f'~/{one}', f'~/{one}/{two}', f'{one}/{two}/image_raw']
    for function in ('create_publisher', 'create_subscription'):
        found = bad_names(learner, {'t.py': ''.join(f'node.{function}(String, {n!r}, 10)\n' for n in [*wrong, *good])})
        for name, why in wrong.items():
            compare([one for one in found if one[2] == name], [('t.py', 'topic', name)], why)
        compare(found, [('t.py', 'topic', name) for name in wrong], 'It follows the rule.')


def test_services(learner):
    """Services are judged as topics are, of servers and of clients, and are reported as services.

    create_service and create_client: the second argument, or the keyword srv_name.
    """
    bad = word(learner.random).capitalize()
    text = (f'node.create_service(Empty, "{bad}/on", on)\nnode.create_client(Empty, "/{bad.lower()}")\n'
            f'node.create_client(Empty, srv_name="{bad}")\nnode.create_service(Empty, "~/reset", on)\n')
    compare(bad_names(learner, {'s.py': text}), [('s.py', 'service', name) for name in
                                                 (f'{bad}/on', f'/{bad.lower()}', bad)])


@pytest.mark.weight(2)
def test_where_names_are(learner):
    """Only names are judged: no comment, no other text, no variable; and keywords are arguments, too.

    Use calls(text): it knows what is a call. A text in the file is no name.
    """
    bad = word(learner.random).capitalize()
    harmless = f'''
"""create_node('{bad}')"""
# self.create_publisher(String, '{bad}', 10)
text = "node.create_service(Empty, '{bad}', None)"
node.create_publisher(String, topic, 10)
node.create_publisher(String, f'{bad}/{{number}}', 10)
node.get_logger().info('{bad}')
node.create_timer(0.5, '{bad}')
node.declare_parameter('{bad}', 1)
node.create_publisher(String)
'''
    compare(bad_names(learner, {'a.py': harmless}), [], 'It is no name of a node, a topic or a service.')
    keywords = f'''
create_node(node_name='{bad}1')
node.create_publisher(msg_type=String, topic='{bad}2', qos_profile=10)
node.create_subscription(String, callback=print, qos_profile=10,
                         topic="{bad}3")
node.create_subscription(
    String,
    '{bad}4',
    print, 10)
'''
    expected = [('b.py', 'node', f'{bad}1'), *(('b.py', 'topic', f'{bad}{n}') for n in (2, 3, 4))]
    compare(bad_names(learner, {'b.py': keywords}), expected, 'It is given as a keyword, or on another line.')


def test_nodes(learner):
    """super().__init__ names a node only in a class with the base Node or LifecycleNode; Node(…) names one, too.

    `bases` holds the names of the base classes. An exception has a super().__init__ as well.
    """
    bad = word(learner.random).capitalize()
    text = f'''
class A(Node):
    def __init__(self):
        super().__init__('{bad}A')
class B(rclpy.lifecycle.LifecycleNode):
    def __init__(self):
        super().__init__('{bad}B', namespace='x')
class C(Mixin, Node):
    def __init__(self):
        super().__init__(node_name='{bad}C')
class MyError(Exception):
    def __init__(self):
        super().__init__('{bad} has failed')
class Thread(threading.Thread):
    def __init__(self):
        super().__init__('{bad}')
node = Node('{bad}D')
other = rclpy.node.Node('{bad}E')
launched = Node(package='x', executable='{bad}', name='y')
'''
    compare(bad_names(learner, {'n.py': text}), [('n.py', 'node', f'{bad}{letter}') for letter in 'ABCDE'],
            'Look at the bases of the class in which super().__init__ is called.')


def test_packages(learner):
    """The name of the package is read from package.xml, wherever that is; it has at least two characters.

    Judge the element <name>, and no other file.
    """
    draw = learner.random
    for name, why in {**spoilt(draw), draw.choice('abcxyz'): 'only one character'}.items():
        if name.strip() == name and name:
            compare(bad_names(learner, {'src/p/package.xml': package_xml(name)}),
                    [('src/p/package.xml', 'package', name)], f'It has {why}.')
    good = {'package.xml': package_xml(f'{word(draw)}_msgs'), 'world.xml': '<world><name>MyWorld</name></world>',
            'README.md': "create_node('BadName')", 'setup.cfg': '[develop]', 'my_package.xml.bak': '<name>Old</name>'}
    compare(bad_names(learner, good), [], 'Only package.xml and Python files are read.')


def test_order(learner):
    """The list is sorted, and each finding is in it once.

    A set forgets what comes twice; sorted() makes a list of it.
    """
    draw = learner.random
    names = [word(draw).capitalize() + letter for letter in 'ABC']
    draw.shuffle(names)
    text = ''.join(f'create_node("{name}")\nn.create_publisher(S, "{name}", 1)\n' for name in names * 2)
    found = learner.call('find_bad_names', {'z/b.py': text, 'a.py': text})
    expected = sorted([path, kind, name] for path in ('z/b.py', 'a.py') for kind in ('node', 'topic') for name in names)
    compare([tuple(one) for one in found], [tuple(one) for one in expected])
    assert [list(one) for one in found] == expected


def test_real_package(learner):
    """In a real package, the turtle simulation, exactly the names that were made wrong are found.

    Try your function with the packages of the course, as the notebook does.
    """
    folder = paths.ROOT / 'environment' / 'ros2_ws' / 'src' / 'turtlesim'
    files = {path.relative_to(folder).as_posix(): path.read_text() for path in [*folder.rglob('*.py'),
                                                                                folder / 'package.xml']}
    bad = word(learner.random).capitalize()
    planted = {"'turtle1/cmd_vel'": ('topic', f'{bad}/cmd_vel'), "'reset'": ('service', f'/{bad.lower()}/reset')}
    expected = []
    for path, text in files.items():
        for old, (kind, new) in planted.items():
            if f', {old},' in text or f', {old})' in text:
                text = text.replace(f', {old}', f', {new!r}')
                expected.append((path, kind, new))
        files[path] = text
    assert len(expected) >= 3
    compare(bad_names(learner, files), expected)
