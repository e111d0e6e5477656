"""What can be said of faults without running them."""

import pytest

from helpers.programs import faults
from helpers.programs.faults.finding import CAUSES
from helpers.programs.faults.live import NUMBERS, Planned

KINDS = [(fault.name, kind) for fault in faults.FAULTS for kind in fault.kinds]


@pytest.mark.parametrize('name, kind', KINDS)
def test_a_repair_changes_only_the_file_that_the_diagnosis_names(name, kind):
    for seed in range(20):
        fault = faults.plan(name, seed, kind)
        changed = {file for file, text in fault.repaired.items() if fault.files[file] != text}
        named = {found.where for found in fault.diagnosis}
        assert changed == set(fault.repaired) == named


@pytest.mark.parametrize('name, kind', KINDS)
def test_a_diagnosis_is_a_finding_in_the_words_of_the_exercises(name, kind):
    for seed in range(20):
        fault = faults.plan(name, seed, kind)
        assert fault.diagnosis and all(isinstance(found, faults.Finding) for found in fault.diagnosis)
        for found in fault.diagnosis:
            assert found.cause in CAUSES[found.fault], found
            assert found.evidence or found.cause in (
                'not sourced',
                'missing',
                'nobody',
                'unknown',
                'collision',
                'inertial',
            )


@pytest.mark.parametrize('fault', faults.FAULTS, ids=lambda fault: fault.name)
def test_seeds_draw_names_and_causes(fault):
    plans = [faults.plan(fault.name, seed) for seed in range(40)]
    assert {plan.kind for plan in plans} == set(fault.kinds)
    assert len({str(plan.files) for plan in plans}) > len(fault.kinds)
    assert faults.plan(fault.name, 7).files == plans[7].files, 'the same seed gives the same system'


def test_the_order_is_that_of_the_chapter_and_earlier_numbers_still_name_a_fault():
    assert [fault.name for fault in faults.FAULTS] == [*CAUSES, 'mystery']
    assert faults.plan('A7.6', 4).files == faults.plan('no_data', 4).files


def test_a_seed_draws_what_it_drew_when_faults_had_numbers():
    assert faults.plan('no_data', 4).facts['publisher_topic'] == '/cellar/humidity'
    assert [found.cause for found in faults.plan('mystery', 295).diagnosis] == ['domain', 'call']
    drawn = [list(Planned('the course', number).drawn) for number in NUMBERS]
    assert drawn == [['wrong_time'], ['too_slow', 'no_parameter'], ['no_transform', 'no_data'], ['unseen'], ['hang']]


@pytest.mark.parametrize('fault', faults.FAULTS, ids=lambda fault: fault.name)
def test_what_is_shown_does_not_tell_the_cause(fault):
    kinds = [kind for kind in fault.kinds if kind != 'loop']  # a program without a server
    assert len({repr(faults.plan(fault.name, 3, kind)) for kind in kinds}) == 1


def test_the_mystery_draws_every_fault_that_it_has():
    drawn = [tuple(found.fault for found in faults.plan('mystery', seed).diagnosis) for seed in range(60)]
    assert all(len(set(names)) == 2 for names in drawn)
    assert {name for names in drawn for name in names} == {
        'no_ros2',
        'no_data',
        'unseen',
        'waiting',
        'hang',
        'no_transform',
        'wrong_time',
        'too_slow',
        'no_parameter',
    }


def test_one_clear_line_for_what_does_not_exist():
    with pytest.raises(ValueError, match="no fault 'nodata': there are no_ros2, no_colcon"):
        faults.plan('nodata')
    with pytest.raises(ValueError, match='no_data has no kind .* it has reliability'):
        faults.plan('no_data', kind='magic')
