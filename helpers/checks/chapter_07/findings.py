"""What a learner's tools have found, against what was put in."""

from helpers.runner import expect


def compare(got, expected: list[tuple], why: dict[str, str]) -> None:
    """Fail with words if `got` is not a list of the `expected` findings, in any order.

    :param why: a sentence for each cause: where to look if it is missed, or found where it is not.
    """
    expect(isinstance(got, list), f'The function returned {got!r}, expected a list of findings, also if it is empty.')
    for one in got:
        fits = isinstance(one, list) and len(one) == 4 and all(isinstance(part, str) for part in one)
        expect(fits, f'{one!r} is no finding: it has four parts, and each is a text.')
    found = [tuple(one) for one in got]
    for one in expected:
        if one in found:
            continue
        twins = [other for other in found if other[:3] == one[:3] and other not in expected]
        expect(not twins, f'{said(one)}: your evidence is {twins and twins[0][3]!r}, expected {one[3]!r}. '
                          f'{why.get(one[2], "")}')
        expect(False, f'You did not find {said(one)} (evidence {one[3]!r}). {why.get(one[2], "")}')
    for one in found:
        expect(one in expected, f'You found {said(one)} (evidence {one[3]!r}), and there is no such fault. '
                                f'{why.get(one[2], "")}')
        expect(found.count(one) == 1, f'You found {said(one)} {found.count(one)} times. Each fault is one finding.')


def said(finding: tuple) -> str:
    """Row, cause and place of a finding, in words."""
    row, where, cause, _ = finding
    return f'{row}, cause `{cause}`, in {where}'
