"""The tools that the set-up runs: their environment, their output, their failures, their end."""

import contextlib
import errno
import fcntl
import io
import json
import os
import re
import signal
import subprocess
import sys
import threading
import time
from pathlib import Path

import pytest

from environment.setup import mutex, requirements, startup, tool_processes, tools
from environment.setup.console import Console
from environment.setup.errors import PreflightError, StepError
from environment.setup.layout import Layout
from environment.setup.main import ROOT
from environment.setup.underlay import Underlay

LOCK = Layout(ROOT).requirements.read_text()


@pytest.mark.parametrize(
    ('output', 'named'),
    [
        ('error: failed to write: No space left on device (os error 28)', 'the disk filled up'),
        ('cc1plus: fatal error: Killed signal terminated program cc1plus', 'memory ran out'),
        ('error: Failed to fetch: `http://x/simple/uv/`\n Caused by: dns error', 'cannot be reached'),
        ('ERROR: Could not find a version\nERROR: No matching distribution found for uv==1', 'cannot be reached'),
        ('error: Failed to initialize cache at `/root/.cache/uv`\n  cause: …', 'write to /root/.cache/uv'),
        ('error: Hash mismatch for `rich==1`', 'differs from the lock'),
    ],
)
def test_known_failures_become_one_line(output, named):
    failure = tools.explain('working', output, 'a.log', {})
    assert isinstance(failure, PreflightError)
    assert named in str(failure)
    assert '\n' not in str(failure)


def test_a_password_in_the_index_is_not_shown():
    failure = tools.explain('x', 'dns error', 'a.log', {'PIP_INDEX_URL': 'https://me:secret@mirror/simple'})
    assert 'secret' not in str(failure)
    assert 'https://mirror/simple' in str(failure)


def test_any_other_failure_keeps_the_end_of_its_output():
    failure = tools.explain('building', '\n'.join(map(str, range(50))), 'a.log', {})
    assert isinstance(failure, StepError)
    assert failure.tail.splitlines() == [str(n) for n in range(30, 50)]


def test_tools_see_neither_another_ros_nor_another_environment(tmp_path):
    layout = Layout(tmp_path)
    dirty = {
        'PATH': '/bin',
        'PYTHONPATH': '/opt/ros/humble/lib',
        'AMENT_PREFIX_PATH': '/opt/ros/humble',
        '_ROS_WHEELS_BOOTSTRAP_COMPLETE': '1',
        'PIP_INDEX_URL': 'https://mirror',
    }
    env = tools.environment(dirty, layout, Underlay())
    assert 'PYTHONPATH' not in env
    assert '_ROS_WHEELS_BOOTSTRAP_COMPLETE' not in env
    assert env['AMENT_PREFIX_PATH'] == str(layout.prefix)
    assert env['PATH'] == f'{layout.prefix}/bin:/bin'
    assert env['PIP_INDEX_URL'] == 'https://mirror'


def test_tools_keep_a_stock_ros(tmp_path):
    ros = Underlay((Path('/opt/ros/jazzy'),))
    env = tools.environment({'PYTHONPATH': '/opt/ros/jazzy/lib'}, Layout(tmp_path), ros)
    assert env['PYTHONPATH'] == '/opt/ros/jazzy/lib'
    assert env['AMENT_PREFIX_PATH'] == f'{tmp_path}/.venv:/opt/ros/jazzy'


def test_uv_gets_what_pip_is_told():
    config = "global.index-url='https://mirror/simple'\nglobal.cert='/ca.pem'\n:env:.index-url='https://other/simple'\n"
    assert requirements.for_uv({}, config) == {'UV_DEFAULT_INDEX': 'https://other/simple', 'SSL_CERT_FILE': '/ca.pem'}
    assert 'UV_DEFAULT_INDEX' not in requirements.for_uv({'UV_INDEX_URL': 'https://mine'}, config)


def test_the_lock_pins_the_installer_and_hashes_everything():
    assert requirements.entry(LOCK, 'uv').count('--hash=sha256:') > 3
    blocks = re.split(r'^(?=[A-Za-z0-9])', LOCK, flags=re.MULTILINE)[1:]
    assert len(blocks) > 200
    assert all('--hash=sha256:' in block for block in blocks)


def test_the_lock_has_all_that_is_asked_for():
    asked = (ROOT / 'environment' / 'requirements.in').read_text().splitlines()
    names = {line.split('=')[0].split('<')[0].strip().lower() for line in asked if line and not line.startswith('#')}
    assert names <= {name.lower() for name in requirements.names(LOCK)}


def test_what_shares_files_with_a_removed_package_is_known(tmp_path):
    for name, files in (('lark', 'lark/a.py'), ('lark_parser', 'lark/a.py\nlark/old.py'), ('Other.One', 'other/a.py')):
        record = tmp_path / f'{name}-1.dist-info'
        record.mkdir()
        (record / 'METADATA').write_text(f'Metadata-Version: 2.1\nName: {name}\nVersion: 1\n')
        (record / 'RECORD').write_text(''.join(f'{file},,\n' for file in files.splitlines()))
        for file in files.splitlines():  # from Python 3.12 on, files that are not there are not told
            (tmp_path / file).parent.mkdir(exist_ok=True)
            (tmp_path / file).touch()
    assert requirements.sharing(tmp_path, ['lark-parser', 'never-there']) == ['lark']
    assert requirements.sharing(tmp_path, ['other-one']) == []


def test_output_goes_to_the_log_and_to_the_listener(tmp_path):
    seen = []
    status, output = tool_processes.run(
        ['sh', '-c', 'echo one; echo two >&2; printf three; exit 5'],
        tmp_path / 'log' / 'a.log',
        os.environ,
        seen.append,
    )
    assert status == 5
    assert output == 'one\ntwo\nthree'
    assert [line for line in seen if line] == ['one\n', 'two\n', 'three']
    assert (tmp_path / 'log' / 'a.log').read_text() == output


def gone(process: int, timeout: float = 5.0) -> bool:
    """Whether the process ends within `timeout` seconds (a zombie has ended)."""
    end = time.monotonic() + timeout
    while time.monotonic() < end:
        try:
            if Path(f'/proc/{process}/stat').read_text().rpartition(')')[2].split()[0] == 'Z':
                return True
        except (FileNotFoundError, ProcessLookupError):
            return True
        time.sleep(0.01)
    return False


def test_an_interruption_ends_the_tool_and_its_children(tmp_path):
    def interrupt(line):
        if line.startswith('ready'):
            raise KeyboardInterrupt

    started = time.monotonic()
    with pytest.raises(KeyboardInterrupt):
        tool_processes.run(
            ['sh', '-c', f'sleep 60 & echo $! > {tmp_path}/child; echo ready; wait'],
            tmp_path / 'a.log', os.environ, interrupt,
        )  # fmt: skip
    assert time.monotonic() - started < tool_processes.GRACE + 5
    child = int((tmp_path / 'child').read_text())
    assert gone(child)


@pytest.mark.parametrize('number', [errno.ENOLCK, errno.ENOSYS, errno.EOPNOTSUPP, errno.EIO])
def test_a_disk_without_locks_stops_no_set_up(tmp_path, monkeypatch, number):
    """A home on NFS whose server has no lock daemon, and others; a disk that is broken is told."""

    def flock(*arguments):
        raise OSError(number, os.strerror(number))

    monkeypatch.setattr(fcntl, 'flock', flock)
    raised = pytest.raises(OSError) if number == errno.EIO else contextlib.nullcontext()
    with raised, mutex.exclusive(tmp_path / 'lock', print) as descriptor:
        assert os.fstat(descriptor)


def test_a_second_one_waits_for_the_lock(tmp_path):
    path, order = tmp_path / 'lock', []
    waiting, first_in = threading.Event(), threading.Event()

    def first():
        with mutex.exclusive(path, order.append):
            first_in.set()
            assert waiting.wait(10)
            order.append('first')

    thread = threading.Thread(target=first)
    thread.start()
    assert first_in.wait(10)

    def on_wait(process):
        order.append(process)
        waiting.set()

    with mutex.exclusive(path, on_wait):
        order.append('second')
    thread.join(10)
    assert order == [str(os.getpid()), 'first', 'second']


def test_the_lock_lasts_as_long_as_a_killed_set_ups_tool(tmp_path):
    """The set-up is killed, its compiler goes on: nobody may start to build meanwhile."""
    code = (
        f'import sys, os; sys.path.insert(0, {str(ROOT)!r})\n'
        'from environment.setup import mutex, tool_processes\n'
        'from pathlib import Path\n'
        f'with mutex.exclusive(Path({str(tmp_path / "lock")!r}), print) as lock:\n'
        f'    tool_processes.run(["sh", "-c", "echo $$; exec sleep 60"], Path({str(tmp_path / "log")!r}), os.environ,\n'
        '                  lambda line: print(line, end="", flush=True), keep=(lock,))\n'
    )
    command = [getattr(sys, '_base_executable', sys.executable), '-ESc', code]
    holder = subprocess.Popen(command, stdout=subprocess.PIPE, text=True)
    tool = int(holder.stdout.readline())
    holder.kill()
    holder.wait()
    holder.stdout.close()
    waited = []

    def on_wait(process):
        waited.append(int(process))
        os.kill(tool, signal.SIGKILL)

    with mutex.exclusive(tmp_path / 'lock', on_wait):
        assert waited == [holder.pid]


def test_progress_off_a_terminal_is_plain_lines():
    stream = io.StringIO()
    console = Console(stream)
    console.begin('Working')
    console.update('detail')
    console.end()
    first, second = stream.getvalue().splitlines()
    assert first == 'Working ...'
    assert second.startswith('Working: 0.')


def test_start_up_gives_defaults_and_respects_what_is_set(tmp_path):
    env = {'ROS_AUTOMATIC_DISCOVERY_RANGE': 'SUBNET'}
    startup.activate(env, str(tmp_path))
    assert env['ROS_AUTOMATIC_DISCOVERY_RANGE'] == 'SUBNET'
    assert env['ROS_PYTHON_CHECK_FIELDS'] == '1'
    assert env['AMENT_PREFIX_PATH'] == str(tmp_path)
    before = dict(env)
    startup.activate(env, str(tmp_path))
    assert env == before


def test_the_readme_lists_what_differs_from_a_stock_ros():
    rows = re.findall(r'^\| `(\w+)` \| (.*) \| `?([^|`]+)`? \| .* \|$', (ROOT / 'README.md').read_text(), re.MULTILINE)
    told = {name: here for name, _, here in rows}
    assert startup.DEFAULTS.items() <= told.items()
    assert {'ROS_DOMAIN_ID', 'ROS_HOME', 'FASTRTPS_DEFAULT_PROFILES_FILE'} <= set(told)
    assert told['FASTRTPS_DEFAULT_PROFILES_FILE'] == f'.venv/{startup.PROFILE}'


def test_start_up_names_the_profile_of_fast_dds_where_it_is_installed(tmp_path):
    env = {}
    startup.activate(env, str(tmp_path))
    assert 'FASTRTPS_DEFAULT_PROFILES_FILE' not in env
    profile = tmp_path / startup.PROFILE
    profile.parent.mkdir(parents=True)
    profile.touch()
    startup.activate(env, str(tmp_path))
    assert env['FASTRTPS_DEFAULT_PROFILES_FILE'] == str(profile)
    own = {'FASTRTPS_DEFAULT_PROFILES_FILE': '/home/me/robot.xml'}
    startup.activate(own, str(tmp_path))
    assert own['FASTRTPS_DEFAULT_PROFILES_FILE'] == '/home/me/robot.xml'


def test_cmake_builds_with_ninja_where_there_is_no_make(tmp_path):
    tools, prefix = tmp_path / 'tools', tmp_path / 'prefix'
    for path in (tools / 'make', prefix / 'bin' / 'ninja'):
        path.parent.mkdir(parents=True)
        path.touch(0o755)
    for given, path, generator in (
        ({}, f'{tmp_path}/none', 'Ninja'),
        ({}, f'{tmp_path}/none:{tools}', None),
        ({'CMAKE_GENERATOR': 'Unix Makefiles'}, f'{tmp_path}/none', 'Unix Makefiles'),
        ({'COURSE_STOCK': '1'}, f'{tmp_path}/none', 'Ninja'),
    ):
        env = {'PATH': path, **given}
        startup.activate(env, str(prefix))
        assert env.get('CMAKE_GENERATOR') == generator
    env = {'PATH': f'{tmp_path}/none'}
    startup.activate(env, str(tmp_path))  # no Ninja, either: CMake says what it misses
    assert 'CMAKE_GENERATOR' not in env


def test_a_middleware_that_is_not_here_does_not_count_for_who_starts_a_kernel(tmp_path):
    prefix, overlay = tmp_path / 'prefix', tmp_path / 'overlay'
    for library in (prefix / 'lib' / 'librmw_fastrtps_cpp.so', overlay / 'lib' / 'librmw_zenoh_cpp.so'):
        library.parent.mkdir(parents=True)
        library.touch()
    middleware = {'rmw_fastrtps_cpp': True, 'rmw_zenoh_cpp': True, 'rmw_cyclonedds_cpp': False, '': False}
    for given, kept in middleware.items():
        env = {'RMW_IMPLEMENTATION': given, 'AMENT_PREFIX_PATH': f'{overlay}:/gone'}
        startup.activate(env, str(prefix))
        assert env['RMW_IMPLEMENTATION'] == given, 'any program but a kernel'
        startup.complete_kernel(env, str(prefix))
        assert ('RMW_IMPLEMENTATION' in env) == kept, given


def test_settings_of_another_ros_do_not_count_for_who_starts_a_kernel(tmp_path):
    for given, left in (
        ({'ROS_LOCALHOST_ONLY': '1'}, {}),
        ({'ROS_LOCALHOST_ONLY': '1', 'ROS_AUTOMATIC_DISCOVERY_RANGE': 'SUBNET'}, {}),
        ({'ROS_LOCALHOST_ONLY': '0'}, {'ROS_LOCALHOST_ONLY': '0'}),
        ({'ROS_DISCOVERY_SERVER': '10.0.0.5:11811;', 'ROS_SUPER_CLIENT': 'True'}, {}),
    ):
        env = dict(given)
        startup.activate(env, str(tmp_path))
        assert env.items() >= given.items(), 'any program but a kernel'
        startup.complete_kernel(env, str(tmp_path))
        assert env['ROS_AUTOMATIC_DISCOVERY_RANGE'] == 'LOCALHOST'
        others = ('ROS_LOCALHOST_ONLY', 'ROS_DISCOVERY_SERVER', 'ROS_SUPER_CLIENT')
        assert {name: value for name, value in env.items() if name in others} == left


def test_programs_of_a_kernel_print_tracebacks_without_colours(tmp_path):
    env = {'PATH': os.defpath, 'FORCE_COLOR': '1'}
    startup.complete_kernel(env, str(tmp_path))
    program = [sys.executable, '-c', 'import missing']
    done = subprocess.run(program, env={**os.environ, **env}, capture_output=True, text=True)
    assert done.stderr.splitlines()[-1] == "ModuleNotFoundError: No module named 'missing'"


def test_a_workspace_stays_on_top_of_the_wheels(tmp_path):
    (tmp_path / 'share' / 'rclpy').mkdir(parents=True)
    env = {'AMENT_PREFIX_PATH': '/ws/install'}
    startup.activate(env, str(tmp_path))
    assert env['AMENT_PREFIX_PATH'] == f'/ws/install:{tmp_path}'


def test_another_environments_guard_is_dropped(tmp_path):
    other = tmp_path / 'other'
    (other / 'lib').mkdir(parents=True)
    (other / 'pyvenv.cfg').touch()
    libs = f'{other}/lib:{other}/lib/python3.12/site-packages/ros_rcl.libs:/usr/lib/mine'
    env = {'_ROS_WHEELS_BOOTSTRAP_COMPLETE': '1', 'LD_LIBRARY_PATH': libs}
    startup.drop_foreign_guard(env, str(tmp_path / 'own'))
    assert env == {'LD_LIBRARY_PATH': '/usr/lib/mine'}


def test_the_own_guard_stays(tmp_path):
    env = {'_ROS_WHEELS_BOOTSTRAP_COMPLETE': '1', 'LD_LIBRARY_PATH': f'{tmp_path}/lib'}
    before = dict(env)
    startup.drop_foreign_guard(env, str(tmp_path))
    assert env == before


def test_the_bootstrapper_is_left_out_where_the_libraries_are_known(tmp_path):
    packages = tmp_path / 'lib' / 'python3.12' / 'site-packages'
    (packages / 'ros_rcl.libs').mkdir(parents=True)
    (packages / 'rclpy').mkdir()
    own, of_rcl = str(tmp_path / 'lib'), str(packages / 'ros_rcl.libs')
    for libraries, guard, known in (
        ('', None, False),
        (own, None, False),  # what sourcing sets
        (of_rcl, None, False),
        (f'{of_rcl}:/opt/lib:{own}', None, True),
        (own, '1', True),
        ('/opt/lib', '1', False),
    ):
        env, modules = {'LD_LIBRARY_PATH': libraries}, {}
        if guard:
            env[startup.GUARD] = guard
        startup.spare_the_bootstrapper(env, str(tmp_path), str(packages), modules)
        assert (startup.BOOTSTRAPPER in modules) == known, (libraries, guard)
        assert env.get(startup.GUARD) == ('1' if known else guard)
    env, modules = {'LD_LIBRARY_PATH': own}, {}
    startup.spare_the_bootstrapper(env, str(tmp_path), str(tmp_path), modules)  # on a stock ROS there are no wheels
    assert env == {'LD_LIBRARY_PATH': own} and not modules


def test_in_a_terminal_python_starts_once(clean_environ):
    """In the real environment: the libraries are those that the bootstrapper finds, also without its guard."""
    code = 'import json, os, sys; print(json.dumps([dict(os.environ), "pathlib" in sys.modules])); import rclpy'
    seen = []
    for env in (clean_environ, None):
        if env is None:  # as what the first one has started, in a terminal
            env = {name: value for name, value in seen[0][0].items() if name != startup.GUARD}
        answer = subprocess.run([sys.executable, '-c', code], env=env, capture_output=True, text=True, timeout=60)
        assert answer.returncode == 0, answer.stderr
        seen.append(json.loads(answer.stdout))
    (first, _), (second, loaded) = seen
    assert first['LD_LIBRARY_PATH'] == second['LD_LIBRARY_PATH']
    assert second[startup.GUARD] == '1' and not loaded


def test_the_environments_python_repairs_an_inherited_guard(clean_environ):
    """In the real environment: a guard from elsewhere must not keep rclpy from its libraries."""
    env = {**clean_environ, '_ROS_WHEELS_BOOTSTRAP_COMPLETE': '1', 'LD_LIBRARY_PATH': '/nowhere'}
    code = 'import os, json, rclpy; print(json.dumps(dict(os.environ)))'
    answer = subprocess.run([sys.executable, '-c', code], env=env, capture_output=True, text=True, timeout=60)
    assert answer.returncode == 0, answer.stderr
    seen = json.loads(answer.stdout)
    assert f'{sys.prefix}/lib' in seen['LD_LIBRARY_PATH'].split(':')
    assert sys.prefix in seen['AMENT_PREFIX_PATH'].split(':')


def test_users_of_a_hub_have_domains_of_their_own(tmp_path):
    alone, mine, chosen = {}, {'JUPYTERHUB_USER': 'ada'}, {'JUPYTERHUB_USER': 'ada', 'ROS_DOMAIN_ID': '7'}
    for environ in (alone, mine, chosen):
        startup.share_the_machine(environ, 1001)
    assert 'ROS_DOMAIN_ID' not in alone
    assert (mine['ROS_DOMAIN_ID'], chosen['ROS_DOMAIN_ID']) == ('2', '7')
    startup.activate(mine, str(tmp_path))
    assert mine['ROS_DOMAIN_ID'] == '2'


def test_a_kernel_that_another_server_starts_finds_ros_and_its_programs():
    code = 'import json, os; print(json.dumps(dict(os.environ)))'
    answers = [
        subprocess.run(
            [sys.executable, '-c', code, *more],
            env={'PATH': '/usr/bin'},
            capture_output=True,
            check=True,
            text=True,
            timeout=60,
        ).stdout
        for more in ((), ('ipykernel_launcher',))
    ]
    plain, kernel = map(json.loads, answers)
    assert plain['PATH'] == '/usr/bin'
    assert kernel['PATH'] == f'{sys.prefix}/bin:/usr/bin'
    assert kernel['ROS_DISTRO'] == 'jazzy'


def test_programs_write_into_the_courses_folder_unless_it_is_another_users(tmp_path):
    prefix, own, foreign = tmp_path / '.venv', {'ROS_HOME': '/mine'}, {}
    startup.keep_to_the_folder(foreign, str(prefix), startup.FOLDERS)
    assert foreign == {}, 'no course that is ours'
    (tmp_path / 'course').touch()
    startup.keep_to_the_folder(own, str(prefix), startup.FOLDERS)
    assert own['ROS_HOME'] == '/mine' and own['IPYTHONDIR'] == str(tmp_path / '.home' / 'ipython')
    assert (tmp_path / '.home').is_dir()
    learners = {'COURSE_RUNNER': '1'}
    startup.keep_to_the_folder(learners, str(prefix), startup.FOLDERS)
    assert learners == {'COURSE_RUNNER': '1'}


def test_programs_of_a_copy_speak_in_its_domain(tmp_path):
    (tmp_path / '.course').mkdir()
    (tmp_path / startup.DOMAIN).write_text('17\n')
    for before, expected in (
        ({}, '17'),
        ({'ROS_DOMAIN_ID': '3'}, '3'),
        ({startup.STOCK: '1'}, None),
        ({'JUPYTERHUB_USER': 'ada'}, str(1 + os.getuid() % 100)),
    ):
        startup.activate(before, str(tmp_path))
        assert before.get('ROS_DOMAIN_ID') == expected
