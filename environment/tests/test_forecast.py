"""What the person who waits is told while packages are built."""

from environment.setup.forecast import Forecast, effort


def test_the_time_left_follows_the_efforts():
    now = [100.0]
    told = Forecast({'small': 1.0, 'large': 3.0, 'last': 1.0}, clock=lambda: now[0])
    assert told.line('Starting >>> small') == ''
    now[0] += 2
    assert told.line('Finished <<< small [1.9s]') == '  1 of 3: small, about 8 s left'
    assert told.line('Finished <<< small [1.9s]') == '', 'a tool that prints the same again counts for nothing'
    now[0] += 6
    assert told.line('Finished <<< large [6.0s]') == '  2 of 3: large, about 2 s left'
    assert told.line('Finished <<< last [0.1s]') == '  3 of 3: last'
    assert told.line('Finished <<< stranger [0.1s]') == ''


def test_interfaces_cost_more_than_what_is_copied(tmp_path):
    copied, compiled = tmp_path / 'copied', tmp_path / 'compiled'
    for folder in (copied, compiled / 'msg'):
        folder.mkdir(parents=True)
    (copied / 'setup.py').touch()
    before = effort(compiled)
    (compiled / 'msg' / 'A.msg').touch()
    assert effort(copied) == before < effort(compiled)
