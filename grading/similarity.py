"""Near-duplicates between submissions: a hint for a talk, never a verdict.

Answers are compared exercise by exercise, as programs and not as text. A cell is parsed; comments, layout, docstrings,
annotations, statements that do nothing and the contents of short texts and of numbers are dropped, and every name that
the learner chose becomes the same sign. A text of several lines, and one that is executed, is an answer in itself: it
is compared as the program that it is, or else, as for XML, YAML and CMake, by its words and signs, without comments and
numbers.
Names of others (rclpy's methods, modules, keyword arguments) stay: they are what tells programs apart. The rest
is a sequence of tokens, of which every `GRAM` neighbours are hashed, and of these hashes a part is kept, by the
winnowing of Schleimer, Wilkerson and Aiken ("Winnowing: local algorithms for document fingerprinting", 2003), so that
equal stretches keep equal hashes wherever they stand.

Two answers are alike if they share most of the hashes that are their own. What the given stub has is nobody's own, and
neither is what many learners wrote: an exercise has its usual answer. An answer with less than `ENOUGH` hashes of its
own says nothing, so short answers are never reported, however equal they are.

The thresholds come from chapter 3: independent right answers to one exercise (the solution and the alternatives) share
at most a third of their own hashes, disguised copies nearly all, and the usual answer to the two shortest exercises has
22 hashes of its own.

Of the libraries, copydetect does the nearest thing. It compares tokens of text, not of programs, compares every pair in
full, and needs a compiler; what is needed here is shorter than the code around it would be.
"""

import ast
import re
import time
from collections import Counter, defaultdict
from collections.abc import Iterable, Mapping
from dataclasses import asdict, dataclass
from functools import cache
from hashlib import blake2b
from itertools import combinations

from grading import idle_code, reader
from helpers import paths
from helpers.exercises import cell_python, definitions, notebooks, package_answers, program
from helpers.exercises.manifest import Exercise
from helpers.exercises.notebooks import NotebookCell

GRAM = 12  # tokens of one hash: about one statement
WINDOW = 6  # of so many neighbouring hashes one is kept: a shared stretch of GRAM + WINDOW - 1 tokens is always seen
ENOUGH = 25  # hashes of its own, below which an answer says nothing
ALIKE = 0.8  # the share of the smaller answer's own hashes that both have, from which on a pair is reported
USUAL = 0.2  # the share of all learners from which on a hash belongs to the exercise's usual answer,
_COMMENT = re.compile(r'<!--(?:(?!-->).){0,10000}-->|(?:^|(?<=\s))#[^\n]*', re.DOTALL)
_WORDS = re.compile(r'[A-Za-z_][\w.-]*|\d[\w.]*|[^\s\w]')
_GIVEN = {'setup.py', 'test/test_copyright.py', 'test/test_flake8.py', 'test/test_pep257.py'}  # in a package
_RUN = {'exec', 'eval', 'compile'}
USUAL_LEAST = 5  # but at least so many learners
MOST_TOO_MUCH = 2  # so many exercises of a learner may take too much time or memory, before the others are left
PATIENCE = 90.0  # seconds for all of a learner's, if together they take too much


@dataclass(frozen=True)
class Pair:
    """Two answers to one exercise that are alike."""

    exercise: str
    first: str
    second: str
    share: float  # of the smaller answer's own hashes, those that both have
    hashes: int  # how many these are


def find(prints: Mapping[str, Mapping[str, Iterable[int] | None]], stubs: Mapping[str, Iterable[int]]) -> list[Pair]:
    """The pairs of learners with answers that are alike, the most alike first.

    :param prints: by learner, then by the exercise's id: the fingerprints of the cell; None if nobody knows them.
    :param stubs: by the exercise's id: those of the cell as it was given.
    """
    found = []
    for exercise in sorted({exercise for cells in prints.values() for exercise in cells}):
        given = set(stubs.get(exercise, ()))
        marks = {learner: cells.get(exercise) for learner, cells in sorted(prints.items())}
        own = {learner: set(theirs) - given for learner, theirs in marks.items() if theirs is not None}
        found += _pairs(exercise, own)
    return sorted(found, key=lambda pair: (-pair.share, -pair.hashes, pair.exercise, pair.first, pair.second))


def _pairs(exercise: str, prints: dict[str, set[int]]) -> list[Pair]:
    """Only hashes that few have are looked at, so the work grows with the learners, not with their pairs."""
    spread = Counter(mark for own in prints.values() for mark in own)
    usual = max(USUAL_LEAST, USUAL * len(prints))
    own = {learner: {mark for mark in marks if spread[mark] <= usual} for learner, marks in prints.items()}
    own = {learner: marks for learner, marks in own.items() if len(marks) >= ENOUGH}
    holders: dict[int, list[str]] = defaultdict(list)
    for learner, marks in own.items():
        for mark in marks:
            holders[mark].append(learner)
    common = Counter(pair for learners in holders.values() for pair in combinations(learners, 2))
    return [
        Pair(exercise, *pair, round(count / smaller, 2), count)
        for pair, count in common.items()
        if count >= ALIKE * (smaller := min(len(own[pair[0]]), len(own[pair[1]])))
    ]


def fingerprints(source: str) -> set[int]:
    """The hashes of a cell; none if it is not Python."""
    try:
        tree = cell_python.syntax_tree(source)
        tokens = _Tokens(tree).tokens if tree is not None else []
    except RecursionError:
        return set()
    hashes = [
        int.from_bytes(
            blake2b('\0'.join(tokens[start : start + GRAM]).encode('utf-8', 'replace'), digest_size=8).digest(), 'big'
        )
        for start in range(len(tokens) - GRAM + 1)
    ]
    return (
        {min(hashes[start : start + WINDOW]) for start in range(max(1, len(hashes) - WINDOW + 1))} if hashes else set()
    )


class _Tokens:
    """A program as tokens in the order of its text, blind to what a copy is disguised by."""

    def __init__(self, tree: ast.Module):
        self.tokens: list[str] = []
        idle_code.prune(tree)
        self._own, self._imported = set(_names(tree)), dict(_imported(tree))
        self._idle = _never_read(tree)
        self._node(tree)

    def _node(self, node: ast.AST) -> None:
        match node:
            case ast.Load() | ast.Store() | ast.Del() | ast.Pass():
                return
            case ast.Expr(value=ast.Constant()):  # a docstring, or a text in place of a comment
                return
            case ast.Assert(test=ast.Constant()):
                return
            case ast.Expr(value=ast.Call(func=ast.Name(id='print'), args=args)) if _constant(args):
                return
            case ast.Assign(targets=[ast.Name(id=name)], value=ast.Constant(value=value)) if (
                name in self._idle and not isinstance(value, (str, bytes))
            ):
                return
            case ast.If(test=ast.Constant(value=value)) if value:
                for part in node.body:
                    self._node(part)
                return
            case ast.Call(func=ast.Name(id='int' | 'float'), args=[ast.Constant(value=value) as number]) if type(
                value
            ) in (int, float):
                self._node(number)
                return
            case ast.Name(id=name) if name in self._imported:
                self.tokens += ['Name', self._imported[name]]
                return
            case ast.alias(name=name):
                self.tokens += ['alias', name]
                return
            case ast.Call(func=ast.Name(id=name), args=[ast.Constant(value=str(text)), *_]) if name in _RUN:
                self._text(text)  # once: texts in texts would be looked into twice as often each time
                self.tokens += ['Call', name]
                return
            case ast.Constant(value=str(text)) if '\n' in text.strip():
                self._text(text)
                return
            case ast.Constant(value=value):
                self.tokens.append(
                    'text'
                    if isinstance(value, (str, bytes))
                    else 'number'
                    if type(value) in (int, float, complex)
                    else repr(value)
                )
                return
            case ast.AnnAssign(target=target, value=value) if value is not None:
                node = ast.Assign(targets=[target], value=value)
        self.tokens.append(type(node).__name__)
        for name, value in ast.iter_fields(node):
            if name in ('annotation', 'returns', 'type_comment', 'kind'):
                continue
            for part in value if isinstance(value, list) else [value]:
                if isinstance(part, ast.AST):
                    self._node(part)
                elif isinstance(part, str):
                    self.tokens.append('own' if part in self._own else part)
        if hasattr(node, 'body'):
            self.tokens.append('end')

    def _text(self, text: str) -> None:
        """The tokens of a text that is an answer, or a part of one: a program, or something that is none."""
        outer, begin = self._own, len(self.tokens)
        if (tree := cell_python.syntax_tree(text)) is not None:
            try:
                idle_code.prune(tree)
                self._own = outer | set(_names(tree))
                self._node(tree)
                return
            except RecursionError:  # texts within texts without end: no program looks like this by chance
                del self.tokens[begin:]
            finally:
                self._own = outer
        words = _WORDS.findall(_COMMENT.sub('', text))
        self.tokens += ['number' if word[0].isdigit() else word for word in words]


def _names(tree: ast.AST) -> Iterable[str]:
    """The names that a program binds itself: variables, parameters, functions, classes, attributes that it sets."""
    for node in ast.walk(tree):
        match node:
            case ast.Name(id=name, ctx=ast.Store()) | ast.Attribute(attr=name, ctx=ast.Store()) | ast.arg(arg=name):
                yield name
            case ast.FunctionDef(name=name) | ast.AsyncFunctionDef(name=name) | ast.ClassDef(name=name):
                yield name
            case ast.ExceptHandler(name=str(name)):
                yield name


def _imported(tree: ast.AST) -> Iterable[tuple[str, str]]:
    """What each name that is imported under another one is called where it comes from."""
    for node in ast.walk(tree):
        match node:
            case ast.alias(name=name, asname=str(other)):
                yield other, name


def _never_read(tree: ast.AST) -> set[str]:
    """The names in functions and at the top to which something is assigned, and which nothing reads."""
    names = [node for node in ast.walk(tree) if isinstance(node, ast.Name)]
    return {node.id for node in names if isinstance(node.ctx, ast.Store)} - {
        node.id for node in names if isinstance(node.ctx, ast.Load)
    }


def _constant(nodes: Iterable[ast.AST]) -> bool:
    return all(isinstance(node, ast.Constant) for node in nodes)


def cells_of(files: Mapping[str, bytes], exercises: Iterable[Exercise]) -> dict[str, str]:
    """The text of each answer in a submission's notebooks, as grading takes it; without doubled ones.

    A package counts with its programs and tests, without what `ros2 pkg create` writes.
    """
    found: dict[str, list[str]] = defaultdict(list)
    wanted: dict[str, list[Exercise]] = defaultdict(list)
    for exercise in exercises:
        wanted[exercise.notebook].append(exercise)
    for notebook, mine in wanted.items():
        names = [notebook] if notebook in files else [name for name in files if '/' not in name]
        code = [cell for name in names for cell in _code(files[name])]
        for one in mine:
            found[one.id] = _texts(code, one)
            if one.folder and (texts := _programs_of(one, files)):
                found[one.id] = texts
    return {exercise: texts[0] for exercise, texts in found.items() if len(texts) == 1}


def _texts(code: list[NotebookCell], exercise: Exercise) -> list[str]:
    """The answer as grading takes it, with what it uses of the learner's own cells; else what claims to be one."""
    try:
        answer = program.build(code, exercise).answer
    except (program.InvalidExercise, program.NotAttempted, RecursionError):
        return [cell.source for cell in program.of_exercise(code, exercise)]
    given = _given(exercise.notebook)
    parts = [
        text
        for cell in code
        if program.exercise_id(cell) is None and cell.source.strip() not in given and cell.id != exercise.cell_id
        for _, text in definitions.of_cell(cell)
    ]
    makers: dict[str, list[str]] = defaultdict(list)
    for text in parts:
        for name in definitions.names_made(text):
            makers[name].append(text)
    needed = definitions.reached(
        definitions.names_used(answer),
        lambda name: [used for text in makers.get(name, ()) for used in definitions.names_used(text)],
    )
    have = definitions.names_in(answer)
    chosen = {text for name in needed - have for text in makers.get(name, ())}
    return ['\n'.join([answer, *(text for text in dict.fromkeys(parts) if text in chosen)])]


@cache
def _given(notebook: str) -> frozenset[str]:
    """The cells of a notebook as it was given."""
    path = paths.NOTEBOOKS / notebook
    return frozenset(cell.source.strip() for cell in _code(path.read_bytes())) if path.is_file() else frozenset()


def _programs_of(exercise: Exercise, files: Mapping[str, bytes]) -> list[str]:
    """The text that stands for a package, if there is one."""
    try:
        made = package_answers.of_submission(exercise, files).cells[-1]['source']
    except (program.InvalidExercise, program.NotAttempted):
        return []
    texts = ast.literal_eval(ast.parse(made).body[-1].value)  # type: ignore[attr-defined]
    own = {name: text for name, text in texts.items() if name.endswith('.py') and name not in _GIVEN}
    return [package_answers.source(exercise, own)]


def prints_of(files: Mapping[str, bytes], exercises: Iterable[Exercise]):
    """The fingerprints of each exercise's cell in a submission's notebooks, as JSON values; in a child process."""
    return {exercise: sorted(fingerprints(text)) for exercise, text in cells_of(files, exercises).items()}, ()


def of_submission(files: Mapping[str, bytes], exercises: Iterable[Exercise]) -> dict[str, list[int] | None]:
    """The same, without the risk of reading it here; None for what cannot be read in time.

    What takes too much costs only its own exercise, unless there are many of these.
    """
    exercises, given_up, begin = list(exercises), 0, time.monotonic()
    found: dict[str, list[int] | None] = {}
    try:
        return reader.ask('grading.similarity:prints_of', dict(files), exercises)[0]
    except reader.TooMuch:
        pass
    for exercise in exercises:
        try:
            if given_up < MOST_TOO_MUCH and time.monotonic() < begin + PATIENCE:
                found |= reader.ask('grading.similarity:prints_of', dict(files), [exercise])[0]
                continue
        except reader.TooMuch:
            given_up += 1
        found[exercise.id] = None
    return found


def not_compared(prints: Mapping[str, Mapping[str, Iterable[int] | None]]) -> list[dict[str, str]]:
    """By learner, a note on answers that take too much time to be compared: nobody writes such ones by chance."""
    unknown = {
        learner: [exercise for exercise, marks in cells.items() if marks is None]
        for learner, cells in sorted(prints.items())
    }
    return [
        {
            'learner': learner,
            'text': f'{", ".join(some)}: it takes too much time or memory to compare the answers with those of others',
        }
        for learner, some in unknown.items()
        if some
    ]


def stubs_of(exercises: Iterable[Exercise]) -> dict[str, set[int]]:
    """The fingerprints of the cells as they were given, from the course's notebooks."""
    exercises = list(exercises)
    files = {
        name: path.read_bytes()
        for name in {exercise.notebook for exercise in exercises}
        if (path := paths.NOTEBOOKS / name).is_file()
    }
    return {exercise: fingerprints(text) for exercise, text in cells_of(files, exercises).items()}


def _code(data: bytes) -> list[NotebookCell]:
    """The cells of a notebook, as grading reads them."""
    try:
        return notebooks.parse(data, 'the notebook')
    except notebooks.InvalidSubmission:
        return []


def as_rows(pairs: Iterable[Pair]) -> list[dict]:
    """The pairs as JSON values."""
    return [asdict(pair) for pair in pairs]
