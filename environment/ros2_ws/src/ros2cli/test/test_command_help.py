"""Help, unknown commands, plug-ins, completion."""

import os
import shlex
import subprocess
import sys

import pytest

from environment.tests.running import ROS2
from helpers import background

VERBS = {
    'bag': ('burst', 'convert', 'info', 'list', 'play', 'record', 'reindex'),
    'component': ('list', 'load', 'standalone', 'types', 'unload'),
    'daemon': ('start', 'status', 'stop'),
    'multicast': ('receive', 'send'),
    'action': ('info', 'list', 'send_goal', 'type'),
    'doctor': ('hello',),
    'interface': ('list', 'package', 'packages', 'proto', 'show'),
    'lifecycle': ('get', 'list', 'nodes', 'set'),
    'node': ('info', 'list'),
    'param': ('delete', 'describe', 'dump', 'get', 'list', 'load', 'set'),
    'pkg': ('create', 'executables', 'list', 'prefix', 'xml'),
    'service': ('call', 'echo', 'find', 'info', 'list', 'type'),
    'topic': ('bw', 'delay', 'echo', 'find', 'hz', 'info', 'list', 'pub', 'type'),
}

COMMANDS = """\
  action     Various action related sub-commands
  bag        Various rosbag related sub-commands
  component  Various component related sub-commands
  daemon     Various daemon related sub-commands
  doctor     Check ROS setup and other potential issues
  interface  Show information about ROS interfaces
  launch     Run a launch file
  lifecycle  Various lifecycle related sub-commands
  multicast  Various multicast related sub-commands
  node       Various node related sub-commands
  param      Various param related sub-commands
  pkg        Various package related sub-commands
  run        Run a package specific executable
  service    Various service related sub-commands
  topic      Various topic related sub-commands
  wtf        Use `wtf` as alias to `doctor`

  Call `ros2 <command> -h` for more detailed usage.
"""


@pytest.mark.parametrize('argv', [['--help'], ['-h'], []])
def test_help_lists_the_commands_as_stock_does(ros2, argv):
    text = ros2.output(*argv)
    assert text.startswith(
        'usage: ros2 [-h] [--use-python-default-buffering] Call `ros2 <command> -h` for more detailed usage. ...\n\n'
        'ros2 is an extensible command-line tool for ROS 2.\n'
    )
    assert text.endswith('\nCommands:\n' + COMMANDS)


@pytest.mark.parametrize('command', VERBS)
def test_a_command_without_a_verb_prints_its_help(ros2, command):
    if command == 'doctor':  # checks
        text = ros2.output(command, '-h')
    else:
        text = ros2.output(command)
        assert text == ros2.output(command, '--help')
    listed = text.partition('Commands:\n')[2].partition('\n\n')[0]
    assert tuple(line.split()[0] for line in listed.splitlines()) == VERBS[command]


@pytest.mark.parametrize('command,verb', [(command, verb) for command, verbs in VERBS.items() for verb in verbs])
def test_every_verb_has_help(ros2, command, verb):
    assert ros2.output(command, verb, '--help').startswith(f'usage: ros2 {command} {verb} [-h]')


def test_an_unknown_command_is_wrong_usage(ros2):
    error = ros2.error('fly', status=2)
    assert 'ros2: error: argument Call `ros2 <command> -h` for more detailed usage.: invalid choice: ' in error
    assert "invalid choice: 'fly'" in error or 'invalid choice: fly' in error
    assert 'invalid choice' in ros2.error('topic', 'fly', status=2)


def test_a_broken_plug_in_does_not_take_the_others_down(ros2, tmp_path):
    info = tmp_path / 'broken-1.dist-info'
    info.mkdir()
    (info / 'METADATA').write_text('Metadata-Version: 2.1\nName: broken\nVersion: 1\n')
    (info / 'entry_points.txt').write_text('[ros2cli.command]\nbroken = no_such_module:Command\n')
    done = subprocess.run(
        [ROS2],
        capture_output=True,
        text=True,
        env={**ros2.environ, 'PYTHONPATH': f'{tmp_path}{os.pathsep}{ros2.environ.get("PYTHONPATH", "")}'},
    )
    assert done.returncode == 0
    assert done.stderr == "Failed to load entry point 'broken': No module named 'no_such_module'\n"
    assert '  topic  ' in done.stdout


def test_help_does_not_load_ros(ros2):
    done = subprocess.run(
        [
            sys.executable,
            '-c',
            'import sys; from ros2cli.cli import main; main(argv=[]); main(argv=["topic"]);'
            'sys.exit("rclpy" in sys.modules)',
        ],
        capture_output=True,
        env=ros2.environ,
    )
    assert done.returncode == 0, done


def complete(ros2, line: str, strip: bool = True) -> list[str]:
    """Return what the Tab key offers at the end of a line."""
    read, write = os.pipe()
    try:
        subprocess.run(
            [ROS2],
            check=True,
            pass_fds=[write],
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
            env={
                **ros2.environ,
                '_ARGCOMPLETE': '1',
                '_ARGCOMPLETE_IFS': '\n',
                'COMP_LINE': line,
                'COMP_POINT': str(len(line)),
                'COMP_TYPE': '9',
                '_ARGCOMPLETE_STDOUT_FILENAME': f'/dev/fd/{write}',
            },
        )
        os.close(write)
        write = None
        with os.fdopen(read, closefd=False) as answers:
            return [word.strip() if strip else word for word in answers.read().split('\n')]
    finally:
        os.close(read)
        if write is not None:
            os.close(write)


def test_tab_completes_commands_options_packages_and_types(ros2):
    assert complete(ros2, 'ros2 to') == ['topic']
    assert set(complete(ros2, 'ros2 topic ')) >= set(VERBS['topic'])
    assert '--once' in complete(ros2, 'ros2 topic echo --on')
    assert complete(ros2, 'ros2 pkg prefix ros2topi') == ['ros2topic']
    assert complete(ros2, 'ros2 interface show std_srvs/srv/Set') == ['std_srvs/srv/SetBool']


VALUES = {
    'topic pub /x geometry_msgs/msg/PointStamped': (
        'header:\n  stamp:\n    sec: 0\n    nanosec: 0\n  frame_id: ""\npoint:\n  x: 0.0\n  y: 0.0\n  z: 0.0\n'
    ),
    'service call /x example_interfaces/srv/AddTwoInts': 'a: 0\nb: 0\n',
    'action send_goal /x example_interfaces/action/Fibonacci': 'order: 0\n',
}


@pytest.mark.parametrize('line', VALUES)
def test_tab_writes_values_that_the_shell_and_yaml_understand(ros2, line):
    """Tutorial, Understanding topics: after a quote with a backslash; or after a quote and the first letters."""
    whole = '\n'.join(complete(ros2, f"ros2 {line} \\'", strip=False))
    assert shlex.split(whole) == [VALUES[line]]
    assert (
        '\n'.join(complete(ros2, f'ros2 {line} "{VALUES[line][:2]}', strip=False)).replace('\\"', '"') == VALUES[line]
    )
    listed = '\n'.join(complete(ros2, f'ros2 {line} ', strip=False)).splitlines()
    assert '--stdin' in listed and f"\\'{VALUES[line][:2]}" in '\n'.join(listed)


def test_the_hook_for_bash_is_installed_and_registers_ros2(ros2):
    hook = f'{ros2.output("pkg", "prefix", "ros2cli").strip()}/share/ros2cli/environment/ros2-argcomplete.bash'
    done = subprocess.run(
        ['bash', '-c', f'PATH={os.path.dirname(ROS2)}:$PATH; source {hook} && complete -p ros2'],
        capture_output=True,
        text=True,
    )
    assert done.stdout.endswith(' ros2\n'), done


def test_the_first_tab_completes_and_so_does_the_second(ros2):
    prefix = ros2.output('pkg', 'prefix', 'ros2cli').strip()
    environ = {**ros2.environ, 'PATH': f'{os.path.dirname(ROS2)}:{os.environ["PATH"]}', 'TERM': 'dumb'}
    with background(['bash', '--norc', '--noprofile', '-i'], env=environ, terminal=True) as terminal:
        terminal.type(f'source {prefix}/share/ros2cli/environment/ros2-argcomplete.bash\n')
        terminal.type('ros2 pkg prefix ros2topi\t\n')
        terminal.wait_for_output(lambda line: line.strip() == prefix, timeout=60)
        terminal.type('ros2 interface show std_srvs/srv/Set\t\n')
        terminal.wait_for_output('bool success', timeout=60)
