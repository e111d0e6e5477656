"""A learner's first hour in an empty home: what it writes, it writes into the course's folder."""

import json
import os
import re
import signal
import subprocess
import time
import urllib.request
from pathlib import Path
from uuid import uuid4

import pytest

from helpers import paths

pytestmark = [pytest.mark.timeout(400), pytest.mark.early]
# Not by the proxy of whoever runs the tests.
DIRECT = urllib.request.build_opener(urllib.request.ProxyHandler({}))
PATIENCE = 120  # s
KEPT = (
    'ROS_',
    'JUPYTER',
    'IPYTHON',
    'MPL',
    'XDG_',
    'COURSE_',
    'AMENT_',
    'COLCON_',
    'RCUTILS',
    'FASTRTPS',
    'PYTHON',
    'CMAKE_',
    'LD_LIBRARY',
    '_ROS',
)
CELL = """
import os, subprocess, rclpy, matplotlib.pyplot as plt
from helpers import ros
from std_msgs.msg import String
ros.start()
node = rclpy.create_node('first')
node.get_logger().info('hello')
plt.plot([1, 2])
print(subprocess.run(['ros2', 'topic', 'list'], capture_output=True, text=True).stdout)
print('domain', os.environ['ROS_DOMAIN_ID'], node.context.get_domain_id())
"""


@pytest.fixture
def environ(tmp_path):
    """What a new user's terminal has: an empty home, and nothing of this course or of another ROS."""
    (tmp_path / 'home').mkdir()
    kept = {name: value for name, value in os.environ.items() if not name.startswith(KEPT)}
    return {**kept, 'HOME': str(tmp_path / 'home')}


def course(environ, *arguments, **options) -> subprocess.CompletedProcess:
    return subprocess.run(
        [paths.ROOT / 'course', *arguments],
        env=environ,
        cwd=paths.ROOT,
        capture_output=True,
        text=True,
        timeout=PATIENCE,
        **options,
    )


def ask(address: str, token: str, path: str, data=None):
    body = None if data is None else json.dumps(data).encode()
    request = urllib.request.Request(address + path, data=body, headers={'Authorization': f'token {token}'})
    with DIRECT.open(request, timeout=PATIENCE) as answer:
        return json.loads(answer.read() or 'null')


def run_cell(address: str, token: str, kernel: str) -> str:
    """Run CELL in a kernel of the server; returns what it prints."""
    import websocket

    url = f'{address.replace("http", "ws", 1)}api/kernels/{kernel}/channels?token={token}'
    channel = websocket.create_connection(url, timeout=PATIENCE)
    header = {
        'msg_id': uuid4().hex,
        'msg_type': 'execute_request',
        'username': '',
        'session': uuid4().hex,
        'version': '5.3',
    }
    channel.send(
        json.dumps(
            {
                'header': header,
                'parent_header': {},
                'metadata': {},
                'channel': 'shell',
                'content': {'code': CELL, 'silent': False, 'store_history': True},
            }
        )
    )
    text = ''
    while True:
        message = json.loads(channel.recv())
        if message['parent_header'].get('msg_id') != header['msg_id']:
            continue
        text += message['content'].get('text', '') + ''.join(message['content'].get('traceback', []))
        if message['msg_type'] == 'status' and message['content']['execution_state'] == 'idle':
            channel.close()
            return text


def in_lab(environ, log: Path) -> str:
    """Start JupyterLab, run a cell in a notebook, end it; returns what the cell printed."""
    with log.open('w') as output:
        server = subprocess.Popen(
            [paths.ROOT / 'course', 'lab', '--no-browser'],
            env=environ,
            cwd=paths.ROOT,
            stdout=output,
            stderr=subprocess.STDOUT,
            start_new_session=True,
        )
    try:
        end = time.monotonic() + PATIENCE
        found = None
        while not found and server.poll() is None and time.monotonic() < end:
            time.sleep(0.1)  # the log has no event to wait for
            found = re.search(r'(http://127\.0\.0\.1:\d+/)\S*token=(\w+)', log.read_text())
        assert found, log.read_text()
        session = ask(
            found[1],
            found[2],
            'api/sessions',
            {'path': '01_environment.ipynb', 'name': '01_environment.ipynb', 'type': 'notebook', 'kernel': {}},
        )
        return run_cell(found[1], found[2], session['kernel']['id'])
    finally:
        server.send_signal(signal.SIGTERM)
        server.wait(PATIENCE)


def below(folder: Path) -> set[str]:
    return {str(path.relative_to(folder)) for path in folder.rglob('*')}


@pytest.mark.one_of(6)
def test_nothing_is_written_into_the_home(environ, tmp_path):
    home = Path(environ['HOME'])
    printed = in_lab(environ, tmp_path / 'lab.log')
    domain = re.search(r'domain (\d+) (\d+)', printed)
    assert domain and domain[1] == domain[2], printed
    assert '/rosout' in printed
    assert below(home) == set(), 'JupyterLab, or its kernel'

    terminal = course(environ, 'shell', '--', 'bash', '-c', 'echo $ROS_DOMAIN_ID; ros2 topic list')
    assert terminal.returncode == 0, terminal.stderr
    assert terminal.stdout.splitlines()[0] == domain[1], 'the terminal and the notebook hear each other'
    assert course(environ, 'check', '1.1').returncode in (0, 1)
    handed_in = course(environ, 'submit', '--id', 'ada', '-o', str(tmp_path / 'ada.zip'))
    assert handed_in.returncode == 0, handed_in.stderr
    assert course(environ, 'doctor').returncode == 0
    assert below(home) == set()
    assert (paths.ROOT / '.home' / 'ros' / 'log').is_dir()


@pytest.mark.parametrize('login', ['/bin/bash', '/usr/bin/zsh', '/no/fish'])
def test_the_shell_is_one_that_the_chapters_lines_are_for(environ, login):
    opened = course({**environ, 'SHELL': login}, 'shell', input='echo "bash $BASH_VERSION"; command -v ros2\nexit 3\n')
    assert opened.returncode == 3
    assert re.search(r'bash \d', opened.stdout) and str(paths.ROOT / '.venv' / 'bin' / 'ros2') in opened.stdout


# As owners of robots have them: for another middleware, for the server of a TurtleBot, for the days before Jazzy.
OF_ANOTHER_ROS = {
    'RMW_IMPLEMENTATION': 'rmw_cyclonedds_cpp',
    'ROS_DISCOVERY_SERVER': '10.0.0.5:11811;',
    'ROS_SUPER_CLIENT': 'True',
    'ROS_LOCALHOST_ONLY': '1',
}


@pytest.mark.parametrize('arguments', [[], ['--', 'bash']])
def test_settings_for_another_ros_do_not_count(environ, arguments):
    lines = [f'export {name}="{value}"\n' for name, value in OF_ANOTHER_ROS.items()]
    Path(environ['HOME'], '.bashrc').write_text(''.join([*lines, 'cd\n']))
    Path(environ['HOME'], 'environment.py').write_text('raise SystemExit("not a module of the course")')
    opened = course({**environ, **OF_ANOTHER_ROS}, 'shell', *arguments, input='env\nros2 topic list\n')
    assert '/rosout' in opened.stdout.splitlines(), opened.stderr
    assert not [name for name in OF_ANOTHER_ROS if f'{name}=' in opened.stdout]
    assert 'RMW_IMPLEMENTATION=rmw_cyclonedds_cpp does not count here' in opened.stderr
    assert 'WARN' not in opened.stderr


def test_a_domain_of_the_users_own_wins(environ):
    chosen = course({**environ, 'ROS_DOMAIN_ID': '42'}, 'shell', '--', 'printenv', 'ROS_DOMAIN_ID')
    assert chosen.stdout == '42\n'


@pytest.mark.one_of(3)
def test_a_stock_shell_has_nothing_of_the_courses_defaults(environ):
    code = 'import os, json; print(json.dumps(dict(os.environ)))'
    shells = [
        json.loads(course(environ, 'shell', *options, '--', 'python3', '-c', code).stdout)
        for options in ((), ('--stock',))
    ]
    names = {
        'ROS_AUTOMATIC_DISCOVERY_RANGE',
        'ROS_PYTHON_CHECK_FIELDS',
        'RCUTILS_COLORIZED_OUTPUT',
        'RCUTILS_CONSOLE_OUTPUT_FORMAT',
        'FASTRTPS_DEFAULT_PROFILES_FILE',
        'ROS_DOMAIN_ID',
        'OPENBLAS_NUM_THREADS',
    }
    assert names <= set(shells[0])
    assert not names & set(shells[1])
    assert shells[1]['ROS_DISTRO'] == 'jazzy'
    own = course({**environ, 'ROS_DOMAIN_ID': '42'}, 'shell', '--stock', '--', 'printenv', 'ROS_DOMAIN_ID')
    assert own.stdout == '42\n'
