"""The five systems of exercise 7.8: what is drawn, what is noted, and what a learner can and cannot read."""

import itertools
import json
import re
import sys
from types import SimpleNamespace

import pytest

from helpers import paths
from helpers.checks.chapter_07 import live_systems
from helpers.exercises import remarks
from helpers.exercises.notebooks import NotebookCell
from helpers.programs import faults
from helpers.programs.faults import mystery
from helpers.programs.faults.live import (
    FILE,
    NUMBERS,
    POSSIBLE,
    STACKS,
    Planned,
    Records,
    changed,
    differences,
    name_in,
    question,
    way,
)
from helpers.runner.results import ExerciseResult, TestResult
from helpers.runner.verdicts import ExpectationFailed

MODULE = sys.modules['helpers.programs.faults.live']  # `faults.live` is the function


@pytest.fixture
def noted(monkeypatch):
    """Records of their own, of which nothing is read from or written to the checkout."""
    found = Records()
    monkeypatch.setattr(MODULE, 'records', found)
    monkeypatch.setattr(MODULE, '_load', dict)
    monkeypatch.setenv('COURSE_PROGRESS', 'off')
    return found


@pytest.fixture
def here(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)


def test_two_of_five_systems_have_two_faults_and_no_fault_comes_twice():
    for who in map(str, range(60)):
        drawn = [sorted(Planned(who, number).drawn) for number in NUMBERS]
        assert sorted(map(len, drawn)) == [1, 1, 1, 2, 2]
        assert len(set(itertools.chain(*drawn))) == 7


def test_every_fault_is_drawn_by_somebody_and_shown_by_a_question():
    drawn, asked = set(), set()
    for who in map(str, range(120)):
        for system in (Planned(who, number) for number in NUMBERS):
            drawn |= {
                (name, one.cause, one.where.partition('/')[2], tuple(one.change)) for name, one in system.drawn.items()
            }
            assert len(system.questions()) == len(system.drawn)
            for number, command in system.questions():
                assert number == STACKS or question(command) == number, command
                asked.add(number)
    assert {name for name, *_ in drawn} == set(POSSIBLE) and len(drawn) == 17
    assert asked == {1, 2, 3, 4, 5, STACKS}


def test_another_name_draws_other_systems():
    files = {tuple(str(Planned(who, number).files) for number in NUMBERS) for who in map(str, range(30))}
    assert len(files) == 30
    assert Planned(' ada ', 1).files == Planned('ada', 1).files, 'spaces around a name do not count'
    with pytest.raises(ValueError, match='there is no system 6: there are 1, 2, 3, 4, 5'):
        Planned('ada', 6)


def test_the_evidence_of_a_fault_is_not_in_a_healthy_system():
    for who in map(str, range(40)):
        for system in (Planned(who, number) for number in NUMBERS):
            healthy = '\n'.join((system.files | system.repaired).values())
            for one in system.drawn.values():
                if one.cause not in ('call', 'parameter', 'no clock'):  # words that a right file may have, too
                    assert not any(re.search(pattern, healthy) for pattern in one.shows), one


def test_the_evidence_of_the_truth_would_be_accepted():
    for who in map(str, range(40)):
        for one in itertools.chain(*(Planned(who, number).drawn.values() for number in NUMBERS)):
            assert live_systems.shows(one, one.evidence), one
            assert not live_systems.shows(one, 'it must be the network'), one


ODD = (
    [],
    {},
    None,
    5,
    [[]],
    ['start.txt', 5, None],
    [[], 'a', 'b'],
    [{}, 'a', 'b'],
    [None],
    '\ud800',
    ['\ud800', '', ''],
)


@pytest.mark.parametrize('odd', ODD, ids=range(len(ODD)))
def test_an_answer_of_another_form_is_told_and_breaks_no_test(odd, monkeypatch):
    """As changes, as findings, and as the name."""
    monkeypatch.setattr(live_systems, 'run', lambda learner, who, answers, first: dict.fromkeys(answers, 'no change'))
    for name in ('NAME', 'FINDINGS', 'CHANGES'):
        answer = {'NAME': 'Ada', 'FINDINGS': {}, 'CHANGES': {}}
        answer[name] = odd if name == 'NAME' else {1: [odd]}
        for judge in (live_systems.judge_findings, live_systems.judge_repair):
            learner = SimpleNamespace(
                server=SimpleNamespace(workspaces={}), value=answer.__getitem__, end_calls=lambda: None
            )
            with pytest.raises(ExpectationFailed):
                live_systems.judge_all(learner, judge)


def test_a_repair_as_changes_is_the_repair():
    for who in map(str, range(40)):
        for system in (Planned(who, number) for number in NUMBERS):
            right = system.files | system.repaired
            changes = differences(system.files, right)
            assert changed(system.files, changes) == right
            assert {file for file, _, _ in changes} == set(system.repaired)
            assert not any(new == right[file] for file, _, new in changes), 'pieces, not whole files'


@pytest.mark.parametrize(
    'before, after',
    [
        ('a\na\na\n', 'a\nb\na\n'),  # no line stands alone
        ('a\nb\n', ''),
        ('', 'a\n'),
        ('a\nb\n', 'a\nb\nc\n'),
        ('a\nb', 'x\na\nb'),
        ('a = 1\nb = 1\n', 'a = 2\nb = 2\n'),
    ],
)
def test_any_change_can_be_told(before, after):
    changes = differences({'f': before, 'g': 'same'}, {'f': after, 'g': 'same'})
    assert changed({'f': before, 'g': 'same'}, changes) == {'f': after, 'g': 'same'}


def test_a_change_that_does_not_fit_says_why():
    files = {'f': 'one two two'}
    assert changed(files, [('f', 'one', '1'), ['f', '', 'all']]) == {'f': 'all'}
    for change, text in (
        (('f', 'two', '2'), "'two' is 2 times in f"),
        (('f', 'three', '3'), "'three' is 0 times in f"),
        (('g', 'one', '1'), "'g' is no file to change: there are f"),
        (('f', 'one'), 'is no change: write'),
        ('one', 'is no change: write'),
        (('f', 'one', None), 'three texts'),
    ):
        with pytest.raises(ValueError, match=re.escape(text)):
            changed(files, [change])


@pytest.mark.parametrize(
    'command, number',
    [
        ('ros2 node list', 1),
        ('ros2 param get /rover speed', 1),
        ('start.txt', 1),
        ('ros2 node info /panel', 2),
        ('ros2 topic hz /load', 2),
        ('timeout 9 ros2 run tf2_ros tf2_echo odom base_link', 2),
        ('ros2 topic info --verbose /load', 3),
        ('ros2 service type /calibrate', 3),
        ('ros2 doctor', 3),
        ('echo $ROS_DOMAIN_ID', 4),
        ('panel/.bashrc', 4),
        ('cat rooms.sh', 4),
        ('ros2 param get /panel use_sim_time', 5),
        ('ros2 topic info /clock', 5),
        ('ros2 topic echo --once /tf', 5),
        ('robot/robot.py', 0),
        ('ls', 0),
    ],
)
def test_a_command_asks_a_question(command, number):
    assert question(command) == number


def test_looks_and_changes_are_noted_and_the_truth_waits_for_the_check(domain, here, noted, capsys):
    system = faults.live('ada', 1)
    try:
        with pytest.raises(RuntimeError, match=r'comes when check\("7.8"\) has passed'):
            system.diagnosis  # noqa: B018 - reading it is what is tried
        with pytest.raises(RuntimeError, match='yours to repair'):
            system.repair()
        held = repr([value for name, value in vars(system).items() if name != 'files'])
        for found in Planned('ada', 1).drawn.values():
            for told in (found.where, *found.shows):
                assert told not in held, 'the handle holds nothing of the truth'
        assert 'system 1 of' in repr(system) and system.task in repr(system)
        system.run('echo $ROS_DOMAIN_ID\nls')
        system.run('echo $ROS_DOMAIN_ID', on='robot')
        system.show('panel/panel.py')
        system.stacks()
        assert noted.of('ada', 1) == {'looks': [4, 0, 4, 0, STACKS], 'changes': 0, 'last': []}
        system.edit('panel/panel.py', "super().__init__('panel')", "super().__init__('other')")
        system.write('start.txt', 'panel: python3 panel.py\n')
        with pytest.raises(ValueError, match="'robot/sensor.py' is no file to change"):
            system.write('robot/sensor.py', '')
        assert noted.of('ada', 1)['changes'] == 2
        changes = system.changes()
        assert ('panel/panel.py', "super().__init__('panel')", "super().__init__('other')") in changes
        texts = {file: (system.path / file).read_text() for file in system.files}
        again = faults.live('ada', 1, changes)
        assert {file: (again.path / file).read_text() for file in again.files} == texts
        assert noted.of('ada', 1)['changes'] == 2, 'what is made at once was counted before'
    finally:
        faults.stop()
    capsys.readouterr()
    assert way('ada', passed=False) == ['System 1: 5 looks, 2 changes.']
    lines = way('ada', passed=True)
    assert len(lines) == 1 and lines[0].count('shows a fault') == len(Planned('ada', 1).drawn)
    assert system.diagnosis == Planned('ada', 1).diagnosis


def test_changes_that_stand_in_no_cell_yet_are_told_and_kept(domain, here, noted, capsys):
    """Also those that somebody has made in an editor."""
    change = 'panel/panel.py', "super().__init__('panel')", "super().__init__('other')"
    try:
        system = faults.live('ada', 1)
        file = system.path / change[0]
        file.write_text(file.read_text().replace(*change[1:]))
        faults.live('ada', 2)
        said = capsys.readouterr().out
        assert said.startswith('System 1 is stopped. What you have changed in it, for CHANGES[1]:\n')
        assert repr([change]) in said
        faults.live('ada', 1)
        said = capsys.readouterr().out
        assert 'To go on from there: faults.live(NAME, 1,' in said and repr([change]) in said
        faults.live('ada', 1, [change])
        faults.stop()
        assert capsys.readouterr().out == '', 'these stand in a cell'
        with pytest.raises(RuntimeError, match=r"stage it again, faults.live\('ada', 1\)"):
            system.run('ls')
    finally:
        faults.stop()
    assert noted.of('ada', 1)['last'] == [change] and noted.of('ada', 2)['last'] == []


def test_a_question_that_was_asked_late_would_have_been_shorter(noted):
    (number, command), *_ = Planned('ada', 2).questions()
    for looks, told in (
        ([number], 'you asked it first.'),
        ([0, 0, number], 'you asked it with look 3; as the first one it would have been shorter.'),
        ([0], 'you did not ask it.'),
    ):
        noted.of('ada', 2)['looks'] = looks
        assert command in way('ada', True)[0] and told in way('ada', True)[0]
        assert command not in way('ada', False)[0], 'a question tells the cause'


def test_a_check_of_the_exercise_tells_the_way(noted):
    noted.of('ada', 3)['looks'] = [1]
    cells = [NotebookCell('# Exercise 7.8: five systems that run\nNAME = "ada"\n', 1, None)]
    test = TestResult('a', '7.8', False, 1, 'failed')

    def result(**changes):
        return ExerciseResult(**{'id': '7.8', 'title': '', 'points': 1, 'verdict': 'failed', 'score': 0.0} | changes)

    assert remarks.after([result(tests=[test])], cells) == ['System 3: 1 look, 0 changes.']
    assert remarks.after([result(id='7.7', tests=[test])], cells) == []
    assert remarks.after([result()], cells) == [], 'nothing was answered'
    assert name_in('NAME = f()') is None and name_in('NAME =') is None


def test_the_record_lasts_and_a_broken_one_is_no_harm(tmp_path, monkeypatch):
    monkeypatch.setattr(paths, 'NOTEBOOKS', tmp_path)
    monkeypatch.chdir(tmp_path)
    monkeypatch.delenv('COURSE_PROGRESS', raising=False)
    first, other = Records(), Records()
    first.of('ada', 1)['looks'].append(2)
    first.keep()
    assert other.of('ada', 1) == {'looks': [2], 'changes': 0, 'last': []}
    other.of('ada')['passed'] = True
    other.keep()
    first.keep()
    assert first.passed('ada') and json.loads((tmp_path / FILE).read_text())['ada']['passed'], 'nothing is forgotten'
    for text in ('{', '[]', '{"ada": 1}', '{"ada": {"passed": 1, "systems": {"x": {}}}}'):
        (tmp_path / FILE).write_text(text)
        assert Records().of('ada', 1) == {'looks': [], 'changes': 0, 'last': []}


def test_what_the_panel_lacks_is_said():
    def shown(value='31', rate='10.0', answer='done', begin=1.0, step=0.1):
        return [
            f'[INFO] [panel]: load: {value}, {rate} a second, calibrate: {answer}, base_link: {begin + step * i:.2f} m'
            for i in range(8)
        ]

    assert mystery.lacks(shown()) == ''
    assert mystery.lacks(shown(answer='done-7'), 'done-7', 0.5, 30) == ''
    for lines, text in (
        (shown()[:2], 'hardly anything'),
        ([], 'hardly anything'),
        (shown(value='-'), 'measures is not there'),
        (shown(rate='2.0'), 'less than ten'),
        (shown(rate='-'), 'less than ten'),
        (shown(rate='200.0'), 'more than ten'),
        (shown(answer='-'), 'answer of the service'),
        (shown(step=0.0), 'does not drive ahead'),
        (shown(begin=-3.0), 'does not drive ahead'),
        ([shown()[0].replace('1.00 m', '-'), *shown(step=0.0)[1:]], 'does not drive ahead'),  # unknown, then at rest
        ([*shown()[:7], shown()[7].partition('base_link')[0] + 'base_link: -'], 'does not drive ahead'),
        ([line.partition('base_link')[0] + 'base_link: too old' for line in shown()], 'does not drive ahead'),
    ):
        assert text in mystery.lacks(lines)
    assert 'measures' in mystery.lacks(shown(), first=1000) and 'answer' in mystery.lacks(shown(), 'done-8')
    assert 'drive' in mystery.lacks(shown(), begin=20.0)


@pytest.mark.one_of(6)
@pytest.mark.parametrize('name, place', [(name, place) for name in POSSIBLE for place in range(3)])
def test_each_fault_breaks_the_system_and_its_repair_mends_it(tmp_path, domain, name, place):
    class One(mystery.Mystery):
        def plan(self):
            possible = self._possible()
            self.plan_system([name])
            self.asked = possible[name][place % len(possible[name])].cause

    seed = next(seed for seed in itertools.count() if (one := One(seed)).drawn[name].cause == one.asked)
    fault = One(seed, folder=tmp_path / 'system').stage()
    with fault:
        assert not fault.verify(timeout=2.0)
        fault.repair()
        assert fault.verify(), '\n'.join(program.output for program in fault.programs.values())
