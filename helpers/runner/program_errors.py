"""What went wrong in the learner's process, in words: a LearnerError for each problem that it reports."""

import re
from collections.abc import Mapping, Sequence

from helpers.runner import explanations, slips
from helpers.runner.verdicts import InvalidProgram, LearnerCrashed, LearnerError, LearnerTimeout, Unheard

# Functions in which the callback of a deadlock waits for the answer of a service or an action.
_WAITS_FOR_ANSWER = ('.call(', 'until_future_complete', '.done()', '.send_goal(', '.get_result(', 'spin_once(')


class ProgramErrors:
    """The errors of one program.

    :param absent: by name, why a name is not there that some cell binds.
    :param answer: the text of the exercise's cell.
    :param cells: the texts of the other cells that are loaded.
    """

    def __init__(self, title: str, absent: Mapping[str, str], answer: str, cells: Sequence[str] = ()):
        self._title, self._absent, self._answer, self._cells = title, absent, answer, cells

    def of(self, problem: dict, arguments: dict) -> LearnerError:
        """The error for a problem that the learner's process has reported; `arguments`: of what it was asked."""
        name = str(problem.get('name', arguments.get('name', '')))[:200]
        match problem.get('kind'):
            case 'missing':
                return InvalidProgram(self._absent.get(name) or f'{self._title} does not define `{name}`.')
            case 'waits':
                return self._waits(problem)
            case 'no_node':
                return LearnerError(
                    f'`{name}(…)` gives {_a(str(problem.get("got"))[:100])}, not a node. '
                    'A class must inherit from `Node`; a function must return the node.'
                )
            case 'no_super':
                call = slips.super_call(self._answer, name)
                return LearnerError(f'`{name}` is not initialised as a node: call `{call}` first in `__init__`.')
            case 'not_callable':
                return LearnerError(f'`{name}` is {_a(str(problem.get("got"))[:100])}, not a function.')
            case 'busy':
                return LearnerError(
                    f'Your node never comes to rest: {problem.get("count")} callbacks ran at one '
                    'moment of simulated time. Has a timer the period 0, or does a node answer its own '
                    'messages?'
                )
            case 'too_long':
                return LearnerError(f'What `{name}(…)` returns is too long to be read.')
            case 'sleeps':
                return LearnerError(
                    f'A callback sleeps with time.sleep{_at(lines_of(problem), self._title)}: that is the clock on '
                    "the wall. While it sleeps, no time passes for the robot. Wait on the node's clock: "
                    'self.get_clock().sleep_for(…), a rate, or a timer.',
                    _stack(lines_of(problem)),
                )
            case 'exception':
                return self._exception(problem, name)
            case 'deaf':
                return Unheard(
                    'Your program did not hear in time what was sent to it. Does it do something else '
                    'meanwhile, in a thread of its own?'
                )
        return LearnerCrashed('Your program disturbed its connection to the tests (an error of an unknown kind).')

    def _waits(self, problem: dict) -> LearnerError:
        """A callback waits for another callback."""
        call, lines = str(problem.get('call'))[:100], lines_of(problem)
        what = 'spins' if 'spin' in call else 'waits for an answer'
        return LearnerTimeout(
            f'A callback {what}{_at(lines, self._title)}. Only another callback can receive what it waits for, and '
            'none runs before this one has returned: a deadlock, with or without a timeout. Use call_async (or '
            'send_goal_async), and go on in a done-callback or after `await`.',
            _stack(lines),
        )

    def _exception(self, problem: dict, name: str) -> LearnerError:
        places = {
            'load': 'While the cell was run',
            'constructor': f'While `{name}(…)` was made',
            'call': f'While `{name}(…)` ran',
            'execute': 'In an execute callback',
            'callback': _callback(problem),
        }
        where = places.get(str(problem.get('where')), 'Then')
        lines = lines_of(problem)
        kind, text = str(problem.get('type'))[:100], str(problem.get('text'))[:1000]
        text = re.sub(r' \(<cell \d+>, line \d+\)$', '', text)  # where it is stands in `lines`
        at = _at(lines, self._title, code=False)
        if kind == 'SystemExit':
            return LearnerCrashed(
                f'{where} your code called exit(){at}. A node must not end its process.', _stack(lines)
            )
        if kind == 'EOFError' and 'reading a line' in text:
            return LearnerCrashed(
                f'Your code called input(){at}. Nobody is at a keyboard while it is tested: take '
                'what you need as an argument or a parameter.',
                _stack(lines),
            )
        error = f'{kind}: {text}' if text else kind
        notes = problem.get('notes')
        notes = notes[:5] if isinstance(notes, list) and kind in ('NameError', 'ImportError') else []
        called = '' if lines else str(problem.get('callback', ''))[:100]
        early = str(problem.get('early', ''))[:200]
        code = [line['code'] for line in lines]
        more = explanations.explain(kind, text, early, self._absent, called, notes, self._answer, code, self._cells)
        return LearnerCrashed(
            f'{where} your code raised {error}{at}. {more}'.strip(),
            '\n'.join([_stack(lines), error, *(f'Not loaded: {note}' for note in notes)]),
        )


def hanging(op: str, limit: float, arguments: dict, lines: list[dict], title: str = '') -> LearnerError:
    """The error of a program that has not answered within `limit` seconds; `lines`: those that it was at.

    :param title: the exercise's, which is the name of its cell.
    """
    made = f'`{arguments.get("name")}(…)`'
    doing = {'load': 'The cell', 'start': made, 'call': made}.get(op, 'A callback')
    where = f' It was still{_at(lines, title)}.' if lines else ''
    asks = any(waiting in line['code'] for line in lines for waiting in _WAITS_FOR_ANSWER)
    hint = (
        ' It waits for an answer, which only another callback can receive, and none runs before this one has '
        'returned: a deadlock. Use call_async, and go on in a done-callback or after `await`.'
        if op == 'step' and asks
        else ' A callback must return at once; what has to wait belongs into a timer.'
        if op == 'step'
        else " Spinning and waiting are not the node's business: leave them to the program that runs it."
        if op in ('start', 'load')
        else ''
    )
    return LearnerTimeout(f'{doing} did not return within {limit:g} s.{where}{hint}', _stack(lines))


def _a(kind: str) -> str:
    return 'nothing (None)' if kind == 'NoneType' else f'an object of type `{kind}`'


def lines_of(message: dict) -> list[dict]:
    """The learner's lines in a message, whatever else it may hold."""
    found = message.get('lines')
    return (
        [
            {key: str(line.get(key, ''))[:300] for key in ('cell', 'line', 'function', 'code')}
            for line in found[:20]
            if isinstance(line, dict)
        ]
        if isinstance(found, list)
        else []
    )


def _callback(problem: dict) -> str:
    """In which callback it was. A done-callback of a future belongs to no node."""
    if not problem.get('callback'):
        return 'In a done-callback, or in a task of the executor,'
    return f'In a callback ({problem["callback"]} of node `{problem.get("node")}`)'


def _at(lines: list[dict], title: str, code: bool = True) -> str:
    """Where the innermost of the learner's lines is, to be put into a sentence; `code`: with its text.

    If that is in another cell, which is perhaps right as it is: also the line of the exercise that has called it.
    """
    if not lines:
        return ''
    *outer, last = lines
    at = f' at {last["cell"]}, line {last["line"]}{": `" + last["code"] + "`" if code else ""}'
    calls = [line for line in outer if line['cell'] == title] if last['cell'] != title else []
    return at + (f', called from {title}, line {calls[-1]["line"]}: `{calls[-1]["code"]}`' if calls else '')


def _stack(lines: list[dict]) -> str:
    """The learner's lines as a traceback."""
    return '\n'.join(
        f'{line["cell"]}, line {line["line"]}{", in " + line["function"] if line["function"] else ""}\n'
        f'    {line["code"]}'
        for line in lines
    )
