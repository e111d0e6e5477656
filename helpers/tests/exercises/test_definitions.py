"""What is taken from other cells than an exercise's own."""

import pytest

from helpers.exercises import definitions
from helpers.exercises.notebooks import NotebookCell


def kept(source):
    return [text.strip() for _, text in definitions.of_cell(NotebookCell(source, 1))]


@pytest.mark.parametrize(
    'source',
    [
        'import os',
        'from a import b',
        'def f():\n    return 1',
        'async def f():\n    pass',
        'class A:\n    x = 1',
        '@decorated\nclass A:\n    pass',
        'X = 1',
        'X = -1.5 + 2j',
        'X, Y = 1, 2',
        'X, (Y, *Z) = A',
        'X: int = 3',
        "X = {'a': [1, (2,)]}",
        'QOS = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)',
        'T = rclpy.time.Time(seconds=3)',
        'D = Duration(seconds=0.5)',
        'Alias = some.module.Class',
        'now = lambda: 5',
        'A = B = 3',
        'X = Y[0]',
        'X = Y[:7]',
        "X = f'{A}/{B:.2f}'",
        'X = A if B > 3 and C else -A',
        "INFINITE = float('inf')",
        'TURN = math.radians(40)',
        "WORD = re.compile('[a-z]+')",
        "Place = namedtuple('Place', 'x y')",
        "State = Enum('State', 'IDLE DRIVING')",
        'RECENT = collections.deque(maxlen=3)',
        'ANGLES = [math.radians(a) for a in range(0, 360, 45) if a]',
        'X = {name: len(value) for name, value in Y.items()}',
        "X = ', '.join(sorted(Y))",
        'SEVERAL = partial(Executor, num_threads=4)',
        'STOP = Twist()',
        'ANGLES = np.linspace(0, 2 * math.pi, 8)',
        "LOG = logging.getLogger('driver')",
        "T = TypeVar('T')",
        'RANDOM = random.Random(3)',
        'NUMBERS = itertools.count(1)',
        'SLOWLY = Twist(linear=Vector3(x=0.5 * FASTEST))',
        "IDLE = std_msgs.msg.String(data='idle')",
        'LOCK = threading.Lock()',
        'ALONE = MutuallyExclusiveCallbackGroup()',
        'try:\n    import numpy\nexcept ImportError:\n    numpy = None',
        'if sys.version_info >= (3, 11):\n    import tomllib\nelse:\n    import tomli as tomllib',
    ],
)
def test_definitions_are_kept(source):
    assert kept(source) == [source]


@pytest.mark.parametrize(
    'source',
    [
        'TABLE = []\nTABLE.append(1)',
        'TABLE = {}\nfor n, name in enumerate(NAMES):\n    TABLE[name] = n',
        'TABLE = {}\nfor n in range(3):\n    half = n / 2\n    if half > 1:\n        TABLE[half] = n',
        'PERIOD = 0.2\nPERIOD += 0.05',
        "SEEN = set()\nSEEN.update('abc')",
        'QOS = QoSProfile(depth=1)\nQOS.depth = 10',
        'class Settings: pass\nSettings.period = 0.25',
        'BOTH = [[], []]\nBOTH[0].extend([1, 2])\nBOTH[1] += [3]',
        '@dataclass\nclass Config:\n    period: float = 0.25\nCONFIG = Config(period=0.5)\nCONFIG.period /= 2',
        '@dataclasses.dataclass(frozen=True)\nclass Config:\n    period: float\nONE, TWO = FEW = Config(1.0)',
        'class Place(NamedTuple):\n    x: float\nHOME = Place(1.0)',
        "Place = namedtuple('Place', 'x y')\nHOME = Place(1, y=-2)",
    ],
)
def test_what_builds_a_constant_is_kept_with_it(source):
    assert '\n'.join(kept(source)) == source
    for _, text in definitions.of_cell(NotebookCell(source, 1)):
        assert definitions.names_made(text) & definitions.names_in(source)


@pytest.mark.parametrize(
    'source',
    [
        'x = [1]\nx.sort(key=f())',
        'x = []\nx.append(f())',
        'x = 1\nx += f()',
        'x = {}\nfor n in f():\n    x[n] = 1',
        'x = {}\nfor n in range(3):\n    x[n] = 1\n    print(n)',
        'x = {}\nfor n in range(3):\n    x[n] = 1\nelse:\n    f()',
    ],
)
def test_what_does_more_is_not(source):
    assert len(kept(source)) == 1
    assert definitions.changed_later(NotebookCell(source, 1)) == {'x'}


@pytest.mark.parametrize(
    'source',
    [
        'x = []\ny.append(1)',
        'x = []\nprint(x)',
        "import os\nos.environ['A'] = 'b'",
        "import os\nif True:\n    os.environ['A'] = 'b'",
        'def f(): pass\nf().x = 1',
        'command = Twist()\nx = 1',
        'TALKER = Node("x")\nx = 1',
        'STOP = Twist(linear=f())\nx = 1',
        'lock = threading.Lock()\nx = 1',
        'class Talker(Node): pass\ntalker = Talker()',
        '@dataclass\nclass Place: pass\nhome = Place(f())',
    ],
)
def test_what_changes_no_constant_is_not_either(source):
    assert len(kept(source)) == 1
    assert not definitions.changed_later(NotebookCell(source, 1))


@pytest.mark.parametrize(
    'source',
    [
        'print(1)',
        'rclpy.init()',
        "node = Node('x')",
        'x = f()',
        'x += 1',
        'for i in range(3):\n    y = i',
        'with spinning(node):\n    pass',
        'node.x = 1',
        'node.x, node.y = 1, 2',
        'x, (y, *node.z) = 1, (2, 3)',
        'd["a"] = 1',
        'del x',
        'assert x',
        'x = [f() for _ in y]',
        'if True:\n    f()',
        'try:\n    f()\nexcept ImportError:\n    pass',
        'x = [f(y) for y in z]',
        'x = [y for y in f()]',
        'x = [y async for y in z]',
        'x = f().split()',
        "x = join(a, 'b')",
        "x = f'{f()}'",
        'x = 1 if f() else 2',
        'x = 1 < f()',
        'while True: pass',
        'QOS = QoSProfile(depth=f())',
        'x = await y',
        'await y',
        '%%bash\nls',
        '!rm -rf x',
        'def broken(:',
        '"just text"',
        'x = (y := 3)',
        'raise SystemExit',
    ],
)
def test_demonstrations_are_dropped(source):
    assert kept(source) == []


def test_notebook_commands_are_dropped_line_by_line():
    commands = '%matplotlib inline\nimport os\n!ls\nx = !ls\nfiles = %sx ls\nos?\n?os\nY = 2'
    assert kept(commands) == ['import os', 'Y = 2']
    assert kept('text = """\n%not a command\n"""') == ['text = """\n%not a command\n"""']
    assert kept('x = 7 \\\n % 2') == ['x = 7 \\\n % 2']


@pytest.mark.parametrize('head', ['%%time\n', '%%capture out\n', '\n%%capture\n%%time\n'])
def test_a_cell_that_runs_below_a_magic_counts(head):
    """As it does in the notebook. What a shell gets does not."""
    found = definitions.of_cell(NotebookCell(f'{head}import os\ndef f():\n    return 3\n', 1))
    assert [text.partition('\n')[0] for _, text in found] == ['import os', 'def f():']
    assert found[0][0] == head.count('\n') + 1
    assert definitions.of_cell(NotebookCell('%%bash\nimport os\n', 1)) == ()


def test_commands_within_functions_do_not_cost_them():
    source = 'def f():\n    !ls -la \\\n        /tmp\n    %timeit 1\n    return 3\n\ndef g():\n    !ls\n'
    found = definitions.of_cell(NotebookCell(source, 1))
    assert [line for line, _ in found] == [1, 7]
    namespace = {}
    exec(found[0][1], namespace)
    assert namespace['f']() == 3


@pytest.mark.parametrize(
    ('line', 'names'),
    [(1, {'a', 'b', 'c', 'd', 'f'}), (2, {'b', 'c', 'd', 'f'}), (4, {'f'}), (5, {'f'}), (7, set()), (9, set())],
)
def test_the_names_that_are_not_reached_after_an_error(line, names):
    """A block may have made a part of its names; what is imported is the same in each cell."""
    text = 'a = 1\nb, c = 1, \\\n    2\nif a:\n    d = 3\nimport os\ndef f(): pass\n'
    assert definitions.names_not_reached(text, line) == names


def test_line_numbers_are_kept():
    cell = NotebookCell('print(1)\n\ndef f():\n    pass\nprint(2)', 1)
    assert definitions.of_cell(cell) == ((3, 'def f():\n    pass\n'),)
    cell = NotebookCell('import a; print(1); import b', 1)
    assert definitions.of_cell(cell) == ((1, 'import a\n'), (1, 'import b\n'))


def test_the_names_that_a_text_needs():
    text = 'import os\ndef f(a, *b, c=d):\n    e = g(a, b, c)\n    return [h for h in e if h in os.name]\nf(i)'
    assert definitions.names_used(text) == {'d', 'g', 'i'}
    assert definitions.names_used('def f(:') == set()


@pytest.mark.parametrize('source', ['for X in Y: pass', 'with f() as X: pass', 'for _ in Y:\n    X = 1', 'X += 1'])
def test_names_in_blocks_are_bound(source):
    assert 'X' in definitions.names_in(source)
