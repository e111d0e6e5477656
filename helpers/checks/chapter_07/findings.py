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


def compare(
    got, expected: list[tuple], why: dict[str, str], rule: str = '', given: str = '', extra=lambda finding: ''
) -> None:
    """Fail with words if `got` is not a list of the `expected` findings, in any order.

    :param why: a sentence for each cause: where to look if it is missed, or found where it is not.
    :param rule: the rule that is broken if a finding is missed, or is too much; by default that of its cause.
    :param given: what the function was asked about, to be shown.
    :param extra: a finding that is too much → why it is none, or '' for the sentence of its cause.
    """
    first = rule or (rule_of(expected[0][2]) if expected else '')
    given = f'\n{given}' if given else ''
    expect(
        isinstance(got, list),
        f'The function returned {got!r}, expected a list of findings, also if it is empty.',
        first,
    )
    for one in got:
        fits = isinstance(one, list) and len(one) == 4 and all(isinstance(part, str) for part in one)
        expect(fits, f'{one!r} is no finding: it has four parts, and each is a string.', first)
    found = [with_name(one) for one in got]
    for one in found:
        expect(not no_fault(one[0]), no_fault(one[0]), rule or (rule_of(one[2]) if one[2] in why else first))
    for one in expected:
        if one in found:
            continue
        broken = rule or rule_of(one[2])
        for part, name in ((3, 'evidence'), (1, '`where`'), (0, '`fault`')):
            twins = [
                other
                for other in found
                if other not in expected and all(other[k] == one[k] for k in range(4) if k != part)
            ]
            expect(
                not twins,
                f'{said(one)}: your {name} is {twins and twins[0][part]!r}, expected {one[part]!r}. '
                f'{why.get(one[2], "")}{given}',
                broken,
            )
        expect(False, f'You did not find {said(one)} (evidence {one[3]!r}). {why.get(one[2], "")}{given}', broken)
    for one in found:
        broken = rule or (rule_of(one[2]) if one[2] in why else first)
        expect(
            one in expected,
            f'You found {said(one)} (evidence {one[3]!r}), and there is no such fault. '
            f'{extra(one) or why.get(one[2], "")}{given}',
            broken,
        )
        times, wanted = found.count(one), expected.count(one)
        expect(times <= wanted, f'You found {said(one)} {times} times. Each fault is one finding.{given}', broken)
        expect(
            times == wanted,
            f'You found {said(one)} {times} time(s), and there are {wanted} with the same four parts: each is a '
            f'finding of its own.{given}',
            broken,
        )


def said(finding: tuple) -> str:
    """What a finding says, but for its evidence, in words."""
    fault, where, cause, _ = finding
    return f'`{fault}`, cause `{cause}`, in {where}'
