# attack: reads the tests' source and expected values from stack frames
# row: 8
# aims at: 90.1
# stopped by: tests and learner's code share no process
# expect verdict: failed
# expect message: wrong
def total(numbers):
    import inspect
    for frame in sys._current_frames().values():
        while frame:
            search(repr(frame.f_locals), 'a frame')
            search(repr(list(frame.f_globals)), 'globals')
            try:
                search(inspect.getsource(frame), 'source')
            except (OSError, TypeError):
                pass
            if 'test_' in frame.f_code.co_name:
                tell('SEEN', frame.f_code.co_name)
            frame = frame.f_back
    return 0
