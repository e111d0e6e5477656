"""Waits in ROS time, then does something."""

from __future__ import annotations

from collections.abc import Callable

from launch.actions import TimerAction
from launch.frontend import expose_action
from launch.launch_context import LaunchContext

from launch_ros.global_parameters import GLOBAL_PARAMETERS, GlobalParameter
from launch_ros.ros_adapters import get_ros_node


@expose_action('ros_timer')
class RosTimer(TimerAction):
    """Visits actions after a time in ROS: with SetUseSimTime before it, in the time of /clock."""

    def describe(self) -> str:
        return 'RosTimer'

    def _call_later(self, context: LaunchContext, seconds: float, function: Callable[[], None]) -> Callable[[], None]:
        from rclpy.parameter import Parameter

        node = get_ros_node(context)
        node.set_parameters([Parameter('use_sim_time', value=_wants_sim_time(context))])

        def fire() -> None:
            timer.cancel()
            context.asyncio_loop.call_soon_threadsafe(function)

        timer = node.create_timer(seconds, fire, clock=node.get_clock())
        return timer.cancel


def _wants_sim_time(context: LaunchContext) -> bool:
    parameters = context.launch_configurations.get(GLOBAL_PARAMETERS, [])
    given = [item.value for item in parameters if isinstance(item, GlobalParameter) and item.name == 'use_sim_time']
    return bool(given and given[-1])
