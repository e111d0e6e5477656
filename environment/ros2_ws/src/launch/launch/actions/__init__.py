"""Actions."""

from launch.actions.declare_launch_argument import DeclareLaunchArgument
from launch.actions.emit_event import EmitEvent, Shutdown
from launch.actions.environment import AppendEnvironmentVariable, SetEnvironmentVariable, UnsetEnvironmentVariable
from launch.actions.execute_process import ExecuteProcess
from launch.actions.group_action import GroupAction, PopLaunchConfigurations, PushLaunchConfigurations
from launch.actions.include_launch_description import IncludeLaunchDescription
from launch.actions.launch_configuration import SetLaunchConfiguration, UnsetLaunchConfiguration
from launch.actions.log_info import LogInfo
from launch.actions.opaque import OpaqueCoroutine, OpaqueFunction
from launch.actions.register_event_handler import RegisterEventHandler
from launch.actions.timer_action import TimerAction
from launch.actions.unregister_event_handler import UnregisterEventHandler

__all__ = [
    'AppendEnvironmentVariable',
    'DeclareLaunchArgument',
    'EmitEvent',
    'ExecuteProcess',
    'GroupAction',
    'IncludeLaunchDescription',
    'LogInfo',
    'OpaqueCoroutine',
    'OpaqueFunction',
    'PopLaunchConfigurations',
    'PushLaunchConfigurations',
    'RegisterEventHandler',
    'SetEnvironmentVariable',
    'SetLaunchConfiguration',
    'Shutdown',
    'TimerAction',
    'UnregisterEventHandler',
    'UnsetEnvironmentVariable',
    'UnsetLaunchConfiguration',
]
