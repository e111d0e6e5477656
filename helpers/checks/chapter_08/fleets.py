"""What the tests of exercise 8.3 share: the learner's package, built, and what is found of the governors in it.

The governor of the tests has one parameter more, with a name and a value that are drawn: a node of the learner's own
that is only called as the governor does not have it.
"""

import math
import signal
from collections.abc import Iterable
from pathlib import Path

from helpers.checks.chapter_08 import executables
from helpers.runner import about, expect
from helpers.runner.observer import Observer
from helpers.runner.workspaces import ExerciseWorkspace, package

GIVEN = Path(__file__).with_name('given')
PATIENCE = 20.0  # s of wall time until the governors are there
_GOVERNOR = 'src/fleet/fleet/governor.py'
_ONE_MORE = """

class Governor(Governor):
    def __init__(self):
        super().__init__()
        self.declare_parameter({name!r}, {value!r})
"""
_TWIST = 'geometry_msgs/msg/Twist'
ROBOTS = ('/robot1/governor', '/robot2/governor')
WANTED = {  # name of the node → parameter → (value, rule)
    ROBOTS[0]: {'rate': (20.0, 'rate'), 'max_linear': (1.0, 'robot1'), 'mode': ('normal', 'robot2')},
    ROBOTS[1]: {'rate': (20.0, 'rate'), 'max_linear': (0.6, 'max-linear'), 'mode': ('slow', 'robot2')},
}


def fleet(learner) -> ExerciseWorkspace:
    """The package with the learner's two files, built."""
    workspace = learner.workspace(
        {
            **package(GIVEN / 'fleet'),
            _GOVERNOR: _governor(learner),
            'src/fleet/config/fleet.yaml': learner.text('FLEET_YAML'),
            'src/fleet/launch/fleet.launch.py': learner.text('FLEET_LAUNCH'),
        }
    )
    workspace.build()
    return workspace


def _governor(learner) -> str:
    """The text of the tests' governor."""
    name, value = executables.sign(learner)
    return package(GIVEN / 'fleet')[_GOVERNOR] + _ONE_MORE.format(name=name, value=value)


def launched(learner) -> dict[str, dict]:
    """What is found of each governor after `ros2 launch`: name of the node → its names and parameters.

    It is launched once for all tests of a session, without the sources.
    """
    workspace = fleet(learner)
    key = 'fleet', workspace.name
    if key not in learner.server.workspaces:
        learner.server.workspaces[key] = _launch(learner, workspace, 'mv src sources')
    log, reports = learner.server.workspaces[key]
    expect(
        'InvalidParameterTypeException' not in log,
        'A governor did not start: a value in FLEET_YAML has the wrong '
        'type. rate and max_linear are doubles: 1.0, and not 1.',
        'types',
    )
    expect(
        not executables.lacks_parameter_file(log),
        'The launch file names a parameter file that is not there. The sources of the package are gone, so name the '
        'installed file: FindPackageShare finds its folder.',
        'installed-file',
    )
    expect(
        "Couldn't parse params file" not in log,
        'A governor did not start: ROS cannot read FLEET_YAML. Look at the indentation, and at the two underscores '
        'of ros__parameters.',
        'types',
    )
    names = [report['node'] for report in reports]
    expect(names, f'`ros2 launch fleet fleet.launch.py` started no governor. Its output ends: {_last(log)}', 'nodes')
    expect(
        len(set(names)) == len(names),
        f'Several nodes have one name: {", ".join(sorted(names))}. Two robots need two namespaces.',
        'nodes',
    )
    return {report['node']: report for report in reports}


def launched_with_rate(learner, rate: int) -> list[dict]:
    """What is found of the governors when the rate in the installed parameter file is another one."""
    share = 'share=$(ros2 pkg prefix --share fleet)'
    workspace = fleet(learner)
    _, reports = _launch(
        learner,
        workspace,
        f'{share}; cp $share/config/fleet.yaml kept.yaml; sed -i "s/20[.]0*/{rate}.0/" $share/config/fleet.yaml',
    )
    workspace.run('bash', '-c', f'{share}; cp kept.yaml $share/config/fleet.yaml')
    return reports


def alone(learner, *namespaces: str) -> dict[str, dict]:
    """What is found of governors that are started without a launch file: namespace → names and parameters.

    They run where the launch file has never run: it could have changed what is installed.
    """
    workspace = learner.workspace({'fleet.yaml': learner.text('FLEET_YAML')})
    arguments = '--ros-args', '--params-file', f'{workspace.path}/fleet.yaml', '-r'
    program = f'{_governor(learner)}\n\nmain()\n'
    tasks = [workspace.start(*arguments, f'__ns:={one}', program=program) for one in namespaces]
    names = {namespace: f'{namespace}/governor' for namespace in namespaces}
    with Observer(learner) as observer:
        observer.until(
            lambda: {*names.values()} <= {*observer.nodes()} or any(task.wait(0) is not None for task in tasks),
            PATIENCE,
        )
        there = observer.nodes()
        reports = {one: _report(learner, observer, name) for one, name in names.items() if name in there}
    for task in tasks:
        task.end()
    ended = [task.output for one, task in zip(namespaces, tasks, strict=True) if one not in reports]
    expect(not ended, f'A governor with your parameter file ended with: {_last("".join(ended[:1]))}')
    return reports


def robots(learner) -> dict[str, dict]:
    """What is found of the two governors; the rule `nodes`."""
    with about('nodes'):
        there = launched(learner)
    expect(
        set(there) == set(ROBOTS),
        f'These nodes were started: {", ".join(sorted(there))}; expected {" and ".join(ROBOTS)}.',
        'nodes',
    )
    _judge_program(learner, there.values())
    return there


def _judge_program(learner, reports: Iterable[dict]) -> None:
    """The rule `nodes`: each node is the given executable."""
    drawn = executables.sign(learner)
    for report in reports:
        expect(
            report['drawn'] == drawn,
            f'{report["node"]} is not the executable governor of the package fleet. Start that one: '
            "Node(package='fleet', executable='governor', …).",
            'nodes',
        )


def judge_values(learner) -> None:
    """The rules `robot1` and `robot2`, and the values of these two for the others."""
    there = robots(learner)
    for name, parameters in WANTED.items():
        for parameter, (wanted, rule) in parameters.items():
            got = there[name][parameter]
            expect(
                got == wanted,
                f'{name} has {parameter} = {got!r}, expected {wanted!r}. Does it get the file, does '
                'the name of the block fit, and does a later block override it?',
                rule,
            )


def judge_names(learner) -> None:
    """The rules `remapped` and `others-stay`."""
    there = robots(learner)
    for name, wanted, rule in (
        (ROBOTS[1], '/robot2/base/cmd_vel', 'remapped'),
        (ROBOTS[0], '/robot1/cmd_vel', 'others-stay'),
    ):
        got = there[name]['publishes']
        expect(
            got == wanted, f'{name} publishes on {got}, expected {wanted}. Names in remappings are relative, too.', rule
        )
    for name in ROBOTS:
        got, wanted = there[name]['listens'], name.replace('governor', 'cmd_vel_in')
        expect(got == wanted, f'{name} listens to {got}, expected {wanted}.', 'others-stay')


def judge_others(learner, *namespaces: str) -> None:
    """The rules `rate` and `max-linear`, for governors in these namespaces."""
    robots(learner)
    with about('rate'):
        reports = alone(learner, *namespaces)
    for namespace, report in reports.items():
        for name, wanted, rule in (
            ('rate', 20.0, 'rate'),
            ('max_linear', 0.6, 'max-linear'),
            ('mode', 'normal', 'robot2'),
        ):
            expect(
                report[name] == wanted,
                f'A governor in {namespace} with your file has {name} = {report[name]!r}, expected {wanted!r}.',
                rule,
            )


def judge_installed_file(learner) -> None:
    """The rule `installed-file`."""
    there = robots(learner)
    drawn = learner.random.randint(21, 49)
    again = launched_with_rate(learner, drawn)
    _judge_program(learner, again)
    found = [report['rate'] for report in again]
    expect(
        found == [drawn, drawn],
        f'The rate in the installed config/fleet.yaml was changed to {drawn}, and the '
        f'governors have {found}. The launch file must use the installed file, for both, '
        'and give no values itself.',
        'installed-file',
    )
    with about('installed-file'):
        reports = alone(learner, *(name.removesuffix('/governor') for name in ROBOTS))
    for report in reports.values():
        name = report['node']
        for parameter in WANTED[name]:
            got, own = there[name][parameter], report[parameter]
            expect(
                got == own,
                f'{name} has {parameter} = {got!r}, and without your launch file your parameter file gives it {own!r}. '
                'Values belong into the file; the launch file must give none itself.',
                'installed-file',
            )


def _launch(learner, workspace, before: str) -> tuple[str, list[dict]]:
    """Launch the fleet: what the launch has printed, and what is found of each node."""
    task = workspace.start('bash', '-c', f'{before}; exec ros2 launch fleet fleet.launch.py')
    with Observer(learner) as observer:
        names = observer.all_there(task, PATIENCE)
        reports = [_report(learner, observer, name) for name in names]
    task.signal(signal.SIGINT)
    task.wait(10.0)
    task.end()
    workspace.run('bash', '-c', '[ ! -e sources ] || mv sources src')
    return task.output, reports


def _report(learner, observer: Observer, name: str) -> dict:
    only, _ = executables.sign(learner)
    found = observer.parameters(name, ['max_linear', 'slow_linear', 'rate', 'mode', only])

    def topics() -> list[str]:
        return [', '.join(observer.topics(name, kind, _TWIST)) for kind in ('publisher', 'subscriber')]

    observer.until(lambda: all(topics()), PATIENCE)  # what a node has is known later than the node itself
    publishes, listens = topics()
    return {
        'node': name,
        'publishes': publishes,
        'listens': listens,
        **dict.fromkeys(('max_linear', 'slow_linear', 'rate'), math.nan),
        'mode': '',
        **found,
        'drawn': (only, found.get(only)),
    }


def _last(log: str) -> str:
    lines = [line.strip() for line in log.splitlines() if line.strip()]
    return lines[-1][:300] if lines else 'nothing'
