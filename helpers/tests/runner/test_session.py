"""What a session makes of tests that are themselves at fault: never a pass, never a learner's zero."""

import os
import time
from pathlib import Path

import pytest

from helpers.exercises import manifest
from helpers.exercises import program as programs
from helpers.runner import seeds, session, start_processes
from helpers.tests import small

ONE = '''
def test_one(learner):
    """One."""
    assert learner.call('Talker') == 1
'''
PROGRAM = 'def Talker():\n    return 1\n'


def run(folder, exercises=(1,), hidden=False, program=PROGRAM, **options):
    cells = [cell for number in exercises for cell in small.cells(program, number)]
    return session.run(
        cells,
        [small.exercise(number) for number in exercises],
        session.Options(visible=folder / 'checks', hidden=folder / 'exercises' if hidden else None, **options),
    )


def test_visible_and_hidden(tmp_path):
    small.write_tests(tmp_path, small.VISIBLE)
    small.write_tests(tmp_path, small.HIDDEN, kind='exercises')
    report = session.run(
        small.cells(small.TALKER.replace('+= 1', '+= 2')),
        [small.exercise()],
        session.Options(visible=tmp_path / 'checks', hidden=tmp_path / 'exercises'),
    )
    (result,) = report.exercises
    assert [(test.hidden, test.verdict, test.weight) for test in result.tests] == [
        (False, 'passed', 1),
        (True, 'failed', 3),
    ]
    assert result.tests[1].message == "The texts are ['0', '2', '4', '6']."
    assert (result.verdict, result.score, report.sandbox, report.log) == ('failed', 2.5, 'none', [])


def test_tests_side_by_side_give_what_they_give_one_after_the_other(tmp_path):
    text = """
@pytest.mark.not_looked_at(rule='speed', why='it depends on the machine')
@pytest.mark.parametrize('number', range(3))
def test_drawn(learner, number):
    \"\"\"The number.\"\"\"
    expect(number != 1, f'{learner.random.random()}')
"""
    small.write_tests(tmp_path, ONE + text)
    alone, *others = (run(tmp_path, seed='seven', side_by_side=count) for count in (1, 2, 5))
    assert [test.verdict for test in alone.exercises[0].tests] == ['passed', 'passed', 'failed', 'passed']
    for report in others:
        for result in (*report.exercises, *alone.exercises):
            for test in result.tests:
                test.seconds = 0.0
        assert report.exercises == alone.exercises and report.log == []


def test_tests_side_by_side_run_at_the_same_time(tmp_path):
    text = f"""
import time
from pathlib import Path


def meet(mine, other):
    Path({str(tmp_path)!r}, mine).touch()
    end = time.monotonic() + 60
    while not Path({str(tmp_path)!r}, other).exists():
        assert time.monotonic() < end
        time.sleep(0.01)


def test_first(learner):
    meet('first', 'second')


def test_second(learner):
    meet('second', 'first')
"""
    small.write_tests(tmp_path, text)
    (result,) = run(tmp_path, side_by_side=2).exercises
    assert [test.verdict for test in result.tests] == ['passed', 'passed']


def test_a_process_of_tests_that_dies_takes_no_other_one_with_it(tmp_path):
    small.write_tests(tmp_path, ONE + '\ndef test_two(learner):\n    """Two."""\n    os._exit(3)\n')
    report = run(tmp_path, side_by_side=2)
    assert [test.verdict for test in report.exercises[0].tests] == ['passed', 'grader_error']
    assert report.exercises[0].score is None and 'status 3' in '\n'.join(report.log)


@pytest.mark.parametrize('side_by_side', [1, 2])
def test_a_file_that_cannot_be_read_is_one_fault(tmp_path, side_by_side):
    small.write_tests(tmp_path, ONE + '\ndef test_two(learner):\n    """Two."""\n\nthis is no Python\n')
    (result,) = run(tmp_path, side_by_side=side_by_side).exercises
    assert result.verdict == 'grader_error' and len(result.tests) == 1


def test_only_the_named_tests_run(tmp_path):
    small.write_tests(tmp_path, ONE + ONE.replace('test_one', 'test_two'))
    small.write_tests(tmp_path, ONE.replace('90.1', '90.2'), 2)
    first, second = run(tmp_path, (1, 2), tests={'90.1': ['test_two']}).exercises
    assert [test.test.rpartition('::')[2] for test in first.tests + second.tests] == ['test_two', 'test_one']
    assert (first.score, second.score) == (10, 10)


@pytest.mark.parametrize(
    ('text', 'log'),
    [
        ('\ndef test_two(learner):\n    """Two."""\n    os._exit(3)\n', 'status 3'),
        ('\ndef test_two(learner):\n    """Two."""\n    {}["key"]\n', 'KeyError'),
        ('\ndef test_two(learner):\n    """Two."""\n    pytest.skip("x")\n', 'Skipped'),
        ('\ndef test_two(nothing):\n    """Two."""\n', 'FixtureLookupError'),
        ('\nimport nothing\n', 'nothing'),
        ('\nthis is no Python\n', 'SyntaxError'),
        ('\n@pytest.mark.weight(-1)\ndef test_two(learner):\n    """Two."""\n', ''),
    ],
    ids=['exit', 'exception', 'skip', 'fixture', 'import', 'syntax', 'weight'],
)
def test_a_fault_of_the_tests_is_no_mark(tmp_path, text, log):
    """The faulty exercise has no score; the other one has its own."""
    small.write_tests(tmp_path, ONE)
    small.write_tests(tmp_path, ONE.replace('90.1', '90.2'), 2)
    small.write_tests(tmp_path, ONE + text, 2)
    report = run(tmp_path, (1, 2))
    good, bad = report.exercises
    assert (good.verdict, good.score) == ('passed', 10), report.log
    assert (bad.verdict, bad.score) == ('grader_error', None)
    assert log in '\n'.join(report.log)
    assert all(not test.message for test in bad.tests)


@pytest.mark.one_of(3)
def test_a_test_that_takes_too_long_is_tried_again_and_then_judged(tmp_path):
    """Whatever of the learner's it waits for, or reads: also in a regular expression."""
    small.write_tests(
        tmp_path,
        ONE
        + """
import re


def test_slow(learner):
    \"\"\"Slow.\"\"\"
    re.match('(a*)*b', 'a' * 40)
""",
    )
    began = time.monotonic()
    (result,) = run(tmp_path, (1,), test_timeout=3.0).exercises
    assert (result.verdict, result.score) == ('timeout', 5.0)
    assert 'took too long with your program' in result.tests[-1].message
    assert time.monotonic() - began < 60


def test_a_test_may_say_that_it_takes_longer(tmp_path):
    small.write_tests(
        tmp_path,
        ONE
        + """
import time


@pytest.mark.may_take(60)
def test_slow(learner):
    \"\"\"Slow.\"\"\"
    time.sleep(3.0)
""",
    )
    (result,) = run(tmp_path, (1,), test_timeout=1.0).exercises
    assert result.verdict == 'passed'


def test_all_tests_of_a_session_have_a_total_time(tmp_path):
    small.write_tests(
        tmp_path,
        ONE
        + """
import time


def test_slow(learner):
    \"\"\"Slow.\"\"\"
    time.sleep(5.0)


def test_late(learner):
    \"\"\"Late.\"\"\"
""",
    )
    (result,) = run(tmp_path, (1,), total_timeout=4.0).exercises
    assert result.verdict == 'timeout' and result.score is not None
    assert 'did not run any more' in result.tests[-1].message


COMPUTES = """
def test_computes(learner):
    \"\"\"Computes with what comes.\"\"\"
    assert round(learner.call('Talker')) == 1


def test_dies(learner):
    \"\"\"Dies of what comes.\"\"\"
    if learner.call('Talker') != 1:
        os.kill(os.getpid(), 9)
"""
STUCK_IN_C = """
def test_stuck(learner):
    \"\"\"Stands in C, with the lock of the interpreter.\"\"\"
    if learner.call('Talker') != 1:
        sum(range(10**11))
"""


def reference(exercise):
    """A program that is right."""
    return programs.build(small.cells(PROGRAM), exercise).as_dict()


@pytest.mark.one_of(4)
@pytest.mark.parametrize('text', [COMPUTES, STUCK_IN_C], ids=['dies', 'stuck'])
def test_who_alone_makes_a_fault_fails(tmp_path, text):
    small.write_tests(tmp_path, ONE + text)
    wrong = {'program': "def Talker():\n    return 'text'\n", 'test_timeout': 1.5}
    assert run(tmp_path, **wrong).exercises[0].score is None  # nothing to compare with
    report = run(tmp_path, **wrong, reference=reference)
    (result,) = report.exercises
    assert (result.verdict, result.score) == ('failed', 0), report.log
    assert all('with another program it does' in test.message for test in result.tests[1:])
    assert 'only with this program' in '\n'.join(report.log)


def test_a_fault_that_other_programs_meet_too_stays_open(tmp_path):
    text = '\ndef test_two(learner):\n    """Two."""\n    {}["key"]\n'
    small.write_tests(tmp_path, ONE + text)
    (result,) = run(tmp_path, program="def Talker():\n    return 'text'\n", reference=reference).exercises
    assert (result.verdict, result.score) == ('grader_error', None)


def test_a_fault_that_does_not_come_again_is_nobodys(tmp_path):
    """Another program passes, and then this one does, too: the first faults came from elsewhere."""
    faults = tmp_path / 'faults'
    small.write_tests(
        tmp_path,
        ONE
        + f"""
def test_two(learner):
    \"\"\"Two.\"\"\"
    with open({str(faults)!r}, 'a') as file:
        file.write('x')
    assert os.path.getsize({str(faults)!r}) > 2 or {{}}['key']
""",
    )
    report = run(tmp_path, reference=reference)
    assert (report.exercises[0].verdict, report.exercises[0].score) == ('passed', 10), report.log


def test_two_tests_of_one_name(tmp_path):
    path = small.write_tests(tmp_path, ONE) / 'chapter_90' / 'test_90_1.py'
    again = path.parent / 'checks' / 'chapter_90' / path.name
    again.parent.mkdir(parents=True)
    again.write_text(path.read_text())
    report = run(tmp_path)
    assert (report.exercises[0].verdict, report.exercises[0].score) == ('grader_error', None)
    assert 'two tests have this name' in '\n'.join(report.log)


def test_a_fault_that_passes_is_tried_again(tmp_path):
    flag = tmp_path / 'flag'
    small.write_tests(
        tmp_path,
        ONE
        + f'''
def test_two(learner):
    """Two."""
    if not os.path.exists({str(flag)!r}):
        open({str(flag)!r}, 'w').close()
        os._exit(1)


def test_three(learner):
    """Three."""
    assert learner.call('Talker') == 1
''',
    )
    report = run(tmp_path)
    assert (report.exercises[0].verdict, report.exercises[0].score) == ('passed', 10)
    assert 'status 1' in report.log[0]


def test_a_seed_gives_the_same_inputs_again(tmp_path):
    small.write_tests(
        tmp_path,
        '''
@pytest.mark.parametrize('number', (1, 2))
def test_drawn(learner, number):
    """Drawn."""
    expect(False, f'{learner.random.random()}')
''',
    )
    first = run(tmp_path)
    again = run(tmp_path, seed=first.seed)
    assert again == first
    one, other = (test.message for test in first.exercises[0].tests)
    assert one != other, 'two tests draw from one sequence'


def test_seeds():
    assert seeds.derive('a', 'ada') == seeds.derive('a', 'ada')
    texts = [seeds.derive(*names) for names in (('a', 'ada'), ('b', 'ada'), ('a', 'bob'), ('a', 'ada', ''), ('a', ''))]
    assert len(set(texts)) == len(texts)
    assert seeds.generator('a', 'x').random() == seeds.generator('a', 'x').random()
    assert len({seeds.generator(seed, test).random() for seed in 'ab' for test in 'xy'}) == 4
    assert seeds.fresh() != seeds.fresh()


def test_no_tests_at_all(tmp_path):
    report = run(tmp_path)
    assert (report.exercises[0].verdict, report.exercises[0].score) == ('grader_error', None)


def test_files_of_other_exercises_are_not_read(tmp_path):
    """They would cost time; and what is wrong in them is no matter of this exercise."""
    small.write_tests(tmp_path, ONE)
    (tmp_path / 'checks' / 'chapter_90' / 'test_90_2.py').write_text('raise OSError\n')
    assert run(tmp_path).exercises[0].passed
    report = run(tmp_path, exercises=(1, 2))
    assert [exercise.verdict for exercise in report.exercises][1] == 'grader_error'


def test_a_files_path_says_what_it_tests():
    names = (
        'test_3_1.py',
        'a/test_8_10.py',
        'a/exercises/3_1/hidden.py',
        '3_1/hidden.py',
        'test_8_10_more.py',
        'test_3_1.txt',
        'conftest.py',
        'test_rules.py',
        'hidden.py',
        '3_1/mutants.py',
        'a3_1/hidden.py',
    )
    assert [manifest.tested_in(Path(name)) for name in names] == ['3.1', '8.10', '3.1', '3.1', *[None] * 7]


def test_hidden_tests_must_be_there(tmp_path):
    small.write_tests(tmp_path, ONE)
    report = run(tmp_path, hidden=True)
    assert (report.exercises[0].verdict, report.exercises[0].score) == ('grader_error', None)
    assert 'no hidden tests' in report.log[0]


def test_a_learners_side_that_does_not_start(tmp_path):
    small.write_tests(tmp_path, ONE)
    report = run(tmp_path, launcher='helpers.tests.runner.test_session:broken')
    assert (report.exercises[0].verdict, report.exercises[0].score) == ('grader_error', None)
    assert 'no such sandbox' in '\n'.join(report.log)


def broken(domain_id, limits):
    """A launcher that cannot start."""
    raise OSError('no such sandbox')


def test_nothing_runs_for_what_is_not_attempted_or_invalid(tmp_path):
    calls = []
    for source, verdict in ((small.STUB, 'not_attempted'), ('x = 1', 'invalid_submission')):
        report = session.run(small.cells(source), [small.exercise()], session.Options(visible=tmp_path), calls.append)
        assert (report.exercises[0].verdict, report.exercises[0].score) == (verdict, 0)
        assert '90.1' in report.exercises[0].message
    assert not calls


def test_the_learner_finds_no_test_and_no_secret(tmp_path, monkeypatch):
    """Not in their environment, their arguments or their open files; and of the grader's there is only a channel."""
    monkeypatch.setenv('GRADER_TOKEN', 'canary')
    small.write_tests(
        tmp_path,
        '''
def test_secret(learner):
    """Secret."""
    expect(not learner.call('Talker'), f"{learner.call('Talker')}")
''',
    )
    report = run(
        tmp_path,
        program=f"""\
def Talker():
    import os, gc, sys
    found = [key for key, value in os.environ.items() if 'canary' in value or {str(tmp_path)!r} in value]
    links = [f'/proc/self/fd/{{fd}}' for fd in range(3, 50)]
    found += [os.readlink(link) for link in links if os.path.lexists(link)]
    found += [name for name in sys.modules if name.startswith(('pytest', '_pytest', 'helpers.runner.learner'))]
    mine = ('socket:', 'anon_inode', '/dev/', os.environ['HOME'])
    return [text for text in found if not text.startswith(mine)]
""",
    )
    assert report.exercises[0].passed, report.exercises[0].tests


def test_nothing_is_left_running(tmp_path):
    """What the learner's program starts ends with it."""
    small.write_tests(tmp_path, ONE)
    pids = tmp_path / 'pids'
    report = run(
        tmp_path,
        program=f"""\
import subprocess
def Talker():
    with open({str(pids)!r}, 'a') as file:
        print(subprocess.Popen(['sleep', '1000']).pid, file=file)
    return 1
""",
    )
    assert report.exercises[0].passed
    for pid in pids.read_text().split():
        assert not os.path.exists(f'/proc/{pid}') or '(sleep) Z' in open(f'/proc/{pid}/stat').read()


def test_limits_are_set(tmp_path):
    small.write_tests(tmp_path, ONE.replace('== 1', '== [256, 2**24, 5, 0]'))
    report = run(
        tmp_path,
        limits=start_processes.Limits(cpu=5),
        program="""\
import resource
def Talker():
    return [resource.getrlimit(what)[0] for what in (resource.RLIMIT_NOFILE, resource.RLIMIT_FSIZE,
                                                     resource.RLIMIT_CPU, resource.RLIMIT_CORE)]
""",
    )
    assert report.exercises[0].passed, report.exercises[0].tests
