"""A name made unique."""

import os
import socket

from launch.frontend.expose import expose_substitution
from launch.launch_context import LaunchContext
from launch.some_substitutions_type import SomeSubstitutionsType
from launch.substitution import Substitution
from launch.substitutions.arguments import counted
from launch.utilities import describe_substitutions, normalize_to_list_of_substitutions, perform_substitutions


@expose_substitution('anon')
class AnonName(Substitution):
    """A name made unique; the same within one launch."""

    def __init__(self, name: SomeSubstitutionsType):
        self._name = normalize_to_list_of_substitutions(name)

    @classmethod
    def parse(cls, data):
        """Read ``$(anon name)``."""
        return cls, {'name': counted('anon', data, 1)[0]}

    def describe(self) -> str:
        return f'AnonName({describe_substitutions(self._name)})'

    def perform(self, context: LaunchContext) -> str:
        name = perform_substitutions(context, self._name)
        host = ''.join(char if char.isalnum() else '_' for char in socket.gethostname())
        made = f'{name}_{host}_{os.getpid()}_{id(context)}'
        return context.launch_configurations.setdefault(f'anon{name}', made)
