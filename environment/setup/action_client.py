"""Lets an action's client be used from another thread than the one that spins (runs inside of rclpy 7.1.6).

ros2/rclpy#1123: `send_goal_async` and its like send first and note the request afterwards. A thread that spins
meanwhile can take the answer in between, finds no such request, and the future never completes. Upstream's fix (#1519)
came after 7.1.6 was put into wheels. Here, as there, a lock holds the answer back until the request is noted.
"""

import functools
import threading

ASKING = ('send_goal_async', '_cancel_goal_async', '_get_result_async')


def patch(client_class):
    """Give each object of `client_class` a lock that sending and taking share; returns the class."""
    if hasattr(client_class, '_course_patched'):
        return client_class
    create = client_class.__init__

    @functools.wraps(create)
    def __init__(self, *args, **kwargs):
        self._course_lock = threading.RLock()
        create(self, *args, **kwargs)

    client_class.__init__ = __init__
    for name in (*ASKING, 'take_data'):
        setattr(client_class, name, _locked(getattr(client_class, name)))
    client_class._course_patched = True
    return client_class


def _locked(method):
    @functools.wraps(method)
    def wrapper(self, *args, **kwargs):
        with self._course_lock:
            return method(self, *args, **kwargs)

    return wrapper
