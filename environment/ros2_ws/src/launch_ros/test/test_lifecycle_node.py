"""Lifecycle nodes, led through their states by a launch file."""

import sys
import textwrap

import pytest
from launch_ros.actions import LifecycleNode, LifecycleTransition, Node
from launch_ros.event_handlers import OnStateTransition
from launch_ros.events import matches_node_name
from launch_ros.events.lifecycle import ChangeState
from lifecycle_msgs.msg import State, Transition
from lifecycle_msgs.srv import GetState

from environment.tests.running import ROS2

pytestmark = pytest.mark.timeout(180)

NODE = """
import sys

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.lifecycle import LifecycleNode, TransitionCallbackReturn


class Managed(LifecycleNode):
    def on_configure(self, state):
        return TransitionCallbackReturn.ERROR if 'fail' in sys.argv else TransitionCallbackReturn.SUCCESS


rclpy.init()
try:
    rclpy.spin(Managed('unnamed'))
except (KeyboardInterrupt, ExternalShutdownException):
    pass
"""

HEADER = """
import sys

from launch import LaunchDescription
from launch.actions import EmitEvent, LogInfo, RegisterEventHandler
from launch_ros.actions import LifecycleNode, LifecycleTransition
from launch_ros.event_handlers import OnStateTransition
from launch_ros.events import matches_node_name
from launch_ros.events.lifecycle import ChangeState
from lifecycle_msgs.msg import Transition
"""


@pytest.fixture
def launch_file(tmp_path, start):
    """Launch the actions of a Python file; ``NODE`` is the path of a program with a lifecycle node."""
    (tmp_path / 'node.py').write_text(NODE)

    def launch_one(body):
        text = textwrap.indent(textwrap.dedent(body), '    ')
        path = tmp_path / 'a.launch.py'
        start_of_node = f'sys.executable, arguments=[{str(tmp_path / "node.py")!r}'
        path.write_text(f'{HEADER}\n\ndef generate_launch_description():\n{text.replace("PROGRAM", start_of_node)}\n')
        return start(ROS2, 'launch', str(path))

    return launch_one


def test_the_events_of_the_lifecycle_example(launch_file, peer):
    process = launch_file("""
        node = LifecycleNode(name='talker', namespace='demo', executable=PROGRAM], output='screen')
        activate = EmitEvent(event=ChangeState(
            lifecycle_node_matcher=matches_node_name('/demo/talker'), transition_id=Transition.TRANSITION_ACTIVATE))
        configure = EmitEvent(event=ChangeState(
            lifecycle_node_matcher=lambda action: action is node, transition_id=Transition.TRANSITION_CONFIGURE))
        return LaunchDescription([
            RegisterEventHandler(OnStateTransition(
                target_lifecycle_node=node, start_state='configuring', goal_state='inactive',
                entities=[LogInfo(msg='inactive now'), activate])),
            RegisterEventHandler(OnStateTransition(
                target_lifecycle_node=node, goal_state='active', entities=[LogInfo(msg='active now')])),
            node,
            configure,
        ])
    """)
    process.wait_for_output(': inactive now', timeout=60)
    process.wait_for_output(': active now', timeout=60)
    state = peer.call(GetState, '/demo/talker/get_state').current_state
    assert (state.id, state.label) == (State.PRIMARY_STATE_ACTIVE, 'active')
    assert process.stop(timeout=60) == 0
    assert 'Traceback' not in process.output


def test_transitions_in_a_row_and_by_themselves(launch_file, peer):
    process = launch_file("""
        done = OnStateTransition(matcher=lambda event: getattr(event, 'goal_state', '') == 'active',
                                 entities=lambda event, context: LogInfo(msg=f'{event.action.node_name} is active'))
        return LaunchDescription([
            RegisterEventHandler(done),
            LifecycleNode(name='auto', namespace='', executable=PROGRAM], autostart=True),
            LifecycleNode(name='led', namespace='', executable=PROGRAM]),
            LifecycleTransition(lifecycle_node_names=['led'], transition_ids=[
                Transition.TRANSITION_CONFIGURE, Transition.TRANSITION_ACTIVATE, Transition.TRANSITION_DEACTIVATE,
                Transition.TRANSITION_ACTIVATE]),
        ])
    """)
    process.wait_for_output('/auto is active', timeout=90)
    process.wait_for_output('/led is active', timeout=90)
    assert process.stop(timeout=60) == 0


def test_a_transition_that_fails_stops_the_row(launch_file, peer):
    process = launch_file("""
        return LaunchDescription([
            LifecycleNode(name='bad', namespace='', executable=PROGRAM, 'fail']),
            LifecycleTransition(lifecycle_node_names=['/bad'], transition_ids=[1, '3']),
        ])
    """)
    process.wait_for_output("Stopping transitions for /bad because 'error occured during transitions'", timeout=60)
    process.wait_for_output(
        "[ERROR] [launch_ros.actions.lifecycle_node]: Failed to make transition 'TRANSITION_CONFIGURE' for "
        "LifecycleNode '/bad'",
        timeout=60,
    )
    assert process.stop(timeout=60) == 0


def test_wrong_arguments_are_told():
    with pytest.raises(ValueError, match='No transition_ids provided'):
        LifecycleTransition(lifecycle_node_names=['a'], transition_ids=[])
    with pytest.raises(ValueError, match='No lifecycle_node_names provided'):
        LifecycleTransition(lifecycle_node_names=[], transition_ids=[1])
    with pytest.raises(ValueError, match='is not the number of a transition'):
        ChangeState(lifecycle_node_matcher=lambda _: True, transition_id=-5)
    with pytest.raises(RuntimeError, match='requires a "LifecycleNode" action as the target'):
        OnStateTransition(entities=[], target_lifecycle_node=Node(package='p', executable='e'))
    assert OnStateTransition(entities=[], matcher=lambda _: True, goal_state='active').matches('any event')
    assert OnStateTransition(entities=[]).describe()[0] == (
        "OnStateTransition(matcher='event == StateTransition', handler='<actions>', handle_once=False)"
    )
    assert ChangeState.valid_transitions[Transition.TRANSITION_CONFIGURE] == 'TRANSITION_CONFIGURE'
    assert ChangeState.valid_states[State.PRIMARY_STATE_ACTIVE] == 'PRIMARY_STATE_ACTIVE'
    with pytest.raises(TypeError, match="'namespace'"):
        LifecycleNode(name='n', executable=sys.executable)
    node = LifecycleNode(name='n', namespace='', executable=sys.executable)
    assert node.is_lifecycle_node and not node.node_autostart
    assert not matches_node_name('n')(type('Other', (), {'node_name': '/m'}))
