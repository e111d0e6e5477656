"""Texts that the launch context knows."""

from __future__ import annotations

import os
import socket

from launch.launch_context import LaunchContext
from launch.some_substitutions_type import SomeSubstitutionsType
from launch.substitution import Substitution
from launch.substitutions.substitution_failure import SubstitutionFailure
from launch.utilities import describe_substitutions, normalize_to_list_of_substitutions, perform_substitutions, to_text


class _Named(Substitution):
    """Something of the context that has a name and perhaps a default."""

    _label = ''

    def __init__(self, name: SomeSubstitutionsType, *, default=None):
        self._name = normalize_to_list_of_substitutions(name)
        if isinstance(default, (int, float)):  # upstream takes numbers, too
            default = str(default)
        self._default = None if default is None else normalize_to_list_of_substitutions(default)

    def describe(self) -> str:
        return f'{self._label}({describe_substitutions(self._name)})'

    def perform(self, context: LaunchContext) -> str:
        name = perform_substitutions(context, self._name)
        value = self._look_up(context, name)
        if value is None:
            if self._default is None:
                raise SubstitutionFailure(self._failure(name))
            return perform_substitutions(context, self._default)
        return value

    def _look_up(self, context: LaunchContext, name: str) -> str | None:
        raise NotImplementedError

    def _failure(self, name: str) -> str:
        raise NotImplementedError


class LaunchConfiguration(_Named):
    """The value of a launch argument or another launch configuration."""

    _label = 'LaunchConfig'

    def __init__(self, variable_name: SomeSubstitutionsType, *, default=None):
        super().__init__(variable_name, default=default)

    @property
    def variable_name(self):
        """The name, as substitutions."""
        return self._name

    def _look_up(self, context: LaunchContext, name: str) -> str | None:
        return context.launch_configurations.get(name)

    def _failure(self, name: str) -> str:
        return f"launch configuration '{name}' does not exist"


class EnvironmentVariable(_Named):
    """The value of an environment variable."""

    _label = 'EnvVar'

    def __init__(self, name: SomeSubstitutionsType, *, default_value=None):
        super().__init__(name, default=default_value)

    def _look_up(self, context: LaunchContext, name: str) -> str | None:
        return context.environment.get(name)

    def _failure(self, name: str) -> str:
        return f"environment variable '{name}' does not exist"


class LocalSubstitution(Substitution):
    """A local variable of the context, e.g. ``event.reason`` in a handler of a shutdown."""

    def __init__(self, expression: str, description: str | None = None):
        self._expression, self._description = expression, description or expression

    def describe(self) -> str:
        return f"LocalVar('{self._description}')"

    def perform(self, context: LaunchContext) -> str:
        first, *rest = self._expression.split('.')
        try:
            value = context.get_locals_as_dict()[first]
            for name in rest:
                value = getattr(value, name)
        except (KeyError, AttributeError):
            raise SubstitutionFailure(f"local variable '{self._expression}' does not exist") from None
        return str(value)


class ThisLaunchFile(Substitution):
    """The path of the launch file."""

    def describe(self) -> str:
        return 'ThisLaunchFile()'

    def perform(self, context: LaunchContext) -> str:
        path = context.get_locals_as_dict().get('current_launch_file_path')
        if path is None:
            raise SubstitutionFailure('ThisLaunchFile used outside of a launch file (in a script)')
        return path


class ThisLaunchFileDir(Substitution):
    """The directory of the launch file."""

    def describe(self) -> str:
        return 'ThisLaunchFileDir()'

    def perform(self, context: LaunchContext) -> str:
        path = context.get_locals_as_dict().get('current_launch_file_directory')
        if path is None:
            raise SubstitutionFailure('ThisLaunchFileDir used outside of a launch file (in a script)')
        return path


class AnonName(Substitution):
    """A name made unique; the same within one launch."""

    def __init__(self, name: SomeSubstitutionsType):
        self._name = normalize_to_list_of_substitutions(name)

    def describe(self) -> str:
        return f'AnonName({describe_substitutions(self._name)})'

    def perform(self, context: LaunchContext) -> str:
        name = to_text(context, self._name)
        host = ''.join(char if char.isalnum() else '_' for char in socket.gethostname())
        made = f'{name}_{host}_{os.getpid()}_{id(context)}'
        return context.launch_configurations.setdefault(f'anon{name}', made)
