"""What can be said of faults without running them."""

import pytest

from helpers.programs import faults
from helpers.programs.faults.finding import CAUSES

KINDS = [(fault.row, kind) for fault in faults.FAULTS for kind in fault.kinds]


@pytest.mark.parametrize('row, kind', KINDS)
def test_a_repair_changes_only_the_file_that_the_diagnosis_names(row, kind):
    for seed in range(20):
        fault = faults.plan(row, seed, kind)
        changed = {file for file, text in fault.repaired.items() if fault.files[file] != text}
        named = {found.where for found in fault.diagnosis}
        assert changed == set(fault.repaired) == named


@pytest.mark.parametrize('row, kind', KINDS)
def test_a_diagnosis_is_a_finding_in_the_words_of_the_exercises(row, kind):
    for seed in range(20):
        fault = faults.plan(row, seed, kind)
        assert fault.diagnosis and all(isinstance(found, faults.Finding) for found in fault.diagnosis)
        for found in fault.diagnosis:
            assert found.cause in CAUSES[found.row], found
            assert found.evidence or found.cause in (
                'not sourced',
                'missing',
                'nobody',
                'unknown',
                'collision',
                'inertial',
            )


@pytest.mark.parametrize('fault', faults.FAULTS, ids=lambda fault: fault.row)
def test_seeds_draw_names_and_causes(fault):
    plans = [faults.plan(fault.name, seed) for seed in range(40)]
    assert {plan.kind for plan in plans} == set(fault.kinds)
    assert len({str(plan.files) for plan in plans}) > len(fault.kinds)
    assert faults.plan(fault.row, 7).files == plans[7].files, 'the same seed gives the same system'


@pytest.mark.parametrize('fault', faults.FAULTS, ids=lambda fault: fault.row)
def test_what_is_shown_does_not_tell_the_cause(fault):
    kinds = [kind for kind in fault.kinds if kind != 'loop']  # a program without a server
    assert len({repr(faults.plan(fault.row, 3, kind)) for kind in kinds}) == 1


def test_the_mystery_draws_every_row_that_it_has():
    drawn = [tuple(found.row for found in faults.plan('mystery', seed).diagnosis) for seed in range(60)]
    assert all(len(set(rows)) == 2 for rows in drawn)
    assert {row for rows in drawn for row in rows} == {
        'A7.2',
        'A7.6',
        'A7.7',
        'A7.8',
        'A7.9',
        'A7.12',
        'A7.13',
        'A7.14',
        'A7.15',
    }


def test_one_clear_line_for_what_does_not_exist():
    with pytest.raises(ValueError, match="no fault 'A7.99': there are no_source, no_ros2"):
        faults.plan('A7.99')
    with pytest.raises(ValueError, match='no_data has no kind .* it has reliability'):
        faults.plan('A7.6', kind='magic')
