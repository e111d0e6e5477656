"""What `check` shows: results as HTML for a notebook, and as lines for a terminal.

The cause of what is wrong comes first, then the rule of the card that it breaks, then what is kept and what was not
looked at.

The same results give the same text: no times, no addresses, no order by chance. Colours suit light and dark themes.
"""

import re

from jinja2 import Environment
from markupsafe import Markup, escape

from helpers.exercises import program
from helpers.runner import results, verdicts
from helpers.runner.results import ExerciseResult, TestResult
from helpers.show.colours import BAD, GOOD, OPEN

_STYLES = {GOOD: 'green', BAD: 'red', OPEN: 'yellow'}  # of rich's, for a terminal

# How a verdict is put into words, after the name of the exercise.
_WORDS = {
    verdicts.FAILED: 'not there yet',
    verdicts.TIMEOUT: 'does not come to an end',
    verdicts.LEARNER_CRASHED: 'stops with an error',
    verdicts.INVALID_SUBMISSION: 'cannot be run',
    verdicts.GRADER_ERROR: 'could not be checked',
    results.NOT_ATTEMPTED: 'not solved yet',
}

_TEMPLATE = Environment(autoescape=True, trim_blocks=True, lstrip_blocks=True).from_string("""\
{% for exercise in exercises %}
<div style="border-left: 4px solid {{ colour(exercise) }}; padding: 0.2em 0 0.2em 0.9em; margin: 0.3em 0">
<div style="font-weight: 600">{{ heading(exercise) }}</div>
{% set again = repeated(exercise) %}
{% for test in failed(exercise) %}
{% if test.test not in again %}
{% for line in happened(test) %}
<div{% if loop.first %} style="margin-top: 0.4em; font-weight: 600"{% endif %}>{{ code(line) }}</div>
{% endfor %}
{% endif %}
<div><span style="color: {{ mark(test)[1] }}; font-weight: 700">{{ mark(test)[0] }}</span> \
{{ code(broken(exercise, test)) }}{% if test.test in again %} The same as above.{% endif %}</div>
{% if test.test not in again %}
{% if hint(test) %}
<div style="margin-left: 1.4em; font-style: italic; opacity: 0.8">{{ code(hint(test)) }}</div>
{% endif %}
{% if test.details %}
<details style="margin-left: 1.4em"><summary>Where in your code</summary><pre>{{ test.details }}</pre></details>
{% endif %}
{% if test.output %}
<details style="margin-left: 1.4em"><summary>What your program printed</summary><pre>{{ test.output }}</pre></details>
{% endif %}
{% endif %}
{% endfor %}
{% for line in standing(exercise) %}
<div style="margin-top: 0.4em">{{ code(line) }}</div>
{% endfor %}
</div>
{% endfor %}
""")


def heading(exercise: ExerciseResult) -> str:
    """'Exercise 3.1: a beacon'."""
    return f'Exercise {exercise.id}: {exercise.title}'


def summary(exercise: ExerciseResult) -> str:
    """One sentence on what the visible tests have shown."""
    passed, total = exercise.count(hidden=False)
    kept = f'{exercise.count_rules(results.KEPT)} of {len(exercise.rules)} rules are kept'
    if exercise.passed:
        shown = kept if exercise.rules else f'{passed} of {total} tests passed'
        return f'Solved: {shown}. When your work is graded, they are tried with other values.'
    if exercise.verdict == results.NOT_ATTEMPTED and exercise.message not in ('', program.unsolved(exercise.id)):
        return exercise.message
    if exercise.verdict == results.NOT_ATTEMPTED:
        return 'Not solved yet: write your code where the cell says "Your code here", run the cell, and check again.'
    if exercise.verdict == verdicts.INVALID_SUBMISSION and not exercise.tests:
        return exercise.message
    if exercise.verdict == verdicts.GRADER_ERROR:
        return (
            'The check itself failed, not your code. Run it again; if it stays so, run `./course doctor` in a '
            'terminal, or tell your instructor.'
        )
    return f'{kept if exercise.rules else f"{passed} of {total} tests passed"}: {_WORDS[exercise.verdict]}.'


def standing(exercise: ExerciseResult) -> list[str]:
    """What stands below the findings: what of the cells did not run, which rules were not looked at, how many are kept,
    and where the tests are.
    """
    lines = []
    if exercise.tests and not exercise.passed:
        lines += exercise.message.splitlines()
    if exercise.tests and exercise.verdict != verdicts.GRADER_ERROR:
        reasons: dict[str, list[str]] = {}
        for rule in exercise.rules:
            if rule.state == results.NOT_LOOKED_AT:
                reasons.setdefault(rule.why, []).append(rule.name)
        lines += [
            f'Nothing wrong so far: {", ".join(names)}.'
            if why == results.SO_FAR
            else f'Not looked at{" here" if exercise.passed else " yet"}: {", ".join(names)} ({why}).'
            for why, names in reasons.items()
        ]
        if not exercise.passed and exercise.count_rules(results.KEPT):
            names = ', '.join(rule.name for rule in exercise.rules if rule.state == results.KEPT)
            lines.append(f'Kept: {names}.')
    lines.append(summary(exercise))
    if exercise.tests and not exercise.passed:
        lines[-1] += f' The tests are in `{test_file(exercise)}`.'
    return lines


def test_file(exercise: ExerciseResult) -> str:
    """The file with the visible tests of an exercise, from the course's folder."""
    chapter, number = exercise.id.split('.')
    return f'helpers/checks/chapter_{int(chapter):02}/test_{chapter}_{number}.py'


def broken(exercise: ExerciseResult, test: TestResult) -> str:
    """The rule of the card that a failed test found broken: its name and its sentence; else what the test expects."""
    for rule in exercise.rules:
        if rule.name == test.rule:
            return f'{rule.name}: {rule.text}'
    return expected(test)


def expected(test: TestResult) -> str:
    """The first line of a test's docstring: what it expects."""
    return test.expected.partition('\n')[0]


def hint(test: TestResult) -> str:
    """The rest of a test's docstring, as one paragraph: where to look. Only where the test has no better diagnosis."""
    if test.verdict != verdicts.FAILED or not test.hint:
        return ''
    return ' '.join(test.expected.partition('\n')[2].split())


def happened(test: TestResult) -> list[str]:
    """What happened instead, line by line."""
    if test.verdict == verdicts.GRADER_ERROR:
        return ['This test itself failed, not your code.']
    return test.message.splitlines()


def failed(exercise: ExerciseResult) -> list[TestResult]:
    """The tests to tell of: one that failed as an earlier one did, and broke the same rule, has no news."""
    again = repeated(exercise)
    told: set[str | None] = set()
    found = []
    for test in exercise.tests:
        if not test.passed and not (test.test in again and test.rule and test.rule in told):
            told.add(test.rule)
            found.append(test)
    return found


def repeated(exercise: ExerciseResult) -> set[str]:
    """The tests that failed in the same way as an earlier one: what happened is told once."""
    seen, found = set(), set()
    for test in exercise.tests:
        if not test.passed and test.message:
            key = (test.message, test.details)
            found |= {test.test} if key in seen else set()
            seen.add(key)
    return found


def colour(exercise: ExerciseResult) -> str:
    """Green, red, or amber for what was not tested."""
    if exercise.passed:
        return GOOD
    return OPEN if exercise.verdict in (results.NOT_ATTEMPTED, verdicts.GRADER_ERROR) else BAD


def mark(test: TestResult) -> tuple[str, str]:
    """A sign before a test, and its colour. A test that itself failed says nothing about the learner's code."""
    if test.passed:
        return '✓', GOOD
    return ('?', OPEN) if test.verdict == verdicts.GRADER_ERROR else ('✗', BAD)


def code(text: str) -> Markup:
    """The text for a page: what stands between backticks is code."""
    return Markup(re.sub('`([^`\n]+)`', r'<code>\1</code>', str(escape(text))))


def html(exercises: list[ExerciseResult]) -> str:
    """The results for a notebook."""
    return _TEMPLATE.render(
        exercises=exercises,
        heading=heading,
        standing=standing,
        colour=colour,
        hint=hint,
        broken=broken,
        happened=happened,
        failed=failed,
        repeated=repeated,
        mark=mark,
        code=code,
    )


def lines(exercises: list[ExerciseResult]) -> list[tuple[str, str]]:
    """The results for a terminal: pairs of a style of rich's ('' for plain) and one line of text."""
    found = []
    for exercise in exercises:
        style = _STYLES[colour(exercise)]
        found.append((f'bold {style}', heading(exercise)))
        again = repeated(exercise)
        for test in failed(exercise):
            sign, shade = mark(test)
            same = test.test in again
            found += [('', f'  {line}') for line in happened(test) if not same]
            found.append((_STYLES[shade], f'    {sign} {broken(exercise, test)}{" The same as above." * same}'))
            if not same:
                found += [('dim', f'      {hint(test)}')] if hint(test) else []
                found += [('dim', f'      | {line}') for line in test.details.splitlines()]
        found += [('', f'  {line}') for line in standing(exercise)]
    return found


def plain(exercises: list[ExerciseResult]) -> str:
    """The results as plain text."""
    return '\n'.join(text for _, text in lines(exercises))
