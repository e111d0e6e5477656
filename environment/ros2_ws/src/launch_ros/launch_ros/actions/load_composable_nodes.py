"""Has a container load nodes."""

from __future__ import annotations

import asyncio
from typing import Any

import launch.logging
from launch.action import Action
from launch.frontend import Entity, Parser, expose_action
from launch.launch_context import LaunchContext
from launch.some_substitutions_type import SomeSubstitutionsType
from launch.utilities import to_text

from launch_ros.actions.node import Node
from launch_ros.composable_node import ComposableNode
from launch_ros.ros_adapters import get_ros_node
from launch_ros.service_call import call_service
from launch_ros.utilities import add_node_name

_LOGGER = 'launch_ros.actions.load_composable_nodes'


@expose_action('load_composable_node')
class LoadComposableNodes(Action):
    """
    Asks a container that runs to load nodes, one after the other; waits until it is there.

    :param composable_node_descriptions: what to load
    :param target_container: the container, or its full name
    """

    def __init__(
        self,
        *,
        composable_node_descriptions: list[ComposableNode],
        target_container: SomeSubstitutionsType | Node,
        **kwargs,
    ):
        super().__init__(**kwargs)
        self._descriptions, self._container = list(composable_node_descriptions), target_container
        self._task: asyncio.Task | None = None

    @classmethod
    def parse(cls, entity: Entity, parser: Parser):
        """Read ``load_composable_node``, with a ``composable_node`` for each node."""
        _, kwargs = super().parse(entity, parser)
        kwargs['target_container'] = parser.parse_substitution(entity.get_attr('target'))
        kwargs['composable_node_descriptions'] = parse_descriptions(entity, parser)
        return cls, kwargs

    def execute(self, context: LaunchContext) -> None:
        """
        Begin to load.

        :raises RuntimeError: if the package composition_interfaces is not installed
        """
        name = self._container.node_name if isinstance(self._container, Node) else to_text(context, self._container)
        # Now: a group that is left takes its namespace, parameters and remappings with it.
        asked = [get_composable_node_load_request(each, context) for each in self._descriptions]
        requests = [request for request in asked if request is not None]
        if requests:
            client = get_ros_node(context).create_client(_service_type(), f'{name}/_container/load_node')
            self._task = context.asyncio_loop.create_task(_load(context, name, client, requests))
            context.add_future(self._task)

    def get_asyncio_future(self) -> asyncio.Future | None:
        return self._task


def get_composable_node_load_request(composable_node_description: ComposableNode, context: LaunchContext) -> Any:
    """
    Return the request to load a node; None if its condition does not hold.

    :raises RuntimeError: if the package composition_interfaces is not installed
    """
    if not composable_node_description.is_wanted(context):
        return None
    return _service_type().Request(**composable_node_description.request_fields(context))


def parse_descriptions(entity: Entity, parser: Parser) -> list[ComposableNode]:
    """Return what the ``composable_node`` in an element stand for."""
    parsed = [
        ComposableNode.parse(parser, child)
        for child in entity.get_attr('composable_node', data_type=list[Entity], optional=True) or []
    ]
    return [description(**kwargs) for description, kwargs in parsed]


def _service_type() -> Any:
    try:
        from composition_interfaces.srv import LoadNode
    except ModuleNotFoundError as error:
        raise RuntimeError(
            "loading nodes into a container needs the package 'composition_interfaces', which is not installed: put it "
            'into a workspace, build and source it. Nodes in Python need no container: launch them with '
            'launch_ros.actions.Node.'
        ) from error
    return LoadNode


async def _load(context: LaunchContext, container: str, client: Any, requests: list[Any]) -> None:
    logger = launch.logging.get_logger(_LOGGER)
    for request in requests:
        answer = await call_service(context, client, request, logger)
        if answer is None:
            return
        node = answer.full_node_name or request.node_name
        if answer.success:
            add_node_name(context, node, logger=container)
            logger.info(f"Loaded node '{node}' in container '{container}'")
        else:
            logger.error(
                f"Failed to load node '{node}' of type '{request.plugin_name}' in container '{container}': "
                f'{answer.error_message}'
            )
