"""What changes a mark besides the tests: the late policy and adjustments by hand, read and applied."""

import pytest

from grading import adjustments, late
from grading.adjustments import Adjustment, AdjustmentError
from grading.late import PolicyError

POINTS = {'3.1': 10.0, '3.2': 5.0}
POLICY = """
due: 2026-11-20T23:59:00+01:00
grace_minutes: 15
per_day: 10
cap: 25
extensions: {ada: 2026-11-27T23:59:00+01:00}
handed_in:
  bob: 2026-11-20T21:14:00+01:00
"""

DUE = 'due: 2026-11-20T23:59:00Z\n'


def written(tmp_path, text, name='file.yaml'):
    path = tmp_path / name
    path.write_text(text)
    return path


@pytest.mark.parametrize(
    ('learner', 'handed_in', 'days', 'percent'),
    [
        ('eve', '2026-11-20T22:59:00Z', 0, 0),
        ('eve', '2026-11-20T23:14:00Z', 0, 0),  # within the grace
        ('eve', '2026-11-20T23:14:01Z', 1, 10),
        ('eve', '2026-11-21T22:59:00Z', 1, 10),
        ('eve', '2026-11-21T22:59:01Z', 2, 20),
        ('eve', '2026-12-21T22:59:01Z', 32, 25),  # the cap
        ('ada', '2026-11-27T22:59:00Z', 0, 0),  # an extension
        ('ada', '2026-11-28T22:59:00Z', 1, 10),
        ('bob', '2026-12-28T22:59:00Z', 0, 0),  # the platform's own time
    ],
)
def test_lateness(tmp_path, learner, handed_in, days, percent):
    found = late.load(written(tmp_path, POLICY)).judge(learner, handed_in)
    assert (found.days, found.percent) == (days, percent)
    assert found.applied(7.77) == round(7.77 * (100 - percent) / 100, 2)


def test_a_grace_that_ends_after_all_times(tmp_path):
    policy = late.load(written(tmp_path, 'due: 9999-12-31T23:00:00Z\ngrace_minutes: 600'))
    assert policy.judge('ada', '9999-12-31T23:59:59Z').days == 0


def test_times_are_told_in_utc(tmp_path):
    policy = late.load(written(tmp_path, 'due: "2026-11-20T23:59:00-05:00"'))
    assert policy.judge('ada', '').days == 0  # nobody knows when
    found = policy.judge('ada', '2026-11-25T00:00:00Z')
    assert (found.due, found.handed_in, found.percent) == ('2026-11-21T04:59:00Z', '2026-11-25T00:00:00Z', 0)


@pytest.mark.parametrize(
    ('text', 'problem'),
    [
        ('', 'a line "due'),
        ('due: tomorrow', 'due must be a time with its zone'),
        ('due: 2026-11-20T23:59:00', 'due must be a time with its zone'),
        ('due: 2026-11-20T23:59:00Z\nper_day: much', 'per_day must be a number from 0 to 100'),
        ('due: 2026-11-20T23:59:00Z\nper_day: 101', 'per_day must be a number from 0 to 100'),
        ('due: 2026-11-20T23:59:00Z\ngrace_minutes: .nan', 'grace_minutes must be'),
        ('due: 2026-11-20T23:59:00Z\nper_hour: 1', "'per_hour' is unknown"),
        ('due: 2026-11-20T23:59:00Z\nextensions: [ada]', 'extensions must be lines'),
        ('due: 2026-11-20T23:59:00Z\nextensions: {ada: 5}', 'extensions of ada must be a time'),
        ('due: [', 'cannot be read'),
        ('due: 2026-13-45T23:59:00Z', 'cannot be read'),
        ('due: 2026-11-20T24:00:00Z', 'cannot be read'),
        ('due: 2026-11-20T23:59:00+99:99', 'cannot be read'),
        (f'{DUE}extensions: {{ada: 2026-02-30T00:00:00Z}}', 'cannot be read'),
        (f'{DUE}per_day: {"9" * 5000}', 'cannot be read'),
        (f'{DUE}per_day: !!int ""', 'cannot be read'),
        (f'{DUE}per_day: !!timestamp x', 'cannot be read'),
        (f'{DUE}extensions: {"[" * 3000}', 'nested too deeply'),
        (f'{DUE}grace_minutes: .inf', 'grace_minutes must be a number from 0 to 527040'),
        (f'{DUE}grace_minutes: 1.0e+308', 'grace_minutes must be a number from 0 to 527040'),
        ('due: 0001-01-01T00:00:00+14:00', 'due must be a time of the years 1970 to 9999'),
        ('due: 9999-12-31T23:59:59-12:00', 'due must be a time of the years 1970 to 9999'),
        (f'{DUE}handed_in: {{ada: 0001-01-01T00:00:00Z}}', 'handed_in of ada must be a time of the years'),
        (f'{DUE}{DUE}', "found 'due' a second time"),
        (f'{DUE}extensions: {{ada: 2026-11-21T00:00:00Z, ada: 2026-11-22T00:00:00Z}}', "found 'ada' a second time"),
        (f'{DUE}extensions: {{[ada]: 2026-11-21T00:00:00Z}}', 'a key that is no text'),
        (f'{DUE}per_day: 010', 'per_day must be a number'),
        (f'{DUE}per_day: 1:10', 'per_day must be a number'),
    ],
)
def test_a_policy_that_cannot_be_used(tmp_path, text, problem):
    with pytest.raises(PolicyError) as error:
        late.load(written(tmp_path, text))
    assert problem in str(error.value) and 'file.yaml' in str(error.value)


IDS = '0123', '12_34', '1:30', '1e5', '0x1f', '0o17', '1.50', 'no', 'on', 'Y', 'null', 'true', '~', '2026-01-01'


@pytest.mark.parametrize('learner', IDS)
def test_an_id_is_what_is_written(tmp_path, learner):
    """YAML takes some of these for other numbers, and some for none: then they would be somebody else's."""
    policy = late.load(written(tmp_path, f'{DUE}extensions: {{{learner}: 2026-11-21T00:00:00Z}}'))
    assert policy.learners == {learner}
    try:
        rows = adjustments.load(
            written(tmp_path, f"- {{learner: {learner}, exercise: '3.1', points: 1, reason: x}}"), POINTS
        )
        assert [row.learner for row in rows] == [learner]
    except AdjustmentError as error:
        assert 'in quotes' in str(error) or 'learner is missing' in str(error)


@pytest.mark.parametrize(
    ('text', 'problem'),
    [
        ('ada,3.2,1,,x\n', 'its first line must be the names of the columns'),
        ('learner;exercise,points,delta,reason\nada,3.2,1,,x\n', 'its first line must be'),
        ('learner,exercise,points,points,reason\nada,3.2,1,2,x\n', 'two columns points'),
    ],
)
def test_columns_that_cannot_be_used(tmp_path, text, problem):
    with pytest.raises(AdjustmentError, match=problem):
        adjustments.load(written(tmp_path, text, 'a.csv'), POINTS)


def test_empty_rows_and_blanks_of_a_spreadsheet(tmp_path):
    text = 'learner, exercise, points, delta, reason\nada, 3.2, 1, , x\n,,,,\n , , , , \n'
    assert adjustments.load(written(tmp_path, text, 'a.csv'), POINTS) == [Adjustment('ada', '3.2', 1.0, None, 'x')]


def test_adjustments(tmp_path):
    expected = [Adjustment('ada', '3.2', 4.5, None, 'right, on paper'), Adjustment('bob', '3.1', None, -1.0, 'twice')]
    text = 'learner,exercise,points,delta,reason\nada,3.2,4.5,,"right, on paper"\nbob,3.1,,-1,twice\n'
    assert adjustments.load(written(tmp_path, '\ufeff' + text, 'a.csv'), POINTS) == expected
    for delimiter in ';\t':
        text = 'learner,exercise,points,delta,reason\nada,3.2,4.5,,"right, on paper"\nbob,3.1,,-1,twice\n'
        text = text.replace(', ', '& ').replace(',', delimiter).replace('& ', ', ')
        assert adjustments.load(written(tmp_path, text, 'a.csv'), POINTS) == expected
    text = """
- {learner: ada, exercise: '3.2', points: 4.5, reason: 'right, on paper'}
- {learner: bob, exercise: '3.1', delta: -1, reason: twice}
"""
    assert adjustments.load(written(tmp_path, text), POINTS) == expected
    assert adjustments.load(written(tmp_path, ''), POINTS) == []


@pytest.mark.parametrize(
    ('row', 'problem'),
    [
        ("{learner: ada, exercise: '3.3', points: 1, reason: x}", "no exercise '3.3'"),
        ('{learner: ada, exercise: 3.10, points: 1, reason: x}', 'in quotes'),
        ("{learner: ada, exercise: '3.1', points: 11, reason: x}", 'has 10 points, not 11'),
        ("{learner: ada, exercise: '3.1', points: -1, reason: x}", 'has 10 points, not -1'),
        ("{learner: ada, exercise: '3.1', points: 1, delta: 1, reason: x}", 'either points or delta'),
        ("{learner: ada, exercise: '3.1', reason: x}", 'either points or delta'),
        ("{learner: ada, exercise: '3.1', delta: .nan, reason: x}", 'delta must be a number'),
        ("{learner: ada, exercise: '3.1', delta: 1}", 'reason is missing'),
        ("{exercise: '3.1', delta: 1, reason: x}", 'learner is missing'),
        ("{learner: ada, exercise: '3.1', delta: 1, reason: x, by: me}", "'by' is unknown"),
        ('ada', 'expected a list'),
        ("{learner: ada, exercise: '3.1', points: true, reason: x}", 'points must be a number, not True'),
        ("{learner: ada, exercise: '3.1', points: yes, reason: x}", "points must be a number, not 'yes'"),
        ("{learner: true, exercise: '3.1', points: 1, reason: x}", 'write the learner in quotes'),
        (f"{{learner: ada, exercise: '3.1', points: {'9' * 400}, reason: x}}", 'points must be a number'),
        (f"{{learner: ada, exercise: '3.1', points: {'9' * 5000}, reason: x}}", 'cannot be read'),
        ("{learner: ada, exercise: '3.1', points: 1, reason: 2026-13-45}", 'cannot be read'),
        ('[' * 3000, 'nested too deeply'),
        ('&a [*a]', 'expected a list'),
    ],
)
def test_adjustments_that_cannot_be_used(tmp_path, row, problem):
    with pytest.raises(AdjustmentError) as error:
        adjustments.load(written(tmp_path, f'- {row}'), POINTS)
    assert problem in str(error.value) and 'file.yaml' in str(error.value)


def test_a_mark_that_is_set_twice(tmp_path):
    """It may be changed after it was set; of two that set it, nobody can say which one is meant."""
    head = 'learner,exercise,points,delta,reason\n'
    twice = written(tmp_path, head + 'ada,3.2,1,,x\nbob,3.2,1,,x\nada,3.2,2,,y\n', 'twice.csv')
    with pytest.raises(AdjustmentError, match='entry 3: the mark of ada in 3.2 is set in entry 1, too'):
        adjustments.load(twice, POINTS)
    assert len(adjustments.load(written(tmp_path, head + 'ada,3.2,1,,x\nada,3.2,,1,y\n', 'a.csv'), POINTS)) == 2


def test_adjustments_of_another_encoding(tmp_path):
    path = tmp_path / 'a.csv'
    path.write_bytes('learner,exercise,points,delta,reason\njosé,3.2,1,,x\n'.encode('latin-1'))
    with pytest.raises(AdjustmentError, match='not in UTF-8'):
        adjustments.load(path, POINTS)


@pytest.mark.parametrize(
    ('points', 'delta', 'mark', 'expected'),
    [
        (8.0, None, 2.0, 8),
        (8.0, None, None, 8),
        (None, 3.0, 2.0, 5),
        (None, 9.0, 2.0, 10),
        (None, -9.0, 2.0, 0),
        (None, 1.0, None, None),
    ],
)
def test_an_adjusted_mark(points, delta, mark, expected):
    assert Adjustment('ada', '3.1', points, delta, 'x').applied(mark, 10) == expected
