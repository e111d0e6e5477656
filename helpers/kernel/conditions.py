"""Shows the condition of a wait: how it is written, and what it lacks."""

import ast
import inspect
import reprlib

_SHORT = reprlib.Repr()
_SHORT.maxstring = _SHORT.maxother = 80
_UNKNOWN = 'its condition'


def source(condition) -> str:
    """A condition as it is written: a lambda's body, or the function's name."""
    name = getattr(condition, '__qualname__', type(condition).__name__)
    if '<lambda>' not in name:
        return f'{name}()'
    body = _body(condition)
    return ast.unparse(body) if body is not None else _UNKNOWN


def lacking(condition) -> str:
    """What a lambda's first part that is false compares, and the value that this has now; '' if nothing is to be shown.

    Of ``lambda: view.frames and len(heard) >= 3``, for instance, ``len(heard) is 2``. That part is evaluated for it.
    """
    part = _body(condition) if '<lambda>' in getattr(condition, '__qualname__', '') else None
    if part is None:
        return ''
    names = {**condition.__globals__, **inspect.getclosurevars(condition).nonlocals}

    def value(expression: ast.expr):
        return eval(compile(ast.Expression(expression), _UNKNOWN, 'eval'), names)  # noqa: S307 - the caller's own code

    try:
        while isinstance(part, ast.BoolOp) and isinstance(part.op, ast.And):
            part = next(one for one in part.values if not value(one))
        if isinstance(part, ast.UnaryOp) and isinstance(part.op, ast.Not):
            part = part.operand
        if isinstance(part, ast.Compare):
            sides = part.left, part.comparators[0]
            part = next((side for side in sides if any(isinstance(one, ast.Name) for one in ast.walk(side))), part)
        if isinstance(part, ast.Constant | ast.Compare | ast.BoolOp):
            return ''
        return f'{ast.unparse(part)} is {" ".join(_SHORT.repr(value(part)).split())}'
    except Exception:  # noqa: BLE001 - it may fail only now; the wait's own message is what counts
        return ''


def _body(condition) -> ast.expr | None:
    """What a lambda returns; None if it cannot be told which of its line's it is."""
    try:
        tree = ast.parse(inspect.getsource(condition).strip())
    except (OSError, TypeError, SyntaxError):
        return None
    bodies = [part.body for part in ast.walk(tree) if isinstance(part, ast.Lambda)]
    return bodies[0] if len(bodies) == 1 else None
