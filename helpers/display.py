"""What `check` shows: results as HTML for a notebook, and as lines for a terminal.

The same results give the same text: no times, no addresses, no order by chance. Colours suit light and dark themes.
"""

from jinja2 import Environment

from helpers.runner import results, verdicts
from helpers.runner.results import ExerciseResult, TestResult

GOOD, BAD, OPEN = '#2e9d4e', '#d6453d', '#c98a00'

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
<div>{{ summary(exercise) }}</div>
{% for test in exercise.tests if not exercise.passed %}
<div style="margin-top: 0.5em"><span style="color: {{ good if test.passed else bad }}; font-weight: 700">\
{{ '✓' if test.passed else '✗' }}</span> {{ expected(test) }}</div>
{% if not test.passed %}
{% for line in happened(test) %}
<div style="margin-left: 1.4em">{{ line }}</div>
{% endfor %}
{% if hint(test) %}
<div style="margin-left: 1.4em; font-style: italic; opacity: 0.8">{{ hint(test) }}</div>
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
    """The rest of a test's docstring, as one paragraph: where to look."""
    return ' '.join(test.expected.partition('\n')[2].split())


def happened(test: TestResult) -> list[str]:
    """What happened instead, line by line."""
    if test.verdict == verdicts.GRADER_ERROR:
        return ['This test itself failed, not your code.']
    return test.message.splitlines()


def colour(exercise: ExerciseResult) -> str:
    """Green, red, or amber for what was not tested."""
    if exercise.passed:
        return GOOD
    return OPEN if exercise.verdict in (results.NOT_ATTEMPTED, verdicts.GRADER_ERROR) else BAD


def html(exercises: list[ExerciseResult]) -> str:
    """The results for a notebook."""
    return _TEMPLATE.render(exercises=exercises, heading=heading, summary=summary, colour=colour, hint=hint,
                            expected=expected, happened=happened, good=GOOD, bad=BAD)


def lines(exercises: list[ExerciseResult]) -> list[tuple[str, str]]:
    """The results for a terminal: pairs of a style of rich's ('' for plain) and one line of text."""
    found = []
    for exercise in exercises:
        style = {GOOD: 'green', BAD: 'red', OPEN: 'yellow'}[colour(exercise)]
        found += [(f'bold {style}', heading(exercise)), ('', f'  {summary(exercise)}')]
        for test in exercise.tests if not exercise.passed else ():
            found.append(('green' if test.passed else 'red', f'  {"✓" if test.passed else "✗"} {expected(test)}'))
            if not test.passed:
                found += [('', f'      {line}') for line in happened(test)]
                if hint(test):
                    found.append(('dim', f'      {hint(test)}'))
                found += [('dim', f'      | {line}') for line in test.details.splitlines()]
    return found


def plain(exercises: list[ExerciseResult]) -> str:
    """The results as plain text."""
    return '\n'.join(text for _, text in lines(exercises))
