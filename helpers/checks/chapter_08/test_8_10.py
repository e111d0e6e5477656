"""Visible tests of exercise 8.10, start it: the whole package, built, launched and used."""

import re

import pytest

from helpers.checks.chapter_08 import deliveries, launch_output, parameter_files
from helpers.runner import about, expect

pytestmark = pytest.mark.exercise('8.10')
APART = 0.3  # m, at most between what the world says and where the robot's commands lead
DEFAULTS = {'max_linear': 0.5, 'tolerance': 0.1, 'timeout': 60.0, 'max_angular': 1.0, 'status_period': 0.5}
PUBLISHER = '/robot_state_publisher'
NODES = '/world', PUBLISHER, '/delivery_robot'
UNNAMED = 'max_angular', 'status_period'
VALUES = (('max_linear', 0.4), ('tolerance', 0.08), ('timeout', 30.0), ('max_angular', 1.0), ('status_period', 0.5))


def story(learner) -> dict:
    """What happened when the package was launched and used, without what comes from a faulty launch."""
    with about('types'):
        deliveries.by_the_file(learner, DEFAULTS)
    with about('drives'):
        told = deliveries.launched(learner)
    missing = launch_output.missing_parameter_file(told['log'])
    expect(
        not missing,
        f'The launch file names a parameter file that is not there: {missing}.'
        + (
            launch_output.other_name(missing, 'delivery_robot', 'config/delivery.yaml')
            or ' The sources of the package are gone, and the launch file is a copy in another folder: '
            'FindPackageShare finds the installed folder by the name of the package.'
        ),
        'robot',
    )
    refused = 'Valid options are' in told['log']
    expect(
        not refused,
        f'Launched with scene:={told["scene"]}, your launch file ended: {told["last"]} The world says what a scene is: '
        'a name, or the path of a YAML file. Pass the value on.',
        'world',
    )
    nowhere = re.search(r"there is no scene '(.*?)'", told['log'])
    expect(
        not nowhere,
        f'Launched with scene:={told["scene"]}, the world got the scene {nowhere and nowhere[1]!r}. Pass the value of '
        "the argument on: ('scene', LaunchConfiguration('scene')).",
        'world',
    )
    others = [node for node in told.get('nodes', ()) if node not in NODES]
    expect(
        '/delivery_robot' in told or not others,
        f'The node /delivery_robot did not start, but {" and ".join(others)} did. Give the robot no other name.',
        'robot',
    )
    expect('/delivery_robot' in told, f'The node /delivery_robot did not start: {told["last"]}', 'robot')
    expect(
        told.get('executable', True),
        '/delivery_robot is not the executable robot of the package delivery_robot. Start that one: '
        "Node(package='delivery_robot', executable='robot', …).",
        'robot',
    )
    return told


def values_of_the_file(learner) -> None:
    """The rule `values`: the parameter file alone gives them."""
    values = deliveries.by_the_file(learner, DEFAULTS)
    for name, wanted in VALUES:
        expect(
            values[name] == wanted,
            f'Without your launch file, DELIVERY_YAML gives /delivery_robot {name} = {values[name]}, expected '
            f'{wanted}. '
            + (
                'It is not named in the specification, so it keeps its default.'
                if name in UNNAMED
                else 'Does the name of the block fit? Values belong into this file; the launch file adds nothing but '
                'the simulated time.'
            ),
            'values',
        )


def values_of_the_launch(told: dict) -> None:
    """The rules `sim-time` and `robot`: the robot has what stood in the installed file when it was launched."""
    values = told['/delivery_robot']
    expect(
        values['use_sim_time'] is True,
        "The node /delivery_robot has use_sim_time False: it does not live in the world's time.",
        'sim-time',
    )
    for name, wanted in told['values'].items():
        expect(
            values[name] == wanted,
            f'Before the launch, {name} became {wanted} in the installed config/delivery.yaml, and /delivery_robot has '
            f'{name} = {values[name]}. The launch file must hand this file over, found by the name of the package, '
            'and give no values itself but the simulated time.',
            'robot',
        )
    expect(
        not told['besides'],
        'The launch file gives /delivery_robot a value itself, besides the file: '
        f'{parameter_files.shown(told["besides"])}. All values but the simulated time stand in config/delivery.yaml.',
        'robot',
    )


def real(told: dict) -> None:
    """Fail if the robot is elsewhere in the launched world than where its commands bring a robot."""
    where, led = told.get('ended_at', 0.0), told.get('retraced', 0.0)
    expect(
        abs(where - led) < APART,
        f'/odom says that the robot is at x = {where:.2f} m, but what came on /cmd_vel brings a robot to {led:.2f} m. '
        'Does the launch file start the world of mujoco_world, and nothing else that publishes /odom?',
        'world',
    )


@pytest.mark.rules('arguments')
def test_arguments(learner):
    """The package can be built and read, and its launch file has the arguments scene and real_time_factor.

    The cells of exercises 8.5 and 8.7 to 8.9 run without an error; DeclareLaunchArgument(name, default_value=…).
    """
    with about('drives'):
        workspace = deliveries.workspace(learner)
        done = workspace.once('python3', '-c', 'import delivery_robot.main')
    expect(
        done.status == 0,
        f'Python cannot read your package, with your cells of exercises 8.5 and 8.7 to 8.9 in it: {done.last_line}',
        'drives',
    )
    done = workspace.once('ros2', 'launch', 'delivery_robot', 'delivery.launch.py', '--show-args')
    why = launch_output.telling(done.output)
    expect(done.status == 0, f'ros2 launch cannot read your launch file: {why}', 'robot')
    declared = deliveries.declared(learner)
    for name, default in (('scene', 'rooms'), ('real_time_factor', '1.0')):
        expect(name in declared, f'The launch file has no argument {name}.')
        expect(declared[name] == default, f'The default of {name} is not {default}.')
    log, values = deliveries.launched_plainly(learner)
    expect(
        not log,
        f'`ros2 launch delivery_robot delivery.launch.py`, without an argument, ended: {launch_output.telling(log)}',
    )
    for name, default in (('scene', 'rooms'), ('real_time_factor', '1.0')):
        expect(
            str(values.get(name, default)) == default,
            f'`ros2 launch delivery_robot delivery.launch.py`, without an argument, starts a world with {name} = '
            f'{values.get(name)}, expected {default}. DeclareLaunchArgument says what an argument is if nobody gives '
            'it.',
        )


@pytest.mark.rules('values', 'types', 'robot', 'sim-time', 'world')
def test_values(learner):
    """The node has the values of the installed delivery.yaml, also after somebody has changed it, and simulated time.

    parameters=[path of the installed file, {'use_sim_time': True}].
    """
    told = story(learner)
    values_of_the_file(learner)
    values_of_the_launch(told)


@pytest.mark.rules('world')
def test_world(learner):
    """The world gets the scene and the real_time_factor that were given to the launch.

    launch_arguments: pairs of a name and LaunchConfiguration(name).
    """
    told = story(learner)
    values = told.get('/world')
    expect(values, 'The node /world did not start: the launch file must include world.launch.py.')
    wanted = {name: told[of] for name, of in (('scene', 'scene'), ('real_time_factor', 'factor'))}
    launched = ' '.join(f'{name}:={value}' for name, value in wanted.items())
    expect(values == wanted, f'Launched with {launched}, the world has {values}.')
    expect(
        told['included'],
        'There is a world, but world.launch.py of the package mujoco_world was not included: it starts the world with '
        'all that belongs to it, such as /robot_state_publisher. Include it with IncludeLaunchDescription.',
    )
    more = [node for node in told.get('nodes', ()) if node not in NODES]
    expect(
        not more,
        f'There is one more node, {more and more[0]}: start nothing but the world, as it is included, and the robot.',
    )
    count = told.get('nodes', []).count(PUBLISHER)
    expect(
        count <= 1,
        f'There are {count} nodes with the name {PUBLISHER}. The world, as it is included, brings one: start no other.',
    )
    expect(
        count or 'missing' in told,
        f'There is no node {PUBLISHER}. The world, as it is included by world.launch.py, brings one.',
    )
    programs = max(len(told['processes']), told.get('programs', 0))
    expect(
        programs <= len(NODES),
        f'The launch started these processes: {", ".join(told["processes"])}; {programs} programs ran. Start nothing '
        'but the world, as it is included, and the robot; what is no ROS node counts, too.',
    )
    real(told)


@pytest.mark.rules('drives', 'ends', 'world')
def test_drives(learner):
    """Launched, the robot drives off, stands when it is called back, reaches another station, and ends with Ctrl+C.

    The cells of exercises 8.5 and 8.7 to 8.9 are used here as files. Their own tests tell more.
    """
    told = story(learner)
    expect(
        'missing' not in told,
        f'This never came: {told.get("missing")}. The last that the launch said: {told["last"]}',
        'drives',
    )
    expect(
        told['cancelled'] == 'canceled',
        f'The goal that was called back ended as {told["cancelled"]}, expected canceled.',
        'drives',
    )
    expect(
        told['stopped_at'] < 5.0,
        f'The robot was called back on its way to x = 6 m, and stood at {told["stopped_at"]:.2f} m.',
        'drives',
    )
    expect(
        told['arrived'] == 'succeeded', f'The goal after that ended as {told["arrived"]}, expected succeeded.', 'drives'
    )
    _, near = told['stations'].values()
    expect(
        abs(told['ended_at'] - near) < 0.2,
        f'The station is at x = {near:g} m, and the robot stands at {told["ended_at"]:.2f} m.',
        'drives',
    )
    real(told)
    expect(
        told['status'] == 0,
        f'After Ctrl+C, ros2 launch ended with the status {told["status"]}, expected 0. Does '
        'your launch file start anything that does not end?',
        'ends',
    )
    expect(
        not told['left'],
        f'After Ctrl+C, ros2 launch ended, and {told["left"]} of the programs that it had started went on.',
        'ends',
    )
