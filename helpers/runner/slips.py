"""What the text of an answer shows of common slips: a missing `self.`, a misspelt name. Nothing is executed."""

import ast
import builtins
import warnings
from functools import lru_cache

from rclpy.node import Node

from helpers.runner import similar

_CONSTRUCTORS = frozenset('_init_ __init _init __init_ _init__ init init__ __int__ __inti__ __intit__'.split())


def missing_self(name: str, text: str) -> str:
    """A sentence if a class of the answer has an attribute or a method `name`; '' if none has."""
    found = _names(text)
    return f'Your class has `self.{name}`: is `self.` missing before it?' if name in found.attributes else ''


def near_name(name: str, text: str) -> str:
    """A name of the answer, or of Python, that is meant by a misspelt one, perhaps; '' if none is like it."""
    return similar.nearest(name, (_names(text).names | set(dir(builtins))) - {name}, 0.8)


def unset_attribute(name: str, text: str) -> str:
    """A sentence on an attribute that an object does not have: nothing sets it, or something like it is set."""
    found = _names(text)
    if name in found.setters:
        return _too_late(name, sorted(found.setters[name]))
    if name in found.changed:
        return f'`self.{name}` has no value that could be changed: set a first one in `__init__`.'
    if name in found.attributes or not found.attributes:
        return ''
    if name in found.variables:
        return f'`{name} = …` makes a variable that the function forgets at its end: write `self.{name} = …`.'
    own = sorted(found.attributes)
    there = [*own, *dir(Node)]
    near = similar.nearest(name, there) or next((one for one in own if one.startswith(name)), '')
    said = f'Nothing in your code sets `{name}`'
    return f'{said}; there is `{near}`.' if near else f'{said}.'


def _too_late(name: str, setters: list[str]) -> str:
    if '__init__' in setters:
        return f'`self.{name}` is asked for before `__init__` has set it, or `__init__` does not set it each time.'
    return f'Only `{setters[0]}` sets `self.{name}`, and it has not run yet. Set a first value in `__init__`.'


def misspelt_constructor(text: str) -> str:
    """A sentence if a class has a method that was meant to be `__init__`; '' if none has."""
    wrong = sorted(_names(text).methods & _CONSTRUCTORS)
    return (
        f'Is `{wrong[0]}` the constructor? It is written `__init__`, with two underscores on each side.'
        if wrong
        else ''
    )


class _Names(ast.NodeVisitor):
    def __init__(self) -> None:
        self.attributes: set[str] = set()  # of `self`, methods included
        self.methods: set[str] = set()
        self.variables: set[str] = set()  # to which functions assign
        self.names: set[str] = set()  # all that it uses or binds
        self.setters: dict[str, set[str]] = {}  # attribute of `self`: the functions that set it
        self.changed: set[str] = set()  # attributes of `self` to which something is added
        self._function = ''

    def visit_FunctionDef(self, node: ast.FunctionDef | ast.AsyncFunctionDef) -> None:
        for part in ast.walk(node):
            if isinstance(part, ast.Assign):
                self.variables |= {target.id for target in part.targets if isinstance(target, ast.Name)}
        around, self._function = self._function, node.name
        self.generic_visit(node)
        self._function = around

    visit_AsyncFunctionDef = visit_FunctionDef

    def visit_ClassDef(self, node: ast.ClassDef) -> None:
        for part in node.body:
            if isinstance(part, ast.FunctionDef | ast.AsyncFunctionDef):
                self.methods.add(part.name)
                self.attributes.add(part.name)
            elif isinstance(part, ast.Assign | ast.AnnAssign):
                targets = part.targets if isinstance(part, ast.Assign) else [part.target]
                self.attributes |= {target.id for target in targets if isinstance(target, ast.Name)}
        self.generic_visit(node)

    def visit_Name(self, node: ast.Name) -> None:
        self.names.add(node.id)

    def visit_arg(self, node: ast.arg) -> None:
        self.names.add(node.arg)
        self.generic_visit(node)

    def visit_alias(self, node: ast.alias) -> None:
        self.names.add((node.asname or node.name).partition('.')[0])

    def visit_AugAssign(self, node: ast.AugAssign) -> None:
        # `self.count += 1` wants a value that is there
        if isinstance(node.target, ast.Attribute) and getattr(node.target.value, 'id', '') == 'self':
            self.changed.add(node.target.attr)
        self.visit(node.value)

    def visit_Attribute(self, node: ast.Attribute) -> None:
        if isinstance(node.ctx, ast.Store) and isinstance(node.value, ast.Name) and node.value.id == 'self':
            self.attributes.add(node.attr)
            self.setters.setdefault(node.attr, set()).add(self._function)
        self.generic_visit(node)


@lru_cache(maxsize=8)
def _names(text: str) -> _Names:
    found = _Names()
    try:
        with warnings.catch_warnings():
            warnings.simplefilter('ignore')  # of the learner's text, such as an invalid escape
            tree = ast.parse(text)
        found.visit(tree)
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        pass  # an answer that is no Python
    return found
