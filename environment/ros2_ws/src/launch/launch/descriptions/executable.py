"""A program with its arguments, directory and environment, which an action may run."""

from __future__ import annotations

import itertools
import os
import re
import shlex
from collections.abc import Iterable

from launch.action import Action
from launch.launch_context import LaunchContext
from launch.some_substitutions_type import SomeSubstitutionsType
from launch.substitutions import LaunchConfiguration
from launch.utilities import normalize_to_list_of_substitutions, to_text

_numbers = itertools.count(1)


class Executable:
    """
    Describes a program to run; ``ExecuteLocal`` runs it.

    :param cmd: the program and its arguments
    :param prefix: words to put before the command, e.g. ``gdb -ex run --args``; by default the launch configuration
        ``launch-prefix``, if the program's name matches the pattern ``launch-prefix-filter``
    :param name: what the log calls the process, instead of the program's name
    :param cwd: the directory to run in
    :param env: the whole environment, instead of the launch's
    :param additional_env: variables to add to the environment
    :param arguments: more arguments, behind those of ``cmd``
    """

    def __init__(
        self,
        *,
        cmd: Iterable[SomeSubstitutionsType],
        prefix: SomeSubstitutionsType | None = None,
        name: SomeSubstitutionsType | None = None,
        cwd: SomeSubstitutionsType | None = None,
        env: dict | None = None,
        additional_env: dict | None = None,
        arguments: Iterable[SomeSubstitutionsType] | None = None,
    ):
        self._arguments = None if arguments is None else list(arguments)
        self._cmd = [normalize_to_list_of_substitutions(part) for part in [*cmd, *(self._arguments or [])]]
        self._prefix, self._name, self._cwd = prefix, name, cwd
        self._env, self._additional_env = _pairs(env), _pairs(additional_env)
        self._final_name: str | None = None
        self._final_cmd: list[str] | None = None
        self._final_cwd: str | None = None
        self._final_env: dict[str, str] | None = None

    @property
    def name(self):
        """What the log calls the process, as substitutions; None if it is the program's name."""
        return None if self._name is None else normalize_to_list_of_substitutions(self._name)

    @property
    def prefix(self):
        """What is put before the command, as substitutions."""
        default = LaunchConfiguration('launch-prefix', default='')
        return normalize_to_list_of_substitutions(default if self._prefix is None else self._prefix)

    @property
    def cmd(self) -> list:
        """The program and its arguments, each as substitutions."""
        return self._cmd

    @property
    def cwd(self):
        """The directory to run in, as substitutions; None if it is the launch's."""
        return None if self._cwd is None else normalize_to_list_of_substitutions(self._cwd)

    @property
    def env(self) -> list[tuple] | None:
        """The whole environment, as pairs of substitutions; None if it is the launch's."""
        return self._env

    @property
    def additional_env(self) -> list[tuple] | None:
        """The variables added to the environment, as pairs of substitutions; None if there are none."""
        return self._additional_env

    @property
    def arguments(self):
        """The arguments that were given apart from the command; None if there are none."""
        return self._arguments

    @property
    def final_name(self) -> str | None:
        """The name and a number, e.g. ``talker-1``; None before ``prepare``."""
        return self._final_name

    @property
    def final_cmd(self) -> list[str] | None:
        """The words of the command; None before ``prepare``."""
        return self._final_cmd

    @property
    def final_cwd(self) -> str | None:
        """The directory; None before ``prepare``, and if it is the launch's."""
        return self._final_cwd

    @property
    def final_env(self) -> dict[str, str] | None:
        """The environment; None before ``prepare``."""
        return self._final_env

    def prepare(self, context: LaunchContext, action: Action | None) -> None:
        """
        Find the texts of name, command, directory and environment.

        :param action: what will run it; for classes that are derived from this one
        """
        cmd = [to_text(context, part) for part in self._cmd]
        if self._has_prefix(context, cmd[0]):
            cmd = [*shlex.split(to_text(context, self.prefix)), *cmd]
        name = os.path.basename(cmd[0]) if self._name is None else to_text(context, self._name)
        self._final_cmd, self._final_name = cmd, f'{name}-{next(_numbers)}'
        self._final_cwd = None if self._cwd is None else to_text(context, self._cwd)
        # As it is now: the process starts later, when others may have changed it.
        env = dict(context.environment) if self._env is None else {}
        for variable, value in [*(self._env or []), *(self._additional_env or [])]:
            env[to_text(context, variable)] = to_text(context, value)
        self._final_env = env

    def _has_prefix(self, context: LaunchContext, program: str) -> bool:
        """Return False if the prefix is the launch's, and not meant for this program."""
        if self._prefix is not None:
            return True
        pattern = to_text(context, LaunchConfiguration('launch-prefix-filter', default=''))
        return re.match(pattern, os.path.basename(program)) is not None


def _pairs(variables: dict | None) -> list[tuple] | None:
    """Return the names and values of environment variables as substitutions."""
    if variables is None:
        return None
    return [tuple(map(normalize_to_list_of_substitutions, pair)) for pair in variables.items()]
