"""What the text of an answer shows of common slips: a missing `self.`, a misspelt name. Nothing is executed."""

import ast
import builtins
import re
import warnings
from collections.abc import Sequence
from functools import lru_cache

from rclpy.node import Node

from helpers.runner import imports, ros_members, similar

_TYPED = 'create_publisher', 'create_subscription', 'create_service', 'create_client'  # their first argument is a type
_UNDERSCORES = 'It is written `__init__`, with two underscores on each side.'
_CONSTRUCTORS = frozenset('_init_ __init _init __init_ _init__ init init__ __int__ __inti__ __intit__'.split())


def missing_self(name: str, text: str, line: str = '') -> str:
    """A sentence if a class of the answer, or Node, has an attribute or a method `name`; '' if none has."""
    found = _names(text)
    if name in found.attributes:
        return f'Your class has `self.{name}`: is `self.` missing before it?'
    of_node = found.bases and name in found.in_classes and name[0] != '_' and callable(getattr(Node, name, None))
    # rclpy.logging has a function get_logger as well, which takes a name.
    if of_node and not re.search(r'\bget_logger\(\s*[^\s)]', line):
        return f'`{name}` is a method of Node: is `self.` missing before it?'
    return ''


def class_meant(name: str, text: str) -> str:
    """A sentence if the answer uses `name` as only a class is used that is spelt with capital letters; else ''."""
    if not name[:1].islower():
        return ''
    found = _names(text)
    for meant in sorted({*found.names, *found.methods, imports.nearest(name.capitalize())}):
        # What has capitals only is a constant.
        if meant.lower() != name.lower() or meant.isupper() or not meant[0].isupper():
            continue
        if name in found.classlike or ros_members.of_class(meant) & found.members.get(name, set()):
            return f'Is `{meant}` meant? The name of a class begins with a capital letter.'
    return ''


def near_name(name: str, text: str) -> str:
    """A name of the answer, or of Python, that is meant by a misspelt one, perhaps; '' if none is like it."""
    return similar.nearest(name, (_names(text).names | set(dir(builtins))) - {name}, 0.8)


def unset_attribute(name: str, text: str, owner: str = '', cells: Sequence[str] = ()) -> str:
    """A sentence on an attribute that an object does not have: nothing sets it, or something like it is set.

    :param owner: the name of the object's class.
    :param cells: the texts of the other cells.
    """
    found = _names(text)
    if name in found.setters:
        return _too_late(name, sorted(found.setters[name]))
    of_init = found.parameters.get(owner, set().union(*found.parameters.values()))
    if name in of_init:
        return f'`{name}` is a parameter of `__init__`: write `self.{name} = {name}` there.'
    if name in found.changed:
        return f'`self.{name}` has no value that could be changed: set a first one in `__init__`.'
    if name in found.attributes or not found.attributes:
        return ''
    if said := _no_method(name, text):
        return said
    if name in found.variables:
        return f'`{name} = …` makes a variable that the function forgets at its end: write `self.{name} = …`.'
    if any(_outside(name, cell) for cell in cells):
        return f'`{name}` is a function outside of your class: write it without `self.`.'
    own = sorted(found.attributes)
    there = [*own, *dir(Node)]
    near = similar.nearest(name, there) or next((one for one in own if one.startswith(name)), '')
    said = f'Nothing in your code sets `{name}`'
    return f'{said}; there is `{near}`.' if near else f'{said}.'


def _no_method(name: str, text: str) -> str:
    """A sentence if a function `name` of the answer is no method, inside of another one or outside of classes."""
    if name in (nested := _names(text).nested):
        around, method = nested[name]
        said = f'`def {name}` is inside of `{around}`'
        return f'{said}: move it to the left, so that it belongs to the class.' if method else f'{said}.'
    if (outside := _outside(name, text)) and outside[1]:
        return f'`def {name}` is outside of the class: move it to the right, so that it belongs to the class.'
    return f'`{name}` is a function outside of your class: write it without `self.`.' if outside else ''


def _outside(name: str, text: str) -> re.Match | None:
    """Where a cell defines a function of this name outside of classes; [1]: its first parameter, if that is `self`."""
    return re.search(rf'^(?:async )?def {name}\(\s*(self\b)?', text, re.MULTILINE)


def _too_late(name: str, setters: list[str]) -> str:
    if '__init__' in setters:
        return f'`self.{name}` is asked for before `__init__` has set it, or `__init__` does not set it each time.'
    return f'Only `{setters[0]}` sets `self.{name}`, and it has not run yet. Set a first value in `__init__`.'


def super_call(text: str, name: str = '') -> str:
    """How the constructor of the answer's class calls that of its base; the class `name`, or the only one.

    A base that is no `Node` itself gives the name of the node, and takes the options.
    """
    classes = [node for node in _tree(text).body if isinstance(node, ast.ClassDef) and name in ('', node.name)]
    bases = {ast.unparse(base).rpartition('.')[2] for node in classes for base in node.bases}
    derived = len(classes) == 1 and bases and not bases & {'Node', 'LifecycleNode'}
    return 'super().__init__(**options)' if derived else "super().__init__('name')"


def misspelt_constructor(text: str) -> str:
    """A sentence if a class has a method that was meant to be `__init__`; '' if none has."""
    of_classes = [methods for methods in _names(text).methods.values() if '__init__' not in methods]
    wrong = sorted(set().union(*of_classes) & _CONSTRUCTORS)
    return f'Is `{wrong[0]}` the constructor? {_UNDERSCORES}' if wrong else ''


def constructor_meant(name: str) -> str:
    """A sentence if `name`, which is asked of super(), is meant to be `__init__`; '' if it is not."""
    return f'Is the constructor meant? {_UNDERSCORES}' if name in _CONSTRUCTORS else ''


def is_variable(name: str, text: str) -> bool:
    """Whether something in the answer gives a variable of this name its value: a loop, a parameter, `=`."""
    return name in _names(text).bound


class _Names(ast.NodeVisitor):
    def __init__(self) -> None:
        self.attributes: set[str] = set()  # of `self`, methods included
        self.methods: dict[str, set[str]] = {}  # class: its methods
        self.parameters: dict[str, set[str]] = {}  # class: the parameters of its `__init__`
        self.nested: dict[str, tuple[str, bool]] = {}  # function: the one that it is inside of; whether it takes `self`
        self.variables: set[str] = set()  # to which functions assign
        self.names: set[str] = set()  # all that it uses or binds
        self.bound: set[str] = set()  # those that it binds, functions and classes left out
        self.in_classes: set[str] = set()  # those that stand in a class
        self.bases: set[str] = set()
        self.classlike: set[str] = set()  # those that are called, inherited from, or the type of an endpoint
        self.members: dict[str, set[str]] = {}  # name: the attributes that it is asked for
        self.setters: dict[str, set[str]] = {}  # attribute of `self`: the functions that set it
        self.changed: set[str] = set()  # attributes of `self` to which something is added
        self._function = ''
        self._classes = 0  # that are around

    def visit_FunctionDef(self, node: ast.FunctionDef | ast.AsyncFunctionDef) -> None:
        for part in ast.walk(node):
            if isinstance(part, ast.Assign):
                self.variables |= {target.id for target in part.targets if isinstance(target, ast.Name)}
        if self._function and self._classes:
            first = [*node.args.posonlyargs, *node.args.args][:1]
            self.nested[node.name] = self._function, [one.arg for one in first] == ['self']
        around, self._function = self._function, node.name
        self.generic_visit(node)
        self._function = around

    visit_AsyncFunctionDef = visit_FunctionDef

    def visit_ClassDef(self, node: ast.ClassDef) -> None:
        methods = [part for part in node.body if isinstance(part, ast.FunctionDef | ast.AsyncFunctionDef)]
        self.methods[node.name] = {part.name for part in methods}
        self.attributes |= self.methods[node.name]
        for part in methods:
            if part.name == '__init__':
                self.parameters[node.name] = {one.arg for one in ast.walk(part.args) if isinstance(one, ast.arg)}
        for other in node.body:
            if isinstance(other, ast.Assign | ast.AnnAssign):
                targets = other.targets if isinstance(other, ast.Assign) else [other.target]
                self.attributes |= {target.id for target in targets if isinstance(target, ast.Name)}
        self.bases |= {getattr(base, 'attr', getattr(base, 'id', '')) for base in node.bases}
        self.classlike |= {base.id for base in node.bases if isinstance(base, ast.Name)}
        function, self._function = self._function, ''
        self._classes += 1
        self.generic_visit(node)
        self._classes -= 1
        self._function = function

    def visit_Name(self, node: ast.Name) -> None:
        self.names.add(node.id)
        if isinstance(node.ctx, ast.Store):
            self.bound.add(node.id)
        if self._classes:
            self.in_classes.add(node.id)

    def visit_arg(self, node: ast.arg) -> None:
        self.names.add(node.arg)
        self.bound.add(node.arg)
        self.generic_visit(node)

    def visit_alias(self, node: ast.alias) -> None:
        self.names.add((node.asname or node.name).partition('.')[0])

    def visit_Call(self, node: ast.Call) -> None:
        made = getattr(node.func, 'attr', getattr(node.func, 'id', ''))
        types = node.args[1:2] if made.startswith('Action') else node.args[:1] if made in _TYPED else []
        self.classlike |= {one.id for one in [node.func, *types] if isinstance(one, ast.Name)}
        self.generic_visit(node)

    def visit_AugAssign(self, node: ast.AugAssign) -> None:
        # `self.count += 1` wants a value that is there
        if isinstance(node.target, ast.Attribute) and getattr(node.target.value, 'id', '') == 'self':
            self.changed.add(node.target.attr)
        self.visit(node.value)

    def visit_Attribute(self, node: ast.Attribute) -> None:
        if isinstance(node.value, ast.Name):
            self.members.setdefault(node.value.id, set()).add(node.attr)
            if isinstance(node.ctx, ast.Store) and node.value.id == 'self':
                self.attributes.add(node.attr)
                self.setters.setdefault(node.attr, set()).add(self._function)
        self.generic_visit(node)


@lru_cache(maxsize=8)
def _names(text: str) -> _Names:
    found = _Names()
    try:
        found.visit(_tree(text))
    except RecursionError:
        pass
    return found


def _tree(text: str) -> ast.Module:
    """The syntax tree of an answer; an empty one if it is no Python."""
    try:
        with warnings.catch_warnings():
            warnings.simplefilter('ignore')  # of the learner's text, such as an invalid escape
            return ast.parse(text)
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        return ast.Module([], [])
