"""Substitutions: texts that are known only while launching."""

from launch.substitutions.boolean_substitution import (
    AndSubstitution,
    EqualsSubstitution,
    IfElseSubstitution,
    NotEqualsSubstitution,
    NotSubstitution,
    OrSubstitution,
)
from launch.substitutions.command import Command
from launch.substitutions.context_substitution import (
    AnonName,
    EnvironmentVariable,
    LaunchConfiguration,
    LocalSubstitution,
    ThisLaunchFile,
    ThisLaunchFileDir,
)
from launch.substitutions.path_substitution import FindExecutable, PathJoinSubstitution
from launch.substitutions.python_expression import PythonExpression
from launch.substitutions.substitution_failure import SubstitutionFailure
from launch.substitutions.text_substitution import TextSubstitution

__all__ = [
    'AndSubstitution',
    'AnonName',
    'Command',
    'EnvironmentVariable',
    'EqualsSubstitution',
    'FindExecutable',
    'IfElseSubstitution',
    'LaunchConfiguration',
    'LocalSubstitution',
    'NotEqualsSubstitution',
    'NotSubstitution',
    'OrSubstitution',
    'PathJoinSubstitution',
    'PythonExpression',
    'SubstitutionFailure',
    'TextSubstitution',
    'ThisLaunchFile',
    'ThisLaunchFileDir',
]
