"""Descriptions: what an action acts on."""

from launch.descriptions.executable import Executable

__all__ = ['Executable']
