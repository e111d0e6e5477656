"""What launch files in XML and YAML have in common: entities, their parser, and the tags of the actions."""

from launch.frontend import expose, type_utils
from launch.frontend.entity import Entity
from launch.frontend.expose import expose_action, expose_substitution
from launch.frontend.parse_substitution import parse_if_substitutions, parse_substitution
from launch.frontend.parser import InvalidFrontendLaunchFileError, Parser

__all__ = [
    'Entity',
    'InvalidFrontendLaunchFileError',
    'Parser',
    'expose',
    'expose_action',
    'expose_substitution',
    'parse_if_substitutions',
    'parse_substitution',
    'type_utils',
]
