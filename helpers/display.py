"""What `check` shows: results as HTML for a notebook, and as lines for a terminal.

The same results give the same text: no times, no addresses, no order by chance. Colours suit light and dark themes.
"""

import re

from jinja2 import Environment
from markupsafe import Markup, escape

from helpers.runner import results, verdicts
from helpers.runner.results import ExerciseResult, TestResult

GOOD, BAD, OPEN = '#2e9d4e', '#d6453d', '#c98a00'

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

_TEMPLATE = Environment(autoescape=True, trim_blocks=True, lstrip_blocks=True).from_string('''\
{% for exercise in exercises %}
<div style="border-left: 4px solid {{ colour(exercise) }}; padding: 0.2em 0 0.2em 0.9em; margin: 0.3em 0">
<div style="font-weight: 600">{{ heading(exercise) }}</div>
<div>{{ code(summary(exercise)) }}</div>
{% set again = repeated(exercise) %}
{% for test in exercise.tests if not exercise.passed %}
<div style="margin-top: 0.5em"><span style="color: {{ mark(test)[1] }}; font-weight: 700">\
{{ mark(test)[0] }}</span> {{ code(expected(test)) }}</div>
{% if test.test in again %}
<div style="margin-left: 1.4em">The same as above.</div>
{% elif not test.passed %}
{% for line in happened(test) %}
<div style="margin-left: 1.4em">{{ code(line) }}</div>
{% endfor %}
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
</div>
{% endfor %}
''')


def heading(exercise: ExerciseResult) -> str:
    """'Exercise 3.1: a beacon'."""
    return f'Exercise {exercise.id}: {exercise.title}'


def summary(exercise: ExerciseResult) -> str:
    """One sentence on the visible tests of an exercise."""
    passed, total = exercise.count(hidden=False)
    if exercise.passed:
        tests = 'The visible test' if total == 1 else f'All {total} visible tests'
        return f'{tests} passed. Hidden tests run when your work is graded.'
    if exercise.verdict == results.NOT_ATTEMPTED:
        return 'Not solved yet: write your code where the cell says "Your code here", run the cell, and check again.'
    if exercise.verdict == verdicts.INVALID_SUBMISSION and not exercise.tests:
        return exercise.message
    if exercise.verdict == verdicts.GRADER_ERROR:
        return 'The check itself failed, not your code. Run it again; if it stays so, tell your instructor.'
    return f'{passed} of {total} visible tests passed: {_WORDS[exercise.verdict]}.'


def expected(test: TestResult) -> str:
    """The first line of a test's docstring: what it expects."""
    return test.expected.partition('\n')[0]


def hint(test: TestResult) -> str:
    """The rest of a test's docstring, as one paragraph: where to look. Beside an error or a hang it would mislead."""
    if test.verdict != verdicts.FAILED:
        return ''
    return ' '.join(test.expected.partition('\n')[2].split())


def happened(test: TestResult) -> list[str]:
    """What happened instead, line by line."""
    if test.verdict == verdicts.GRADER_ERROR:
        return ['This test itself failed, not your code.']
    return test.message.splitlines()


def repeated(exercise: ExerciseResult) -> set[str]:
    """The tests that failed in the same way as an earlier one: what happened is told once."""
    seen, found = set(), set()
    for test in exercise.tests:
        if test.verdict in (verdicts.LEARNER_CRASHED, verdicts.TIMEOUT, verdicts.INVALID_SUBMISSION):
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
    return _TEMPLATE.render(exercises=exercises, heading=heading, summary=summary, colour=colour, hint=hint,
                            expected=expected, happened=happened, repeated=repeated, mark=mark, code=code)


def lines(exercises: list[ExerciseResult]) -> list[tuple[str, str]]:
    """The results for a terminal: pairs of a style of rich's ('' for plain) and one line of text."""
    found = []
    for exercise in exercises:
        style = _STYLES[colour(exercise)]
        found += [(f'bold {style}', heading(exercise)), ('', f'  {summary(exercise)}')]
        again = repeated(exercise)
        for test in exercise.tests if not exercise.passed else ():
            sign, shade = mark(test)
            found.append((_STYLES[shade], f'  {sign} {expected(test)}'))
            if test.test in again:
                found.append(('', '      The same as above.'))
            elif not test.passed:
                found += [('', f'      {line}') for line in happened(test)]
                if hint(test):
                    found.append(('dim', f'      {hint(test)}'))
                found += [('dim', f'      | {line}') for line in test.details.splitlines()]
    return found


def plain(exercises: list[ExerciseResult]) -> str:
    """The results as plain text."""
    return '\n'.join(text for _, text in lines(exercises))
