"""What counts as a definition: what the check of an exercise, and `resume()`, take from the other cells.

Imports, functions, classes and constants, also those that a loop fills. Everything else only demonstrates something,
and runs only where the learner runs it. Nothing is executed here.
"""

import ast
import re
from collections.abc import Callable, Iterable, Iterator, Set
from functools import lru_cache
from itertools import compress

from helpers.exercises import cell_python
from helpers.exercises.constant_syntax import is_constant, is_made_as_constant, is_name
from helpers.exercises.notebooks import NotebookCell

_LINE = re.compile(r'[^\r\n]*(?:\r\n|\r|\n)|[^\r\n]+')
_BUILDING_METHODS = {  # of lists, sets and dictionaries
    *('add', 'append', 'clear', 'discard', 'extend', 'insert', 'pop', 'remove', 'reverse', 'setdefault', 'sort'),
    'update',
}


@lru_cache(maxsize=512)
def of_cell(cell: NotebookCell) -> tuple[tuple[int, str], ...]:
    """Imports, functions, classes and constants of a cell, and what builds these; none if it is not Python.

    Each is its first line's number in the cell, so that line numbers in messages are the learner's, and its text.
    """
    text = cell_python.as_python(cell)
    tree = _tree(text)
    if tree is None:
        return ()
    found = []
    for node, taken, _ in _judged(tree.body):
        if taken:
            first = first_line(node)
            part = lines(text)[first - 1 : node.end_lineno]
            if len(part) == 1:  # a neighbour on the same line is cut off
                part = [part[0].encode()[node.col_offset : node.end_col_offset].decode()]
            found.append((first, ''.join(part).rstrip('\r\n') + '\n'))
    return tuple(found)


def _judged(body: Iterable[ast.stmt]) -> Iterator[tuple[ast.stmt, bool, set[str]]]:
    """Each statement of a cell, whether `of_cell` takes it, and the names that were made before it."""
    made, records = set[str](), set[str]()
    for node in body:
        taken = is_definition(node) or _builds(node, made.__contains__) or _is_record(node, records)
        yield node, taken, made
        if taken:
            made |= _made(node)
            records |= _record_types(node)


@lru_cache(maxsize=512)
def changed_later(cell: NotebookCell) -> frozenset[str]:
    """The names of the cell's constants that a statement changes which `of_cell` leaves out."""
    tree = _tree(cell_python.as_python(cell))
    changed = set[str]()
    for node, taken, made in _judged(tree.body if tree is not None else ()):
        for part in ast.walk(node) if not taken else ():
            match part:
                case ast.Assign(targets=targets):
                    changed |= {_root(target) for target in targets} & made
                case ast.AugAssign(target=target):
                    changed |= {_root(target)} & made
                case ast.Call(func=ast.Attribute(value=whole, attr=name)) if name in _BUILDING_METHODS:
                    changed |= {_root(whole)} & made
    return frozenset(changed)


@lru_cache(maxsize=8)
def lines(text: str) -> list[str]:
    """The lines of a text, with their ends, as Python counts them."""
    return _LINE.findall(text)


def first_line(node: ast.stmt) -> int:
    """The number of a statement's first line, the first decorator's if it has one."""
    return min([node.lineno, *(decorator.lineno for decorator in getattr(node, 'decorator_list', ()))])


@lru_cache(maxsize=512)
def _tree(text: str) -> ast.Module | None:
    return cell_python.syntax_tree(text)


@lru_cache(maxsize=4096)
def names_in(text: str) -> frozenset[str]:
    """The names that a text binds; none if it is not Python."""
    tree = _tree(text)
    return frozenset(defined(tree.body) if tree is not None else ())


def names_given(text: str) -> frozenset[str]:
    """The names to which a text gives something of its own: those that it binds, but does not import."""
    tree = _tree(text)
    return frozenset().union(*map(_made, tree.body if tree is not None else ()))


def names_not_reached(text: str, line: int) -> frozenset[str]:
    """Those of `names_given` that have nothing of the text yet if this line of it has raised an error."""
    tree = _tree(text)
    after = [node for node in (tree.body if tree is not None else ()) if (node.end_lineno or node.lineno) >= line]
    if after and after[0].lineno <= line and not isinstance(after[0], ast.Assign | ast.AnnAssign):
        after = after[1:]  # a block may have made a part of its names
    return frozenset().union(*map(_made, after))


@lru_cache(maxsize=4096)
def names_made(text: str) -> frozenset[str]:
    """The names that one of `of_cell`'s texts binds, or to whose values it adds something."""
    tree = _tree(text)
    statements = [node for node in tree.body if isinstance(node, ast.Expr | ast.For | ast.If)] if tree else []
    calls = [node.func for part in statements for node in ast.walk(part) if isinstance(node, ast.Call)]
    return names_in(text) | {_root(call) for call in calls if isinstance(call, ast.Attribute)} - {''}


@lru_cache(maxsize=4096)
def names_used(text: str) -> frozenset[str]:
    """The names that a text needs and does not bind, of itself or as an argument; none if it is not Python."""
    tree = _tree(text)
    nodes = list(ast.walk(tree)) if tree is not None else []
    bound = {node.arg for node in nodes if isinstance(node, ast.arg)} | defined(nodes)
    names = [node for node in nodes if isinstance(node, ast.Name)]
    bound |= {name.id for name in names if not isinstance(name.ctx, ast.Load)}
    return frozenset({name.id for name in names} - bound)


def reached(names: Iterable[str], following: Callable[[str], Iterable[str]]) -> set[str]:
    """These names, and all that lead on from them: `following` gives the next ones of a name."""
    found, todo = set[str](), list(names)
    while todo:
        if (name := todo.pop()) not in found:
            found.add(name)
            todo += following(name)
    return found


def defined(body: Iterable[ast.AST]) -> set[str]:
    """The names that these statements bind at module level, in blocks such as `if` and `try` too."""
    names: set[str] = set()
    for node in body:
        match node:
            case ast.FunctionDef(name=name) | ast.AsyncFunctionDef(name=name) | ast.ClassDef(name=name):
                names.add(name)
            case ast.Import(names=aliases) | ast.ImportFrom(names=aliases):
                names |= {alias.asname or alias.name.partition('.')[0] for alias in aliases}
            case ast.Assign() | ast.AnnAssign() | ast.AugAssign():
                targets = node.targets if isinstance(node, ast.Assign) else [node.target]
                names |= {part.id for target in targets for part in ast.walk(target) if isinstance(part, ast.Name)}
            case ast.If() | ast.For() | ast.While() | ast.With() | ast.Try():
                targets = [node.target] if isinstance(node, ast.For) else []
                if isinstance(node, ast.With):
                    targets = [item.optional_vars for item in node.items if item.optional_vars]
                names |= {part.id for target in targets for part in ast.walk(target) if isinstance(part, ast.Name)}
                for part in ('body', 'orelse', 'finalbody'):
                    names |= defined(getattr(node, part, []))
                for handler in getattr(node, 'handlers', []):
                    names |= defined(handler.body)
    return names


def is_definition(node: ast.stmt) -> bool:
    """Whether a statement only imports, defines, or binds names to constants."""
    match node:
        case ast.Import() | ast.ImportFrom() | ast.FunctionDef() | ast.AsyncFunctionDef() | ast.ClassDef():
            return True
        case ast.Assign(targets=[ast.Name(id=name)], value=ast.Call() as value) if name.isupper():
            return is_constant(value) or is_made_as_constant(value)
        case ast.Assign(targets=targets, value=value):
            return all(map(is_name, targets)) and is_constant(value)
        case ast.AnnAssign(target=ast.Name(), value=value):
            return value is None or is_constant(value)
        case ast.If(test=test, body=body, orelse=rest):  # such as a version of Python
            return is_constant(test) and _only_defines([*body, *rest])
        case ast.Try(body=body, handlers=handlers, orelse=rest, finalbody=last):  # a library may be missing
            return _only_defines([*body, *(part for handler in handlers for part in handler.body), *rest, *last])
    return False


def _builds(node: ast.stmt, made: Callable[[str], bool]) -> bool:
    """Whether a statement only goes on with constants that the cell has made before: of their names `made` is true.

    Of a dictionary that a loop fills, the loop is a part: without it the dictionary would be there, and empty.
    """
    match node:
        case ast.AugAssign(target=target, value=value):
            return made(_root(target)) and is_constant(target) and is_constant(value)
        case ast.Assign(targets=targets, value=value):
            return all(made(_root(one)) and is_constant(one) for one in targets) and is_constant(value)
        case ast.Expr(value=ast.Call(func=ast.Attribute(value=whole, attr=name), args=args, keywords=keywords)):
            values = [whole, *args, *(keyword.value for keyword in keywords)]
            return name in _BUILDING_METHODS and made(_root(whole)) and all(map(is_constant, values))
        case ast.For(target=target, iter=values, body=body, orelse=[]):
            return is_name(target) and is_constant(values) and _all_build(body, made)
        case ast.If(test=test, body=body, orelse=rest):
            return is_constant(test) and _all_build([*body, *rest], made)
    return False


def _record_types(node: ast.stmt) -> set[str]:
    """The names of data classes and named tuples that a statement defines: what is made of constants by them is one."""
    match node:
        case ast.ClassDef(name=name, bases=bases, decorator_list=decorators):
            marks = [*bases, *(mark.func if isinstance(mark, ast.Call) else mark for mark in decorators)]
        case ast.Assign(targets=[ast.Name(id=name)], value=ast.Call(func=made)):
            marks = [made]
        case _:
            return set()
    called = {getattr(mark, 'attr', getattr(mark, 'id', '')) for mark in marks}  # of a name or an attribute
    return {name} if called & {'dataclass', 'NamedTuple', 'namedtuple'} else set()


def _is_record(node: ast.stmt, types: Set[str]) -> bool:
    match node:
        case ast.Assign(targets=targets, value=ast.Call(func=ast.Name(id=made), args=args, keywords=keywords)):
            values = [*args, *(keyword.value for keyword in keywords)]
            return made in types and all(map(is_name, targets)) and all(map(is_constant, values))
    return False


def _made(node: ast.stmt) -> set[str]:
    """The names that a definition binds; a module that is imported is not the cell's own."""
    return set() if isinstance(node, ast.Import | ast.ImportFrom) else defined([node])


def _all_build(body: list[ast.stmt], made: Callable[[str], bool]) -> bool:
    constant = [isinstance(node, ast.Assign) and is_definition(node) for node in body]
    own = defined(compress(body, constant))
    others = [node for node, known in zip(body, constant, strict=True) if not known and not isinstance(node, ast.Pass)]
    return bool(others) and all(_builds(node, lambda name: name in own or made(name)) for node in others)


def _root(target: ast.expr) -> str:
    """The name of the object that is changed, TABLE of ``TABLE['a'].depth``; '' if it has none."""
    while isinstance(target, ast.Attribute | ast.Subscript):
        target = target.value
    return target.id if isinstance(target, ast.Name) else ''


def _only_defines(body: list[ast.stmt]) -> bool:
    return all(isinstance(node, ast.Pass) or is_definition(node) for node in body)
