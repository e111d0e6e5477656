"""Runs a container of components."""

from __future__ import annotations

from ament_index_python.packages import PackageNotFoundError
from launch.action import Action
from launch.frontend import Entity, Parser, expose_action
from launch.launch_context import LaunchContext
from launch.some_substitutions_type import SomeSubstitutionsType

from launch_ros.actions.load_composable_nodes import LoadComposableNodes, parse_descriptions
from launch_ros.actions.node import Node
from launch_ros.composable_node import ComposableNode


@expose_action('node_container')
class ComposableNodeContainer(Node):
    """
    Runs a program that loads nodes into its own process, and has it load some.

    Further keyword arguments are those of ``Node``.

    :param name: the container's name
    :param namespace: below the one of PushROSNamespace, unless it begins with /
    :param composable_node_descriptions: what to load at once, one after the other
    """

    def __init__(
        self,
        *,
        name: SomeSubstitutionsType,
        namespace: SomeSubstitutionsType,
        composable_node_descriptions: list[ComposableNode] | None = None,
        **kwargs,
    ):
        super().__init__(name=name, namespace=namespace, **kwargs)
        self._descriptions = list(composable_node_descriptions or [])

    @classmethod
    def parse(cls, entity: Entity, parser: Parser):
        """Read ``node_container``, with a ``composable_node`` for each node."""
        _, kwargs = super().parse(entity, parser)
        kwargs.setdefault('namespace', '')
        kwargs['composable_node_descriptions'] = parse_descriptions(entity, parser)
        return cls, kwargs

    def execute(self, context: LaunchContext) -> list[Action] | None:
        wanted = [description for description in self._descriptions if description.is_wanted(context)]
        try:
            super().execute(context)
        except PackageNotFoundError as error:
            raise RuntimeError(
                f'{error}\nThis package has the container, a C++ program. Without it, launch each of the nodes that '
                'are in Python by itself, with launch_ros.actions.Node.'
            ) from error
        if not wanted:
            return None
        return [LoadComposableNodes(composable_node_descriptions=wanted, target_container=self)]
