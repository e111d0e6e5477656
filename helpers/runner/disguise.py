"""Another program that does the same: with it, tests of the learner's cannot know a program by its code.

Variables within functions get other names; each function begins with statements that do nothing, in a number that is
drawn, and with the names that any of the programs uses; in the place of a condition such as `1 < 2` stands one that
computes with a variable. So neither the text nor the compiled code, nor their sizes, names and constants, tell which of
several programs this is: that takes somebody who follows what the code computes.
"""

import ast
import importlib.util
import marshal
import re
from collections.abc import Container, Iterable
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
    return ast.unparse(ast.fix_missing_locations(_Pads(pool, random).visit(tree)))


def with_other_attributes(text: str, kept: Container[str], random: Random) -> str:
    """A module that does what `text` does; attributes and methods of its classes' own have other names.

    Only those that stand nowhere but behind `self.`, so that nothing can depend on the name.

    :param kept: names that stay, such as those of the base classes.
    """
    tree = ast.parse(text)
    nodes = list(ast.walk(tree))
    classes = [node for node in nodes if isinstance(node, ast.ClassDef)]
    methods = [one for node in classes for one in node.body if isinstance(one, ast.FunctionDef | ast.AsyncFunctionDef)]
    attributes = [node for node in nodes if isinstance(node, ast.Attribute)]
    own = [node for node in attributes if isinstance(node.value, ast.Name) and node.value.id == 'self']
    elsewhere = {node.attr for node in attributes if not (isinstance(node.value, ast.Name) and node.value.id == 'self')}
    for node in nodes:
        if isinstance(node, ast.Name):
            elsewhere.add(node.id)
        elif isinstance(node, ast.Constant) and isinstance(node.value, str):
            elsewhere.update(re.findall(r'\w+', node.value))
    made = {node.attr for node in own if isinstance(node.ctx, ast.Store)} | {method.name for method in methods}
    names = {
        name: f'{name}_{random.randrange(10**4)}'
        for name in sorted(made - elsewhere)
        if name not in kept and not name.startswith('__')
    }
    for attribute in own:
        attribute.attr = names.get(attribute.attr, attribute.attr)
    for method in methods:
        method.name = names.get(method.name, method.name)
    return ast.unparse(tree)


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


class _Pads(ast.NodeTransformer):
    """Puts statements that do nothing into each function, and other conditions in the place of `1 < 2` and `2 < 1`."""

    def __init__(self, pool: list[str], random: Random):
        self._pool, self._random = pool, random
        self._own: list[tuple[str, int]] = []  # a variable of each function around, and its value

    def visit_FunctionDef(self, function):
        random = self._random
        begin = 1 if ast.get_docstring(function, clean=False) is not None else 0
        own, value = f'_{random.randrange(10**8)}', random.randrange(10**3, 10**6)
        lines = [f'{own} = {random.random()!r}' for _ in range(random.randint(1, 12))]
        shuffled = random.sample(self._pool, len(self._pool))
        lines.append(f'{own} = {value}')
        lines.append(f'if {own} < 0:\n    ' + '\n    '.join(f'{own}.{name}' for name in shuffled))
        self._own.append((own, value))
        function.body = [self.visit(statement) for statement in function.body]
        self._own.pop()
        function.body[begin:begin] = ast.parse('\n'.join(lines)).body
        return function

    visit_AsyncFunctionDef = visit_FunctionDef

    def visit_Compare(self, condition: ast.Compare) -> ast.expr:
        match condition:
            case ast.Compare(
                left=ast.Constant(value=int(left)), ops=[ast.Lt()], comparators=[ast.Constant(value=int(right))]
            ) if self._own:
                return self._computed(left < right)
        self.generic_visit(condition)
        return condition

    def _computed(self, true: bool) -> ast.expr:
        """A condition that is true, or false; which of them, only one of its numbers depends on."""
        random, (own, value) = Random(self._random.getrandbits(64)), self._own[-1]
        turned = random.random() < 0.5
        modulus = random.randrange(10**4, 10**5)
        limit = random.randrange(modulus // 3, modulus - modulus // 3)
        factor = random.randrange(10**3, 10**6)
        while (value * factor % modulus < limit) is not (true is not turned):
            factor = random.randrange(10**3, 10**6)
        text = f'{own} * {factor} % {modulus} < {limit}'
        return ast.parse(f'not {text}' if turned else text, mode='eval').body
