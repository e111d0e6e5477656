"""``ros2 launch``: real nodes, real terminals, stock's lines."""

import os
import re
import signal
import subprocess
import textwrap
from pathlib import Path

import pytest
from rcl_interfaces.srv import GetParameters
from turtlesim.msg import Pose

from environment.tests.running import ROS2

HEADER = ['from launch import LaunchDescription', 'from launch.actions import *', 'from launch.conditions import *',
          'from launch.event_handlers import *', 'from launch.substitutions import *',
          'from launch.launch_description_sources import *', 'from launch_ros.actions import *',
          'from launch_ros.substitutions import *']  # fmt: skip


@pytest.fixture
def write(tmp_path):
    """Write a launch file with these actions; return its path."""

    def write_one(actions, name='a.launch.py', before=''):
        body = textwrap.indent(textwrap.dedent(actions).strip(), ' ' * 8)
        start = '\n'.join([*HEADER, textwrap.dedent(before)])
        text = f'{start}\ndef generate_launch_description():\n    return LaunchDescription([\n{body}\n    ])\n'
        path = tmp_path / name
        path.write_text(text)
        return str(path)

    return write_one


def ros2(*argv):
    """Run ``ros2 …`` to its end."""
    return subprocess.run([ROS2, *argv], capture_output=True, text=True, timeout=60, stdin=subprocess.DEVNULL)


SIMULATOR = "Node(package='turtlesim', executable='turtlesim_node', output='screen', additional_env={'DISPLAY': ''},"


def test_nodes_get_name_namespace_parameters_and_remappings(write, start, peer, tmp_path):
    (tmp_path / 'p.yaml').write_text('/**:\n  ros__parameters:\n    background_g: 11\n    background_b: 12\n')
    path = write(
        f"""
        DeclareLaunchArgument('red', default_value='1'),
        GroupAction([
            PushRosNamespace('world'),
            SetParameter('holonomic', True),
            {SIMULATOR}
                 name='sim', remappings=[('turtle1/pose', '/where')],
                 parameters=[PathJoinSubstitution([ThisLaunchFileDir(), 'p.yaml']),
                             {{'background_r': LaunchConfiguration('red'), 'background_b': 13}}]),
        ]),
        """
    )
    process = start(ROS2, 'launch', path, 'red:=10')
    line = process.wait_for_output('Starting turtlesim', timeout=30)
    assert line == '[turtlesim_node-1] [INFO] [world.sim]: Starting turtlesim with node name /world/sim'
    names = ['background_r', 'background_g', 'background_b', 'holonomic']
    values = peer.call(GetParameters, '/world/sim/get_parameters', names=names).values
    assert [value.integer_value for value in values[:3]] == [10, 11, 13] and values[3].bool_value
    poses = peer.listen(Pose, '/where')
    peer.until(lambda: poses, 'a pose on the remapped topic')
    assert process.stop(timeout=30) == 0


def test_ctrl_c_ends_every_child_and_prints_stocks_lines(write, terminal, peer):
    path = write(f"{SIMULATOR} name='one'), Node(package='turtlesim', executable='mimic', name='two'),")
    launch = terminal(ROS2, 'launch', path)
    launch.read_until('Spawning turtle')
    # Its node, not only its process: a Python that still imports ends with a traceback, in stock too.
    peer.until(lambda: peer.node.count_publishers('/output/cmd_vel'), 'the node of mimic')
    lines = launch.text.splitlines()
    assert re.fullmatch(r'\[INFO\] \[launch\]: All log files can be found below \S+', lines[0])
    assert lines[1] == '[INFO] [launch]: Default logging verbosity is set to INFO'
    pids = dict(re.findall(r'\[INFO\] \[(\S+)\]: process started with pid \[(\d+)\]', launch.text))
    assert sorted(pids) == ['mimic-2', 'turtlesim_node-1']
    logs = Path(lines[0].split()[-1])
    begin = len(launch.text)
    launch.press('\x03')
    assert launch.wait() == 0
    rest = launch.text[begin:]
    assert '[WARNING] [launch]: user interrupted with ctrl-c (SIGINT)\n' in rest
    assert 'sending signal' not in rest and 'Traceback' not in rest
    for name, pid in pids.items():
        assert not os.path.exists(f'/proc/{pid}')
        assert f'[INFO] [{name}]: process has finished cleanly [pid {pid}]\n' in rest
    assert 'Spawning turtle' not in (logs / 'launch.log').read_text(), "output='screen' does not go to the log"


@pytest.mark.parametrize('name', ['SIGTERM', 'SIGHUP'])
def test_no_child_survives_other_signals(write, start, name):
    path = write(SIMULATOR + '),')
    process = start(ROS2, 'launch', path)
    process.wait_for_output('Spawning turtle', timeout=30)
    pid = re.search(r'started with pid \[(\d+)\]', process.output).group(1)
    os.kill(process.pid, signal.Signals[name])
    process._popen.wait(30)
    assert process.returncode == 1
    assert not os.path.exists(f'/proc/{pid}')
    process.wait_for_output(f'[ERROR] [launch]: received {name}, ending all processes')


def test_a_second_ctrl_c_is_ignored(write, terminal):
    code = "import signal, time; signal.signal(signal.SIGINT, lambda *_: print('got it')); print('up'); time.sleep(60)"
    path = write(f"ExecuteProcess(cmd=['python3', '-u', '-c', {code!r}], output='screen', sigterm_timeout='3'),")
    launch = terminal(ROS2, 'launch', path)
    launch.read_until('] up\n')
    launch.press('\x03')
    launch.read_until('got it')
    launch.press('\x03')
    launch.read_until('[WARNING] [launch]: user interrupted with ctrl-c (SIGINT) again, ignoring...')
    assert launch.wait() == 0
    assert "escalating to 'SIGTERM'" in launch.text and 'exit code -15' in launch.text


def test_a_package_ships_launch_files(start, peer):
    process = start(ROS2, 'launch', 'turtlesim', 'multisim.launch.py', env={'DISPLAY': ''})
    process.wait_for_output('node name /turtlesim1/turtlesim', timeout=30)
    process.wait_for_output('node name /turtlesim2/turtlesim', timeout=30)
    assert process.stop(timeout=30) == 0


def test_show_args_and_print(write, domain):
    path = write(
        """
        DeclareLaunchArgument('must', description='Is needed'),
        DeclareLaunchArgument('may', default_value=['a', LaunchConfiguration('must')]),
        GroupAction([DeclareLaunchArgument('perhaps', default_value='1')], condition=IfCondition('1')),
        """
    )
    result = ros2('launch', path, '--show-args')
    assert (result.returncode, result.stderr) == (0, '')
    assert result.stdout == textwrap.dedent(
        """\
        Arguments (pass arguments as '<name>:=<value>'):

            'must':
                Is needed

            'may':
                no description given
                (default: 'a' + LaunchConfig('must'))

            'perhaps':*
                no description given
                (default: '1')

        * argument(s) which are only used if specific conditions occur
        """
    )
    assert ros2('launch', write('', name='none.launch.py'), '-s').stdout.endswith('\n\n  No arguments.\n')
    printed = ros2('launch', path, '-p').stdout.splitlines()
    assert [re.sub('0x[0-9a-f]+', 'ID', line) for line in printed] == [
        '<launch.launch_description.LaunchDescription object at ID>',
        "├── Action('<launch.actions.declare_launch_argument.DeclareLaunchArgument object at ID>')",
        "├── Action('<launch.actions.declare_launch_argument.DeclareLaunchArgument object at ID>')",
        "└── Action('<launch.actions.group_action.GroupAction object at ID>')",
    ]
    node = write("Node(package='turtlesim', executable='mimic', name='m', arguments=['-a'], parameters=[{'p': 1}]),")
    assert ros2('launch', node, '-p').stdout.splitlines()[1:] == [
        "└── ExecuteProcess(cmd=[ExecInPkg(pkg='turtlesim', exec='mimic'), '-a', '--ros-args', '-r', "
        "LocalVar('node name')], cwd=None, env=None, shell=False)"
    ]


CAUGHT = '[ERROR] [launch]: Caught exception in launch (see debug for traceback): '
SEVERAL = 'Caught multiple exceptions when trying to load file of format [py]:\n - '
OTHER = ' - InvalidFrontendLaunchFileError: The launch file may have a syntax error, or its format is unknown\n'


@pytest.mark.parametrize(
    'actions, before, message',
    [
        ("DeclareLaunchArgument('who'),", '', "Included launch description missing required argument 'who' "
         "(description: 'no description given'), given: []"),
        ('Node(', '', f'{SEVERAL}SyntaxError: '),
        ('', '1 / 0', f'{SEVERAL}ZeroDivisionError: division by zero\n{OTHER}'),
        ('', "{}['NOPE']", f"{SEVERAL}KeyError: 'NOPE'\n{OTHER}"),
        ('', 'import no_such_module', f"{SEVERAL}ModuleNotFoundError: No module named 'no_such_module'\n{OTHER}"),
        ("Node(package='no_such_package', executable='x'),", '',
         '"package \'no_such_package\' not found, searching: ['),
        ("Node(package='turtlesim', executable='nope'),", '', "executable 'nope' not found on the libexec directory '"),
        ("IncludeLaunchDescription('/no/such.launch.py'),", '',
         f"{SEVERAL}FileNotFoundError: [Errno 2] No such file or directory: '/no/such.launch.py'\n"),
        ("LogInfo(msg=LaunchConfiguration('nope')),", '', "launch configuration 'nope' does not exist"),
        ("'no action',", '', f"{SEVERAL}TypeError: a launch description holds actions, got 'no action'\n{OTHER}"),
        ("Node(package='turtlesim', executable='mimic', name='a b'),", '', 'Invalid node name: '),
    ],
)  # fmt: skip
def test_faults_of_a_launch_file_are_told_with_their_class(write, domain, actions, before, message):
    result = ros2('launch', write(actions, before=before))
    assert result.returncode == 1
    assert f'\n{CAUGHT}{message}' in result.stdout
    assert 'Traceback' not in result.stdout + result.stderr


def test_debug_shows_the_traceback(write, domain):
    result = ros2('launch', '--debug', write('', before='1 / 0'))
    assert result.returncode == 1
    assert 'Traceback (most recent call last)' in result.stdout
    assert 'Default logging verbosity is set to DEBUG' in result.stdout


def test_a_file_without_the_function_or_of_no_known_format(domain, tmp_path):
    (tmp_path / 'a.launch.py').write_text('')
    (tmp_path / 'a.launch.txt').write_text('<launch/')
    (tmp_path / 'b.launch.py').write_text('def generate_launch_description():\n    pass\n')
    for name, message in (
        ('a.launch.py', "does not contain the required function 'generate_launch_description()'"),
        ('a.launch.txt', 'The launch file may have a syntax error, or its format is unknown'),
        ('b.launch.py', 'returned NoneType, not a LaunchDescription'),
    ):
        result = ros2('launch', str(tmp_path / name))
        assert result.returncode == 1 and message in result.stdout
        assert ros2('launch', '-s', str(tmp_path / name)).returncode == 1


@pytest.mark.parametrize(
    'argv, message',
    [
        (['no_such_package', 'a.launch.py'],
         "Package 'no_such_package' not found: \"package 'no_such_package' not found"),
        (['turtlesim', 'no.launch.py'], "file 'no.launch.py' was not found in the share directory of package "
         "'turtlesim' which is at '"),
        (['no.launch.py'], 'No launch file supplied'),
        (['turtlesim'], 'No launch file supplied'),
        (['no.launch.py', 'x:=1'], "Package 'no.launch.py' not found: "),
        (['turtlesim', 'multisim.launch.py', 'x=1'], "malformed launch argument 'x=1', expected format "
         "'<name>:=<value>'"),
    ],
)  # fmt: skip
def test_wrong_calls_are_one_line_on_standard_error(domain, argv, message):
    result = ros2('launch', *argv)
    assert (result.returncode, result.stdout) == (1, '')
    assert message in result.stderr and len(result.stderr.splitlines()) == 1


def test_help_is_stocks(domain, monkeypatch):
    monkeypatch.setenv('COLUMNS', '200')
    text = ros2('launch', '--help').stdout
    assert text.startswith('usage: ros2 launch [-h] [-n] [-d] [-p | -s] [-a] [--launch-prefix LAUNCH_PREFIX]')
    assert '[--launch-prefix-filter LAUNCH_PREFIX_FILTER]' in text
    assert 'Run a launch file' in text


def test_a_reader_that_leaves_ends_the_launch(write, domain):
    path = write("ExecuteProcess(cmd=['sh', '-c', 'while :; do echo x; done'], output='screen'),")
    launch = subprocess.Popen([ROS2, 'launch', path], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    try:
        text = ''
        while '[sh-1] x' not in text:
            text += launch.stdout.readline()
        launch.stdout.close()
        assert launch.wait(30) == 0
        assert launch.stderr.read() == ''
        pid = re.search(r'started with pid \[(\d+)\]', text).group(1)
        assert not os.path.exists(f'/proc/{pid}')
    finally:
        launch.kill()
        launch.wait()
        launch.stderr.close()


def test_a_prefix_for_some_programs(write, domain):
    path = write(
        """
        ExecuteProcess(cmd=['echo', 'a'], output='screen'),
        ExecuteProcess(cmd=['printf', 'b'], output='screen'),
        """
    )
    result = ros2('launch', path, '--launch-prefix', 'nice -n 1', '--launch-prefix-filter', 'ech.')
    assert result.returncode == 0
    assert re.search(r'^\[nice-\d\] a$', result.stdout, re.M) and re.search(r'^\[printf-\d\] b$', result.stdout, re.M)


def test_completion_knows_all_formats(tmp_path):
    from ros2launch.api import get_launch_file_paths, is_launch_file

    names = ['a.launch.py', 'b_launch.xml', 'c.launch.yaml', 'd.launch.yml']
    for name in [*names, 'e.txt', 'package.xml']:
        (tmp_path / name).write_text('')
    assert get_launch_file_paths(path=str(tmp_path)) == [str(tmp_path / name) for name in names]
    assert is_launch_file(tmp_path / 'b_launch.xml') and not is_launch_file(tmp_path / 'package.xml')


def test_programs_print_the_arguments_of_a_description(capsys):
    from launch import LaunchDescription
    from launch.actions import DeclareLaunchArgument
    from ros2launch.api import print_arguments_of_launch_description

    print_arguments_of_launch_description(launch_description=LaunchDescription([DeclareLaunchArgument('speed')]))
    assert capsys.readouterr().out == (
        "Arguments (pass arguments as '<name>:=<value>'):\n\n    'speed':\n        no description given\n"
    )
