"""The benchmark measures what it says it does; how fast this machine is, is no test."""

from environment.bench import bench_tf2


def test_rows(monkeypatch):
    for name, value in (('DEPTHS', (5,)), ('DURATION', 1), ('BUDGET', 0.03)):
        monkeypatch.setattr(bench_tf2, name, value)
    rows = list(bench_tf2.measure())
    assert [row[0] for row in rows] == [
        f'depth 5: {name}'
        for name in ('insert', 'look up, latest', 'look up, recent', 'look up, random', 'can, recent', 'full, recent')
    ]
    assert all(figure > 0 and unit == '1/s' for _, figure, unit, *_ in rows)
    assert {row[0]: row[3:] for row in rows if row[3:]} == {
        'depth 5: insert': ('promised', 200_000),
        'depth 5: look up, recent': ('promised', 30_000),
    }
