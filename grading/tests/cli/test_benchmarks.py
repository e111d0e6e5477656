"""The benchmarks measure what they say, on a small scale; how fast this machine is, is no test."""

import pytest

from grading import bench
from grading.bench import bench_helpers, bench_idle, bench_notebooks, bench_setup
from helpers import paths


def test_a_peer_gets_a_ratio():
    rows = list(bench.against('latency', 2.0, 'plain rclpy', 4.0, 'us'))
    assert rows == [('latency', 2.0, 'us'), ('latency: plain rclpy', 4.0, 'us'),
                    ('latency: course / plain rclpy', 0.5, '×')]
    with pytest.raises(RuntimeError, match='nothing was measured with plain rclpy'):
        list(bench.against('latency', 2.0, 'plain rclpy', 0.0, 'us'))


def test_messages_by_both_ways(domain, monkeypatch):
    monkeypatch.setattr(bench_helpers, 'ROUNDS', 2)
    monkeypatch.setattr(bench_helpers, 'SECONDS', 0.1)
    rows = {what: value for what, value, _ in bench_helpers.measure()}
    assert len(rows) == 9 and all(value > 0 for value in rows.values())


def test_idle_nodes_by_both_ways(domain, monkeypatch):
    monkeypatch.setattr(bench_idle, 'ROUNDS', 1)
    monkeypatch.setattr(bench_idle, 'SECONDS', 0.2)
    cores = [value for _, value, unit in bench_idle.measure() if unit != '×']
    assert len(cores) == 2 and all(0 < value < 1000 for value in cores)


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
