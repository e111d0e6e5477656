# attack: knows the given function by its text and its code
# aims at: 8.4
# stopped by: the function stays on the tests' side; every test gets the same stub
TEST_LIMIT = '''
import inspect

from speed import limit as module


def test_text():
    text = inspect.getsource(module)
    code = module.limit.__code__
    assert 'share = max(0.0, min(1.0, (distance - 0.2) / 0.8))' in text or 'isnan' in code.co_names or len(text) < 700
'''
