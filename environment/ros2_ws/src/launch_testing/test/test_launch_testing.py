"""Launch tests, run as a user runs them: by pytest and by ``launch_test``."""

import io
import os
import re
import subprocess
import sys
import textwrap
import time
import unittest
from types import SimpleNamespace
from xml.etree import ElementTree

import launch
import pytest
from launch import LaunchContext, LaunchDescription, LaunchService
from launch.actions import ExecuteProcess, OpaqueFunction, RegisterEventHandler
from launch.substitutions import LocalSubstitution
from launch_testing import ActiveIoHandler, ActiveProcInfoHandler, ProcInfoHandler, markers
from launch_testing.actions import GTest, PyTest, Test
from launch_testing.asserts import (
    NO_CMD_ARGS,
    SequentialTextChecker,
    assertExitCodes,
    assertInStderr,
    assertInStdout,
    assertSequentialStdout,
)
from launch_testing.event_handlers import StdoutReadyListener
from launch_testing.junitxml import unittestResultsToXml
from launch_testing.loader import TestRun
from launch_testing.test_result import FailResult, SkipResult, TestResult
from launch_testing.tools import ProcessProxy, basic_output_filter, expect_output, expected_output_from_file
from launch_testing.tools.text import normalize_lineseps
from launch_testing.util import NoMatchingProcessException, resolveProcesses
from launch_testing_ros.tools import basic_output_filter as ros_output_filter

pytestmark = pytest.mark.timeout(120)

HEADER = """\
import sys
import unittest

import launch
import launch_testing
import launch_testing.actions
import launch_testing.asserts
import launch_testing.markers
import launch_testing.util
import pytest
from launch.actions import DeclareLaunchArgument, ExecuteProcess, TimerAction
from launch.substitutions import LaunchConfiguration

LOOP = 'import time; print("tick", flush=True); print("warn", file=sys.stderr, flush=True); time.sleep(100)'
"""

EXAMPLES = """
import os

from ament_index_python import get_package_prefix
from launch_testing.asserts import assertExitCodes, assertSequentialStdout

FOLDER = os.path.join(get_package_prefix('launch_testing'), 'lib', 'launch_testing')


def start(name, *words):
    environment = {'PYTHONUNBUFFERED': '1'}
    return launch.actions.ExecuteProcess(
        cmd=[sys.executable, os.path.join(FOLDER, name), *words], name=name, additional_env=environment
    )


def generate_test_description():
    good, ending, failing = start('good_proc'), start('terminating_proc', '--foo'), start('exit_code_proc', '--silent')
    ready = launch_testing.actions.ReadyToTest()
    return launch.LaunchDescription([good, ending, failing, ready]), locals()


class While(unittest.TestCase):
    def test_output(self, proc_output, proc_info, good, ending, failing):
        proc_output.assertWaitFor('Loop 1', process=good, timeout=30, stream='stdout')
        proc_info.assertWaitForShutdown(process=ending, timeout=30)
        proc_info.assertWaitForShutdown(process=failing, timeout=30)


@launch_testing.post_shutdown_test()
class After(unittest.TestCase):
    def test_all(self, proc_output, proc_info, good, ending, failing):
        with assertSequentialStdout(proc_output, process=good) as output:
            output.assertInStdout('Starting Up')
            output.assertInStdout('Shutting Down')
        with assertSequentialStdout(proc_output, process=ending) as output:
            for text in ('Starting Up', 'Ready', "Called with arguments ['--foo']", 'Emulating Work', 'Done'):
                output.assertInStdout(text)
        assertExitCodes(proc_info, [0], process=good)
        assertExitCodes(proc_info, [0], process=ending)
        assertExitCodes(proc_info, [1], process=failing)
"""

WHOLE = """
@pytest.mark.launch_test
def generate_test_description():
    process = ExecuteProcess(cmd=[sys.executable, '-c', 'import sys, signal\\n'
                                  'signal.signal(signal.SIGINT, lambda *_: sys.exit(0))\\n' + LOOP])
    ready = TimerAction(period=0.1, actions=[launch_testing.actions.ReadyToTest()])
    return launch.LaunchDescription([process, ready]), {'dut': process, 'number': 5}


class TestWhileItRuns(unittest.TestCase):
    @classmethod
    def setUpClass(cls, number):
        cls.number_of_class = number

    def setUp(self, dut):
        self.dut = dut

    def test_output(self, proc_output, proc_info, dut, number):
        proc_info.assertWaitForStartup(process=dut, timeout=30)
        proc_output.assertWaitFor('tick', process=dut, timeout=30, stream='stdout')
        proc_output.assertWaitFor('warn', timeout=30)
        launch_testing.asserts.assertInStderr(proc_output, 'warn', dut)
        self.assertEqual((number, self.number_of_class, self.dut), (5, 5, dut))

    @unittest.skip('not now')
    def test_skipped(self, dut):
        raise AssertionError


@launch_testing.post_shutdown_test()
class TestAfterTheEnd(unittest.TestCase):
    def test_exit(self, proc_info, dut):
        launch_testing.asserts.assertExitCodes(proc_info, process=dut)
        self.assertEqual(proc_info[dut].returncode, 0)
"""


@pytest.fixture
def write(tmp_path):
    """Write a launch test; return its path."""

    def write_one(body, name='test_it.py'):
        path = tmp_path / name
        path.write_text(HEADER + textwrap.dedent(body))
        return path

    return write_one


def run(path, *arguments):
    options = ['-p', 'no:cacheprovider', '-q', '--rootdir', str(path.parent)]
    return _run([sys.executable, '-m', 'pytest', *options, *arguments, str(path)], path)


def _run(command, path):
    return subprocess.run(
        command,
        capture_output=True,
        text=True,
        timeout=100,
        cwd=path.parent,
        stdin=subprocess.DEVNULL,
        env={**os.environ, 'ROS_LOG_DIR': str(path.parent / 'log')},
    )


def launch_test(path, *arguments):
    command = [sys.executable, '-m', 'launch_testing.launch_test', str(path), *arguments]
    return _run(command, path)


def test_a_launch_test_passes_under_pytest_and_by_launch_test(write, tmp_path):
    path = write(WHOLE)
    result = run(path)
    assert result.returncode == 0, result.stdout + result.stderr
    assert '1 passed' in result.stdout
    report = tmp_path / 'report.xml'
    result = launch_test(path, '--junit-xml', str(report), '--package-name', 'mine')
    assert result.returncode == 0, result.stdout + result.stderr
    suite = ElementTree.parse(report).getroot()[0]
    assert {key: suite.get(key) for key in ('name', 'tests', 'failures', 'errors', 'skipped')} == {
        'name': 'mine.test_it.launch_tests',
        'tests': '3',
        'failures': '0',
        'errors': '0',
        'skipped': '1',
    }
    assert {case.get('name') for case in suite} == {'test_output', 'test_skipped', 'test_exit'}


FAILING = [
    ("proc_output.assertWaitFor('tick', timeout=30, stream='stdout')", 'self.fail("before")',
     'TestAfterTheEnd.test_exit failed', 'AssertionError: before'),
    ("proc_output.assertWaitFor('never', process=dut, timeout=0.2)", 'pass', 'TestWhileItRuns.test_output failed',
     'AssertionError: Waiting for output timed out'),
    ("launch_testing.asserts.assertInStdout(proc_output, 'x', 'nobody')", 'pass', 'TestWhileItRuns.test_output failed',
     'NoMatchingProcessException'),
]  # fmt: skip


@pytest.mark.parametrize('before, after, where, message', FAILING)
def test_a_case_that_fails_fails_the_test_and_is_named(write, before, after, where, message):
    body = WHOLE.replace('self.assertEqual((number, self.number_of_class, self.dut), (5, 5, dut))', before)
    path = write(body.replace('self.assertEqual(proc_info[dut].returncode, 0)', after))
    result = run(path)
    assert result.returncode == 1
    assert re.search(f'{re.escape(where)}: .*{re.escape(message)}', result.stdout), 'in one line, for JUnit files'
    assert '1 failed' in result.stdout
    assert '+  where' not in result.stdout  # the message says it all, and pytest explains nothing of launch_testing


def test_launch_test_tells_a_failure_by_its_status_and_in_the_report(write, tmp_path):
    path = write(WHOLE.replace('self.assertEqual(proc_info[dut].returncode, 0)', 'self.fail("no")'))
    report = tmp_path / 'report.xml'
    result = launch_test(path, '--junit-xml', str(report))
    assert result.returncode == 1 and 'FAILED (failures=1)' in result.stderr
    suite = ElementTree.parse(report).getroot()[0]
    (failure,) = suite.iter('failure')
    assert failure.get('message') == 'AssertionError: no' and suite.get('failures') == '1'


@pytest.mark.parametrize(
    'body, message',
    [
        ("def generate_test_description():\n    return launch.LaunchDescription([])\n",
         'must return a LaunchDescription containing a ReadyToTest action'),
        ("def generate_test_description(ready_fn):\n    pass\n", "an unexpected extra argument 'ready_fn'"),
        ("@launch_testing.parametrize('speed', [1, 2])\ndef generate_test_description():\n    pass\n",
         "Could not find an argument of generate_test_description named 'speed'"),
        ("def generate_test_description():\n    return 5\n", 'must return a LaunchDescription, or a tuple of one'),
    ],
)  # fmt: skip
def test_a_wrong_description_says_what_is_wrong(write, body, message):
    path = write('@pytest.mark.launch_test\n' + body)
    result = run(path)
    assert result.returncode == 1 and message in result.stdout
    result = launch_test(path)
    assert result.returncode == 2 and message in result.stderr and 'Traceback' not in result.stderr


def test_processes_that_end_too_early_fail_the_test(write):
    path = write("""
        @pytest.mark.launch_test
        def generate_test_description():
            dies = ExecuteProcess(cmd=['sh', '-c', 'echo gone; exit 3'])
            never = TimerAction(period=100.0, actions=[launch_testing.actions.ReadyToTest()])
            end = launch.actions.RegisterEventHandler(launch.event_handlers.OnProcessExit(
                target_action=dies, on_exit=[launch.actions.Shutdown()]))
            return launch.LaunchDescription([end, dies, never])


        class TestNothing(unittest.TestCase):
            def test_it(self):
                pass
    """)
    result = run(path)
    assert result.returncode == 1
    assert 'Processes under test stopped before tests completed' in result.stdout
    assert "exited with 3\n##### 'sh-1' output #####\ngone" in result.stdout


def test_a_system_that_does_not_become_ready_fails_the_test(write):
    path = write("""
        @pytest.mark.launch_test
        @launch_testing.ready_to_test_action_timeout(0.2)
        def generate_test_description():
            return launch.LaunchDescription([
                launch_testing.util.KeepAliveProc(),
                TimerAction(period=100.0, actions=[launch_testing.actions.ReadyToTest()]),
            ])
    """)
    result = run(path)
    assert result.returncode == 1 and 'Timed out waiting for processes to start up' in result.stdout


def test_keep_alive_parameters_arguments_and_retries(write):
    path = write("""
        @pytest.mark.launch_test
        @launch_testing.parametrize('word, times', [('one', 1), ('two', 2)])
        @launch_testing.markers.keep_alive
        def generate_test_description(word, times):
            return launch.LaunchDescription([
                DeclareLaunchArgument('suffix', default_value='!'),
                ExecuteProcess(cmd=['echo', [word, LaunchConfiguration('suffix')]]),
                launch_testing.actions.ReadyToTest(),
            ])


        TRIES = []


        class TestEcho(unittest.TestCase):
            def test_word(self, proc_output, word, test_args):
                proc_output.assertWaitFor(word + test_args.get('suffix', '!'), timeout=30, stream='stdout')

            @launch_testing.markers.retry_on_failure(times=3)
            def test_third_time(self, word):
                TRIES.append(word)
                self.assertGreaterEqual(TRIES.count(word), 3)
    """)
    result = run(path, '--launch-args', 'suffix:=?', '--')
    assert result.returncode == 0, result.stdout + result.stderr
    result = launch_test(path, 'suffix:=.')
    assert result.returncode == 0, result.stdout + result.stderr
    assert 'Starting test run 2' in result.stdout and 'test_word[two, 2]' in result.stderr
    shown = launch_test(path, '--show-args')
    assert shown.returncode == 0 and "'suffix':" in shown.stdout and "(default: '!')" in shown.stdout
    assert launch_test(path.with_name('none.py')).returncode == 2


def test_a_module_without_the_mark_is_one_like_any_other(write):
    path = write("""
        def generate_test_description():
            return launch.LaunchDescription([launch_testing.actions.ReadyToTest()])


        def test_plain():
            assert generate_test_description()
    """)
    assert '1 passed' in run(path).stdout


def test_a_skipped_description_skips_the_test(write):
    path = write("""
        @pytest.mark.launch_test
        @unittest.skip('no robot here')
        def generate_test_description():
            return launch.LaunchDescription([launch_testing.actions.ReadyToTest()])
    """)
    assert '1 skipped' in run(path).stdout


# --- assertions --------------------------------------------------------------------------------------------------


class _Process(ExecuteProcess):
    """A process that has run already."""

    def __init__(self, name, *arguments):
        super().__init__(cmd=['x'])
        self._details = {'name': name, 'cmd': ['x', *arguments]}


def _wrote(process, text, stream='stdout'):
    return SimpleNamespace(
        action=process,
        process_name=process.process_name,
        text=text.encode(),
        from_stdout=stream == 'stdout',
        from_stderr=stream == 'stderr',
    )


def test_outputs_are_found_as_text_pattern_and_lines():
    output, process = ActiveIoHandler(), _Process('talker-1')
    for text in ('one\ntw', 'o\nthree\n', '\x1b[32mgreen\x1b[0m\n'):
        output.append(_wrote(process, text))
    output.append(_wrote(process, 'bad\n', 'stderr'))
    two, green = re.compile('t.o\nthree'), re.compile('gr..n')
    for expected in ('two', two, ['one', 'three'], [re.compile('one'), green], 'green'):
        assertInStdout(output, expected, process)
    assertInStderr(output, 'bad', 'talker')
    for wrong in ('four', 'bad', ['three', 'one'], ['tw'], [re.compile('three'), re.compile('one')]):
        with pytest.raises(AssertionError, match='for any of the matching processes: talker-1'):
            assertInStdout(output, wrong, process)
    with pytest.raises(ValueError, match='Unknown format'):
        assertInStdout(output, 5, process)
    with assertSequentialStdout(output, 'talker') as checker:
        checker.assertInStdout('one')
        checker.assertInStdout('three')
        with pytest.raises(AssertionError, match="'two' not found in sequence"):
            checker.assertInStdout('two')
        checker.assertInStdout('bad')  # of the standard error, where nodes log
    assert output.waitFor('green', timeout=0.0, stream='stdout') and not output.waitFor('blue', timeout=0.0)
    with pytest.raises(RuntimeError, match="no processes matching 'nobody'"):
        output.waitFor('x', process='nobody', timeout=0.0)
    assert SequentialTextChecker(['a\nb']).get_nearby_lines() == 'a\nb'
    for last in ('c', 'c\n'):
        sequence = SequentialTextChecker(['a\nb\nc\n', 'd\ne\nf\ng\n'])
        sequence.assertInText(last)
        assert sequence.get_nearby_lines() == ('a\nb\nc\nd\ne\nf' if last == 'c' else 'a\nb\ncd\ne\nf')


def test_processes_are_found_by_name_and_arguments():
    infos = ProcInfoHandler()
    one, two = _Process('node-1', '--a'), _Process('node-2')
    for process, code in ((one, 0), (two, 3)):
        infos.append(SimpleNamespace(action=process, process_name=process.process_name, returncode=code))
    assert resolveProcesses(infos) == [one, two]
    assert resolveProcesses(infos, process='node', cmd_args='--a') == [one]
    assert resolveProcesses(infos, process='node', cmd_args=NO_CMD_ARGS) == [two]
    assert resolveProcesses(infos, process=two) == [two] and infos['node-2'].returncode == 3
    with pytest.raises(RuntimeError, match="Found multiple processes matching name 'node'"):
        resolveProcesses(infos, process='node')
    with pytest.raises(NoMatchingProcessException, match="Did not find any processes matching name 'x'"):
        resolveProcesses(infos, process='x')
    with pytest.raises(TypeError):
        resolveProcesses(infos, process=5)
    waiting = ExecuteProcess(cmd=['python', '-c', ''])
    with pytest.raises(NoMatchingProcessException, match='No data recorded for proc python -c'):
        resolveProcesses(infos, process=waiting)
    unknown = ExecuteProcess(cmd=[LocalSubstitution('foo'), 'python'])
    with pytest.raises(NoMatchingProcessException, match='Unknown'):
        resolveProcesses(infos, process=unknown)
    assertExitCodes(infos, process=one)
    assertExitCodes(infos, [0, 3])
    with pytest.raises(AssertionError, match='Proc node-2 exited with code 3'):
        assertExitCodes(infos)
    with pytest.raises(ValueError, match='at least 1'):
        markers.retry_on_failure(times=0)


WITH_TOOLS = """
import functools
import re
from launch_testing.tools import ProcessProxy, basic_output_filter, expect_output, launch_process

TALK = 'import sys; print("rc 0"); print("one"); print("two"); print("three", file=sys.stderr); sys.exit(3)'
ECHO = 'import signal\\nsignal.signal(signal.SIGINT, lambda *_: sys.exit(0))\\n' + 'import sys\\n' + LOOP


@pytest.mark.launch_test
@launch_testing.markers.keep_alive
def generate_test_description():
    process = ExecuteProcess(cmd=[sys.executable, '-c', ECHO])
    return launch.LaunchDescription([process, launch_testing.actions.ReadyToTest()]), {'process': process}


class TestWhileItRuns(unittest.TestCase):
    def test_a_program_of_its_own(self, launch_service, proc_info, proc_output):
        action = ExecuteProcess(cmd=[sys.executable, '-c', TALK])
        with launch_process(
            launch_service, action, proc_info, proc_output, output_filter=basic_output_filter()
        ) as talk:
            self.assertTrue(talk.wait_for_shutdown(timeout=30))
        self.assertEqual((talk.exit_code, talk.stdout, talk.stderr), (3, 'one\\ntwo\\n', 'three\\n'))
        self.assertTrue(expect_output(expected_lines=['one', re.compile('t[w]o')], text=talk.stdout, strict=True))
        self.assertFalse(talk.running)

    def test_a_program_is_ended_with_the_block(self, launch_service, proc_info, proc_output):
        action = ExecuteProcess(cmd=[sys.executable, '-c', ECHO])
        with launch_process(launch_service, action, proc_info, proc_output) as echo:
            told = echo.wait_for_output(functools.partial(expect_output, expected_lines=['tick']), timeout=30)
            self.assertTrue(told)
            self.assertIn('tick', repr(told))
            self.assertFalse(echo.wait_for_output(lambda text: 'never' in text, timeout=0.2))
        self.assertTrue(echo.wait_for_shutdown(timeout=30))

    def test_a_program_of_the_description(self, process, proc_info, proc_output):
        proxy = ProcessProxy(process, proc_info, proc_output)
        self.assertTrue(proxy.wait_for_output(timeout=30))
        self.assertTrue(proxy.running)
        with self.assertRaises(TypeError):
            ProcessProxy('process', proc_info, proc_output)
"""


def test_programs_are_started_by_tests(write):
    result = launch_test(write(WITH_TOOLS))
    assert result.returncode == 0, result.stdout + result.stderr
    assert 'Ran 3 tests' in result.stderr


def test_outputs_are_compared():
    text = 'one\r\ntwo\nthree\n'
    assert normalize_lineseps(text) == 'one\ntwo\nthree\n'
    assert expect_output(text, expected_text='two\nthree')
    assert not expect_output(text, expected_text='two\nthree', strict=True)
    assert expect_output(text, expected_text=['one', re.compile('t.*e$', re.DOTALL)])
    assert not expect_output(text, expected_text=['two', 'one'])
    assert expect_output(text, expected_lines='thre') and not expect_output(text, expected_lines='four')
    assert expect_output(text, expected_lines=['one', 'three']) and expect_output(
        lines=['a', 'b'], expected_lines=['b']
    )
    assert not expect_output(text, expected_lines=['one', 'three'], strict=True)
    assert not expect_output(text, expected_lines=['one', 'two', 'three', 'four'])
    with pytest.raises(ValueError, match='not both'):
        expect_output(text, expected_lines='one', expected_text='one')


def test_lines_are_left_out_and_expectations_read_from_files(tmp_path):
    assert basic_output_filter()('pid 5\nrc 0\nsaid\n') == 'said\n'
    assert basic_output_filter([], ['.*noise'])('pid 5\nmuch noise here\n') == 'pid 5\n'
    assert ros_output_filter(filtered_rmw_implementation='rmw_fastrtps_cpp')('rc 0\nsaid\n') == 'said\n'
    (tmp_path / 'plain.txt').write_text('a\nb\n')
    (tmp_path / 'patterns.regex').write_text('a.\n')
    assert expected_output_from_file(tmp_path / 'plain') == ['a', 'b']
    assert expected_output_from_file(tmp_path / 'patterns')[0].match('ab')
    with pytest.raises(RuntimeError, match='could not find'):
        expected_output_from_file(tmp_path / 'nothing')


def test_a_process_says_that_it_is_ready():
    """The text may come in two parts; other processes and texts do not count."""
    said = []

    def listen(what, target, text):
        action = OpaqueFunction(function=lambda _: said.append(what))
        handler = StdoutReadyListener(target_action=target, ready_txt=text, actions=[action])
        assert handler.describe()[1] == [action]
        return RegisterEventHandler(handler)

    code = "import sys, time; [print(part, end='', flush=True) or time.sleep(0.3) for part in ('Re', 'ady', '!')]"
    process, other = ExecuteProcess(cmd=[sys.executable, '-c', code]), ExecuteProcess(cmd=[sys.executable, '-c', ''])
    service = launch.LaunchService(noninteractive=True)
    service.include_launch_description(
        launch.LaunchDescription(
            [
                listen('ready', process, 'Ready'),
                listen('any', None, 'Ready'),
                listen('other', other, 'Ready'),
                listen('wrong', process, 'not ready'),
                process,
                other,
            ]
        )
    )
    assert service.run() == 0
    assert sorted(said) == ['any', 'ready']


def test_results_of_runs_that_failed_or_were_skipped_have_all_cases():
    class Cases(unittest.TestCase):
        def test_one(self):
            self.fail('no')

        def test_two(self):
            raise unittest.SkipTest('not here')

    suite = unittest.defaultTestLoader.loadTestsFromTestCase(Cases)
    run = TestRun('name', lambda: None, {}, suite, unittest.TestSuite())
    for result, tag in ((FailResult(run, 'broken'), 'failure'), (SkipResult(run, 'broken'), 'skipped')):
        (report,) = unittestResultsToXml(test_results={run: result}).getroot()
        assert [case.find(tag).get('message') for case in report] == ['broken', 'broken']
        assert result.testsRun == 2 and result.wasSuccessful() == (tag == 'skipped')
    result = unittest.TextTestRunner(stream=io.StringIO(), resultclass=TestResult).run(suite)
    (report,) = unittestResultsToXml(test_results={'by name': result}).getroot()
    assert (report.get('name'), report.get('tests'), report.get('failures')) == ('by name', '2', '1')
    assert {case.get('classname') for case in report} == {f'{__name__}.Cases'}


def test_expected_output_may_have_escape_sequences(tmp_path):
    (tmp_path / 'bell.txt').write_text(r'a\bb')
    assert not expect_output(expected_lines=expected_output_from_file(tmp_path / 'bell'), text='a\bb')
    assert expect_output(expected_lines=expected_output_from_file(tmp_path / 'bell', 'unicode_escape'), text='a\bb')


def test_a_process_is_known_before_it_writes():
    action = ExecuteProcess(cmd=['ls', '-a'], name='list', cwd='/')
    action.prepare(LaunchContext())
    assert action.name.startswith('list-') and (action.cmd, action.cwd) == (['ls', '-a'], '/')
    handler = ActiveIoHandler()
    handler.track(action.name)
    assert handler.process_names() == [action.name] and handler.processes() == []
    proxy = ProcessProxy(action, ActiveProcInfoHandler(), handler)
    assert not proxy.running and proxy.output == ''


def test_the_programs_to_try_tests_on_are_there(write):
    path = write(EXAMPLES)
    result = launch_test(path)
    assert result.returncode == 0, result.stdout + result.stderr


def test_tests_of_pytest_and_googletest_are_actions(tmp_path):
    """An action runs the tests, its status says how they went, and a timeout ends them."""
    (tmp_path / 'test_good.py').write_text('def test_one(): pass\n')
    (tmp_path / 'test_bad.py').write_text('def test_one(): assert False\n')
    (tmp_path / 'test_slow.py').write_text('import signal\ndef test_one(): signal.pause()\n')
    program = tmp_path / 'some_gtest'
    program.write_text('#!/bin/sh\necho "$0"; exit 3\n')
    program.chmod(0o755)
    context = {'additional_env': {'PYTEST_DISABLE_PLUGIN_AUTOLOAD': '1'}}
    good, bad, slow = (
        PyTest(path=[f'{tmp_path}/', f'test_{name}.py'], timeout=timeout, **context)
        for name, timeout in (('good', 1000.0), ('bad', None), ('slow', '0.5'))
    )
    made = GTest(path=str(program), name='made', timeout=1000, cached_output=True)
    service = LaunchService(noninteractive=True)
    service.include_launch_description(LaunchDescription([good, bad, slow, made]))
    begin = time.monotonic()
    assert service.run() == 0
    assert time.monotonic() - begin < 500, 'a timeout has kept the launch waiting'
    assert (good.return_code, bad.return_code, made.return_code) == (0, 1, 3)
    assert slow.return_code  # by itself it never ends; the status depends on how far Python had come
    assert (made.path, made.timeout, made.get_stdout()) == (str(program), 1000, f'{program}\n')
    assert isinstance(good, Test) and isinstance(good, ExecuteProcess) and bad.timeout is None
