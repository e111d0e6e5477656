"""The benchmark measures what it says it does; how fast this machine is, is no test."""

from environment.bench import bench_tf2


def test_rows(monkeypatch):
    for name, value in (('DEPTHS', (5,)), ('DURATION', 1), ('BUDGET', 0.03)):
        monkeypatch.setattr(bench_tf2, name, value)
    rows = list(bench_tf2.measure())
    assert [what for what, _, _ in rows] == [
        f'depth 5: {name}' for name in (
            'insert (at least 200,000)', 'look up, latest', 'look up, recent (at least 30,000)', 'look up, random',
            'can, recent', 'full, recent')]
    assert all(figure > 0 and unit == '1/s' for _, figure, unit in rows)
