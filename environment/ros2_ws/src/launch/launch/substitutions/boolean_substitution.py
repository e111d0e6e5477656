"""Truth values combined, as the texts ``true`` and ``false``."""

from launch.frontend.expose import expose_substitution
from launch.launch_context import LaunchContext
from launch.some_substitutions_type import SomeSubstitutionsType
from launch.substitution import Substitution
from launch.substitutions.arguments import counted
from launch.substitutions.substitution_failure import SubstitutionFailure
from launch.utilities import describe_substitutions
from launch.utilities.type_utils import to_bool


def decide(context: LaunchContext, value: SomeSubstitutionsType) -> bool:
    """
    Return the truth value of a text.

    :raises SubstitutionFailure: if it has none
    """
    try:
        return to_bool(context, value)
    except ValueError as error:
        raise SubstitutionFailure(str(error)) from error


class _Several(Substitution):
    """Some truth values, made one."""

    def __init__(self, *args: SomeSubstitutionsType):
        self.args = list(args)

    def describe(self) -> str:
        return f'{type(self).__name__}({" ".join(describe_substitutions(arg) for arg in self.args)})'

    def perform(self, context: LaunchContext) -> str:
        return str(self._combine([decide(context, arg) for arg in self.args])).lower()

    def _combine(self, values: list[bool]) -> bool:
        raise NotImplementedError


@expose_substitution('any')
class AnySubstitution(_Several):
    """True if at least one is."""

    @classmethod
    def parse(cls, data):
        """Read ``$(any value …)``."""
        return cls, {'args': data}

    def _combine(self, values: list[bool]) -> bool:
        return any(values)


@expose_substitution('all')
class AllSubstitution(_Several):
    """True if all are."""

    @classmethod
    def parse(cls, data):
        """Read ``$(all value …)``."""
        return cls, {'args': data}

    def _combine(self, values: list[bool]) -> bool:
        return all(values)


@expose_substitution('and')
class AndSubstitution(AllSubstitution):
    """True if both are."""

    def __init__(self, left: SomeSubstitutionsType, right: SomeSubstitutionsType):
        super().__init__(left, right)

    @classmethod
    def parse(cls, data):
        """Read ``$(and left right)``."""
        left, right = counted('and', data, 2)
        return cls, {'left': left, 'right': right}


@expose_substitution('or')
class OrSubstitution(AnySubstitution):
    """True if one is."""

    def __init__(self, left: SomeSubstitutionsType, right: SomeSubstitutionsType):
        super().__init__(left, right)

    @classmethod
    def parse(cls, data):
        """Read ``$(or left right)``."""
        left, right = counted('or', data, 2)
        return cls, {'left': left, 'right': right}


@expose_substitution('not')
class NotSubstitution(_Several):
    """True if the other is false."""

    def __init__(self, value: SomeSubstitutionsType):
        super().__init__(value)

    @classmethod
    def parse(cls, data):
        """Read ``$(not value)``."""
        return cls, {'value': counted('not', data, 1)[0]}

    def _combine(self, values: list[bool]) -> bool:
        return not values[0]
