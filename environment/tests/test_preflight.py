"""What a machine does not have: one line, its remedy, and status 2 before anything is made."""

import errno
import json
import os
import subprocess
import sys
from pathlib import Path
from types import SimpleNamespace

import pytest

from environment.setup import preflight
from environment.setup.errors import PreflightError
from environment.setup.layout import Layout
from environment.setup.main import ROOT
from environment.setup.stamps import Stamps
from environment.setup.steps import VERSION
from environment.setup.underlay import Underlay


@pytest.mark.parametrize(
    ('system', 'machine', 'libc', 'named'),
    [
        ('Linux', 'aarch64', ('glibc', '2.39'), 'aarch64'),
        ('Darwin', 'arm64', ('', ''), 'Darwin'),
        ('Linux', 'x86_64', ('glibc', '2.27'), '2.27'),
        ('Linux', 'x86_64', ('', ''), 'another C library'),
    ],
)
def test_platforms_without_wheels(system, machine, libc, named):
    with pytest.raises(PreflightError, match=named) as error:
        preflight.check_platform(system, machine, libc)
    assert 'conda create' in error.value.remedy


def test_platform_with_wheels():
    preflight.check_platform('Linux', 'x86_64', ('glibc', '2.28'))


def test_no_compiler(tmp_path):
    with pytest.raises(PreflightError, match='no C compiler') as error:
        preflight.check_compiler({'PATH': str(tmp_path)})
    assert error.value.remedy == 'run: sudo apt install g++'


def test_no_cpp_compiler(tool):
    path = tool('cc', 'exit 0')
    with pytest.raises(PreflightError, match=r'no C\+\+ compiler'):
        preflight.check_compiler({'PATH': str(path)})


def test_a_compiler_that_does_not_work(tool):
    path = tool('cc', 'exit 0')
    tool('c++', 'echo "probe.cpp:1:10: fatal error: string: No such file" >&2; exit 1')
    with pytest.raises(PreflightError, match='string: No such file'):
        preflight.check_compiler({'PATH': f'{path}:{os.environ["PATH"]}'})


def test_compiler_named_by_the_user(tool):
    path = tool('mycc', 'exit 0')
    preflight.check_compiler({'PATH': f'{path}:/bin:/usr/bin', 'CC': 'mycc -O2', 'CXX': 'mycc'})


def test_no_room(tmp_path):
    preflight.check_space(tmp_path, 0)
    with pytest.raises(PreflightError, match='no room'):
        preflight.check_space(tmp_path, 10**18)


@pytest.mark.parametrize('name', ['ros2-course', 'Jörg', 'ROS学习', 'a_b.c-d+e', 'a@b~c'])
def test_folders_of_any_language_are_fine(name):
    preflight.check_path(Path('/home', name), Underlay(), 'UTF-8')


@pytest.mark.parametrize(
    ('name', 'named'),
    [
        ('My Courses', 'a space'),
        ('course(1)', r"'\('"),
        ("it's", '"\'"'),
        ('a,b', "','"),
        ('a;b', "';'"),
        ('a:b', "':'"),
        ('a=b', "'='"),
        ('a#b', "'#'"),  # apt's lists of sources, and much else, end there
        ('a\u00a0b', r"'\\xa0'"),  # a space that looks like one, and is another character
        ('a\nb', r"'\\n'"),
        (os.fsdecode(b'J\xf6rg'), r"'\\udcf6'"),  # not UTF-8
    ],
)
def test_folders_that_the_tools_of_ros_cannot_read(name, named):
    with pytest.raises(PreflightError, match=f'has {named}, and the tools of ROS') as error:
        preflight.check_path(Path('/home', name), Underlay(), 'UTF-8')
    str(error.value).encode()  # it can be printed
    assert error.value.remedy.startswith('move or rename the folder')


@pytest.mark.parametrize('encoding', ['ISO-8859-1', 'ANSI_X3.4-1968'])
def test_letters_that_the_locale_does_not_have(encoding):
    preflight.check_path(Path('/home/jorg'), Underlay(), encoding)
    with pytest.raises(PreflightError, match=f'its locale is {encoding}') as error:
        preflight.check_path(Path('/home/Jörg'), Underlay(), encoding)
    assert error.value.remedy.startswith('run: export LC_ALL=C.UTF-8')


def test_a_disk_without_links_is_refused(tmp_path, monkeypatch):
    def no_link(*_):
        raise PermissionError(errno.EPERM, os.strerror(errno.EPERM))

    preflight.check_file_system(tmp_path)
    monkeypatch.setattr(os, 'symlink', no_link)
    with pytest.raises(PreflightError) as refusal:
        preflight.check_file_system(tmp_path)
    assert 'symbolic links (operation not permitted)' in refusal.value.what and 'home' in refusal.value.remedy
    assert not list(tmp_path.iterdir())


def test_a_disk_without_programs_is_refused(tmp_path, monkeypatch):
    monkeypatch.setattr(os, 'statvfs', lambda path: SimpleNamespace(f_flag=os.ST_NOEXEC))
    with pytest.raises(PreflightError) as refusal:
        preflight.check_file_system(tmp_path)
    assert 'noexec' in refusal.value.what


def test_a_stock_ros_reads_ascii_only(tmp_path):
    with pytest.raises(PreflightError, match="has 'ö'"):
        preflight.check_path(Path('/home/Jörg'), Underlay((tmp_path,)), 'UTF-8')


def test_the_script_names_a_missing_python(tmp_path):
    """The shell part of `course`, where no Python is new enough."""
    for name in ('dirname', 'readlink'):
        (tmp_path / name).symlink_to(f'/usr/bin/{name}')
    script = tmp_path / 'course'
    script.write_text((ROOT / 'course').read_text().replace('/usr/bin/python3', '/no/python3'))
    answer = subprocess.run(['/bin/sh', script], env={'PATH': str(tmp_path)}, capture_output=True, text=True)
    assert answer.returncode == 2
    assert 'sudo apt-get install g++ python3-dev python3-venv' in answer.stderr
    assert len(answer.stderr.splitlines()) == 1


def run_main(root, environ):
    """`./course doctor` of another root, in its own process."""
    code = (
        'import sys; from pathlib import Path; sys.path.insert(0, sys.argv[1]); '
        'from environment.setup.main import main; sys.exit(main(["doctor"], Path(sys.argv[2])))'
    )
    command = [getattr(sys, '_base_executable', sys.executable), '-ES', '-c', code, str(ROOT), str(root)]
    return subprocess.run(command, env=environ, capture_output=True, text=True, timeout=60)


def test_a_lack_is_one_line_and_leaves_nothing(checkout: Layout, clean_environ, tool):
    # Everything is there except the compiler.
    path = tool('dirname', 'exit 0')
    answer = run_main(checkout.root, {**clean_environ, 'PATH': str(path)})
    assert answer.returncode == 2, answer.stderr
    assert answer.stderr.splitlines() == ['course: no C compiler (cc, gcc, clang) on PATH; run: sudo apt install g++']
    assert not checkout.prefix.exists()


def test_an_index_out_of_reach_leaves_nothing(checkout: Layout, clean_environ):
    checkout.requirements.write_text(f'uv==0.0.1 --hash=sha256:{"0" * 64}\n')
    environ = {
        **{n: v for n, v in clean_environ.items() if not n.startswith(('PIP_', 'UV_'))},
        'PIP_CONFIG_FILE': '/dev/null',
        'PIP_INDEX_URL': 'http://127.0.0.1:9/simple',
        'PIP_RETRIES': '0',
    }
    answer = run_main(checkout.root, environ)
    assert answer.returncode == 2, answer.stderr
    last = answer.stderr.splitlines()[-1]
    assert 'the package index http://127.0.0.1:9/simple cannot be reached' in last
    assert not checkout.prefix.exists()


def test_another_distribution_is_refused_by_the_command(checkout: Layout, clean_environ, stock):
    humble = stock('humble', 'rclpy')
    environ = {**clean_environ, 'ROS_DISTRO': 'humble', 'AMENT_PREFIX_PATH': str(humble)}
    answer = run_main(checkout.root, environ)
    assert answer.returncode == 2
    assert len(answer.stderr.splitlines()) == 1
    assert 'humble' in answer.stderr
    assert not checkout.prefix.exists()


def test_an_environment_upon_a_stock_ros_is_not_rebuilt_without_it(checkout: Layout, clean_environ, stock):
    jazzy = stock('jazzy', 'rclpy')
    made_for = {'setup': VERSION, 'prefix': '/moved', 'python': '/usr/bin/python3', 'underlay': str(jazzy), 'asked': ''}
    Stamps(checkout.state / 'stamps').write('venv', json.dumps(made_for))
    answer = run_main(checkout.root, clean_environ)
    assert answer.returncode == 2
    assert len(answer.stderr.splitlines()) == 1
    assert f'source {jazzy}/setup.bash' in answer.stderr
