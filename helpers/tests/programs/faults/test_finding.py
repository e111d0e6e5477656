"""Findings, written with the names of faults, and with the numbers that faults had in earlier versions."""

import copy
import pickle

import pytest

from helpers.checks.chapter_07.findings import compare
from helpers.programs.faults import Finding
from helpers.programs.faults.finding import CAUSES, name_of, number_of
from helpers.runner.values import decode, encode_result
from helpers.runner.verdicts import ExpectationFailed

OTHERS = ('/ear /chater', 'name', '/chatter')
NAMED, NUMBERED = Finding('no_data', *OTHERS), Finding('A7.6', *OTHERS)


def test_each_fault_has_a_number_of_its_own_and_each_number_a_name():
    numbers = [number_of(name) for name in CAUSES]
    assert sorted(int(number.removeprefix('A7.')) for number in numbers) == list(range(1, 16))
    assert [name_of(number) for number in numbers] == list(CAUSES)
    assert name_of('nodata') == number_of('nodata') == 'nodata'


@pytest.mark.parametrize(
    'finding', [NAMED, NUMBERED, Finding(row='A7.6', where='/ear /chater', cause='name', evidence='/chatter')]
)
def test_both_spellings_are_one_finding(finding):
    assert finding == NAMED == NUMBERED and not finding != NAMED
    assert finding == ('A7.6', *OTHERS) and ('A7.6', *OTHERS) == finding == ('no_data', *OTHERS)
    assert finding in [('A7.6', *OTHERS)] and finding in [NAMED]
    assert finding[0] == 'A7.6' == finding[0] and finding[0] == 'no_data' != finding[0].upper()
    assert finding[0] != 'A7.60' and finding[0] in ('A7.6', 'A7.8') and finding[0] != 6
    assert finding.row == 'A7.6' and finding.fault == 'no_data' and finding.where == '/ear /chater'
    assert finding != Finding('A7.8', *OTHERS) and finding != Finding('no_data', 'elsewhere', *OTHERS[1:])


def test_sets_and_dictionaries_find_the_spelling_that_was_written():
    assert NUMBERED[0] in {'A7.6'} and NAMED[0] in {'no_data'}
    for finding in (NAMED, NUMBERED):
        assert finding.row in {'A7.6'} and finding.fault in {'no_data'}
        assert {'A7.6': 1}[finding.row] == {'no_data': 1}[finding.fault] == 1
    assert len({NUMBERED, Finding('A7.6', *OTHERS), ('A7.6', *OTHERS)}) == 1


def test_what_a_named_tuple_can_do():
    fault, where, cause, evidence = NUMBERED
    assert (fault, where, cause, evidence) == NAMED and Finding(*NAMED) == NAMED
    assert repr(NAMED) == "Finding(fault='no_data', where='/ear /chater', cause='name', evidence='/chatter')"
    assert NUMBERED._replace(where='x') == Finding('no_data', 'x', *OTHERS[1:])
    assert Finding._make(['A7.6', *OTHERS]).row == 'A7.6'
    assert copy.deepcopy(NUMBERED) == pickle.loads(pickle.dumps(NUMBERED)) == NAMED
    match NAMED:
        case Finding('A7.6', where) | Finding(row='A7.6', where=where):
            assert where == '/ear /chater'
        case _:
            pytest.fail('no pattern fits')


def test_a_part_that_is_missing_or_unknown_is_an_error():
    with pytest.raises(TypeError, match="missing 1 required positional argument: 'evidence'"):
        Finding('no_data', 'a', 'b')
    with pytest.raises(TypeError, match='place'):
        Finding(fault='no_data', place='a', cause='b', evidence='c')


@pytest.mark.parametrize('finding', [NAMED, NUMBERED, ('A7.6', *OTHERS), ('no_data', *OTHERS)])
def test_a_check_takes_both_spellings(finding):
    compare(decode(encode_result([finding])), [('no_data', *OTHERS)], {})


@pytest.mark.parametrize(
    'fault, told',
    [
        ('nodata', "'nodata' is no fault of section 7.2. There are no_ros2, no_colcon, .*, no_data, .*, wrong_time."),
        ('A7.66', "'A7.66' is no fault of section 7.2. There are no_ros2"),
        ('waiting', "your `fault` is 'waiting', expected 'no_data'"),
        ('A7.8', "your `fault` is 'waiting', expected 'no_data'"),
    ],
)
def test_a_check_names_a_wrong_fault(fault, told):
    with pytest.raises(ExpectationFailed, match=told) as failed:
        compare([[fault, *OTHERS]], [('no_data', *OTHERS)], {})
    assert failed.value.rule == 'name'
