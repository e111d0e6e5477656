"""The benchmark measures what it says it does; how fast this machine is, is no test."""

from environment.bench import bench_tf2


def test_rows(monkeypatch):
    for name, value in (('DEPTHS', (5,)), ('DURATION', 1), ('BUDGET', 0.03)):
        monkeypatch.setattr(bench_tf2, name, value)
    rows = bench_tf2.run()
    assert [(row['depth'], row['operation']) for row in rows] == [
        (5, name) for name in ('insert', 'look up, latest', 'look up, recent', 'look up, random', 'can, recent',
                               'full, recent')]
    assert all(row['per_second'] > 0 for row in rows)
    assert {row['operation']: row['at_least'] for row in rows if row['at_least']} == {
        'insert': 200_000, 'look up, recent': 30_000}
