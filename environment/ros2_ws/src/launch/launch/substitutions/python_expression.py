"""The value of a Python expression."""

import importlib
from collections.abc import Iterable

from launch.launch_context import LaunchContext
from launch.some_substitutions_type import SomeSubstitutionsType
from launch.substitution import Substitution
from launch.substitutions.substitution_failure import SubstitutionFailure
from launch.utilities import describe_substitutions, normalize_to_list_of_substitutions, perform_substitutions


class PythonExpression(Substitution):
    """
    The value of a Python expression, as text.

    :param python_modules: the modules it may use; the names of ``math`` can be used without the module's name
    """

    def __init__(self, expression: SomeSubstitutionsType, python_modules: Iterable[str] = ('math',)):
        self._expression = normalize_to_list_of_substitutions(expression)
        self._modules = [python_modules] if isinstance(python_modules, str) else list(python_modules)

    def describe(self) -> str:
        return f'PythonExpr({describe_substitutions(self._expression)})'

    def perform(self, context: LaunchContext) -> str:
        expression = perform_substitutions(context, self._expression)
        try:
            names = {name: importlib.import_module(name) for name in self._modules}
            if 'math' in names:
                names = {**vars(names['math']), **names}
            return str(eval(expression, {}, names))
        except Exception as error:
            raise SubstitutionFailure(f"cannot evaluate the Python expression '{expression}': {error}") from error
