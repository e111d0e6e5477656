"""What the set-up patches in the installed rclpy."""

import os
import subprocess
import sys
import threading
from pathlib import Path

import pytest
import rclpy
import rosidl_generator_py
from ament_index_python import get_package_prefix
from rclpy import _rclpy_pybind11

from environment.setup import action_client, backports, context_end, signal_end
from environment.setup.stamps import digest


@pytest.fixture
def site(tmp_path):
    """A site-packages with an rclpy."""
    folder = tmp_path / 'rclpy' / 'action'
    folder.mkdir(parents=True)
    (folder / 'client.py').write_text('class ActionClient:\n    pass\n')
    return tmp_path


def test_a_client_without_a_lock_is_patched_once(site):
    cached = site / 'cached'
    os.link(site / 'rclpy' / 'action' / 'client.py', cached)
    assert backports.apply(site, site) == ['rclpy/action/client.py']
    once = (site / 'rclpy' / 'action' / 'client.py').read_text()
    assert once.count('patch(ActionClient)') == 1
    assert backports.apply(site, site) == ['rclpy/action/client.py']
    assert (site / 'rclpy' / 'action' / 'client.py').read_text() == once
    assert 'patch' not in cached.read_text()  # the installer's own copy


def test_a_newer_patch_takes_the_place_of_an_older_one(site, monkeypatch):
    client = site / 'rclpy' / 'action' / 'client.py'
    before = client.read_text()
    patch, mark, tail = backports._PATCHES['rclpy/action/client.py']
    older = (patch, mark, tail.replace('patch', 'old'))
    with monkeypatch.context() as context:
        context.setitem(backports._PATCHES, 'rclpy/action/client.py', older)
        backports.apply(site, site)
    assert 'old(ActionClient)' in client.read_text()
    backports.apply(site, site)
    assert client.read_text() == before + tail.format(name='_course_action_client')


def test_a_client_with_a_lock_is_left_alone(site):
    client = site / 'rclpy' / 'action' / 'client.py'
    client.write_text('lock = threading.Lock()\n')
    assert backports.apply(site, site) == []
    assert client.read_text() == 'lock = threading.Lock()\n'


def test_a_node_does_not_wait_for_what_makes_interfaces():
    """In a process of its own: here it may be imported already."""
    if not Path(rosidl_generator_py.__file__).is_relative_to(sys.prefix):
        pytest.skip('a stock Jazzy is left as it is')
    code = """
import sys
from std_msgs.msg import String
String.__class__.__import_type_support__()
print('rosidl_parser.parser' in sys.modules)
import rosidl_generator_py
print(sorted(rosidl_generator_py.__all__), hasattr(rosidl_generator_py, 'no_such_name'))
from rosidl_generator_py import generate_py
print(callable(generate_py))
"""
    done = subprocess.run([sys.executable, '-c', code], capture_output=True, text=True, timeout=60)
    assert done.stdout.splitlines() == ['False', "['generate_py', 'import_type_support'] False", 'True'], done.stderr


def test_without_rclpy_there_is_nothing_to_patch(tmp_path):
    assert backports.apply(tmp_path, tmp_path) == []


def test_another_patch_is_due_again(monkeypatch):
    before = digest(backports.text())
    monkeypatch.setitem(backports._DISTRIBUTION, 'METADATA', 'other')
    assert digest(backports.text()) != before


class Client:
    """Sends and notes in two steps, as rclpy's does; the step in between can be stretched."""

    def __init__(self):
        self.noted, self.sent, self.go_on = [], threading.Event(), threading.Event()

    def send_goal_async(self):
        self.sent.set()
        self.go_on.wait(10)
        self.noted.append(1)

    def take_data(self):
        return list(self.noted)

    def _cancel_goal_async(self):
        return self.take_data()

    def _get_result_async(self):
        pass


def test_an_answer_is_taken_after_its_request_is_noted():
    client = action_client.patch(Client)()
    taken = []
    sender = threading.Thread(target=client.send_goal_async)
    taker = threading.Thread(target=lambda: taken.extend(client.take_data()))
    sender.start()
    assert client.sent.wait(10)
    taker.start()
    taker.join(0.2)
    assert taker.is_alive()  # it waits for the one who sends
    client.go_on.set()
    sender.join(10)
    taker.join(10)
    assert taken == [1]
    assert client._cancel_goal_async() == [1]  # one thread may hold the lock twice


def test_rclpy_itself_is_patched_or_newer():
    from rclpy.action import ActionClient, client

    assert hasattr(ActionClient, '_course_patched') or 'Lock()' in open(client.__file__).read()
    assert hasattr(rclpy.Context.try_shutdown, '__wrapped__')


def context_class(error, looks: float = 0):
    """A class whose `try_shutdown` raises this, and whose context is valid for so many looks after that."""

    class Raising:
        def __init__(self):
            self._looks = looks

        def ok(self):
            self._looks -= 1
            return self._looks >= 0

        def try_shutdown(self):
            if error:
                raise error

    return context_end.patch(Raising)


@pytest.mark.parametrize('looks', [0, 3])
def test_a_context_that_a_signal_shuts_down_meanwhile_is_shut_down(looks):
    context = context_class(_rclpy_pybind11.RCLError('rcl_shutdown already called'), looks)()
    context.try_shutdown()
    assert not context.ok()


def test_other_errors_of_the_shutdown_are_told(monkeypatch):
    monkeypatch.setattr(context_end, 'LONGEST', 0.05)
    with pytest.raises(_rclpy_pybind11.RCLError, match='no memory'):
        context_class(_rclpy_pybind11.RCLError('no memory'), float('inf'))().try_shutdown()
    with pytest.raises(KeyError):
        context_class(KeyError())().try_shutdown()


def test_a_shutdown_between_the_look_and_the_call_is_no_error(domain):
    """The other one comes while rclpy asks whether the context is valid: a subclass stretches this moment."""

    class Slow(rclpy.Context):
        def try_shutdown(self):
            # What rclpy does, with the other one in between.
            assert self.ok()
            with self.handle:
                self.handle.shutdown()
                self.handle.shutdown()

    context = context_end.patch(Slow)()
    rclpy.init(context=context, domain_id=domain)
    context.try_shutdown()
    assert not context.ok()


class Context:
    """Is shut down some looks after the signal, or not at all."""

    def __init__(self, looks: float):
        self._looks = looks

    def ok(self) -> bool:
        self._looks -= 1
        return self._looks > 0


def guard_of(context):
    class Guard:
        def __init__(self):
            self._context = context
            self._executor_triggered = False

    return signal_end.patch(Guard)()


def test_who_is_woken_by_a_signal_waits_for_the_shutdown(monkeypatch):
    from rclpy.executors import ExternalShutdownException

    guard = guard_of(Context(looks=5))
    assert not guard._executor_triggered
    with pytest.raises(ExternalShutdownException):
        guard._executor_triggered = True
    guard._executor_triggered = False
    assert not guard._executor_triggered
    monkeypatch.setattr(signal_end, 'LONGEST', 0.05)
    guard = guard_of(Context(looks=float('inf')))
    guard._executor_triggered = True  # a signal that shuts nothing down keeps nobody for ever
    assert guard._executor_triggered


def test_rclpy_itself_waits_for_the_shutdown():
    from rclpy.signals import SignalHandlerGuardCondition

    assert isinstance(SignalHandlerGuardCondition._executor_triggered, property)


def test_interfaces_may_be_anywhere(tmp_path):
    share = tmp_path / 'share' / 'rosidl_adapter' / 'cmake'
    share.mkdir(parents=True)
    file = share / 'rosidl_adapt_interfaces.cmake'
    file.write_text('  file(STRINGS "${idl_output}" idl_tuples)\n\n  set(${idl_var} ${idl_tuples} PARENT_SCOPE)\n')
    cached = tmp_path / 'cached'
    os.link(file, cached)
    before = cached.read_text()
    assert backports.apply(tmp_path, tmp_path) == ['share/rosidl_adapter/cmake/rosidl_adapt_interfaces.cmake']
    assert file.read_text() == before.replace('idl_tuples)', 'idl_tuples ENCODING UTF-8)', 1)
    assert cached.read_text() == before  # the installer's own copy
    assert backports.apply(tmp_path, tmp_path) == []


def test_the_installed_adapter_is_patched():
    adapter = Path(get_package_prefix('rosidl_adapter'), 'share/rosidl_adapter/cmake/rosidl_adapt_interfaces.cmake')
    if adapter.is_relative_to(sys.prefix):  # else a stock Jazzy's
        assert 'idl_tuples ENCODING UTF-8)' in adapter.read_text()


def test_xacro_can_tell_its_errors(tmp_path):
    module = tmp_path / 'xacro' / '__init__.py'
    module.parent.mkdir()
    module.write_text('import xml.dom.minidom\n')
    assert backports.apply(tmp_path, tmp_path) == ['xacro/__init__.py']
    told = 'import xml, xacro; xml.parsers.expat.ExpatError'
    subprocess.run([sys.executable, '-c', told], check=True, env={'PYTHONPATH': str(tmp_path)})
    module.write_text('import xml.parsers.expat\n')
    assert backports.apply(tmp_path, tmp_path) == []  # a newer one that needs nothing
