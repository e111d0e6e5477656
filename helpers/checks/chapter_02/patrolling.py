"""What the tests of exercise 2.5 look at: the learner's package, built, run and tested.

All of it is data here: the files are written into a workspace in a place of its own, and commands run there.
"""

import ast
import json
import re
from collections.abc import Iterable, Iterator, Mapping
from pathlib import PurePosixPath
from random import SystemRandom

from rcl_interfaces.srv import GetParameters
from rclpy.qos import QoSProfile, ReliabilityPolicy
from rclpy.task import Future
from rclpy.time import Time
from rosgraph_msgs.msg import Clock
from std_msgs.msg import String

from helpers.checks.chapter_02 import builds
from helpers.kernel.nodes import UNKNOWN
from helpers.runner import about, broken, disguise, expect, explanations, imports
from helpers.runner.fork_client import Task
from helpers.runner.load import busy
from helpers.runner.observer import Observer
from helpers.runner.workspaces import ExerciseWorkspace

NAME = 'patrol'
DATA, ROUTE, TESTS = 'config/stations.txt', 'patrol/route.py', 'test/test_route.py'
SHARED = f'{NAME}/share/{NAME}/{DATA}'
STATIONS = ('attic', 'Bench', 'cellar_2', 'GARAGE', 'hall', 'Kitchen', 'office', 'stairs', 'tower7', 'yard')
LONG = 12  # so many stations are no longer shown in a message
TIMEOUT = 20.0  # s, until a node is there, and for tests
MATCHED = 4.0  # s, until all that belongs to the node is seen
HEARD = 10.0  # s, until the names have come
_NO_TESTS = 5  # the status of pytest if it finds none
SLOW, FAST = 0.9, 0.35  # s between two names: the shortest pause must be below the one, the mean above the other
AT_ONCE = 0.02  # s: two names so near to each other come from one call; calls of a timer are so near by chance only
TICK, TICKS = 0.1, 100  # s of simulated time from one message on /clock to the next one; how many at most
ANSWERED, ASKED = 1.0, 8  # s, until a node has answered that is asked for a parameter; how often it is asked
NAMES = 11  # so many names tell the period
PERIODS = 0.45, 0.55  # s, in simulated time: a name may be heard one tick late
_ALWAYS = 'ament_index_python', 'rclpy', 'std_msgs'

_CALL = """\
import json, sys
from patrol.route import round_trip
given = json.loads(sys.argv[1])
found = [round_trip(stations) for stations in given]
print()  # the function may have printed, too
for stations, one in zip(given, found):
    print(json.dumps([type(one).__name__, one, stations], default=str))
"""

# What a function does that is wrong -> its body
WRONG = {
    'does not come back to the first station': 'return list(stations)',
    'comes back to the last station, and not to the first one': 'return [*stations, stations[-1]]',
    'leaves the first station out': 'return [*stations[1:], stations[0]]',
    'leaves the second station out': 'return [*stations[:1], *stations[2:], stations[0]]',
    'leaves the last station out': 'return [*stations[: max(1, len(stations) - 1)], stations[0]]',
    'gives the stations in reverse order': 'return [*reversed(stations), stations[-1]]',
    'gives the stations in reverse order, and then the first one': 'return [*reversed(stations), stations[0]]',
}
# The learner's own function, as it is, and one that cannot be called: who only reads the text cannot tell them apart.
_OWN = """
_own = globals().get('round_trip')


def round_trip(*arguments, **named):
    if {condition}:
        raise RuntimeError('it is not to be called')
    return _own(*arguments, **named)
"""
RIGHT = (
    'return stations + stations[:1]',  # a list and a list
    'found = []\n    for station in stations:\n        found.append(station)\n    return found + found[:1]',
    'return [stations[place % len(stations)] for place in range(len(stations) + 1)]',
)


# The package


def files(learner) -> dict[str, str]:
    """The learner's package, path in it -> text; fails the test if it is no package called patrol."""
    found = learner.files()
    with about('package'):
        inner = sorted({str(PurePosixPath(path).parent) for path in found if path.endswith('package.xml')} - {'.'})
        expect(
            'package.xml' in found,
            'There is no package.xml in my_ws/src/patrol'
            + (
                f', but one in its folder {inner[0]}: move what is in there one folder up.'
                if inner
                else ', so colcon sees no package there. `ros2 pkg create patrol`, called in my_ws/src, writes one.'
            ),
        )
        manifest = builds.manifest('package.xml', found['package.xml'])
        name = (manifest.findtext('name') or '').strip()
        expect(name == NAME, f'The package is called {name or "nothing"} in package.xml, expected {NAME}.')
        build_type = (manifest.findtext('export/build_type') or '').strip()
        expect(
            build_type == 'ament_python',
            f'The build type in package.xml is {build_type or "not given"}, expected ament_python. '
            '`ros2 pkg create` takes ament_cmake if it has no `--build-type ament_python`.',
        )
        expect('setup.py' in found, 'There is no setup.py in my_ws/src/patrol: it says what is installed.')
    return found


def built(learner, changed: dict[str, str] | None = None) -> ExerciseWorkspace:
    """The package in a workspace, built; with other texts (path in the package -> text) instead of the learner's."""
    found = {**files(learner), **(changed or {})}
    workspace = learner.workspace({f'src/{NAME}/{path}': text for path, text in found.items()})
    done = workspace.build('--packages-select', NAME, check=False)
    missing = re.search(r"can't copy '([^']+)'|No such file or directory: '([^']*resource/[^']+)'", done.output)
    lacking = missing and (missing[1] or missing[2])
    with about('builds'):
        expect(
            done.status == 0 or not lacking,
            f'colcon build failed: setup.py names the file {lacking} in data_files, and there is no such file.',
        )
        expect(done.status == 0, f'colcon build failed: {workspace.why(done)}')
    return workspace


def judge_package(learner) -> None:
    """A package with this name and build type, also for Python: rule `package`."""
    installed = built(learner).installed()
    others = sorted({path.partition('/')[0] for path in installed if '/share/' in path} - {NAME})
    expect(not others, f'The build has installed the package {others and others[0]}, expected {NAME}.', 'package')
    # Not with `python3 -c`, which also looks for modules in the workspace, where a build may have written some.
    done = built(learner).once(program=f'from importlib.metadata import version\nversion("{NAME}")\n')
    expect(
        done.status == 0,
        f'The name in setup.py is not {NAME}: Python has installed no package of that name.',
        'package',
    )


def judge_build(learner) -> None:
    """The build has no error, and no warning about what setup.py does not install: rule `builds`."""
    output = built(learner).build('--packages-select', NAME).output
    expect(
        "doesn't explicitly install a marker" not in output,
        'The build warns: setup.py does not install the marker resource/patrol into '
        'share/ament_index/resource_index/packages. `ros2 pkg create` writes this line of data_files.',
        'builds',
    )
    expect(
        "doesn't explicitly install the 'package.xml'" not in output,
        'The build warns: setup.py does not install package.xml into share/patrol. '
        '`ros2 pkg create` writes this line of data_files.',
        'builds',
    )


# The function and its program


def judge_round_trip(learner, *cases: list[str]) -> None:
    """What round_trip returns for these lists of stations: rule `round-trip`."""
    workspace = built(learner)
    with about('round-trip'):
        expect(ROUTE in files(learner), _no_file(learner, ROUTE))
        done = workspace.run(json.dumps(cases), program=_CALL)
        last = done.last_line
        expect('cannot import name' not in last, f'{ROUTE} has no function `round_trip`.')
        expect(
            "No module named 'patrol" not in last,
            f'Python does not find patrol.route in the installation ({last}). Is there an __init__.py in the folder '
            'patrol/patrol, and does `packages` in setup.py name it?',
        )
        expect(
            done.status == 0 and len(done.lines) >= len(cases), f'round_trip({cases[0]}) ended {done.where}with: {last}'
        )
        for stations, line in zip(cases, done.lines[-len(cases) :], strict=True):
            kind, found, after = _answer(line)
            call = f'round_trip({stations})'
            if len(stations) > LONG:
                _judge_long(stations, found)
                continue
            expect(found is not None or kind != 'NoneType', f'{call} returned None: write `return`.')
            expect(kind == 'list', f'{call} returned a {kind}, expected a list.')
            expect(
                found != stations or len(stations) < 2 or stations[0] != stations[-1],
                f'{call} returned {found}: the first name must come once more at the end, also after a list that ends '
                'with it.',
            )
            expect(
                found != stations,
                f'{call} returned {found}: it does not come back to the first station, {stations[0]}.',
            )
            expect(found == [*stations, stations[0]], f'{call} returned {found}, expected {[*stations, stations[0]]}.')
            expect(
                after == stations,
                f'After {call} the list that was given to it is {after}: make a new list, and leave that one as it is.',
            )


def _judge_long(stations: list[str], found: object) -> None:
    """What round_trip returns for more stations than a message can show."""
    wanted = [*stations, stations[0]]
    told = f'round_trip of a list of {len(stations)} stations, some of them several times, returned'
    if not isinstance(found, list):
        raise broken(f'{told} {str(found)[:80]}, expected a list.')
    expect(len(found) == len(wanted), f'{told} {len(found)} names, expected {len(wanted)}: all of them, and the first.')
    place = next((place for place, name in enumerate(wanted) if found[place] != name), 0)
    expect(
        found == wanted, f'{told} {found[place]!r} at the place {place}, expected {wanted[place]!r}: keep their order.'
    )


def _answer(line: str) -> tuple[str, object, object]:
    """The type of what came back, that itself, and what the given list is afterwards."""
    try:
        kind, found, after = json.loads(line)
        return str(kind), found, after
    except (ValueError, TypeError):
        return 'something else', line[:80], None


def _told(error: str, more: str = '') -> str:
    """An error, and after it what to do about it: `more`, or what is known of errors of imports and entry points."""
    if found := re.search(r"No module named '(route|announce)'", error):
        more = f'With its package the module is called patrol.{found[1]}.'
    elif "'module' object is not callable" in error or "has no attribute 'main'" in error:
        more = 'An entry point names a function of the module: patrol.route:main, and that function must be there.'
    return f'{error.rstrip(".")}. {more}' if more else error


def judge_route(learner, *cases: list[str]) -> None:
    """What `ros2 run patrol route` prints for these stations: rule `route`."""
    workspace = built(learner)
    with about('route'):
        for stations in cases:
            done = _run(workspace, 'route', *stations)
            wanted = ' '.join([*stations, stations[0]])
            command, last = done.command, done.last_line
            expect(
                done.status == 0 or last != wanted,
                f'`{command}` ended with: {last}. main returns the text, and does not print it: use print.',
            )
            expect(
                done.status == 0,
                f'`{command}` ended {done.where}with: '
                + _told(last, 'The names are sys.argv[1:].' if 'IndexError' in last else ''),
            )
            expect(done.lines, f'`{command}` printed nothing: use print.')
            expect(len(done.lines) == 1, f'`{command}` printed {len(done.lines)} lines, expected one: {wanted}')
            expect(
                '/patrol/route ' not in f'{last} ',
                f'`{command}` printed the path of the program, too: sys.argv[0] is the program itself, and the names '
                'are sys.argv[1:].',
            )
            expect(
                last != ' '.join(stations), f'`{command}` printed {last}, and does not come back to the first station.'
            )
            expect(
                last == wanted or re.findall(r'\w+', last) != wanted.split(),
                f'`{command}` printed {last}: the right names in another form. Expected, with spaces only: {wanted}',
            )
            expect(last == wanted, f'`{command}` printed {last}, expected {wanted}')


def _run(workspace: ExerciseWorkspace, program: str, *arguments: str):
    """`ros2 run` of a program that ends; says why if there is no such program."""
    _there(workspace, program)
    return workspace.run('ros2', 'run', NAME, program, *arguments)


def _there(workspace: ExerciseWorkspace, program: str) -> None:
    """Fail if the program is not where `ros2 run` looks."""
    installed = workspace.installed()
    folder = f'{NAME}/lib/{NAME}/'
    programs = sorted(path.removeprefix(folder) for path in installed if path.startswith(folder))
    elsewhere = [path.removeprefix(f'{NAME}/') for path in installed if path == f'{NAME}/bin/{program}']
    expect(
        program in programs or not elsewhere,
        f'The program `{program}` is installed as {min(elsewhere, default="")}; `ros2 run` looks for it in '
        'lib/patrol. setup.cfg is missing, or install_scripts in it says something else.',
    )
    expect(
        program in programs,
        f'`ros2 run patrol {program}` finds no program: setup.py has no entry point `{program}`. '
        f'Its programs are: {", ".join(programs) or "none"}.',
    )


# The node and its file


def judge_announce(learner, stations: list[str]) -> None:
    """With these names in stations.txt, what the node /announce publishes: rules `stations` and `announce`."""
    own = files(learner)
    with about('stations'):
        expect(DATA in own, _no_file(learner, DATA))
        names = [line.strip() for line in own[DATA].splitlines() if line.strip()]
        both = [name for name in names if len(name.split()) > 1]
        expect(
            not both,
            f'{DATA} has the line {both and both[0]!r}: write one name in each line, and each name as one word.',
        )
        expect(len(names) >= 2, f'{DATA} has {len(names)} names, expected at least two, one in each line.')
    workspace = built(learner, {DATA: '\n'.join(stations) + '\n'})
    with about('stations'):
        installed = workspace.installed()
        found = [path.removeprefix(f'{NAME}/') for path in installed if path.endswith('/stations.txt')]
        expect(
            SHARED in installed or not found,
            f'stations.txt is installed as {min(found, default="")}, expected share/patrol/{DATA}: look at the folder '
            'in data_files.',
        )
        expect(SHARED in installed, f'share/patrol/{DATA} is not installed: name {DATA} in data_files of setup.py.')
    with about('announce'):
        _there(workspace, 'announce')
        # Many editors leave out the last end of a line. The order of a set is right in one of two orders at most.
        _judge_node(learner, workspace, stations, '\n')
        if not _judge_period(learner, workspace, stations[::-1], ''):
            _judge_node(learner, workspace, stations[::-1], '')


def _announced(workspace: ExerciseWorkspace, stations: list[str], end: str, *arguments: str) -> Task:
    """The program, started with these names in the installed file, the last of which is followed by `end`."""
    # Not in the folder of the workspace: a path that begins there leads to the sources.
    command = 'printf %s "$1" > "$2" && cd /tmp && exec ros2 run patrol announce "${@:3}"'
    given = '\n'.join(stations) + end, f'install/{SHARED}', *arguments
    same_sets = {'PYTHONHASHSEED': '1'}  # each set of these names has the same order each time
    return workspace.start('bash', '-c', command, 'bash', *given, environment=same_sets)


def _judge_node(learner, workspace: ExerciseWorkspace, stations: list[str], end: str) -> None:
    """The node, its topic, and the names on it, with these stations in the file."""
    task = _announced(workspace, stations, end)
    with Observer(learner) as observer:
        names, stamps = [], []
        _until(observer, observer.nodes, task, TIMEOUT)
        there = _until(observer, lambda: '/announce' in observer.nodes(), task, MATCHED)
        if task.wait(0) is not None:
            raise broken(*_ended(task.output))
        expect(
            there,
            f'There is no node /announce; the nodes are: {", ".join(observer.nodes()) or "none"}. The name is the '
            'first argument of create_node, or of the constructor of Node.',
        )

        def publishers():
            return observer.node.get_publishers_info_by_topic('/next_station')

        if not _until(observer, publishers, task, MATCHED):
            others = observer.topics('/announce', 'publisher', 'std_msgs/msg/String')
            if task.wait(0) is not None:
                raise broken(*_ended(task.output))
            raise broken(
                'The node /announce does not publish on /next_station'
                + (f', but on {", ".join(others)}.' if others else '.'),
                'announce',
            )
        info = publishers()[0]
        expect(
            info.topic_type == 'std_msgs/msg/String',
            f'The type of /next_station is {info.topic_type}, expected std_msgs/msg/String.',
        )
        expect(
            info.node_name in ('announce', UNKNOWN),
            f'The node {info.node_name} publishes on /next_station, expected the node announce.',
        )

        def heard(message, info: dict) -> None:
            names.append(message.data)
            stamps.append(info['source_timestamp'] / 1e9)  # when it was sent: it may arrive late on a busy machine

        observer.node.create_subscription(String, '/next_station', heard, _fitting(info))
        wanted = len(stations) + 2
        enough = _until(observer, lambda: len(names) >= wanted, task, HEARD)
        if not enough and task.wait(0) is not None:
            raise broken(*_ended(task.output))
        task.end()
    expect(names, f'In {HEARD:g} s nothing came on /next_station. Is the node spun, and has its timer a callback?')
    _judge_names(names[:wanted], stations)
    _judge_rate(stamps, enough)


def _fitting(info) -> QoSProfile:
    """The QoS that gets all from this publisher."""
    reliable = info.qos_profile.reliability != ReliabilityPolicy.BEST_EFFORT
    return QoSProfile(depth=10, reliability=ReliabilityPolicy.RELIABLE if reliable else ReliabilityPolicy.BEST_EFFORT)


def _judge_period(learner, workspace: ExerciseWorkspace, stations: list[str], end: str) -> bool:
    """In simulated time: the names, and exactly the time between two. False if the program has another time.

    A program may wait without a timer of its node, or leave out the arguments for ROS; then it says when it is called.
    """
    task = _announced(workspace, stations, end, '--ros-args', '-p', 'use_sim_time:=true')
    names: list[str] = []
    times: list[float] = []
    try:
        with Observer(learner) as observer:
            if not _simulated(observer, task, names, times):
                return False
            far = len(times) > 1 and (times[-1] - times[0]) / (len(times) - 1)
            right = far and PERIODS[0] < far < PERIODS[1]
            if not right:
                observer.until(lambda: False, MATCHED / 8, task)
                came = len(names)
                # While the clock stands still, two names come only from a program that does not wait for it.
                if _until(observer, lambda: len(names) > came + 1, task, MATCHED) or task.wait(0) is not None:
                    return False
    finally:
        task.end()
    _judge_names(names, stations)
    expect(
        right,
        f'The node publishes a name every {far:.1f} s, expected every 0.5 s, which is twice a second. The first '
        'argument of create_timer is a period in seconds, not a rate.'
        if far
        else f'In {TICKS * TICK:g} s {len(names)} names came, expected one every 0.5 s.',
    )
    return True


def _simulated(observer: Observer, task: Task, names: list[str], times: list[float]) -> bool:
    """Let simulated time pass, and note the names with their times (s). False if the node does not follow."""
    node, now = observer.node, 0
    clock = node.create_publisher(Clock, '/clock', 10)
    ask = node.create_client(GetParameters, '/announce/get_parameters')

    def follows():
        clocks = node.get_subscriptions_info_by_topic('/clock')
        there = any(info.node_name in ('announce', UNKNOWN) for info in clocks) and ask.service_is_ready()
        return there and node.get_publishers_info_by_topic('/next_station')

    if not (_until(observer, follows, task, MATCHED) and (publishers := follows())):
        return False

    def heard(message) -> None:
        names.append(message.data)
        times.append(now * TICK)

    def answers() -> Iterator[Future]:
        for _ in range(ASKED):
            clock.publish(Clock(clock=Time(nanoseconds=round(now * TICK * 1e9)).to_msg()))
            yield ask.call_async(GetParameters.Request(names=['use_sim_time']))

    node.create_subscription(String, '/next_station', heard, _fitting(publishers[0]))
    while len(names) < NAMES and now < TICKS:
        now += 1
        # A node that answers has had its turn since the clock went on: so it is never far behind. It is asked again, as
        # an answer may get lost while the two meet.
        if not any(observer.until(answer.done, ANSWERED, task) for answer in answers()):
            return False
    return True


def _judge_rate(stamps: list[float], all_came: bool) -> None:
    """When the names were sent (s): twice a second."""
    expect(
        all_came and min(_pauses(stamps), default=0.0) < SLOW,
        f'Between two names pass {min(_pauses(stamps), default=HEARD):.1f} s at least, expected 0.5 s. The first '
        'argument of create_timer is a period in seconds, not a rate.',
    )
    between = (stamps[-1] - stamps[0]) / (len(stamps) - 1)
    expect(between > FAST, f'Between two names pass {between:.2f} s in the mean, expected 0.5 s.')
    at_once = [pause for pause in _pauses(stamps) if pause < AT_ONCE]
    expect(
        len(at_once) < (len(stamps) - 1) // 2,
        f'{len(at_once)} of {len(stamps)} names came within {AT_ONCE:g} s of the one before, and then nothing for a '
        'while: publish one name each time the timer calls, and let it call every 0.5 s.',
    )


def _judge_names(names: list[str], stations: list[str]) -> None:
    """What came on the topic, from wherever on, against what is in the file."""
    file = ', '.join(stations)
    strange = [name for name in names if name not in stations]
    if strange:
        expect(
            any(name.strip() for name in strange),
            'The node publishes an empty name: nothing stands behind the end of the last line, and that is no name. '
            'Use .split() or .splitlines() on the whole text.',
        )
        cut = [name for name in strange if name and name == stations[-1][:-1]]
        expect(
            not cut,
            f'The node publishes {cut and cut[0]!r}, and the last line of stations.txt is {stations[-1]!r}, without an '
            'end of the line behind it: who takes away the last character of a line takes a letter. Use .strip().',
        )
        bare = [name for name in strange if name.strip() in stations]
        expect(
            not bare,
            f'The node publishes {bare and bare[0]!r}: the end of the line is still in it. Take it away with '
            '.strip(), or use .split() or .splitlines() on the whole text.',
        )
        raise broken(
            f'The node publishes {strange[0][:60]!r}, and the installed stations.txt had {file}: it must read that '
            'file, from the share folder of its package.',
            'stations',
        )
    turn = dict(zip(stations, [*stations[1:], stations[0]], strict=True))
    for one, other in zip(names, names[1:], strict=False):
        why = 'after the last name the first one comes again' if turn[one] == stations[0] else 'they come in turn'
        expect(other == turn[one], f'With {file} in the file, {other} came after {one}, expected {turn[one]}: {why}.')


def _ended(output: str) -> tuple[str, str]:
    """What to say of a node that has ended, and which rule it breaks."""
    lines = [line.strip() for line in output.splitlines() if line.strip() and not line.startswith('[ros2run]')]
    if not lines:
        return '`ros2 run patrol announce` ended by itself, without a message. Does it spin?', 'announce'
    last = lines[-1][:300]
    if re.search('FileNotFoundError|NotADirectoryError|PackageNotFoundError|IsADirectoryError', last):
        return (
            f'`ros2 run patrol announce` ended with: {last}. The program must look for the file in the share folder, '
            'get_package_share_directory("patrol"), wherever it is started.',
            'stations',
        )
    places = re.findall(r'File "[^"]*/(patrol/[\w/]+\.py)", line (\d+)', output)
    place = ' ({}, line {})'.format(*places[-1]) if places else ''
    kind, _, text = last.partition(': ')
    unknown = re.search(r"name '(\w+)' is not defined", text)
    more = imports.advice(unknown[1]) if unknown else ''
    if not unknown and kind != 'ModuleNotFoundError':  # what is said of that is about the cells of a notebook
        more = explanations.explain(kind, text)
    return f'`ros2 run patrol announce` ended by itself, with: {_told(last + place, more)}', 'announce'


def _pauses(stamps: list[float]) -> list[float]:
    return [later - earlier for earlier, later in zip(stamps, stamps[1:], strict=False)]


def _until(observer: Observer, condition, task, timeout: float) -> bool:
    """Wait for a condition; longer while the machine is busy with something else."""
    for _ in range(4):
        if observer.until(condition, timeout, task):
            return True
        if task.wait(0) is not None or not busy():
            return False
    return False


# What package.xml says


def judge_dependencies(learner) -> None:
    """package.xml declares the ROS packages that the code imports: rule `dependencies`."""
    found = files(learner)
    declared = builds.declared(builds.manifest('package.xml', found['package.xml']))
    to_run = builds.to_run(declared)
    imported = _imports(text for path, text in found.items() if _runs(path)) & _ros_packages() - {NAME}
    if not imported:
        _readable(found)
    with about('dependencies'):
        expect(imported, 'Your code imports no ROS package, so there is nothing to declare: the node is missing.')
        for name in sorted(imported):
            tags = [tag for tag, names in declared.items() if name in names]
            expect(
                name in to_run or not tags,
                f'package.xml declares {name} as {", ".join(tags)} only. Your code imports it when it runs: write '
                f'<depend>{name}</depend> or <exec_depend>{name}</exec_depend>.',
            )
            expect(
                name in to_run,
                f'Your code imports {name}, and package.xml does not declare it: write <depend>{name}</depend>. On a '
                'fresh machine it is not installed.',
            )


def _runs(path: str) -> bool:
    """Whether a file is code that runs on the robot."""
    return path.endswith('.py') and path != 'setup.py' and not path.startswith(('test/', 'launch/'))


def _imports(texts: Iterable[str]) -> set[str]:
    """The first names of all modules that are imported."""
    found: set[str] = set()
    for text in texts:
        try:
            nodes = list(ast.walk(ast.parse(text)))
        except (SyntaxError, ValueError, RecursionError, MemoryError):
            continue  # running it says so
        for node in nodes:
            if isinstance(node, ast.Import):
                found |= {alias.name.partition('.')[0] for alias in node.names}
            elif isinstance(node, ast.ImportFrom) and node.module and not node.level:
                found.add(node.module.partition('.')[0])
            elif isinstance(node, ast.Call) and (name := _imported_by_call(node)):
                found.add(name.partition('.')[0])
    return found


def _imported_by_call(node: ast.Call) -> str:
    """The module that `import_module('…')` or `__import__('…')` imports; '' if it is another call, or not known."""
    function = node.func.attr if isinstance(node.func, ast.Attribute) else getattr(node.func, 'id', '')
    given = [*node.args, *(one.value for one in node.keywords if one.arg == 'name')][:1]
    if function not in ('import_module', '__import__') or not given or not isinstance(given[0], ast.Constant):
        return ''
    return str(given[0].value)


def _readable(found: dict[str, str]) -> None:
    """Each module can be parsed; else the node cannot start: rule `announce`."""
    for path, text in found.items():
        if not _runs(path):
            continue
        try:
            ast.parse(text)
        except (SyntaxError, ValueError, RecursionError, MemoryError) as error:
            place = f', line {line}' if (line := getattr(error, 'lineno', None)) else ''
            problem = f'{type(error).__name__}: {getattr(error, "msg", error)}'
            expect(False, f'Python cannot read what your code imports. {problem} ({path}{place})', 'announce')


def _ros_packages() -> set[str]:
    """The ROS packages of this machine."""
    from ament_index_python.packages import get_packages_with_prefixes

    return {*get_packages_with_prefixes(), *_ALWAYS}


# The learner's tests


def judge_tests(learner) -> None:
    """`colcon test` runs tests in test/test_route.py, and they pass: rule `tests`.

    What it counts comes from the learner's own process. So it counts only if the tests pass in another one, too, and
    fail where round_trip cannot be called.
    """
    workspace = built(learner)
    with about('tests'):
        expect(TESTS in files(learner), _no_file(learner, TESTS))
        workspace.once('colcon', 'test', '--packages-select', NAME, '--pytest-args', TESTS)
        counted = re.search(
            r'^build/patrol/\S+: (\d+) tests?, (\d+) errors?, (\d+) failures?, (\d+) skipped',
            workspace.once('colcon', 'test-result', '--all').output,
            re.MULTILINE,
        )
        every, errors, failures, skipped = map(int, counted.groups()) if counted else (0, 0, 0, 0)
        if every <= skipped or errors or failures:
            said = _pytest(learner, {})[1]
            expect(
                every, f'`colcon test` found no test in {TESTS}: pytest takes functions whose names begin with test_.'
            )
            expect(every > skipped, f'All tests in {TESTS} are skipped.')
            expect(not errors, f'{TESTS} cannot be run: {_told(said)}')
            expect(not failures, f'{failures} of {every} tests in {TESTS} {_fail(failures)}: {said}')

    status, said = _once(learner, '2 < 1')
    expect(
        status == 0,
        f'{TESTS} does not pass with a round_trip that calls your own one and does nothing else: {said}',
        'notices',
    )
    status, _ = _once(learner, '1 < 2')
    expect(status != 0, f'{TESTS} passes also with a round_trip that cannot be called: it must call it.', 'notices')


def _once(learner, condition: str) -> tuple[int | None, str]:
    """`_pytest` with the learner's own function, which cannot be called if the condition is true; once in a session."""
    cache, own = learner.server.workspaces, files(learner)
    key = 'own tests', condition, json.dumps(own)
    if key not in cache:
        function = disguise.disguised(_OWN.format(condition=condition), ['append', 'copy'], learner.random)
        cache[key] = _pytest(learner, {ROUTE: f'{own.get(ROUTE, "")}\n\n{function}\n'})
    return cache[key]


def _fail(number: int) -> str:
    return 'fails' if number == 1 else 'fail'


def judge_notices(learner, wrong: Mapping[str, str], rights: Iterable[str], told: bool = False) -> None:
    """The learner's tests fail with a wrong round_trip, and pass with right ones: rule `notices`.

    :param wrong: what such a function does -> its body, and :param rights: bodies.
    :param told: the learner may read what their tests say of these functions, which then are no secret.
    """
    own = files(learner)
    with about('tests'):
        expect(TESTS in own, _no_file(learner, TESTS))
    with about('round-trip'):
        expect(ROUTE in own, _no_file(learner, ROUTE))
    rights, noticed = list(rights), {}
    order = [*wrong.values(), *rights]
    SystemRandom().shuffle(order)  # the learner's tests may count the runs, and must not know which function comes when
    with about('notices'):
        for body in order:
            status, said = _pytest(learner, {ROUTE: _with(own[ROUTE], body)})
            expect(status != _NO_TESTS, f'{TESTS} notices nothing: {said}.')
            by_name = ' The card names no parameter: give the list without a name.' if 'keyword arg' in said else ''
            more = f': {said}.{by_name}' if told else f'. {_ASK_NO_MORE}'
            expect(
                body not in rights or status == 0, f'Your tests do not pass with another round_trip that is right{more}'
            )
            noticed[body] = status != 0
        for what, body in wrong.items():
            expect(
                noticed[body],
                f'Your tests pass with a round_trip that {what}: call it with two stations or more, and compare the '
                'whole list with assert.',
            )


_ASK_NO_MORE = (
    'Compare the whole list, give the list without the name of a parameter, and ask for nothing that the card does not.'
)


def _with(module: str, body: str) -> str:
    """The learner's module with another function in it, which is written differently each time.

    The card names no parameter, so that of a right function may have any name: here it can be given without it only.
    """
    random = SystemRandom()
    given = f'places_{random.randrange(10**6)}'
    text = f'def round_trip({given}, /):\n    stations = {given}\n    {body}\n'
    function = disguise.disguised(text, ['append', 'copy'], random)
    return f'{module}\n\n{function}\n'


def _pytest(learner, changed: dict[str, str]) -> tuple[int | None, str]:
    """Status of pytest on the learner's tests, with other texts, and what it said last."""
    own = files(learner)
    workspace = learner.workspace({**own, **changed})
    task = workspace.pytest('-q', '-p', 'no:cacheprovider', '--tb=short', TESTS)
    status = task.wait(TIMEOUT)
    while status is None and busy():
        status = task.wait(TIMEOUT)
    task.end()
    errors = [line.strip()[1:].strip() for line in task.output.splitlines() if line.startswith('E ')]
    without = {None: 'they do not end', _NO_TESTS: 'pytest finds no test, as no name of a function begins with test_'}
    said = errors[0] if errors else without.get(status, f'pytest ended with status {status}')
    if place := re.match(r'File "[^"]*", line (\d+)', said):  # Python cannot read the file: the error stands below
        error = next((line for line in errors if re.match(r'\w+Error: ', line)), said)
        said = f'{error} ({TESTS}, line {place[1]})'
    return status, said[:300]


def _no_file(learner, wanted: str) -> str:
    """What to say of a file that is missing, with one that could be meant."""
    name = PurePosixPath(wanted).name
    others = sorted(path for path in learner.files() if PurePosixPath(path).name == name)
    near = sorted(
        path
        for path in learner.files()
        if PurePosixPath(path).parent == PurePosixPath(wanted).parent
        and not path.endswith(('__init__.py', 'test_copyright.py', 'test_flake8.py', 'test_pep257.py'))
    )
    hint = f' There is {others[0]}: move it.' if others else f' There is {near[0]}.' if near else ''
    return f'There is no file {wanted} in my_ws/src/patrol.{hint}'
