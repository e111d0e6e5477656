"""The value of a Python expression."""

import importlib
from collections.abc import Iterable

from launch.frontend.expose import expose_substitution
from launch.launch_context import LaunchContext
from launch.some_substitutions_type import SomeSubstitutionsType
from launch.substitution import Substitution
from launch.substitutions.arguments import counted
from launch.utilities import describe_substitutions, normalize_to_list_of_substitutions, perform_substitutions


@expose_substitution('eval')
class PythonExpression(Substitution):
    """
    The value of a Python expression, as text.

    What is wrong with it is raised as Python does: NameError, SyntaxError …

    :param python_modules: the modules it may use; the names of ``math`` can be used without the module's name
    """

    def __init__(self, expression: SomeSubstitutionsType, python_modules: Iterable[SomeSubstitutionsType] = ('math',)):
        self._expression = normalize_to_list_of_substitutions(expression)
        modules = [python_modules] if isinstance(python_modules, (str, Substitution)) else python_modules
        self._modules = [normalize_to_list_of_substitutions(module) for module in modules]

    @classmethod
    def parse(cls, data):
        """Read ``$(eval 'expression' ['module, module'])``."""
        expression, *modules = counted('eval', data, 1, 2)
        return cls, {'expression': expression, **({'python_modules': modules} if modules else {})}

    def describe(self) -> str:
        modules = ', '.join(describe_substitutions(module) for module in self._modules)
        return f'PythonExpr({describe_substitutions(self._expression)}, [{modules}])'

    def perform(self, context: LaunchContext) -> str:
        expression = perform_substitutions(context, self._expression)
        texts = [perform_substitutions(context, module) for module in self._modules]
        modules = [name.strip() for text in texts for name in text.split(',') if name.strip()]
        names = {name.partition('.')[0]: importlib.import_module(name.partition('.')[0]) for name in modules}
        for name in modules:
            importlib.import_module(name)
        if 'math' in names:
            names = {**vars(names['math']), **names}
        return str(eval(expression, {}, names))
