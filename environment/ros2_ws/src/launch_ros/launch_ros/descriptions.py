"""Descriptions that actions take: composable nodes, and parameters under upstream's second name for them."""

from launch_ros.composable_node import ComposableNode
from launch_ros.parameter_descriptions import Parameter, ParameterFile, ParameterValue

__all__ = ['ComposableNode', 'Parameter', 'ParameterFile', 'ParameterValue']
