"""The benchmarks measure what they say, on a small scale; how fast this machine is, is no test."""

import pytest

from grading.bench import bench_grading, bench_helpers, bench_idle, bench_notebooks, bench_setup, machine_facts
from grading.bench.peers import timing
from grading.course import Course
from grading.submission import Submission
from helpers import paths


def test_the_machine_is_told():
    facts = machine_facts.facts()
    assert facts['processor'] and facts['processors'] > 0 and facts['memory'] > 2**28 and facts['packages']['ipykernel']
    many = machine_facts.BUSY * facts['processors']
    assert machine_facts.busy(many) == ''
    assert f'load {many + 1:.1f} on' in machine_facts.busy(many + 1)


def test_messages_by_both_ways(domain, monkeypatch):
    monkeypatch.setattr(bench_helpers, 'ROUNDS', 2)
    monkeypatch.setattr(bench_helpers, 'SECONDS', 0.1)
    figures = list(bench_helpers.measure())
    assert len(figures) == 3
    assert all(figure.value > 0 and figure.ratio > 0 and figure.reference == 'plain rclpy' for figure in figures)


def test_idle_nodes_by_both_ways(domain, monkeypatch):
    monkeypatch.setattr(bench_idle, 'ROUNDS', 1)
    monkeypatch.setattr(bench_idle, 'SECONDS', 0.2)
    (figure,) = bench_idle.measure()
    assert 0 < figure.value < 1000 and 0 < figure.reference_value < 1000


def test_grading_is_compared_on_the_same_terms(monkeypatch):
    asked = []
    monkeypatch.setattr(bench_grading.sandbox, 'problem', lambda: '')
    monkeypatch.setattr(bench_grading, '_run', lambda course, count, output: (3.0 * count, 2**20))
    monkeypatch.setattr(bench_grading, '_parts', lambda course: ())
    monkeypatch.setattr(bench_grading, '_whole', lambda output: ())
    monkeypatch.setattr(bench_grading, '_program', lambda count: asked.append(('course', count)) or 5.0)
    monkeypatch.setattr(timing, 'seconds', lambda peer, count: asked.append((peer, count)) or 20.0)
    compared = [figure for figure in bench_grading.measure() if figure.reference]
    assert [(figure.reference, figure.value, figure.ratio) for figure in compared] == [
        ('nbgrader autograde', 0.5, 0.25),
        ('otter run', 0.5, 0.25),
    ]
    assert asked == [('course', 10), ('nbgrader autograde', 10), ('course', 10), ('otter run', 10)]


def test_the_submission_of_the_whole_course_has_an_answer_to_each_exercise(tmp_path):
    course = Course.here()
    work = Submission('learner', tmp_path, bench_grading.solved(course))
    found = work.programs(course.exercises, course.exercises)
    assert not found.without and found.programs.keys() == {exercise.id for exercise in course.exercises}


def test_a_notebook_that_fails_is_no_figure(tmp_path, monkeypatch):
    import nbformat

    (tmp_path / 'solutions').mkdir()
    broken = nbformat.v4.new_notebook(cells=[nbformat.v4.new_code_cell('1 / 0')])
    nbformat.write(broken, tmp_path / 'solutions' / '91_broken.ipynb')
    monkeypatch.setattr(paths, 'ROOT', tmp_path)
    with pytest.raises(RuntimeError, match='ZeroDivisionError'):
        list(bench_notebooks.measure())


def test_steps_of_a_set_up_are_read(tmp_path):
    script = tmp_path / 'course'
    script.write_text('#!/bin/sh\necho "Fetching uv: 1.5 s" >&2\necho "Building 28 ROS packages: 60.2 s" >&2\n')
    script.chmod(0o755)
    seconds, steps = bench_setup._course(tmp_path, {'PATH': '/usr/bin:/bin'})
    assert seconds > 0 and steps == [('Fetching uv', 1.5), ('Building 28 ROS packages', 60.2)]
