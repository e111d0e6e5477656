"""`feedback/<learner>.html`: one page for the learner, without scripts, every value escaped.

It shows what was expected and what happened; never an assertion, a test's code or the grader's own faults.
"""

from jinja2 import Environment, PackageLoader

from grading.record import Record
from helpers import display
from helpers.runner import results, verdicts

_WORDS = {
    verdicts.PASSED: 'solved',
    verdicts.FAILED: 'not there yet',
    verdicts.TIMEOUT: 'does not come to an end',
    verdicts.LEARNER_CRASHED: 'stops with an error',
    verdicts.INVALID_SUBMISSION: 'cannot be run',
    verdicts.GRADER_ERROR: 'to be graded again: our fault, not yours',
    results.NOT_ATTEMPTED: 'not solved yet',
}

_ENVIRONMENT = Environment(loader=PackageLoader('grading.reports', ''), autoescape=True, trim_blocks=True,
                           lstrip_blocks=True)
_ENVIRONMENT.filters['points'] = lambda value: '–' if value is None else f'{value:g}'


def dumps(record: Record) -> str:
    """The page."""
    return _ENVIRONMENT.get_template('feedback.html.j2').render(
        record=record, words=_WORDS, expected=display.expected, hint=display.hint, happened=display.happened,
        colour=display.colour, heading=display.heading)
