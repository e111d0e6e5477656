"""What a learner's tools have found, against what was put in."""

from helpers.programs.faults.finding import CAUSES, name_of
from helpers.runner import expect


def rule_of(cause: str) -> str:
    """The rule of the card that states a cause: its name, in the form of names of rules."""
    return cause.lower().replace(' ', '-')


def with_name(finding: list) -> tuple:
    """A learner's finding whose fault has its name, also if it was written with the earlier number."""
    fault, where, cause, evidence = finding
    return name_of(fault), where, cause, evidence


def no_fault(name: str) -> str:
    """What is said of a finding whose fault is none of the chapter's; '' if it is one."""
    return '' if name in CAUSES else f'{name!r} is no fault of section 7.2. There are {", ".join(CAUSES)}.'


def is_finding(value) -> bool:
    """Whether a learner's value has the form of a finding: four strings."""
    return isinstance(value, list) and len(value) == 4 and all(isinstance(part, str) for part in value)


def compare(
    got, expected: list[tuple], why: dict[str, str], rule: str = '', given: str = '', extra=lambda finding: ('', '')
) -> None:
    """Fail with words if `got` is not a list of the `expected` findings, in any order.

    :param why: a sentence for each cause: where to look if it is missed, or found where it is not.
    :param rule: the rule that is broken if a finding is missed, or is too much; by default that of its cause.
    :param given: what the function was asked about, to be shown.
    :param extra: a finding that is too much → why it is none, and the rule that says so; '' twice for the sentence and
        the rule of its cause.
    """
    first = rule or (rule_of(expected[0][2]) if expected else '')
    given = f'\n{given}' if given else ''
    found = _read(got, first)
    for one in found:
        expect(not no_fault(one[0]), no_fault(one[0]), rule or (rule_of(one[2]) if one[2] in why else first))
    for one in expected:
        if one not in found:
            _judge_missed(one, [other for other in found if other not in expected], why, rule, given)
    for one in found:
        told, of = extra(one)
        broken = rule or (rule_of(one[2]) if one[2] in why else first)
        expect(
            one in expected,
            f'You found {said(one)} (evidence {one[3]!r}), and there is no such fault. '
            f'{told or why.get(one[2], "")}{given}',
            of or broken,
        )
        times, wanted = found.count(one), expected.count(one)
        expect(times <= wanted, f'You found {said(one)} {times} times. Each fault is one finding.{given}', broken)
        expect(
            times == wanted,
            f'You found {said(one)} {times} time(s), and there are {wanted} with the same four parts: each is a '
            f'finding of its own.{given}',
            broken,
        )


def _read(got, rule: str) -> list[tuple]:
    """The findings that a learner's function has returned; fail with words if that is no list of findings."""
    expect(
        isinstance(got, list), f'The function returned {got!r}, expected a list of findings, also if it is empty.', rule
    )
    expect(not is_finding(got), f'The function returned one finding, {got!r}, expected a list: put it into [ ].', rule)
    for one in got:
        expect(is_finding(one), f'{one!r} is no finding: it has four parts, and each is a string.', rule)
    return [with_name(one) for one in got]


def _judge_missed(one: tuple, others: list[tuple], why: dict[str, str], rule: str, given: str) -> None:
    """Fail with words because a finding is missed: the part in which one of the `others`, which are wrong, differs."""
    broken, more = rule or rule_of(one[2]), f'{why.get(one[2], "")}{given}'
    for part, name in ((3, 'evidence'), (1, '`where`'), (0, '`fault`'), (2, 'cause')):
        twins = [other for other in others if all(other[k] == one[k] for k in range(4) if k != part)]
        # Another cause of the exercise is another finding; one that there is not is misspelt.
        twins = [other for other in twins if part != 2 or other[2] not in why]
        expect(
            not twins,
            f'{said(one)}: your {name} is {twins and twins[0][part]!r}, expected {one[part]!r}. {more}',
            broken,
        )
    expect(False, f'You did not find {said(one)} (evidence {one[3]!r}). {more}', broken)


def said(finding: tuple) -> str:
    """What a finding says, but for its evidence, in words."""
    fault, where, cause, _ = finding
    return f'`{fault}`, cause `{cause}`, in {where}'
