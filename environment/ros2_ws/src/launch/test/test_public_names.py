"""Each public name of launch and launch_ros is there for a reason: the course, a tutorial, or upstream's programs."""

import importlib
import re
from pathlib import Path

import launch
import launch_ros

from helpers.paths import ROOT

# What tutorials of Jazzy use: those of launch and testing, a how-to guide, upstream's demos.
TUTORIALS = {
    'Creating a launch file; Integrating launch files into packages': 'LaunchDescription actions substitutions Node',
    'Using substitutions': 'DeclareLaunchArgument ExecuteProcess IncludeLaunchDescription TimerAction conditions '
    'IfCondition LaunchConfiguration PythonExpression PathJoinSubstitution FindPackageShare launch_description_sources '
    'PythonLaunchDescriptionSource',
    'Using event handlers': 'EmitEvent LogInfo RegisterEventHandler OnExecutionComplete OnProcessExit OnProcessIO '
    'OnProcessStart OnShutdown Shutdown EnvironmentVariable FindExecutable LocalSubstitution event_handlers events',
    'Managing large projects': 'GroupAction PushROSNamespace TextSubstitution',
    'Launch: different file formats': 'frontend',
    'Migrating launch files, in XML': 'SetEnvironmentVariable UnsetEnvironmentVariable SetLaunchConfiguration Command '
    'UnlessCondition PushRosNamespace FindPackagePrefix ExecutableInPackage ThisLaunchFileDir',
    'Integration testing with launch': 'LaunchService',
    'Architecture of launch, and its examples': 'Action Condition Event EventHandler LaunchContext Substitution '
    'logging LaunchDescriptionEntity LaunchDescriptionSource LaunchIntrospector process ProcessExited ProcessIO '
    'ProcessStarted ProcessStderr ProcessStdout ShutdownProcess SignalProcess matches_action matches_name matches_pid '
    'matches_executable OpaqueCoroutine OpaqueFunction UnregisterEventHandler TimerEvent',
    'demos: lifecycle': 'LifecycleNode LifecycleTransition ChangeState StateTransition OnStateTransition lifecycle '
    'matches_node_name',
}
# What launch files and packages of others use that no tutorial shows; upstream has all of it.
OTHERS = {
    'tags and substitutions of XML and YAML': 'AppendEnvironmentVariable UnsetLaunchConfiguration '
    'ResetLaunchConfigurations AllSubstitution AndSubstitution AnonName AnySubstitution EqualsSubstitution FileContent '
    'IfElseSubstitution LaunchLogDir NotEqualsSubstitution NotSubstitution OrSubstitution ThisLaunchFile Parameter '
    'RosTimer SetParameter SetParametersFromFile SetRemap SetROSLogDir SetUseSimTime',
    'launch files that go on with a directory by /': 'PathSubstitution',
    'launch files of earlier distributions': 'LaunchConfigurationEquals LaunchConfigurationNotEquals '
    'AnyLaunchDescriptionSource FrontendLaunchDescriptionSource',
    'extensions of launch, and annotations': 'SomeEntitiesType SomeEntitiesType_types_tuple SomeSubstitutionsType '
    'SomeSubstitutionsType_types_tuple SubstitutionFailure parameter_descriptions '
    'descriptions OnActionEventBase ExecutionComplete ProcessTargetedEvent RunningProcessEvent FindPackage '
    'evaluate_condition_expression InvalidConditionExpressionError',
    'packages with tags of their own': 'Entity Parser expose expose_action expose_substitution type_utils '
    'parse_substitution parse_if_substitutions InvalidFrontendLaunchFileError',
    'packages with actions of their own that run programs': 'ExecuteLocal Executable',
    'programs that read launch files': 'InvalidLaunchFileError InvalidPythonLaunchFileError '
    'get_launch_description_from_any_launch_file get_launch_description_from_frontend_launch_file '
    'get_launch_description_from_python_launch_file load_python_launch_file_as_module',
    'tests that look at what a launch file gives to a node': 'evaluate_parameters normalize_parameters',
    'groups that are written by hand': 'PopEnvironment PopLaunchConfigurations PushEnvironment '
    'PushLaunchConfigurations ResetEnvironment',
}
IMPORT = re.compile(r'from (launch(?:_ros)?(?:\.\w+)*) import (\([^)]*\)|[^\n(]*)')


def public_names() -> dict[str, set[str]]:
    """The names of both packages' `__all__`, with the modules that have them."""
    names: dict[str, set[str]] = {}
    for package in (launch, launch_ros):
        root = Path(package.__file__).parent
        for file in root.rglob('__init__.py'):
            module = '.'.join((package.__name__, *file.parent.relative_to(root).parts))
            for name in getattr(importlib.import_module(module), '__all__', ()):
                names.setdefault(name, set()).add(module)
    return names


def names_in(reasons: dict[str, str]) -> set[str]:
    return {name for names in reasons.values() for name in names.split()}


def course_uses() -> set[str]:
    """What the chapters, helpers and packages of the course import from launch and launch_ros."""
    sources = ROOT / 'environment/ros2_ws/src'
    files = [
        *(ROOT / 'solutions').glob('*.md'),
        *(ROOT / 'helpers').rglob('*.py'),
        *sources.glob('*/launch/*.launch.py'),
    ]
    files += [file for file in sources.glob('*/*/**/*.py') if 'test' not in file.parts and 'launch' not in file.parts]
    found = set()
    for file in files:
        for _, names in IMPORT.findall(file.read_text()):
            found |= {name.split(' as ')[0].strip() for name in names.strip('()').split(',')}
    return found


def test_every_public_name_has_a_reason():
    unused = set(public_names()) - names_in(TUTORIALS) - names_in(OTHERS) - course_uses()
    assert not unused, 'used by nobody: drop them, or say why they stay'


def test_the_reasons_name_what_is_there():
    assert names_in(TUTORIALS) | names_in(OTHERS) <= set(public_names())


def test_public_names_can_be_imported():
    for name, modules in public_names().items():
        for module in modules:
            assert hasattr(importlib.import_module(module), name), f'{module} has no {name}'
