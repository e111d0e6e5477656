"""start and stop of ROS, in any order; what importing helpers does and does not."""

import gc
import os
import subprocess
import sys

import pytest
import rclpy
from rclpy.node import Node

from helpers import spin_for, spinning, wait_for
from helpers.kernel import ros as ros_module
from helpers.kernel.domains import claim
from helpers.kernel.nodes import is_alive
from helpers.tests.real_kernel import ROOT
from helpers.tests.sample_nodes import Talker


def test_start_and_stop_are_idempotent(ros, domain):
    context = ros.start()
    assert ros.start() is context
    assert context.get_domain_id() == domain
    talker = Talker()
    ros.stop()
    ros.stop()
    assert not rclpy.ok() and not is_alive(talker)
    assert ros.start().ok()


def test_start_in_another_domain_begins_anew(ros, domain):
    handle = spinning(talker := Talker())
    with claim() as other:
        assert ros.start(other).get_domain_id() == other
        assert not is_alive(talker) and not handle.running
        assert ros.start().get_domain_id() == other, 'without a domain the running one is kept'
        ros.stop()


@pytest.mark.parametrize('end', [rclpy.shutdown, lambda: rclpy.utilities.get_default_context().shutdown()])
def test_start_after_another_end(ros, end):
    """Also after the context was shut down without rclpy knowing, as a signal does: rclpy.spin_* must work again."""
    spin_for(0.01, Talker())
    end()
    ros.start()
    spin_for(0.2, talker := Talker())
    assert talker.count
    rclpy.spin_once(Node('other'), timeout_sec=0)


def test_plain_rclpy_init_is_accepted(ros):
    ros.stop()
    rclpy.init()
    context = ros.start()
    with spinning(Talker()):
        assert rclpy.ok()
    assert ros.start() is context


def test_importing_is_cheap_and_sets_defaults_only_where_nothing_is_set():
    code = (
        'import helpers, os, sys; assert "rclpy" not in sys.modules; '
        'print(os.environ["ROS_PYTHON_CHECK_FIELDS"], os.environ["ROS_AUTOMATIC_DISCOVERY_RANGE"])'
    )
    env = {**os.environ, 'PYTHONPATH': str(ROOT), 'ROS_AUTOMATIC_DISCOVERY_RANGE': 'SUBNET'}
    env.pop('ROS_PYTHON_CHECK_FIELDS', None)
    done = subprocess.run([sys.executable, '-c', code], env=env, capture_output=True, text=True, timeout=60, check=True)
    assert done.stdout.split() == ['1', 'SUBNET']


def test_a_function_is_shown_where_its_module_has_the_same_name():
    import helpers
    import helpers.kernel.spinning

    assert callable(helpers.spinning) and helpers.ros is ros_module
    assert 'spinning' in dir(helpers)
    with pytest.raises(AttributeError, match='spining'):
        helpers.spining  # noqa: B018


def test_a_plain_program_may_have_two_nodes_of_one_name(ros):
    one, two = Talker(), Talker()
    assert is_alive(one) and is_alive(two)


def test_a_node_with_actions_leaves_the_graph_when_it_is_destroyed(ros):
    """An ActionClient or ActionServer that somebody still holds keeps its destroyed node in the graph."""
    from example_interfaces.action import Fibonacci
    from rclpy.action import ActionClient, ActionServer

    from helpers.kernel.nodes import destroy

    watcher, node = Node('watcher'), Node('asker')
    held = ActionClient(node, Fibonacci, 'count'), ActionServer(node, Fibonacci, 'count', lambda goal: None)
    wait_for(lambda: 'asker' in watcher.get_node_names(), timeout=20)
    destroy(node)
    wait_for(lambda: 'asker' not in watcher.get_node_names(), timeout=20)
    assert len(held) == 2


def test_a_lifecycle_node_leaves_the_graph_when_it_is_destroyed(ros):
    from rclpy.lifecycle import LifecycleNode

    watcher, node = rclpy.create_node('watcher'), LifecycleNode('managed')
    wait_for(lambda: 'managed' in watcher.get_node_names(), timeout=30)
    gc.disable()  # it must not need a collection
    try:
        node.destroy_node()
        wait_for(lambda: 'managed' not in watcher.get_node_names(), timeout=30)
    finally:
        gc.enable()
    node.destroy_node()  # a second time does no harm
