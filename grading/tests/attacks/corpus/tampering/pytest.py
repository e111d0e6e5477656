# attack: makes every test of pytest pass
# row: 4
# aims at: 90.1
# stopped by: pytest runs in another process
# expect verdict: failed or timeout
# expect message: wrong or did not return
try:
    import _pytest.python
    import pytest
    _pytest.python.Function.runtest = lambda self: None
    _pytest.python.Function.setup = lambda self: None
    pytest.fail = pytest.skip = lambda *args, **kwargs: None
except ImportError:
    pass


def total(numbers):
    return 0
