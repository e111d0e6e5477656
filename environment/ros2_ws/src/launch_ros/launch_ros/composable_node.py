"""A node that a container loads into its own process."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from launch.action import Action
from launch.condition import Condition
from launch.frontend import Entity, Parser
from launch.launch_context import LaunchContext
from launch.some_substitutions_type import SomeSubstitutionsType
from launch.utilities import to_text

from launch_ros.actions.node import check_remappings, parse_parameters, parse_remappings
from launch_ros.actions.set_remap import REMAPPINGS
from launch_ros.global_parameters import GLOBAL_PARAMETERS
from launch_ros.parameters import check_parameters, parameter_messages
from launch_ros.utilities import make_namespace_absolute, prefix_namespace

if TYPE_CHECKING:
    from rcl_interfaces.msg import Parameter as ParameterMessage


class ComposableNode:
    """
    Which node a container shall load, and how.

    :param package: the package of the component
    :param plugin: the component's class, e.g. ``composition::Talker``
    :param name: the node's name, instead of the component's own
    :param namespace: below the one of PushROSNamespace, unless it begins with /
    :param parameters: dictionaries and paths of YAML files
    :param remappings: (from, to) pairs
    :param extra_arguments: dictionaries for the container, e.g. ``{'use_intra_process_comms': True}``
    :param condition: load it only if this is true
    :raises TypeError: if parameters or remappings have items that they cannot have
    """

    def __init__(
        self,
        *,
        package: SomeSubstitutionsType,
        plugin: SomeSubstitutionsType,
        name: SomeSubstitutionsType | None = None,
        namespace: SomeSubstitutionsType | None = None,
        parameters: list | None = None,
        remappings: list[tuple[SomeSubstitutionsType, SomeSubstitutionsType]] | None = None,
        extra_arguments: list | None = None,
        condition: Condition | None = None,
    ):
        check_parameters([*(parameters or []), *(extra_arguments or [])])
        check_remappings(remappings or [])
        self.package, self.node_plugin = package, plugin
        self.node_name, self.node_namespace = name, namespace
        self.parameters, self.remappings, self.extra_arguments = parameters, remappings, extra_arguments
        self._condition = condition

    @classmethod
    def parse(cls, parser: Parser, entity: Entity) -> tuple[type[ComposableNode], dict[str, Any]]:
        """Return the class, and the keyword arguments that a ``composable_node`` stands for."""
        _, kwargs = Action.parse(entity, parser)
        for attribute, argument, optional in (
            ('pkg', 'package', False),
            ('plugin', 'plugin', False),
            ('name', 'name', True),
            ('namespace', 'namespace', True),
        ):
            value = entity.get_attr(attribute, optional=optional)
            if value is not None:
                kwargs[argument] = parser.parse_substitution(value)
        kwargs.update(parse_remappings(entity, parser))
        kwargs.update(parse_parameters(entity, parser))
        kwargs.update(parse_parameters(entity, parser, tag='extra_arg', argument='extra_arguments'))
        entity.assert_entity_completely_parsed()
        return cls, kwargs

    def condition(self) -> Condition | None:
        """Return the condition given, if any."""
        return self._condition

    def is_wanted(self, context: LaunchContext) -> bool:
        """Return whether the condition holds."""
        return self._condition is None or self._condition.evaluate(context)

    def request_fields(self, context: LaunchContext) -> dict[str, Any]:
        """
        Return the fields of the request to load it, with what is set for all nodes: namespace, parameters, remappings.

        :raises OSError: if a parameter file cannot be read
        """
        name = '' if self.node_name is None else to_text(context, self.node_name)
        given = None if self.node_namespace is None else to_text(context, self.node_namespace)
        namespace = make_namespace_absolute(prefix_namespace(context.launch_configurations.get('ros_namespace'), given))
        remappings = [(to_text(context, old), to_text(context, new)) for old, new in self.remappings or []]
        remappings = [*context.launch_configurations.get(REMAPPINGS, []), *remappings]
        parameters = [*context.launch_configurations.get(GLOBAL_PARAMETERS, []), *(self.parameters or [])]
        node = f'{(namespace or "").rstrip("/")}/{name}'

        def messages(items: list) -> list[ParameterMessage]:
            return parameter_messages(context, items, node)

        return {
            'package_name': to_text(context, self.package),
            'plugin_name': to_text(context, self.node_plugin),
            'node_name': name,
            'node_namespace': namespace or '',
            'remap_rules': [f'{old}:={new}' for old, new in remappings],
            'parameters': messages(parameters),
            'extra_arguments': messages(self.extra_arguments or []),
        }
