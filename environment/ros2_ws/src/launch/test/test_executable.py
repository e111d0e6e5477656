"""A program that is described apart from the action that runs it: `launch.descriptions.Executable`, `ExecuteLocal`."""

import re
import signal
import sys

import pytest
from launch import LaunchContext, LaunchDescription, LaunchService
from launch.actions import EmitEvent, ExecuteLocal, ExecuteProcess, OpaqueFunction, RegisterEventHandler
from launch.descriptions import Executable
from launch.event_handlers import OnProcessExit, OnProcessStart
from launch.events import Shutdown
from launch.substitutions import EnvironmentVariable, LaunchConfiguration


def run(*entities) -> int:
    """Launch until nothing is left to do."""
    service = LaunchService(noninteractive=True)
    service.include_launch_description(LaunchDescription(list(entities)))
    return service.run()


def test_an_executable_knows_its_texts_once_it_is_prepared(monkeypatch):
    monkeypatch.setenv('PROGRAM_NAME', 'lister')
    context = LaunchContext()
    program = Executable(
        cmd=['ls', ['-', 'a b']],
        name=EnvironmentVariable('PROGRAM_NAME'),
        cwd=['/', 'tmp'],
        env={EnvironmentVariable('PROGRAM_NAME'): 'x'},
        additional_env={'MORE': ['y', 'z']},
        arguments=['"one word"'],
    )
    finals = (program.final_name, program.final_cmd, program.final_cwd, program.final_env)
    assert finals == (None, None, None, None) and program.arguments == ['"one word"']
    assert (len(program.cmd), len(program.env), len(program.additional_env)) == (3, 1, 1)
    program.prepare(context, None)
    assert re.fullmatch(r'lister-\d+', program.final_name)
    assert program.final_cmd == ['ls', '-a b', '"one word"']
    assert (program.final_cwd, program.final_env) == ('/tmp', {'lister': 'x', 'MORE': 'yz'})


def test_an_executable_has_by_default_the_environment_of_the_launch():
    context = LaunchContext()
    context.environment['ONLY_HERE'] = '1'
    program = Executable(cmd=['/bin/ls'], additional_env={'MORE': '2'})
    program.prepare(context, None)
    assert (program.final_env['ONLY_HERE'], program.final_env['MORE'], program.final_cwd) == ('1', '2', None)
    assert program.final_name.startswith('ls-') and program.name is None and program.env is None
    assert 'MORE' not in context.environment


@pytest.mark.parametrize(
    'own, pattern, words',
    [
        (None, '', ['nice', '-n', '1']),
        (None, 'tail', []),
        (None, 'l.', ['nice', '-n', '1']),
        ('echo', 'tail', ['echo']),
    ],
)
def test_the_prefix_of_the_launch_goes_before_programs_that_match(own, pattern, words):
    context = LaunchContext()
    context.launch_configurations.update({'launch-prefix': 'nice -n 1', 'launch-prefix-filter': pattern})
    program = Executable(cmd=['/bin/ls', '-a'], prefix=own)
    program.prepare(context, None)
    assert program.final_cmd == [*words, '/bin/ls', '-a']


def test_a_description_runs_with_all_that_an_action_can(capfd):
    ended = []
    action = ExecuteLocal(
        process_description=Executable(
            cmd=[sys.executable, '-c', 'import os; print(os.environ["WORD"], os.getcwd())'],
            name='teller',
            cwd='/',
            additional_env={'WORD': LaunchConfiguration('word', default='hello')},
        ),
        output={'both': 'screen'},
        output_format='<{this.process_description.final_name}> {line}',
        cached_output=True,
        on_exit=lambda event, context: ended.append((event.returncode, event.cwd)),
    )
    assert action.get_sub_entities() == []
    assert run(action) == 0
    assert (action.return_code, action.get_stdout(), ended) == (0, 'hello /\n', [(0, '/')])
    assert action.process_details['name'] == action.process_description.final_name
    assert re.search(r'<teller-\d+> hello /\n', capfd.readouterr().out)
    with pytest.raises(RuntimeError, match=r"ExecuteLocal action 'teller-\d+': executed more than once"):
        action.execute(LaunchContext())


def test_the_lines_of_a_process_begin_with_its_name(capfd):
    assert run(ExecuteProcess(cmd=['echo', 'word'], name='speaker', output='screen')) == 0
    assert re.search(r'^\[speaker-\d+\] word$', capfd.readouterr().out, re.MULTILINE)


def test_events_of_a_described_program_reach_its_handlers_and_a_shutdown_ends_it():
    seen = []
    program = Executable(cmd=[sys.executable, '-S', '-c', 'import signal; signal.pause()'], name='sleeper')
    sleeper = ExecuteLocal(process_description=program)
    status = run(
        sleeper,
        RegisterEventHandler(
            OnProcessStart(target_action=sleeper, on_start=[EmitEvent(event=Shutdown(reason='it has started'))])
        ),
        RegisterEventHandler(
            OnProcessExit(target_action=sleeper, on_exit=[OpaqueFunction(function=lambda _: seen.append('ended'))])
        ),
    )
    assert (status, sleeper.return_code, seen) == (0, -signal.SIGINT, ['ended'])


def test_a_derived_description_may_change_what_is_run():
    class Twice(Executable):
        def prepare(self, context, action):
            self.cmd.append([EnvironmentVariable('HOME')])
            super().prepare(context, action)
            self.owner = action

    program = Twice(cmd=['echo'])
    action = ExecuteLocal(process_description=program, cached_output=True)
    assert run(action) == 0
    assert program.owner is action and action.get_stdout().strip() == program.final_env['HOME']


def test_a_process_shows_its_description_before_and_after():
    process = ExecuteProcess(cmd=['ls', '-a'], name='list', cwd='/', env={'A': 'b'})
    before = process.process_description
    assert isinstance(process, ExecuteLocal) and len(process.cmd) == 2 and not isinstance(process.cmd[0], str)
    process.prepare(LaunchContext())
    assert process.process_description is before
    assert (process.cmd, process.cwd, process.env) == (['ls', '-a'], '/', {'A': 'b'})
    assert process.name == before.final_name
