"""Tests with launch fixtures, run by pytest as a user runs them."""

import os
import re
import subprocess
import sys
import textwrap

import pytest

pytestmark = pytest.mark.timeout(120)

HEADER = """\
import sys

import launch
import launch_pytest
import pytest
from launch.actions import ExecuteProcess, TimerAction
from launch_pytest import tools

CODE = ('import signal, sys; signal.signal(signal.SIGINT, lambda *_: sys.exit(5));'
        'print("up", flush=True); print("oops", file=sys.stderr, flush=True); signal.pause()')


def loop():
    return ExecuteProcess(cmd=[sys.executable, '-c', CODE], cached_output=True)
"""


@pytest.fixture
def run(tmp_path):
    """Run some tests; return (status, output)."""

    def run_one(body, *arguments):
        path = tmp_path / 'test_it.py'
        path.write_text(HEADER + textwrap.dedent(body))
        options = ['-p', 'no:cacheprovider', '-v', '--rootdir', str(tmp_path)]
        command = [sys.executable, '-m', 'pytest', *options, *arguments]
        result = subprocess.run(
            command,
            capture_output=True,
            text=True,
            timeout=100,
            cwd=tmp_path,
            env={**os.environ, 'ROS_LOG_DIR': str(tmp_path / 'log')},
        )
        return result.returncode, result.stdout + result.stderr

    return run_one


def test_functions_coroutines_and_generators(run):
    status, output = run("""
        @pytest.fixture
        def dut():
            return loop()


        @launch_pytest.fixture
        def description(dut):
            return launch.LaunchDescription([dut, launch_pytest.actions.ReadyToTest()])


        @pytest.mark.launch(fixture=description)
        def test_function(dut, launch_context, launch_service):
            assert launch_service.context is launch_context
            assert tools.wait_for_start_sync(launch_context, dut, timeout=30)
            assert tools.wait_for_output_sync(launch_context, dut, lambda text: text == 'up\\n', timeout=30)
            tools.assert_stderr_sync(launch_context, dut, lambda text: text == 'oops\\n', timeout=30)
            assert not tools.wait_for_output_sync(launch_context, dut, lambda text: False, timeout=0.1)
            assert not tools.wait_for_exit_sync(launch_context, dut, timeout=0.1)


        @pytest.mark.launch(fixture=description)
        async def test_coroutine(dut, launch_context):
            def validate(text):
                assert text.splitlines() == ['up']

            await tools.assert_output(launch_context, dut, validate, timeout=30)
            assert not await tools.wait_for_stderr(launch_context, dut, lambda text: 'none' in text, timeout=0.1)


        @pytest.mark.launch(fixture=description)
        def test_generator(dut, launch_context):
            assert tools.wait_for_output_sync(launch_context, dut, lambda text: 'up' in text, timeout=30)
            yield
            assert dut.return_code == 5


        @pytest.mark.launch(fixture=description)
        async def test_async_generator(dut, launch_context):
            assert await tools.wait_for_output(launch_context, dut, lambda text: 'up' in text, timeout=30)
            yield
            assert dut.return_code == 5


        class TestInAClass:
            @pytest.mark.launch(fixture=description)
            def test_method(self, dut, launch_context):
                assert tools.wait_for_output_sync(launch_context, dut, lambda text: 'up' in text, timeout=30)
                yield
                assert dut.return_code == 5


        @pytest.mark.launch(fixture=description, shutdown=True)
        def test_after_the_end(dut):
            assert dut.return_code is not None
    """)
    assert status == 0, output
    assert '6 passed' in output


def test_tests_share_a_launch_and_the_end_waits_for_all(run):
    status, output = run(
        """
        made = []


        @launch_pytest.fixture(scope='module')
        def shared():
            made.append(loop())
            return launch.LaunchDescription([made[-1]]), made[-1]


        @pytest.mark.launch(fixture=shared)
        def test_first(shared, launch_context):
            assert tools.wait_for_output_sync(launch_context, shared[1], lambda text: 'up' in text, timeout=30)
            yield
            assert made[0].return_code == 5


        @pytest.mark.launch(fixture=shared, shutdown=True)
        def test_end(shared):
            assert made[0].return_code == 5


        @pytest.mark.launch(fixture=shared)
        def test_second(shared):
            assert len(made) == 1 and made[0].return_code is None


        @pytest.mark.parametrize('number', [1, 2])
        @pytest.mark.launch(fixture=shared)
        def test_numbers(shared, number):
            assert made[0].return_code is None
    """,
        '-rp',
    )
    assert status == 0, output
    # From the summary: what a launched process prints may stand within the lines of progress, and break them.
    order = [line.partition('::')[2] for line in output.splitlines() if re.match(r'PASSED \S+::', line)]
    assert order == ['test_first', 'test_second', 'test_numbers[1]', 'test_numbers[2]', 'test_first[shutdown_test]',
                     'test_end']  # fmt: skip


def test_failures_are_failures(run):
    status, output = run("""
        @launch_pytest.fixture
        def description():
            return launch.LaunchDescription([loop()])


        @launch_pytest.fixture
        def nothing():
            return 5


        @launch_pytest.fixture
        def broken():
            return launch.LaunchDescription([launch.actions.LogInfo(msg=launch.substitutions.LaunchConfiguration('no')),
                                             TimerAction(period=100.0, actions=[launch_pytest.actions.ReadyToTest()])])


        @pytest.mark.launch(fixture=description)
        def test_before(launch_service):
            assert False, 'before the end'
            yield


        @pytest.mark.launch(fixture=description)
        def test_after(launch_service):
            yield
            assert False, 'after the end'


        @pytest.mark.launch(fixture=description)
        async def test_twice(launch_service):
            yield
            yield


        @pytest.mark.launch(fixture=nothing)
        def test_no_description():
            pass


        @pytest.mark.launch(fixture=broken)
        def test_broken():
            pass


        def test_ordinary():
            pass
    """)
    assert status == 1
    assert '3 failed, 1 passed' in output and '2 errors' in output, output
    for message in (
        'before the end',
        'after the end',
        'must stop iteration after yielding once',
        'return value must be either a launch description',
        'ended with an error before it was ready',
    ):
        assert message in output  # fmt: skip


def test_a_mark_without_a_fixture_says_so_and_the_test_is_left_out(run):
    status, output = run("""
        @pytest.mark.launch
        def test_it():
            pass
    """)
    assert (status, '1 skipped, 1 warning' in output) == (0, True)
    assert '"fixture" keyword argument is required in a pytest.mark.launch() decorator' in output


def test_a_launch_that_ends_by_itself_is_waited_for(run):
    status, output = run("""
        @launch_pytest.fixture(auto_shutdown=False)
        def description():
            process = ExecuteProcess(cmd=['sh', '-c', 'sleep 0.2; echo done'], cached_output=True)
            return launch.LaunchDescription([process]), process


        @pytest.mark.launch(fixture=description, shutdown=True)
        def test_it(description):
            assert description[1].return_code == 0 and description[1].get_stdout() == 'done\\n'
    """)
    assert status == 0, output
