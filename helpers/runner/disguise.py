"""Another program that does the same: with it, tests of the learner's cannot know a program by its code.

Variables within functions get other names; each function begins with statements that do nothing, in a number that is
drawn, and with the names that any of the programs uses; a condition such as `1 < 2` gets other numbers. So neither the
text nor the compiled code, nor their sizes and names, tell which of several programs this is.
"""

import ast
import importlib.util
import marshal
from collections.abc import Iterable
from random import Random


def names(texts: Iterable[str]) -> list[str]:
    """The attributes and names that these programs use."""
    found: set[str] = set()
    for text in texts:
        for node in ast.walk(ast.parse(text)):
            if isinstance(node, ast.Attribute):
                found.add(node.attr)
            elif isinstance(node, ast.Name):
                found.add(node.id)
    return sorted(name for name in found if not name.startswith('__'))


def disguised(text: str, pool: list[str], random: Random) -> str:
    """A program that does what `text` does. `pool`: `names` of all programs."""
    tree = ast.parse(text)
    for node in ast.walk(tree):
        if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef)):
            _rename(node, random)
            _pad(node, pool, random)
        elif isinstance(node, ast.Compare):
            _renumber(node, random)
    return ast.unparse(ast.fix_missing_locations(tree))


def compiled(text: str) -> bytes:
    """The file of a module without its text, as Python imports it in place of `.py`."""
    code = compile(text, '<module>', 'exec', dont_inherit=True)
    return importlib.util.MAGIC_NUMBER + bytes(12) + marshal.dumps(code)


def _rename(function: ast.FunctionDef | ast.AsyncFunctionDef, random: Random) -> None:
    """Give local variables other names, but those that something else in the function may mean, too."""
    inside = list(ast.walk(function))
    kept = {node.arg for node in inside if isinstance(node, (ast.arg, ast.keyword)) and node.arg}
    kept |= {name for node in inside if isinstance(node, (ast.Global, ast.Nonlocal)) for name in node.names}
    kept |= {
        node.name
        for node in inside
        if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef, ast.ClassDef, ast.ExceptHandler)) and node.name
    }
    kept |= {(node.asname or node.name).partition('.')[0] for node in inside if isinstance(node, ast.alias)}
    local = {node.id for node in inside if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store)} - kept
    others = {name: f'{name}_{random.randrange(10 ** random.randint(2, 6))}' for name in sorted(local)}
    for node in inside:
        if isinstance(node, ast.Name):
            node.id = others.get(node.id, node.id)


def _renumber(condition: ast.Compare, random: Random) -> None:
    """Give a condition `1 < 2` or `2 < 1` other numbers, with which it is as true as before."""
    match condition:
        case ast.Compare(
            left=ast.Constant(value=int(left)), ops=[ast.Lt()], comparators=[ast.Constant(value=int(right))]
        ):
            low, high = sorted(random.sample(range(10**3, 10**6), 2))
            both = (low, high) if left < right else (high, low)
            condition.left, condition.comparators = ast.Constant(both[0]), [ast.Constant(both[1])]


def _pad(function: ast.FunctionDef | ast.AsyncFunctionDef, pool: list[str], random: Random) -> None:
    begin = 1 if ast.get_docstring(function, clean=False) is not None else 0
    own = f'_{random.randrange(10**8)}'
    lines = [f'{own} = {random.random()!r}' for _ in range(random.randint(1, 12))]
    shuffled = random.sample(pool, len(pool))
    lines.append(f'if {own} < 0:\n    ' + '\n    '.join(f'{own}.{name}' for name in shuffled))
    function.body[begin:begin] = ast.parse('\n'.join(lines)).body
