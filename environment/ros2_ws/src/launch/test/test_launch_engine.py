"""The launch service and its actions, in this process and without ROS."""

import importlib
import os
import re
import sys
import textwrap
import threading
import time
from pathlib import Path

import launch.logging
import pytest
from launch import (
    Action,
    EventHandler,
    LaunchContext,
    LaunchDescription,
    LaunchDescriptionSource,
    LaunchIntrospector,
    LaunchService,
    SomeEntitiesType,
    SomeEntitiesType_types_tuple,
    SomeSubstitutionsType_types_tuple,
)
from launch.actions import (
    AppendEnvironmentVariable,
    DeclareLaunchArgument,
    EmitEvent,
    ExecuteProcess,
    GroupAction,
    IncludeLaunchDescription,
    LogInfo,
    OpaqueFunction,
    RegisterEventHandler,
    ResetLaunchConfigurations,
    SetEnvironmentVariable,
    SetLaunchConfiguration,
    Shutdown,
    TimerAction,
)
from launch.conditions import IfCondition, LaunchConfigurationEquals, LaunchConfigurationNotEquals, UnlessCondition
from launch.event_handlers import OnExecutionComplete, OnProcessExit, OnProcessIO, OnProcessStart, OnShutdown
from launch.events import ExecutionComplete, matches_action
from launch.events import Shutdown as ShutdownEvent
from launch.events.process import (
    ProcessExited,
    ProcessIO,
    ShutdownProcess,
    matches_executable,
    matches_name,
    matches_pid,
)
from launch.launch_description_sources import PythonLaunchDescriptionSource
from launch.substitutions import (
    AllSubstitution,
    AndSubstitution,
    AnySubstitution,
    Command,
    EnvironmentVariable,
    EqualsSubstitution,
    FileContent,
    FindExecutable,
    IfElseSubstitution,
    LaunchConfiguration,
    LaunchLogDir,
    LocalSubstitution,
    NotEqualsSubstitution,
    NotSubstitution,
    PathJoinSubstitution,
    PathSubstitution,
    PythonExpression,
    SubstitutionFailure,
    TextSubstitution,
    ThisLaunchFile,
    ThisLaunchFileDir,
)

pytestmark = pytest.mark.timeout(60)


@pytest.fixture(autouse=True)
def own_log(monkeypatch, tmp_path):
    monkeypatch.setenv('ROS_LOG_DIR', str(tmp_path / 'log'))
    launch.logging.reset()
    yield
    launch.logging.reset()


@pytest.fixture
def go(capsys):
    """Launch actions to the end; return (exit status, what the user and the processes said, all lines)."""

    def go_on(*actions, **kwargs):
        service = LaunchService(**kwargs)
        service.include_launch_description(LaunchDescription(list(actions)))
        status = service.run()
        lines = capsys.readouterr().out.splitlines()[2:]
        said = [re.sub(r'^\[INFO\] \[launch\.user\]: ', '', line) for line in lines if 'launch.user' in line]
        return status, said, lines

    return go_on


def python(code, **kwargs):
    return ExecuteProcess(cmd=[sys.executable, '-S', '-u', '-c', textwrap.dedent(code)], **kwargs)


def perform(substitution, **configurations):
    context = LaunchContext()
    context.launch_configurations.update(configurations)
    return context.perform_substitution(substitution)


# --- substitutions and conditions --------------------------------------------------------------------------------


@pytest.mark.parametrize(
    'substitution, text',
    [
        (TextSubstitution(text='a'), 'a'),
        (LaunchConfiguration('x'), '5'),
        (LaunchConfiguration(['', 'x']), '5'),
        (LaunchConfiguration('none', default='d'), 'd'),
        (LaunchConfiguration('none', default=7), '7'),
        (PathJoinSubstitution(['/a', 'b', ['c', LaunchConfiguration('x')]]), '/a/b/c5'),
        (PathJoinSubstitution(['/a']) / 'b', '/a/b'),
        (
            PathSubstitution('a') / 'b' / PathJoinSubstitution(['c', 'd']) / [LaunchConfiguration('x'), '.t'],
            'a/b/c/d/5.t',
        ),
        (PathSubstitution(LaunchConfiguration('x')), '5'),
        (PathSubstitution(Path('/a')) / Path('b/c'), '/a/b/c'),
        (PythonExpression(['2 * ', LaunchConfiguration('x')]), '10'),
        (PythonExpression('cos(0)'), '1.0'),
        (PythonExpression("os.path.basename('/a/b')", python_modules=['os']), 'b'),
        (EnvironmentVariable('COURSE_TEST_NO_SUCH', default_value='d'), 'd'),
        (Command(['echo ', LaunchConfiguration('x')]), '5\n'),
        (EqualsSubstitution(LaunchConfiguration('x'), '5.0'), 'true'),
        (NotSubstitution(AndSubstitution('1', 'False')), 'true'),
        (IfElseSubstitution('false', 'a', 'b'), 'b'),
    ],
)
def test_substitutions(substitution, text):
    assert perform(substitution, x='5') == text


@pytest.mark.parametrize(
    'substitution, message',
    [
        (LaunchConfiguration('nope'), "launch configuration 'nope' does not exist"),
        (EnvironmentVariable('COURSE_TEST_NO_SUCH'), "environment variable 'COURSE_TEST_NO_SUCH' does not exist"),
        (FindExecutable(name='no-such-program'), "executable 'no-such-program' not found on the PATH"),
        (Command('false'), 'executed command failed. Command: false'),
        (Command('no-such-program'), 'file not found: '),
        (Command("sh -c 'echo bad >&2'"), 'showed stderr output'),
        (ThisLaunchFileDir(), 'outside of a launch file'),
        (LocalSubstitution('event.reason'), "local variable 'event.reason' does not exist"),
    ],
)
def test_substitutions_that_fail_say_why(substitution, message):
    with pytest.raises(SubstitutionFailure, match=message):
        perform(substitution)


@pytest.mark.parametrize('modules, error', [((), NameError), (('math',), None), (('no_such_module',), ImportError)])
def test_an_expression_raises_what_python_does(modules, error):
    expression = PythonExpression(['ceil(', LaunchConfiguration('x'), ')'], modules)
    names = ', '.join(f"'{name}'" for name in modules)
    assert expression.describe() == f"PythonExpr('ceil(' + LaunchConfig('x') + ')', [{names}])"
    if error is None:
        assert perform(expression, x='1.2') == '2'
    else:
        pytest.raises(error, perform, expression, x='1.2')


@pytest.mark.parametrize('left, right, same', [
    (True, '1', True), ('FALSE', 0, True), ('true', 10, False), (None, '', True), (10, 10 + 1e-10, True),
    ('nan', 'nan', False), ('-inf', '-inf', True), ('one', 1, False),
])  # fmt: skip
def test_texts_truth_values_and_numbers_are_compared(left, right, same):
    for pair in ((left, right), (right, left)):
        assert perform(EqualsSubstitution(*pair)) == str(same).lower()
        assert perform(NotEqualsSubstitution(*pair)) == str(not same).lower()


def test_find_executable():
    assert os.access(perform(FindExecutable(name='sh')), os.X_OK)


def test_conditions(go):
    status, said, _ = go(
        SetLaunchConfiguration('on', 'True'),
        LogInfo(msg='if', condition=IfCondition(LaunchConfiguration('on'))),
        LogInfo(msg='not if', condition=IfCondition('0')),
        LogInfo(msg='unless', condition=UnlessCondition('false')),
        LogInfo(msg='not unless', condition=UnlessCondition(LaunchConfiguration('on'))),
        LogInfo(msg='equals', condition=LaunchConfigurationEquals('on', 'True')),
        LogInfo(msg='unset', condition=LaunchConfigurationEquals('off', None)),
        LogInfo(msg='differs', condition=LaunchConfigurationNotEquals('on', 'x')),
    )
    assert (status, said) == (0, ['if', 'unless', 'equals', 'unset', 'differs'])


def test_a_condition_that_is_neither_true_nor_false_ends_the_launch(go):
    status, _, lines = go(LogInfo(msg='x', condition=IfCondition('maybe')))
    assert status == 1
    assert lines == [
        '[ERROR] [launch]: Caught exception in launch (see debug for traceback): invalid condition expression '
        "'maybe': expected one of ['true', '1'] or ['false', '0']"
    ]


# --- actions -----------------------------------------------------------------------------------------------------


def test_a_group_is_a_scope_for_configurations_and_environment(go):
    shown = [LaunchConfiguration('a', default='-'), ' ', EnvironmentVariable('COURSE_TEST_E', default_value='-')]
    status, said, _ = go(
        SetLaunchConfiguration('a', '1'),
        GroupAction(
            [SetLaunchConfiguration('a', '2'), SetEnvironmentVariable('COURSE_TEST_E', 'x'),
             AppendEnvironmentVariable('COURSE_TEST_E', 'y'), LogInfo(msg=shown)]
        ),
        LogInfo(msg=shown),
        GroupAction([LogInfo(msg=shown)], forwarding=False, launch_configurations={'b': '3'}),
        GroupAction([Action(), SetLaunchConfiguration('a', '4')], scoped=False, forwarding=False),
        LogInfo(msg=shown),
    )  # fmt: skip
    assert (status, said) == (0, ['2 x:y', '1 -', '- -', '4 -'])
    assert 'COURSE_TEST_E' not in os.environ


def test_arguments_have_defaults_choices_and_descriptions(go):
    choice = DeclareLaunchArgument('mode', default_value='a', choices=['a', 'b'], description='The mode')
    assert choice.description == "The mode. Valid choices are: ['a', 'b']"
    assert DeclareLaunchArgument('m', choices=['a']).description == "One of: ['a']"
    with pytest.raises(RuntimeError, match='not in provided choices'):
        DeclareLaunchArgument('m', default_value='z', choices=['a'])
    assert go(choice, LogInfo(msg=LaunchConfiguration('mode')))[1] == ['a']
    status, _, lines = go(SetLaunchConfiguration('mode', 'z'), choice)
    assert status == 1
    assert 'Argument "mode" provided value "z" is not valid. Valid options are: [\'a\', \'b\']' in lines[0]


def test_an_opaque_function_may_return_actions_or_fail(go):
    def decide(context, word, *, times):
        return [LogInfo(msg=word)] * times

    assert go(OpaqueFunction(function=decide, args=['hi'], kwargs={'times': 2}))[1] == ['hi', 'hi']

    def fail(context):
        raise KeyError('broken')

    status, said, lines = go(LogInfo(msg='before'), OpaqueFunction(function=fail), LogInfo(msg='after'))
    assert (status, said) == (1, ['before'])
    assert "Caught exception in launch (see debug for traceback): 'broken'" in lines[-1]
    assert not any('Traceback' in line for line in lines)
    assert any('Traceback' in line for line in go(OpaqueFunction(function=fail), debug=True)[2])


def test_a_timer_waits_and_is_cancelled_by_a_shutdown(go):
    begin = time.monotonic()
    status, said, _ = go(
        TimerAction(period=1000.0, actions=[LogInfo(msg='never')]),
        # Before the longer one, so that it ends first however late that one begins.
        TimerAction(period='0.1', actions=[LogInfo(msg='first')]),
        TimerAction(period=0.3, actions=[LogInfo(msg='second'), EmitEvent(event=ShutdownEvent(reason='enough'))]),
        RegisterEventHandler(OnShutdown(on_shutdown=[LogInfo(msg=['end: ', LocalSubstitution('event.reason')])])),
    )
    assert (status, said) == (0, ['first', 'second', 'end: enough'])
    assert time.monotonic() - begin >= 0.3


def test_what_a_timer_waits_for_sees_the_configurations_of_its_beginning_and_changes_them_for_itself(go):
    def say(*names):
        return LogInfo(msg=[part for name in names for part in (LaunchConfiguration(name, default='none'), ' ')])

    status, said, _ = go(
        GroupAction([
            SetLaunchConfiguration('a', 'in the group'),
            TimerAction(period=0.01, actions=[SetLaunchConfiguration('b', 'in the timer'), say('a', 'b', 'c')]),
        ]),
        SetLaunchConfiguration('c', 'after'),
        TimerAction(period=0.05, actions=[say('a', 'b', 'c')]),
    )  # fmt: skip
    assert (status, said) == (0, ['in the group in the timer none ', 'none none after '])


def test_included_files_get_arguments_and_know_where_they_are(go, tmp_path):
    (tmp_path / 'sub').mkdir()
    child = tmp_path / 'sub' / 'child.launch.py'
    child.write_text(
        textwrap.dedent("""
            from launch import LaunchDescription
            from launch.actions import DeclareLaunchArgument, LogInfo, TimerAction
            from launch.substitutions import LaunchConfiguration, ThisLaunchFileDir

            def generate_launch_description():
                return LaunchDescription([
                    DeclareLaunchArgument('who'),
                    LogInfo(msg=[ThisLaunchFileDir(), ' ', LaunchConfiguration('who')]),
                    TimerAction(period=0.05, actions=[LogInfo(msg=['later in ', ThisLaunchFileDir() / 'a'])]),
                ])
        """)
    )
    include = IncludeLaunchDescription(
        PythonLaunchDescriptionSource([str(tmp_path), '/sub/child.launch.py']), launch_arguments={'who': 'me'}.items()
    )
    assert go(include)[1] == [f'{child.parent} me', f'later in {child.parent}/a']
    assert not list(tmp_path.glob('**/__pycache__'))
    bare = IncludeLaunchDescription(str(child))
    for action in (include, bare):
        found = LaunchDescription([action]).get_launch_arguments_with_include_launch_description_actions()
        assert [(argument.name, includes) for argument, includes in found] == [('who', [action])]
    status, _, lines = go(bare)
    assert status == 1
    assert lines[0].endswith(
        "Included launch description missing required argument 'who' (description: 'no description given'), given: []"
    )


def test_arguments_of_an_include_are_set_one_after_the_other_in_the_included_file(go, tmp_path):
    child = tmp_path / 'child.launch.py'
    child.write_text(
        textwrap.dedent("""
            from launch import LaunchDescription
            from launch.actions import LogInfo
            from launch.substitutions import LaunchConfiguration

            def generate_launch_description():
                return LaunchDescription([LogInfo(msg=LaunchConfiguration('b'))])
        """)
    )
    values = {'a': 'new', 'b': [LaunchConfiguration('a'), ' ', ThisLaunchFileDir()]}
    included = IncludeLaunchDescription(str(child), launch_arguments=values.items())
    assert go(SetLaunchConfiguration('a', 'old'), included)[1] == [f'new {tmp_path}']


def test_a_required_argument_is_given_by_the_include_itself(go):
    inner = IncludeLaunchDescription(LaunchDescriptionSource(LaunchDescription([DeclareLaunchArgument('who')])))
    status, _, lines = go(SetLaunchConfiguration('who', 'set outside'), inner)
    assert (status, "missing required argument 'who'" in lines[0]) == (1, True)


# --- processes ---------------------------------------------------------------------------------------------------


def test_a_process_is_reported_in_stocks_words(go):
    good = ExecuteProcess(cmd=['sh', '-c', 'echo out; echo err >&2; printf unfinished'], output='screen', name='good')
    status, _, lines = go(good)
    pid = good.process_details['pid']
    name = good.process_name
    assert re.fullmatch(r'good-\d+', name)
    assert status == 0 and good.return_code == 0
    assert lines[0] == f'[INFO] [{name}]: process started with pid [{pid}]'
    assert sorted(lines[1:4]) == sorted([f'[{name}] out', f'[{name}] err', f'[{name}] unfinished'])
    assert lines[4:] == [f'[INFO] [{name}]: process has finished cleanly [pid {pid}]']
    bad = ExecuteProcess(cmd=['sh', '-c', 'exit 3'])
    _, _, lines = go(bad)
    pid = bad.process_details['pid']
    assert lines[-1] == (
        f"[ERROR] [{bad.process_name}]: process has died [pid {pid}, exit code 3, cmd 'sh -c exit 3']."
    )


@pytest.mark.parametrize(
    'output, on_screen', [('log', {'err'}), ('screen', {'out', 'err'}), ('both', {'out', 'err'}), ('own_log', set())]
)
def test_output_goes_to_screen_and_log_as_asked(go, output, on_screen):
    process = ExecuteProcess(cmd=['sh', '-c', 'echo out; echo err >&2'], output=output)
    _, _, lines = go(process)
    assert {line.split('] ')[1] for line in lines if line.startswith(f'[{process.process_name}]')} == on_screen
    logged = open(os.path.join(launch.logging.launch_config.log_dir, 'launch.log')).read()
    assert (f'[{process.process_name}] out' in logged) == (output in ('log', 'both'))


def test_a_program_that_does_not_exist_is_one_line(go):
    status, _, lines = go(ExecuteProcess(cmd=['/no/such/program']))
    assert len(lines) == 1 and 'exception occurred while executing process: ' in lines[0]
    assert "No such file or directory: '/no/such/program'" in lines[0]


def test_environment_directory_shell_prefix_and_tty(go, tmp_path):
    _, _, lines = go(
        SetEnvironmentVariable('COURSE_TEST_A', '1'),
        ExecuteProcess(
            cmd=['echo $COURSE_TEST_A $COURSE_TEST_B; pwd'], shell=True, cwd=str(tmp_path), output='screen',
            additional_env={'COURSE_TEST_B': LaunchConfiguration('b', default='2')}, name='s',
        ),
        ExecuteProcess(cmd=['world'], prefix='echo hello', output='screen', name='p'),
        ExecuteProcess(cmd=['sh', '-c', 'test -t 1 && test -t 2 && echo tty'], emulate_tty=True, output='screen'),
        ExecuteProcess(cmd=['env'], env={'ONLY': 'this'}, output='screen', name='e'),
    )  # fmt: skip
    said = [line.split('] ', 1)[1] for line in lines if re.match(r'\[\w+-\d+\] ', line)]
    assert {'1 2', str(tmp_path), 'hello world', 'tty', 'ONLY=this'} <= set(said)


def test_handlers_see_start_output_and_exit(go):
    process = python(r"import sys; sys.stdout.write('ready\nsteady\ng'); sys.stdin.read(0)", output='screen')
    other = python('pass')

    def on_exit(event, context):
        return [LogInfo(msg=f'exit {event.returncode} {event.process_name == process.process_name}')]

    status, said, _ = go(
        RegisterEventHandler(OnProcessStart(target_action=process, on_start=[LogInfo(msg='start')])),
        RegisterEventHandler(OnProcessIO(target_action=process, on_stdout=lambda event: LogInfo(msg=repr(event.text)))),
        RegisterEventHandler(OnProcessExit(target_action=process, on_exit=on_exit)),
        process,
        other,
    )
    assert (status, said) == (0, ['start', "b'ready\\nsteady\\ng'", 'exit 0 True'])


def test_on_exit_may_shut_everything_down_and_stop_the_others(go):
    long = python('import time\ntry: time.sleep(100)\nexcept KeyboardInterrupt: print("interrupted")', output='screen')
    first = python("print('up')", on_exit=Shutdown())
    status, _, lines = go(
        long, RegisterEventHandler(OnProcessIO(target_action=None)), RegisterEventHandler(
            OnProcessStart(target_action=long, on_start=[first])
        ),
    )  # fmt: skip
    assert f'[INFO] [launch]: process[{first.process_name}] was required: shutting down launched system' in lines
    assert f"[INFO] [{long.process_name}]: sending signal 'SIGINT' to process[{long.process_name}]" in lines
    assert long.return_code is not None


def test_one_process_can_be_ended_alone(go):
    long = python('import time; print("up"); time.sleep(100)')
    after = LogInfo(msg='gone')
    status, said, _ = go(
        RegisterEventHandler(OnProcessIO(
            target_action=long,
            on_stdout=lambda _: EmitEvent(event=ShutdownProcess(process_matcher=matches_action(long))),
        )),
        RegisterEventHandler(OnProcessExit(target_action=long, on_exit=[after])),
        long,
    )  # fmt: skip
    assert (status, said) == (0, ['gone'])


class OnAnyExit(EventHandler):
    """As packages of others write event handlers: annotated, and with one entity or several for an answer."""

    def __init__(self, answer: SomeEntitiesType):
        assert isinstance(answer, SomeEntitiesType_types_tuple)
        super().__init__(matcher=lambda event: isinstance(event, ProcessExited), entities=answer)


def test_an_event_handler_of_another_package_answers_with_one_entity_or_several(go):
    for answer in (LogInfo(msg='gone'), [LogInfo(msg='gone')]):
        _, said, _ = go(RegisterEventHandler(OnAnyExit(answer)), python('pass'))
        assert said == ['gone']


def test_what_is_an_entity_and_what_is_a_text_can_be_asked():
    assert isinstance(LaunchDescription(), SomeEntitiesType_types_tuple)
    assert not isinstance(1, SomeEntitiesType_types_tuple)
    for text in ('a', Path('a'), LaunchConfiguration('a'), ['a', LaunchConfiguration('b')]):
        assert isinstance(text, SomeSubstitutionsType_types_tuple)
    assert not isinstance(1.5, SomeSubstitutionsType_types_tuple)


def test_respawn_starts_again_up_to_the_limit(go):
    process = ExecuteProcess(cmd=['false'], respawn=True, respawn_delay=0.01, respawn_max_retries=2)
    _, _, lines = go(process)
    assert sum('process started with pid' in line for line in lines) == 3


def test_a_shutdown_ends_respawning(go):
    process = ExecuteProcess(cmd=['true'], respawn=True, respawn_delay=1000.0)
    status, _, lines = go(process, RegisterEventHandler(OnProcessExit(target_action=process, on_exit=[Shutdown()])))
    assert status == 0 and sum('process started with pid' in line for line in lines) == 1


def test_a_stubborn_process_and_its_children_are_killed_in_the_end(go, tmp_path):
    pids = tmp_path / 'pids'
    stubborn = python(
        f"""
        import os, signal, time
        signal.signal(signal.SIGINT, signal.SIG_IGN)
        signal.signal(signal.SIGTERM, signal.SIG_IGN)
        child = os.fork()
        if child:
            open({str(pids)!r}, 'w').write(f'{{os.getpid()}} {{child}}')
            print('up')
        time.sleep(1000)
        """,
        sigterm_timeout='0.2',
        sigkill_timeout='0.2',
    )
    name = stubborn.cmd
    status, _, lines = go(
        RegisterEventHandler(OnProcessIO(target_action=stubborn, on_stdout=lambda _: Shutdown(reason='enough'))),
        stubborn,
    )
    name = stubborn.process_name
    said = [line for line in lines if 'escalating' in line or 'sending' in line]
    assert said == [
        f"[INFO] [{name}]: sending signal 'SIGINT' to process[{name}]",
        f"[ERROR] [{name}]: process[{name}] failed to terminate '0.2' seconds after receiving 'SIGINT', "
        "escalating to 'SIGTERM'",
        f"[INFO] [{name}]: sending signal 'SIGTERM' to process[{name}]",
        f"[ERROR] [{name}]: process[{name}] failed to terminate '0.4' seconds after receiving 'SIGTERM', "
        "escalating to 'SIGKILL'",
        f"[INFO] [{name}]: sending signal 'SIGKILL' to process[{name}]",
    ]
    assert stubborn.return_code == -9 and status == 0
    for pid in pids.read_text().split():
        assert not _lives(int(pid)), f'process {pid} lives on'


def _lives(pid):
    """Return True unless the process has ended; one that nobody waits for (a zombie) has."""
    try:
        return open(f'/proc/{pid}/stat').read().rsplit(')', 1)[1].split()[0] != 'Z'
    except FileNotFoundError:
        return False


def test_shutdown_from_another_thread(capsys):
    service = LaunchService()
    process = python('import time; time.sleep(1000)')
    started = threading.Event()
    service.include_launch_description(LaunchDescription([
        RegisterEventHandler(OnProcessStart(target_action=process, on_start=lambda *_: started.set())), process
    ]))  # fmt: skip

    def stop():
        started.wait(30)
        service.shutdown()

    stopper = threading.Thread(target=stop)
    stopper.start()
    assert service.run() == 0
    stopper.join()
    assert not _lives(process.process_details['pid'])


def test_a_service_in_a_thread_leaves_signals_alone_and_waits_when_idle(capsys):
    service = LaunchService()
    results = []
    thread = threading.Thread(target=lambda: results.append(service.run(shutdown_when_idle=False)))
    thread.start()
    said = threading.Event()
    service.include_launch_description(LaunchDescription([OpaqueFunction(function=lambda _: said.set())]))
    assert said.wait(30)
    assert thread.is_alive()
    service.shutdown()
    thread.join(30)
    assert results == [0]


def test_an_include_between_may_give_what_is_required(go):
    def launched(given, outer):
        inner = IncludeLaunchDescription(
            LaunchDescriptionSource(LaunchDescription([DeclareLaunchArgument('a')])), launch_arguments=given
        )
        source = LaunchDescriptionSource(LaunchDescription([inner]))
        return go(IncludeLaunchDescription(source, launch_arguments=outer))[0]

    assert launched([('a', '1')], []) == 0
    assert launched([], [('a', '1')]) == 1  # that it is set outside does not count


def test_arguments_behind_a_reset_are_not_those_of_the_launch():
    inside = GroupAction([DeclareLaunchArgument('a')], forwarding=False)
    description = LaunchDescription([DeclareLaunchArgument('b'), inside, DeclareLaunchArgument('c')])
    assert [argument.name for argument in description.get_launch_arguments()] == ['b', 'c']
    assert all(argument._conditionally_included for argument in description.get_launch_arguments(True))


def test_a_description_from_a_script_is_its_own_place(go):
    where = LogInfo(msg=[ThisLaunchFileDir(), ' ', ThisLaunchFile()])
    source = LaunchDescriptionSource(LaunchDescription([where]), location='<script>')
    assert go(IncludeLaunchDescription(source))[1] == [f'<script> {os.path.abspath("<script>")}']
    assert source.location == '<script>'


def test_locals_are_read_only_and_name_what_there_is():
    context = LaunchContext()
    context.extend_globals({'a': 1})
    context.extend_locals({'b': 2})
    assert (context.locals.a, context.locals.b) == (1, 2)
    with pytest.raises(AttributeError, match=r"does not contain attribute 'c', it contains: \[a, b\]"):
        context.locals.c  # noqa: B018
    with pytest.raises(AttributeError, match="can't set attribute 'a', locals are read-only"):
        context.locals.a = 2


@pytest.mark.parametrize('kind', [SetLaunchConfiguration, SetEnvironmentVariable, AppendEnvironmentVariable])
def test_names_and_values_of_actions_are_lists_of_substitutions(kind):
    action = kind('a', ['b', LaunchConfiguration('c')])
    assert [part.text for part in action.name] == ['a'] and len(action.value) == 2


def test_without_a_writable_log_directory_the_launch_goes_on(go, monkeypatch, tmp_path, capsys):
    blocker = tmp_path / 'file'
    blocker.write_text('')
    monkeypatch.setenv('ROS_LOG_DIR', str(blocker))
    launch.logging.reset()
    assert go(ExecuteProcess(cmd=['true']))[0] == 0


def test_the_description_is_shown_as_a_tree():
    process = ExecuteProcess(cmd=['ls', LaunchConfiguration('a')])
    text = LaunchIntrospector().format_launch_description(
        LaunchDescription(
            [
                LogInfo(msg='x'),
                RegisterEventHandler(OnProcessExit(on_exit=[LogInfo(msg='y')])),
                process,
                GroupAction([]),
                LaunchDescription(),
            ]
        )
    )
    lines = text.splitlines()
    assert lines[1] == "├── LogInfo('x')"
    # Upstream draws a branch to the next line although that one belongs to the line above.
    assert lines[3] == "│   ├── OnProcessExit(matcher='event == ProcessExited', handler='<actions>', handle_once=False)"
    assert lines[4] == "│       └── LogInfo('y')"
    assert lines[5] == "├── ExecuteProcess(cmd=['ls', LaunchConfig('a')], cwd=None, env=None, shell=False)"
    assert re.fullmatch(r"├── Action\('<launch\.actions\.group_action\.GroupAction object at 0x\w+>'\)", lines[6])
    assert re.fullmatch(r"└── Unknown entity\('<launch\.launch_description\.LaunchDescription .+>'\)", lines[7])


def described(handler) -> str:
    return re.sub(r' at 0x\w+>', ' at N>', handler.describe()[0])


def test_event_handlers_describe_themselves_as_upstreams_do():
    process, entities = ExecuteProcess(cmd=['true']), [LogInfo(msg='x')]
    ended = OnProcessExit(target_action=process, on_exit=entities, handle_once=True)
    assert described(ended) == (
        "OnProcessExit(matcher='event == ProcessExited and ExecuteLocal(event.action)', handler='<actions>', "
        'handle_once=True)'
    )
    assert ended.describe()[1] == entities and (ended.entities, ended.handle_once) == (entities, True)
    assert described(OnExecutionComplete(target_action=entities[0], on_completion=entities)) == (
        "OnExecutionComplete(matcher='event == ExecutionComplete and Action(event.action)', handler='<actions>', "
        'handle_once=False)'
    )
    assert described(OnProcessIO(on_stdout=print)) == (
        "OnProcessIO(matcher='event == ProcessIO', handler='<function OnProcessIO.__init__.<locals>.handle at N>', "
        'handle_once=False)'
    )
    assert described(OnProcessStart(on_start=print)) == (
        "OnProcessStart(matcher='event == ProcessStarted', handler='<built-in function print>', handle_once=False)"
    )
    ending = OnShutdown(on_shutdown=entities)  # its actions are not shown
    assert described(ending) == (
        "OnShutdown(matcher='event issubclass of launch.events.Shutdown', "
        "handler='<function OnShutdown.__init__.<locals>.<lambda> at N>', handle_once=False)"
    )
    assert ending.describe()[1] == []
    own = EventHandler(matcher=lambda event: True, entities=entities)
    assert own.describe() == ("EventHandler(matcher='None', handler='None', handle_once=False)", entities)
    assert own.handler_description is own.matcher_description is None


# --- events and handlers -----------------------------------------------------------------------------------------


def test_on_execution_complete_comes_when_the_action_is_done(go):
    process = python('import sys; sys.exit(3)')
    quick = LogInfo(msg='quick')
    status, said, _ = go(
        RegisterEventHandler(OnExecutionComplete(target_action=quick, on_completion=[LogInfo(msg='after quick')])),
        RegisterEventHandler(OnExecutionComplete(
            target_action=process,
            on_completion=lambda event, _: LogInfo(msg=f'after {event.action.return_code}'),
        )),
        RegisterEventHandler(OnProcessExit(target_action=process, on_exit=[LogInfo(msg='exit')])),
        quick,
        process,
    )  # fmt: skip
    assert (status, said) == (0, ['quick', 'after quick', 'exit', 'after 3'])


def test_completion_may_start_a_process_although_nothing_else_runs(go):
    first, second = ExecuteProcess(cmd=['true']), ExecuteProcess(cmd=['true'])
    status, _, lines = go(RegisterEventHandler(OnExecutionComplete(target_action=first, on_completion=[second])), first)
    assert status == 0 and second.return_code == 0


@pytest.mark.parametrize('kind, argument', [
    (OnProcessExit, 'on_exit'), (OnProcessStart, 'on_start'), (OnExecutionComplete, 'on_completion'),
])  # fmt: skip
def test_a_handler_refuses_what_is_no_action(kind, argument):
    with pytest.raises(TypeError, match="action_matcher must be an '.+' instance or a callable"):
        kind(target_action='talker', **{argument: []})
    with pytest.raises(TypeError, match="of type 'LaunchDescriptionEntity' but got '<class 'str'>'"):
        kind(**{argument: [LogInfo(msg='x'), 'y']})
    assert not kind(target_action=lambda action: False, **{argument: []}).matches(ExecutionComplete(action=None))


@pytest.mark.parametrize('number, stream', [(0, 'stdin'), (1, 'stdout'), (2, 'stderr')])
def test_an_event_of_reading_or_writing_knows_its_stream(number, stream):
    details = {'action': None, 'name': 'one', 'cmd': ['ls'], 'cwd': None, 'env': None, 'pid': 1}
    event = ProcessIO(text=b'x', fd=number, **details)
    assert [name for name in ('stdin', 'stdout', 'stderr') if getattr(event, f'from_{name}')] == [stream]
    heard = []
    OnProcessIO(**{f'on_{stream}': lambda event: heard.append(event)}).handle(event, LaunchContext())
    assert heard == [event]


def test_a_process_is_found_by_its_number_name_and_program(go):
    long, other = python('import time; print("up"); time.sleep(100)'), python('pass')
    found = []

    def stop(event):
        found.extend(matches(long) for matches in (
            matches_pid(event.pid), matches_name(event.process_name), matches_executable(event.cmd[0]),
            matches_pid(0), matches_name('nobody-1'), matches_executable('/no/such'),
        ))  # fmt: skip
        return EmitEvent(event=ShutdownProcess(process_matcher=matches_name(event.process_name)))

    status, _, _ = go(RegisterEventHandler(OnProcessIO(target_action=long, on_stdout=stop)), long)
    assert found == [True, True, True, False, False, False] and status == 0
    assert not matches_pid(1)(other), 'a process that was never started has no number'


# --- what upstream has beside ------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    'substitution, text',
    [
        (AnySubstitution('false', 'on'), 'true'),
        (AnySubstitution('false', 'no', '0'), 'false'),
        (AllSubstitution('true', 'yes', '1'), 'true'),
        (AllSubstitution('true', LaunchConfiguration('x')), 'false'),
        (IfElseSubstitution('on', 'a', 'b'), 'a'),
        (IfElseSubstitution('yes', if_value='a'), 'a'),
        (IfElseSubstitution(LaunchConfiguration('x'), else_value='b'), 'b'),
        (NotEqualsSubstitution('1', 'one'), 'true'),
    ],
)
def test_truth_values_are_yamls(substitution, text):
    assert perform(substitution, x='off') == text


def test_a_text_without_truth_value_is_a_failure_of_the_substitution():
    with pytest.raises(SubstitutionFailure, match="Cannot convert value 'maybe' to '<class 'bool'>'"):
        perform(NotSubstitution('maybe'))
    with pytest.raises(RuntimeError, match='One of if_value and else_value must be specified'):
        IfElseSubstitution('true')


def test_the_content_of_a_file_and_the_directory_of_the_log(tmp_path):
    (tmp_path / 'robot.urdf').write_text('<robot/>')
    assert perform(FileContent([str(tmp_path), '/robot.urdf'])) == '<robot/>'
    with pytest.raises(SubstitutionFailure, match="cannot read the file '/no/such'"):
        perform(FileContent('/no/such'))
    assert perform(LaunchLogDir()) == launch.logging.launch_config.log_dir
    assert perform(LaunchLogDir() / 'a') == os.path.join(launch.logging.launch_config.log_dir, 'a')


def test_a_process_tells_what_it_was_made_of_and_what_became_of_it(go, tmp_path):
    process = ExecuteProcess(
        cmd=['pwd'], name=['n', LaunchConfiguration('x')], cwd=str(tmp_path), additional_env={'A': '1'},
        cached_output=True,
    )  # fmt: skip
    assert [part.describe() for part in process.name] == ["'n'", "LaunchConfig('x')"]
    assert process.cwd[0].text == str(tmp_path) and process.env is None and process.process_details is None
    assert [[part[0].text for part in pair] for pair in process.additional_env] == [['A', '1']]
    go(SetLaunchConfiguration('x', 'ow'), process)
    assert re.fullmatch(r'now-\d+', process.name)
    assert (process.cmd, process.cwd, process.env['A']) == (['pwd'], str(tmp_path), '1')
    assert process.get_stdout() == f'{tmp_path}\n' and process.get_stderr() == ''
    with pytest.raises(RuntimeError, match='cached_output=True'):
        ExecuteProcess(cmd=['true']).get_stdout()


@pytest.mark.parametrize('pattern, name', [('tru', 'env'), ('fal', 'true'), ('', 'env')])
def test_a_prefix_is_put_before_the_programs_that_match(go, pattern, name):
    process = ExecuteProcess(cmd=['true'])
    go(SetLaunchConfiguration('launch-prefix', 'env'), SetLaunchConfiguration('launch-prefix-filter', pattern), process)
    assert process.process_name.rpartition('-')[0] == name
    own = ExecuteProcess(cmd=['true'], prefix='nice')
    go(SetLaunchConfiguration('launch-prefix', 'env'), SetLaunchConfiguration('launch-prefix-filter', 'fal'), own)
    assert own.process_name.startswith('nice-')


def test_a_deprecated_description_warns(go):
    description = LaunchDescription([LogInfo(msg='x')], deprecated_reason='use the other')
    assert (description.deprecated, description.deprecated_reason) == (True, 'use the other')
    _, said, lines = go(description)
    assert lines[0] == '[WARNING] [launch]: deprecated launch description: use the other' and said == ['x']


def test_a_group_without_forwarding_begins_with_the_first_environment(go):
    shown = [LaunchConfiguration('a', default='-'), ' ', EnvironmentVariable('COURSE_TEST_E', default_value='-')]
    _, said, _ = go(
        SetLaunchConfiguration('a', '1'), SetEnvironmentVariable('COURSE_TEST_E', 'x'),
        GroupAction([LogInfo(msg=shown)], forwarding=False, launch_configurations={'b': LaunchConfiguration('a')}),
        LogInfo(msg=shown), ResetLaunchConfigurations({'c': '2'}), LogInfo(msg=shown),
    )  # fmt: skip
    assert said == ['- -', '1 x', '- x']


MODULES = {
    'launch.actions': 'append_environment_variable declare_launch_argument emit_event execute_process group_action '
    'include_launch_description log_info opaque_function register_event_handler set_environment_variable '
    'set_launch_configuration shutdown_action timer_action unregister_event_handler unset_environment_variable',
    'launch.conditions': 'if_condition unless_condition launch_configuration_equals launch_configuration_not_equals',
    'launch.event_handlers': 'on_execution_complete on_process_exit on_process_io on_process_start on_shutdown',
    'launch.events': 'shutdown matchers process.process_exited process.process_io process.shutdown_process',
    'launch.launch_description_sources': 'any_launch_description_source frontend_launch_description_source '
    'python_launch_description_source',
    'launch.substitutions': 'command environment_variable find_executable launch_configuration path_join_substitution '
    'python_expression text_substitution this_launch_file_dir',
}


@pytest.mark.parametrize('name', [f'{package}.{module}' for package, names in MODULES.items()
                                  for module in names.split()])  # fmt: skip
def test_modules_have_upstreams_names(name):
    module = importlib.import_module(name)
    wanted = {'shutdown_action': 'Shutdown', 'matchers': 'matches_action', 'process_io': 'ProcessIO',
              'on_process_io': 'OnProcessIO'}  # fmt: skip
    last = name.rpartition('.')[2]
    assert hasattr(module, wanted.get(last, ''.join(word.capitalize() for word in last.split('_'))))


# --- the log -----------------------------------------------------------------------------------------------------


def test_what_processes_print_is_in_the_log_files_as_it_is(go):
    done, _, _ = go(ExecuteProcess(cmd=['sh', '-c', 'echo out; echo err >&2'], name='both', output='full'))
    folder = Path(launch.logging.launch_config.log_dir)
    files = {file.name: sorted(file.read_text().splitlines()) for file in folder.iterdir() if file.name != 'launch.log'}
    name = next(name for name in files if name.endswith('-stdout.log')).removesuffix('-stdout.log')
    out, err = f'[{name}] out', f'[{name}] err'
    assert done == 0 and files == {f'{name}-stdout.log': [out], f'{name}-stderr.log': [err], f'{name}.log': [err, out]}
    text = (folder / 'launch.log').read_text()
    assert re.search(rf'^\d+\.\d+ {re.escape(out)}$', text, re.M), text
    assert re.search(rf'^\d+\.\d+ \[INFO\] \[{name}\]: process started', text, re.M)


def test_the_form_of_the_lines_can_be_chosen(capsys, monkeypatch):
    config = launch.logging.launch_config
    config.set_screen_format('default_with_timestamp')
    launch.logging.get_logger('one').info('x')
    assert re.fullmatch(r'\d+\.\d{7} \[INFO\] \[one\]: x\n', capsys.readouterr().out)
    config.set_screen_format('{message}!')
    launch.logging.get_logger('one').info('x')
    assert capsys.readouterr().out == 'x!\n'
    with pytest.raises(ValueError, match='Cannot set a custom format style for the "default" log format'):
        config.set_log_format('default', log_style='%')
    with pytest.raises(ValueError, match='/no/such is not a directory'):
        config.log_dir = '/no/such'
    monkeypatch.setenv('OVERRIDE_LAUNCH_SCREEN_FORMAT', r'{name}\t{message}')
    monkeypatch.setenv('OVERRIDE_LAUNCH_LOG_FORMAT', 'log {message}')
    launch.logging.reset()
    launch.logging.get_logger('one').info('x')
    assert capsys.readouterr().out == 'one\tx\n'
    assert Path(launch.logging.launch_config.get_log_file_path()).read_text() == 'log x\n'


def test_handlers_of_ones_own_take_the_log_files():
    config, written = launch.logging.launch_config, []

    class Kept(launch.logging.handlers.Handler):
        def emit(self, record):
            written.append((self.path, self.format(record)))

    def made(path, encoding):
        handler = Kept()
        handler.path = os.path.basename(path)
        return handler

    config.log_handler_factory = made
    config.set_log_format('{levelname} {message}')
    launch.logging.get_logger('one').info('x')
    out, _ = launch.logging.get_output_loggers('p', {'stdout': {'log', 'own_log'}})
    out.info('y')
    (first, x), (main, timed), own = written
    assert (first, x, main, own) == ('launch.log', 'INFO x', 'launch.log', ('p-stdout.log', 'y'))
    assert re.fullmatch(r'\d+\.\d+ y', timed)
    assert launch.logging.handlers.Handler is launch.logging.handlers.Handler
    with pytest.raises(AttributeError, match='there is no handler Formatter'):
        launch.logging.handlers.Formatter  # noqa: B018


def test_after_a_reset_old_loggers_write_nothing_and_settings_are_new(capsys):
    config, old = launch.logging.launch_config, launch.logging.get_logger('one')
    config.level = launch.logging.DEBUG
    old.debug('x')
    config.reset()
    old.error('y')
    new = launch.logging.get_logger('one')
    new.debug('y')
    assert capsys.readouterr().out == '[DEBUG] [one]: x\n' and config.level == launch.logging.INFO
    config.level = launch.logging.ERROR  # also for loggers that there are
    new.info('y')
    assert capsys.readouterr().out == ''
