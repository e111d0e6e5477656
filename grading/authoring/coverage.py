"""Which tests look at which rule of a card: the table of `./course build --rules`, and what is missing in it.

A visible test names the rules that it looks at by `@pytest.mark.rules('rate', 'texts')`; in `pytestmark` the mark is
for all tests of the file. A rule at which no test on the learner's machine can look is named in the visible file's
`pytestmark` by `pytest.mark.not_looked_at(rule='name', why='...')`; then a hidden test must look at it. A mutant names
the rule that it breaks. Test files are read, not run.
"""

import ast
from collections.abc import Iterable
from dataclasses import dataclass, field
from pathlib import Path

from grading import variants
from helpers.exercises import manifest
from helpers.exercises.manifest import Exercise


@dataclass
class Marks:
    """What a file of tests says of rules."""

    looks: dict[str, list[str]] = field(default_factory=dict)  # rule -> tests
    not_looked_at: dict[str, str] = field(default_factory=dict)  # rule -> why
    problems: list[str] = field(default_factory=list)


@dataclass(frozen=True)
class RuleCoverage:
    """One rule of one exercise."""

    exercise: str
    rule: str
    visible: tuple[str, ...]
    not_looked_at: str  # why
    hidden: tuple[str, ...]
    mutants: tuple[str, ...]

    @property
    def lacks(self) -> list[str]:
        """What is missing."""
        lacking = []
        if not self.visible and not self.not_looked_at:
            lacking.append('visible test')
        if self.not_looked_at and not self.hidden:
            lacking.append('hidden test')
        return lacking + ([] if self.mutants else ['mutant'])


@dataclass
class Table:
    """All rules of some exercises, and what is wrong with the marks."""

    rows: list[RuleCoverage] = field(default_factory=list)
    problems: list[str] = field(default_factory=list)
    without_rules: list[str] = field(default_factory=list)  # exercises

    @property
    def complete(self) -> bool:
        """Whether each exercise has rules, no cell is empty, and each name that is used is a rule of a card."""
        return not self.problems and not self.without_rules and not any(row.lacks for row in self.rows)

    def lines(self) -> list[str]:
        """The table as text."""
        table = [('exercise', 'rule', 'visible tests', 'mutants')]
        for row in self.rows:
            seen = ', '.join(row.visible) or (
                row.not_looked_at and f'- ({row.not_looked_at}) {", ".join(row.hidden) or "NO HIDDEN TEST"}'
            )
            table.append((row.exercise, row.rule, seen or 'NONE', ', '.join(row.mutants) or 'NONE'))
        widths = [max(len(line[column]) for line in table) for column in range(3)]
        lines = [
            ' '.join([*(cell.ljust(width + 1) for cell, width in zip(line, widths, strict=False)), line[3]])
            for line in table
        ]
        return [
            *(lines if self.rows else []),
            *self.problems,
            *(f'exercise {exercise}: its card has no rules' for exercise in self.without_rules),
        ]


def table(exercises: Iterable[Exercise], checks: Path, folder: Path = variants.FOLDER) -> Table:
    """Read the marks of the tests and the mutants of these exercises.

    :param checks: the folder of the visible tests; :param folder: that of the exercises.
    :raises variants.VariantError: a list of mutants cannot be read.
    """
    made = Table()
    for exercise in exercises:
        visible, hidden = marks(exercise, checks, folder)
        mutants = variants.mutants(exercise.id, folder)
        names = [rule.name for rule in exercise.rules]
        if not names:
            made.without_rules.append(exercise.id)
        said = [(name, 'a visible test') for name in (*visible.looks, *visible.not_looked_at)]
        said += [(name, 'a hidden test') for name in (*hidden.looks, *hidden.not_looked_at)]
        said += [(name, f'mutant {one.name!r}') for one in mutants for name in (one.breaks, *one.also) if name]
        made.problems += [
            f'exercise {exercise.id}: {who} names the rule {name!r}, which its card has not'
            for name, who in said
            if name not in names
        ]
        made.problems += [f'exercise {exercise.id}: {text}' for text in (*visible.problems, *hidden.problems)]
        if names:
            made.problems += [
                f'exercise {exercise.id}: mutant {one.name!r} does not say which rule it breaks'
                for one in mutants
                if not one.breaks
            ]
        for name in names:
            made.rows.append(
                RuleCoverage(
                    exercise.id,
                    name,
                    tuple(visible.looks.get(name, ())),
                    visible.not_looked_at.get(name, ''),
                    tuple(hidden.looks.get(name, ())),
                    tuple(one.name for one in mutants if name in (one.breaks, *one.also)),
                )
            )
    return made


def marks(exercise: Exercise, checks: Path, folder: Path = variants.FOLDER) -> tuple[Marks, Marks]:
    """The marks of an exercise's visible and of its hidden tests; the folders as in `table`."""
    visible = manifest.visible_tests(checks, exercise.id)
    return read(visible), read(manifest.hidden_tests(folder, exercise.id))


def read(path: Path) -> Marks:
    """Return the marks of a file of tests; none if there is no such file."""
    marks = Marks()
    if not path.is_file():
        return marks
    body = ast.parse(path.read_text(encoding='utf-8')).body
    tests = [node for node in body if isinstance(node, ast.FunctionDef) and node.name.startswith('test')]
    for node in body:
        if isinstance(node, ast.Assign) and any(
            isinstance(name, ast.Name) and name.id == 'pytestmark' for name in node.targets
        ):
            for mark in node.value.elts if isinstance(node.value, (ast.List, ast.Tuple)) else [node.value]:
                _note(marks, mark, [test.name for test in tests], path)
    for test in tests:
        for mark in test.decorator_list:
            _note(marks, mark, [test.name], path)
    return marks


def _note(marks: Marks, mark: ast.expr, tests: list[str], path: Path) -> None:
    """Take down one mark, if it is about rules."""
    kind = ast.unparse(mark.func if isinstance(mark, ast.Call) else mark)
    if not isinstance(mark, ast.Call) or kind not in ('pytest.mark.rules', 'pytest.mark.not_looked_at'):
        return
    try:
        names = [ast.literal_eval(argument) for argument in mark.args]
        options = {keyword.arg: ast.literal_eval(keyword.value) for keyword in mark.keywords}
        if kind == 'pytest.mark.rules':
            if not names or options:
                raise ValueError
            for name in names:
                marks.looks.setdefault(name, []).extend(tests)
        else:
            if names or set(options) != {'rule', 'why'} or not options['why']:
                raise ValueError
            marks.not_looked_at[options['rule']] = options['why']
    except (AttributeError, ValueError):
        marks.problems.append(
            f"{path.name}:{mark.lineno}: write pytest.mark.rules('name', …) or "
            "pytest.mark.not_looked_at(rule='name', why='…')"
        )
