"""Launch files in XML."""

from launch_xml.entity import Entity
from launch_xml.parser import Parser

__all__ = ['Entity', 'Parser']
