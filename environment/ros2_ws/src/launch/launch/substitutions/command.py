"""The output of a command."""

import shlex
import subprocess

import launch.logging
from launch.frontend.expose import expose_substitution
from launch.launch_context import LaunchContext
from launch.some_substitutions_type import SomeSubstitutionsType
from launch.substitution import Substitution
from launch.substitutions.arguments import counted
from launch.substitutions.substitution_failure import SubstitutionFailure
from launch.utilities import describe_substitutions, normalize_to_list_of_substitutions, perform_substitutions, to_text


@expose_substitution('command')
class Command(Substitution):
    """
    What a command prints. It is run once, without a shell, and must succeed.

    :param on_stderr: what to do if it prints to its standard error: fail, ignore, warn or capture
    """

    def __init__(self, command: SomeSubstitutionsType, *, on_stderr: SomeSubstitutionsType = 'fail'):
        self._command = normalize_to_list_of_substitutions(command)
        self._on_stderr = on_stderr

    @classmethod
    def parse(cls, data):
        """Read ``$(command 'command' [on_stderr])``."""
        command, *on_stderr = counted('command', data, 1, 2)
        return cls, {'command': command, **({'on_stderr': on_stderr[0]} if on_stderr else {})}

    def describe(self) -> str:
        return f'Command({describe_substitutions(self._command)})'

    def perform(self, context: LaunchContext) -> str:
        text = perform_substitutions(context, self._command)
        on_stderr = to_text(context, self._on_stderr)
        if on_stderr not in ('fail', 'ignore', 'warn', 'capture'):
            raise SubstitutionFailure("expected 'on_stderr' to be one of: 'fail', 'ignore', 'warn', 'capture'")
        try:
            result = subprocess.run(
                shlex.split(text),
                text=True,
                check=False,
                stdout=subprocess.PIPE,
                stderr=subprocess.STDOUT if on_stderr == 'capture' else subprocess.PIPE,
                env=dict(context.environment),
            )
        except FileNotFoundError as error:
            raise SubstitutionFailure(f'file not found: {error}') from error
        if result.returncode != 0:
            raise SubstitutionFailure(
                f'executed command failed. Command: {text}\nCaptured stderr output: {result.stderr or ""}'
            )
        if result.stderr and on_stderr != 'ignore':
            message = (
                f'executed command showed stderr output. Command: {text}\nCaptured stderr output:\n{result.stderr}'
            )
            if on_stderr == 'fail':
                raise SubstitutionFailure(message)
            launch.logging.get_logger('launch.substitutions').warning(message)
        return result.stdout
