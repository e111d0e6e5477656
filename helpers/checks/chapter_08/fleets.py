"""What the tests of exercise 8.3 share: the learner's package, built, and what is found of the governors in it.

The executable in the package is a stand-in: it says how it was started, and the tests start the governor in this way
elsewhere. A node of the learner's own that is only called as the governor is a stranger.
"""

import json
import secrets
import shlex
import signal
from pathlib import Path
from typing import Any

from helpers.checks.chapter_08 import hurried_launch, launch_output, parameter_files
from helpers.runner import about, expect, stand_ins
from helpers.runner.load import busy
from helpers.runner.observer import Observer, processes, running
from helpers.runner.stand_ins import Start
from helpers.runner.workspaces import ExerciseWorkspace, package

GIVEN = Path(__file__).with_name('given')
PATIENCE = 20.0  # s of wall time until the governors are there
SETTLED = 5.0  # s of wall time in which what runs besides them may end
_GOVERNOR = 'src/fleet/fleet/governor.py'
# Behind the text of the governor: prints what a node has that was started with these arguments.
_REPORT = """

rclpy.init()
governor = Governor()
values = {{name: governor.get_parameter(name).value for name in ('max_linear', 'slow_linear', 'rate', 'mode')}}
names = {{'node': governor.get_fully_qualified_name(), 'publishes': governor.output.topic_name,
         'listens': governor.input.topic_name}}
place = names['node'].removesuffix('/governor')
asked = governor.get_publisher_names_and_types_by_node, governor.get_subscriber_names_and_types_by_node
names['topics'] = sorted({{topic for ask in asked for topic, _ in ask('governor', place)}})
print({mark!r} + json.dumps({{**names, **values}}), flush=True)
rclpy.shutdown()
"""
PROGRAM = 'governor'
MOST = 8  # governors that are started; two are asked for
ROBOTS = ('/robot1/governor', '/robot2/governor')
OF_EACH_NODE = {'/rosout', '/parameter_events'}  # topics that any node has
REST = {'slow_linear': (0.2, 'rest')}  # a default of the program `governor`
WANTED = {  # name of the node → parameter → (value, rule)
    ROBOTS[0]: {'rate': (20.0, 'rate'), 'max_linear': (1.0, 'robot1'), 'mode': ('normal', 'robot2'), **REST},
    ROBOTS[1]: {'rate': (20.0, 'rate'), 'max_linear': (0.6, 'max-linear'), 'mode': ('slow', 'robot2'), **REST},
}
OTHERS = {'rate': (20.0, 'rate'), 'max_linear': (0.6, 'max-linear'), 'mode': ('normal', 'robot2'), **REST}


def fleet(learner) -> ExerciseWorkspace:
    """The package with the learner's two files, built."""
    workspace = learner.workspace(
        {
            **package(GIVEN / 'fleet'),
            _GOVERNOR: stand_ins.of(learner).text(PROGRAM),
            'src/fleet/config/fleet.yaml': learner.text('FLEET_YAML'),
            'src/fleet/launch/fleet.launch.py': learner.text('FLEET_LAUNCH'),
        }
    )
    workspace.build()
    return workspace


def launched(learner) -> dict[str, dict]:
    """What is found of each governor after `ros2 launch`: name of the node → its names and parameters.

    It is launched once for all tests of a session, without the sources.
    """
    workspace = fleet(learner)
    key = 'fleet', workspace.name
    if key not in learner.server.workspaces:
        learner.server.workspaces[key] = _launch(learner, workspace, 'mv src sources', 'fleet fleet.launch.py')
    log, reports, _, others = learner.server.workspaces[key]
    expect(
        'InvalidParameterTypeException' not in log,
        f'A governor did not start: a value in FLEET_YAML has the wrong type.{launch_output.wrong_type(log)} rate and '
        'max_linear are doubles: 1.0, and not 1.',
        'types',
    )
    missing = launch_output.missing_parameter_file(log)
    expect(
        not missing,
        f'The launch file names a parameter file that is not there: {missing}.'
        + (
            launch_output.other_name(missing, 'fleet', 'config/fleet.yaml')
            or ' The sources of the package are gone, so name the installed file: FindPackageShare finds its folder.'
        ),
        'installed-file',
    )
    expect(
        "Couldn't parse params file" not in log,
        f'A governor did not start: ROS cannot read FLEET_YAML. '
        f'{parameter_files.why_unreadable(learner.text("FLEET_YAML"))}',
        'types',
    )
    names = [report['node'] for report in reports]
    expect(
        names,
        f'`ros2 launch fleet fleet.launch.py` started no governor. Its output ends: {launch_output.telling(log)}',
        'nodes',
    )
    expect(
        len(set(names)) == len(names),
        f'Several nodes have one name: {", ".join(sorted(names))}. Two robots need two namespaces.',
        'nodes',
    )
    expect(not others, others, 'nodes')
    return {report['node']: report for report in reports}


def _starts(learner) -> list[Start]:
    """How the governors were started by the launch that all tests share."""
    return learner.server.workspaces['fleet', fleet(learner).name][2]


def launched_with(learner, values: dict[str, float | str]) -> tuple[list[dict], dict[str, Any]]:
    """What is found of the governors when the installed parameter file gives these values to all nodes, and what else
    the launch file gave them.

    A copy of the launch file is launched, in another folder, with the parameter file as it was beside it. This folder
    is the first one in which ROS looks for packages, and has none.
    """
    share = 'share=$(ros2 pkg prefix --share fleet)'
    workspace = fleet(learner)
    installed = parameter_files.with_values(learner.text('FLEET_YAML'), values)
    _, reports, starts, _ = _launch(
        learner,
        workspace,
        f'{share}; cp $share/config/fleet.yaml kept.yaml; printf "%s" "$1" > $share/config/fleet.yaml; '
        'mkdir -p elsewhere/launch elsewhere/config; cp $share/launch/fleet.launch.py elsewhere/launch; '
        'cp kept.yaml elsewhere/config/fleet.yaml; unset COLCON_PREFIX_PATH; '
        'export AMENT_PREFIX_PATH="$PWD/elsewhere:$AMENT_PREFIX_PATH"; cd elsewhere',
        'launch/fleet.launch.py',
        installed,
    )
    workspace.run('bash', '-c', f'{share}; cp kept.yaml $share/config/fleet.yaml')
    return reports, parameter_files.given_besides(starts, installed)


def alone(learner, *namespaces: str) -> dict[str, dict]:
    """What is found of governors that are started without a launch file: namespace → names and parameters."""
    files = {'fleet.yaml': learner.text('FLEET_YAML')}
    arguments = '--ros-args', stand_ins.FILE_OPTION, 'fleet.yaml', '-r'
    log, reports = _reports(learner, [Start(PROGRAM, (*arguments, f'__ns:={one}'), files) for one in namespaces])
    found = {report['node'].removesuffix('/governor'): report for report in reports}
    expect(
        {*namespaces} <= found.keys(), f'A governor with your parameter file ended with: {launch_output.telling(log)}'
    )
    return found


def robots(learner) -> dict[str, dict]:
    """What is found of the two governors; the rule `nodes`."""
    with about('nodes'):
        there = launched(learner)
    expect(
        set(there) == set(ROBOTS),
        f'These nodes were started: {", ".join(sorted(there))}; expected {" and ".join(ROBOTS)}.',
        'nodes',
    )
    _judge_program(list(there.values()))
    return there


def _judge_program(there: list[dict]) -> None:
    """The rule `nodes`: each node is the given executable."""
    for report in there:
        expect(
            not report.get('stranger'),
            f'{report["node"]} is not the executable governor of the package fleet. Start that one: '
            "Node(package='fleet', executable='governor', …).",
            'nodes',
        )


def judge_values(learner) -> None:
    """The rules `robot1`, `robot2` and `rest`, and the values of these two for the others."""
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
        expect(got == wanted, f'{name} publishes on {got}, expected {wanted}. {_of_remapping(got, name)}', rule)
    for name in ROBOTS:
        got, wanted = there[name]['listens'], name.replace('governor', 'cmd_vel_in')
        expect(got == wanted, f'{name} listens to {got}, expected {wanted}.', 'others-stay')
        more = {*there[name]['topics']} - {there[name]['publishes'], got} - OF_EACH_NODE
        expect(
            '/clock' not in more,
            f'{name} has the topic /clock: somebody has set use_sim_time to true. Leave it out; the governors live in '
            "the machine's time.",
            'others-stay',
        )
        expect(
            not more,
            f'{name} has the topic {", ".join(sorted(more))}, which no governor has without your launch file. Remap '
            'cmd_vel of robot2, and nothing else.',
            'others-stay',
        )


def _of_remapping(got: str, name: str) -> str:
    """What may be wrong with the remapping by which the governor `name` publishes on the topic `got`."""
    plain = name.replace('governor', 'cmd_vel')
    if got.startswith(f'{name}/'):
        return '`~` stands for the name of the node: leave it out. A relative name is in the namespace of its robot.'
    if name == ROBOTS[0] and got == plain.replace('cmd_vel', 'base/cmd_vel'):
        return 'Only robot2 has a base that listens there.'
    if name == ROBOTS[1] and got == plain:
        return "A remapping is a pair, what the program says first: ('cmd_vel', 'base/cmd_vel')."
    return 'Names in remappings are relative, too.'


def judge_others(learner, *namespaces: str) -> None:
    """The rules `rate`, `max-linear` and `rest`, for governors in these namespaces."""
    robots(learner)
    with about('rate'):
        reports = alone(learner, *namespaces)
    for namespace, report in reports.items():
        for name, (wanted, rule) in OTHERS.items():
            expect(
                report[name] == wanted,
                f'A governor in {namespace} with your file has {name} = {report[name]!r}, expected {wanted!r}.',
                rule,
            )


def judge_installed_file(learner) -> None:
    """The rule `installed-file`."""
    there = robots(learner)
    drawn = learner.random.randint(21, 49)
    values = {'rate': float(drawn), 'max_linear': round(1 + drawn / 100, 2), 'slow_linear': drawn / 100, 'mode': 'stop'}
    again, besides = launched_with(learner, values)
    besides |= parameter_files.given_besides(_starts(learner), learner.text('FLEET_YAML'))
    _judge_program(again)
    found = {report['node']: report for report in again}
    for parameter, wanted in values.items():
        for name in ROBOTS:
            got = found.get(name, {}).get(parameter)
            expect(
                got == wanted,
                f'Before the launch, {parameter} became {wanted} for all nodes in the installed config/fleet.yaml, and '
                f'{name} has {parameter} = {got}. The launch file must use the installed file, for both, '
                'find it by the name of the package, wherever it stands itself, and give no values.',
                'installed-file',
            )
    expect(
        not besides,
        f'The launch file gives a governor a value itself, besides the file: {parameter_files.shown(besides)}. All '
        'values stand in config/fleet.yaml.',
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


def _launch(learner, workspace, before: str, what: str, *texts: str) -> tuple[str, list[dict], list[Start], str]:
    """`ros2 launch` with the words `what`, in a hurry: what it and the governors have printed, what is found of each
    node, how the governors were started, and a sentence if other programs run than these nodes.

    :param before: what bash does before, with these texts as $1, …
    """
    heard = stand_ins.of(learner)
    heard.release()
    script = f'{before}; exec {shlex.join(hurried_launch.COMMAND)} {what}'
    task = workspace.start('bash', '-c', script, 'bash', *texts)
    with Observer(learner) as observer:
        strangers = observer.all_there(task, PATIENCE, lambda: len(heard.starts(PROGRAM)), len(ROBOTS))
        started = heard.starts(PROGRAM)
        nodes = len(strangers) + len(started)
        observer.until(lambda: len(started) <= task.programs <= nodes, SETTLED, task)
        others = _others(task.output, task.programs, len(started), nodes)
    task.signal(signal.SIGINT)
    heard.release()
    task.wait(10.0)
    task.end()
    workspace.run('bash', '-c', '[ ! -e sources ] || mv sources src')
    log, reports = _reports(learner, started)
    reports += [{'node': name, 'stranger': True} for name in strangers]
    return f'{task.output}\n{log}', reports, started, others


def _others(log: str, programs: int, governors: int, nodes: int) -> str:
    """A sentence, if the programs that run are more than the nodes, or fewer than the governors; '' if not.

    :param programs: how many run, as is seen from outside. What the launch has printed may say something else.
    """
    if programs < governors:
        return (
            f'{governors} governors said that they were started, and {programs} programs run in the launch. Start them '
            'with the action Node.'
        )
    if max(programs, running(log)) <= nodes:
        return ''
    return (
        f'The launch started these processes: {", ".join(processes(log))}; {programs} programs run. Not each of them '
        'has a node, or is done. Start the two governors and nothing else: what another process starts later is one '
        'more node.'
    )


def _reports(learner, starts: list[Start]) -> tuple[str, list[dict]]:
    """Start governors in these ways, where no launch file has run: what they print, and what is found of each."""
    mark = f'found {secrets.token_hex(8)} '
    program = package(GIVEN / 'fleet')[_GOVERNOR] + _REPORT.format(mark=mark)
    tasks = [start.begin(learner, program) for start in starts[:MOST]]
    for task in tasks:
        if task.wait(PATIENCE) is None and busy():
            task.wait(3 * PATIENCE)
    for task in tasks:  # some share a place, in which all is ended at once
        task.end()
    log = '\n'.join(task.output for task in tasks)
    return log, [json.loads(line.removeprefix(mark)) for line in log.splitlines() if line.startswith(mark)]
