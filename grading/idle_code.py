"""Takes out of a program what does nothing: by this, copies are disguised (`grading.similarity`).

Idle are lines for the log; statements that compute a value which nobody takes, or give it to a name that nobody reads;
branches and loops that are never entered, or in which everything is idle; what stands behind a `return`; imports, and
functions in functions, that nobody uses. That an attribute or an operator may have an effect is not looked at: nothing
is judged.
"""

import ast
from collections.abc import Iterable

_ROUNDS = 10  # what only idle statements have read is idle, too
_PURE = frozenset(
    'bool bytes complex dict float frozenset int len list object print range repr set str tuple type'.split()
)
_ENDS = ast.Return, ast.Raise, ast.Break, ast.Continue
_OPERATORS = {
    ast.Eq: lambda a, b: a == b,
    ast.NotEq: lambda a, b: a != b,
    ast.Lt: lambda a, b: a < b,
    ast.LtE: lambda a, b: a <= b,
    ast.Gt: lambda a, b: a > b,
    ast.GtE: lambda a, b: a >= b,
}


def prune(tree: ast.Module) -> ast.Module:
    """The program without what does nothing; `tree` itself is changed."""
    for _ in range(_ROUNDS):
        pruner = _Pruner(tree)
        pruner.block(tree, within=False)
        if not pruner.found:
            break
    return tree


class _Pruner:
    """One look at a program."""

    def __init__(self, tree: ast.Module):
        nodes = list(ast.walk(tree))
        self._read = {node.id for node in nodes if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Load)}
        self._attributes = {
            node.attr for node in nodes if isinstance(node, ast.Attribute) and isinstance(node.ctx, ast.Load)
        }
        self._pure: dict[ast.AST, bool] = {}
        self.found = False

    def block(self, node: ast.AST, within: bool) -> None:
        """Take idle statements out of all blocks of a node; `within`: whether it stands in a function."""
        within = (
            within and not isinstance(node, ast.ClassDef) or isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef))
        )
        for name in ('body', 'orelse', 'finalbody', 'handlers', 'cases'):
            statements = getattr(node, name, None)
            if not isinstance(statements, list):
                continue
            kept: list[ast.AST] = []
            for statement in statements:
                self.block(statement, within)
                kept += self._living(statement, within)
                if kept and isinstance(kept[-1], _ENDS):
                    break
            self.found |= len(kept) != len(statements) or any(
                a is not b for a, b in zip(kept, statements, strict=False)
            )
            statements[:] = kept

    def _living(self, node: ast.AST, within: bool) -> list[ast.AST]:
        """What is left of a statement."""
        match node:
            case ast.If(test=test) if (known := _truth(test)) is not None:
                return list(node.body if known else node.orelse)
            case ast.While(test=test) if _truth(test) is False:
                return list(node.orelse)
        return [] if self._idle(node, within) else [node]

    def _idle(self, node: ast.AST, within: bool) -> bool:
        match node:
            case ast.Pass() | ast.Global() | ast.Nonlocal() | ast.AnnAssign(value=None):
                return True
            case ast.Expr(value=ast.Call(func=ast.Attribute(value=ast.Call(func=ast.Attribute(attr='get_logger'))))):
                return True
            case ast.Expr(value=value) | ast.Assert(test=value):
                return self._effectless(value)
            case ast.With(items=items, body=[]):
                return all(self._effectless(_opened(item.context_expr)) for item in items)
            case ast.Assign(targets=targets, value=value) if within:
                return self._effectless(value) and all(map(self._unread, targets))
            case ast.AnnAssign(target=target, value=ast.expr() as value) | ast.AugAssign(target=target, value=value):
                return within and self._effectless(value) and self._unread(target)
            case ast.Delete(targets=targets):
                return all(map(self._unread, targets))
            case ast.Import(names=names) | ast.ImportFrom(names=names):
                return all((one.asname or one.name).partition('.')[0] not in self._read | {'*'} for one in names)
            case ast.FunctionDef(name=name) | ast.AsyncFunctionDef(name=name) | ast.ClassDef(name=name):
                return within and name not in self._read and not node.decorator_list
            case ast.If(test=test, body=body, orelse=orelse):
                return self._effectless(test) and not body and not orelse
            case ast.For(target=target, iter=values, body=[] | [ast.Break() | ast.Continue()], orelse=[]):
                return self._effectless(values) and self._unread(target)
            case ast.For(iter=ast.List(elts=[]) | ast.Tuple(elts=[]) | ast.Constant(value='' | b''), orelse=[]):
                return True
            case ast.While(test=test, body=[ast.Break()], orelse=[]):
                return self._effectless(test)
            case ast.Try(body=[], orelse=[], finalbody=[]):
                return True
        return False

    def _unread(self, target: ast.expr) -> bool:
        match target:
            case ast.Name(id=name):
                return name not in self._read
            case ast.Attribute(value=ast.Name(), attr=name):
                return name not in self._attributes
            case ast.Tuple(elts=parts) | ast.List(elts=parts):
                return all(map(self._unread, parts))
        return False

    def _effectless(self, value: ast.expr) -> bool:
        """Whether nothing comes of computing a value but the value."""
        if value not in self._pure:
            self._pure[value] = all(map(_pure, _parts(value)))
        return self._pure[value]


def _opened(value: ast.expr) -> ast.expr:
    """What stands for `nullcontext(…)`, of which nothing comes if its block is empty."""
    match value:
        case ast.Call(func=ast.Name(), args=parts, keywords=[]):
            return ast.Tuple(elts=parts)
    return value


def _parts(value: ast.AST) -> Iterable[ast.AST]:
    """The parts of an expression that are computed with it: not those of a function."""
    waiting = [value]
    while waiting:
        node = waiting.pop()
        yield node
        if not isinstance(node, ast.Lambda):
            waiting += ast.iter_child_nodes(node)


def _pure(node: ast.AST) -> bool:
    match node:
        case ast.Call(func=ast.Name(id=name)):
            return name in _PURE
        case ast.Call() | ast.Await() | ast.Yield() | ast.YieldFrom() | ast.NamedExpr():
            return False
    return True


def _truth(test: ast.expr) -> bool | None:
    """Whether a condition is always true or always false; None if that is not plain."""
    match test:
        case ast.Constant(value=value):
            return bool(value)
        case ast.List(elts=parts) | ast.Tuple(elts=parts) | ast.Set(elts=parts) | ast.Dict(values=parts):
            return bool(parts)
        case ast.UnaryOp(op=ast.Not(), operand=operand):
            known = _truth(operand)
            return None if known is None else not known
        case ast.UnaryOp(op=ast.USub() | ast.UAdd(), operand=operand):
            return _truth(operand)
        case ast.BoolOp(op=operator, values=values):
            truths = [_truth(value) for value in values]
            decisive = isinstance(operator, ast.Or)
            return decisive if decisive in truths else None if None in truths else not decisive
        case ast.Compare(left=ast.Constant(value=left), ops=[operator], comparators=[ast.Constant(value=right)]):
            compare = _OPERATORS.get(type(operator))
            if compare is not None and isinstance(left, (int, float)) and isinstance(right, (int, float)):
                return compare(left, right)
    return None
