"""Runs a program."""

from __future__ import annotations

import shlex
from collections.abc import Iterable
from typing import Any

from launch.actions.execute_local import ExecuteLocal
from launch.actions.shutdown_action import Shutdown
from launch.descriptions.executable import Executable
from launch.frontend import Entity, Parser, expose_action
from launch.some_substitutions_type import SomeSubstitutionsType
from launch.substitutions import TextSubstitution
from launch.utilities import describe_substitutions


@expose_action('executable')
class ExecuteProcess(ExecuteLocal):
    """
    Runs a program until it ends, or until the system shuts down.

    Further keyword arguments are those of ``ExecuteLocal``; those here are those of ``Executable``.

    :param cmd: the program and its arguments
    :param prefix: words to put before the command
    :param name: what the log calls the process, instead of the program's name
    :param cwd: the directory to run in
    :param env: the whole environment, instead of the launch's
    :param additional_env: variables to add to the environment
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
        **kwargs,
    ):
        program = Executable(cmd=cmd, prefix=prefix, name=name, cwd=cwd, env=env, additional_env=additional_env)
        super().__init__(process_description=program, **kwargs)

    @classmethod
    def parse(cls, entity: Entity, parser: Parser, ignore: Iterable[str] = ()):
        """
        Read ``executable``.

        :param ignore: attributes that a derived action reads itself
        """
        _, kwargs = super().parse(entity, parser)
        if 'cmd' not in ignore:
            kwargs['cmd'] = cls._parse_cmdline(entity.get_attr('cmd'), parser)
        attributes = [
            ('cwd', 'cwd', str),
            ('name', 'name', str),
            ('launch-prefix', 'prefix', str),
            ('output', 'output', str),
            ('sigterm_timeout', 'sigterm_timeout', float),
            ('sigkill_timeout', 'sigkill_timeout', float),
            ('respawn', 'respawn', bool),
            ('respawn_delay', 'respawn_delay', float),
            ('respawn_max_retries', 'respawn_max_retries', int),
            ('shell', 'shell', bool),
            ('emulate_tty', 'emulate_tty', bool),
            ('log_cmd', 'log_cmd', bool),
        ]
        for attribute, argument, kind in attributes:
            if argument in ignore:
                continue
            may_be_text = kind is not int and argument not in ('respawn_delay', 'shell', 'log_cmd')
            value = entity.get_attr(attribute, data_type=kind, optional=True, can_be_str=may_be_text)
            if value is not None:
                kwargs[argument] = parser.parse_substitution(value) if isinstance(value, str) else value
        for timeout in kwargs.keys() & {'sigterm_timeout', 'sigkill_timeout'}:
            if isinstance(kwargs[timeout], float):
                kwargs[timeout] = str(kwargs[timeout])
        if kwargs.get('respawn_delay', 0.0) < 0.0:
            raise ValueError(
                'Attribute respawn_delay of Entity node expected to be a non-negative value but got '
                f'`{kwargs["respawn_delay"]}`'
            )
        if 'on_exit' not in ignore:
            cls._parse_on_exit(entity, kwargs)
        if 'additional_env' not in ignore:
            cls._parse_env(entity, parser, kwargs)
        return cls, kwargs

    @staticmethod
    def _parse_on_exit(entity: Entity, kwargs: dict[str, Any]) -> None:
        on_exit = entity.get_attr('on_exit', optional=True)
        if on_exit == 'shutdown':
            kwargs['on_exit'] = [Shutdown()]
        elif on_exit is not None:
            raise ValueError(
                f'Attribute on_exit of Entity node expected to be shutdown but got `{on_exit}`'
                'Other on_exit actions not yet supported'
            )

    @staticmethod
    def _parse_env(entity: Entity, parser: Parser, kwargs: dict[str, Any]) -> None:
        variables = entity.get_attr('env', data_type=list[Entity], optional=True)
        if variables is not None:
            kwargs['additional_env'] = {
                tuple(parser.parse_substitution(item.get_attr('name'))): parser.parse_substitution(
                    item.get_attr('value')
                )
                for item in variables
            }
            for item in variables:
                item.assert_entity_completely_parsed()

    @staticmethod
    def _parse_cmdline(cmd: str, parser: Parser) -> list[list]:
        """Return the words of a command line; a space inside what a substitution gives does not divide words."""
        substitutions = []

        def keep(substitution) -> str:
            substitutions.append(substitution)
            return f'\0{len(substitutions) - 1}\0'

        line = ''.join(
            part.text if isinstance(part, TextSubstitution) else keep(part) for part in parser.parse_substitution(cmd)
        )
        words = []
        for word in shlex.split(line):
            pieces = [
                TextSubstitution(text=piece) if i % 2 == 0 else substitutions[int(piece)]
                for i, piece in enumerate(word.split('\0'))
            ]
            words.append(
                [piece for piece in pieces if not isinstance(piece, TextSubstitution) or piece.text]
                or [TextSubstitution(text='')]
            )
        return words

    @property
    def cmd(self) -> list:
        """The command: lists of substitutions, or, once it is executed, texts."""
        return self.process_description.final_cmd or self.process_description.cmd

    @property
    def name(self):
        """What the log calls the process: substitutions or None, or, once it is executed, a text such as talker-1."""
        return self.process_description.final_name or self.process_description.name

    @property
    def cwd(self):
        """The directory to run in: substitutions, or, once it is executed, a text; None if it is the launch's."""
        return self.process_description.final_cwd or self.process_description.cwd

    @property
    def env(self):
        """The whole environment: pairs of substitutions, None for the launch's; once it is executed, texts."""
        final = self.process_description.final_env
        return self.process_description.env if final is None else final

    @property
    def additional_env(self):
        """The variables added to the environment, as pairs of substitutions; None if there are none."""
        return self.process_description.additional_env

    @property
    def prefix(self):
        """What is put before the command, as substitutions."""
        return self.process_description.prefix

    def describe(self) -> str:
        program = self.process_description
        cwd = None if program.cwd is None else f"'{describe_substitutions(program.cwd)}'"
        parts = ', '.join(describe_substitutions(part) for part in program.cmd)
        pairs = [': '.join(map(describe_substitutions, pair)) for pair in program.env or []]
        env = program.env and f'{{{", ".join(pairs)}}}'
        return f'ExecuteProcess(cmd=[{parts}], cwd={cwd}, env={env}, shell={self.shell})'
