"""Two texts compared."""

from launch.frontend.expose import expose_substitution
from launch.launch_context import LaunchContext
from launch.substitutions.arguments import counted
from launch.substitutions.equals_substitution import EqualsSubstitution


@expose_substitution('not-equals')
class NotEqualsSubstitution(EqualsSubstitution):
    """True if the two differ."""

    @classmethod
    def parse(cls, data):
        """Read ``$(not-equals left right)``."""
        left, right = counted('not-equals', data, 2)
        return cls, {'left': left, 'right': right}

    def _same(self, context: LaunchContext) -> bool:
        return not super()._same(context)
