"""Descriptions that actions take, under upstream's second name for them."""

from launch_ros import components
from launch_ros.parameter_descriptions import Parameter, ParameterFile, ParameterValue

__all__ = ['Parameter', 'ParameterFile', 'ParameterValue']


def __getattr__(name: str):
    raise components.error(name, __name__)
