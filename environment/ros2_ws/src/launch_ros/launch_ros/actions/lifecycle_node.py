"""Runs a lifecycle node."""

from __future__ import annotations

import asyncio

import launch.logging
from launch.event_handler import EventHandler
from launch.frontend import Entity, Parser, expose_action
from launch.launch_context import LaunchContext
from launch.launch_description_entity import LaunchDescriptionEntity
from lifecycle_msgs.msg import Transition, TransitionEvent
from lifecycle_msgs.srv import ChangeState as ChangeStateService
from lifecycle_msgs.srv import GetState

from launch_ros.actions.lifecycle_transition import LifecycleTransition
from launch_ros.actions.node import Node
from launch_ros.events.lifecycle import ChangeState, StateTransition
from launch_ros.ros_adapters import get_ros_node
from launch_ros.service_call import call_service

_ASK_AGAIN = 2.0  # seconds for the answer to the first question, which may be lost while the two discover each other


@expose_action('lifecycle_node')
class LifecycleNode(Node):
    """
    Runs a program whose node has a lifecycle; emits StateTransition and reacts to ChangeState.

    Further keyword arguments are those of ``Node``.

    :param autostart: configure and activate the node as soon as it is there
    """

    def __init__(self, *, name, namespace, autostart: bool = False, **kwargs):
        super().__init__(name=name, namespace=namespace, **kwargs)
        self._autostart = autostart
        self._reached: asyncio.Lock | None = None
        self._is_reached = False
        self._logger_of_node = launch.logging.get_logger('launch_ros.actions.lifecycle_node')

    @classmethod
    def parse(cls, entity: Entity, parser: Parser):
        """Read ``lifecycle_node``."""
        _, kwargs = super().parse(entity, parser)
        autostart = entity.get_attr('autostart', data_type=bool, optional=True, can_be_str=False)
        if autostart is not None:
            kwargs['autostart'] = autostart
        return cls, kwargs

    @property
    def is_lifecycle_node(self) -> bool:
        """True."""
        return True

    @property
    def node_autostart(self) -> bool:
        """True if the node is configured and activated by itself."""
        return self._autostart

    def execute(self, context: LaunchContext) -> list[LaunchDescriptionEntity] | None:
        self._expand_name(context)
        self._listen(context)
        super().execute(context)
        if not self._autostart:
            return None
        first = [Transition.TRANSITION_CONFIGURE, Transition.TRANSITION_ACTIVATE]
        return [LifecycleTransition(lifecycle_node_names=[self.node_name], transition_ids=first)]

    def _listen(self, context: LaunchContext) -> None:
        """Subscribe before the node starts, so that no transition is missed."""

        def pass_on(message: TransitionEvent) -> None:
            event = StateTransition(action=self, msg=message)
            context.asyncio_loop.call_soon_threadsafe(context.emit_event_sync, event)

        def change(event: ChangeState, context: LaunchContext) -> None:
            if event.lifecycle_node_matcher(self):
                context.add_future(context.asyncio_loop.create_task(self._change_state(context, event.transition_id)))

        node = get_ros_node(context)
        self._subscription = node.create_subscription(
            TransitionEvent, f'{self.node_name}/transition_event', pass_on, 10
        )
        # In this order: a node that answers get_state has learned of the subscription before.
        self._get_state = node.create_client(GetState, f'{self.node_name}/get_state')
        self._change = node.create_client(ChangeStateService, f'{self.node_name}/change_state')
        self._reached = asyncio.Lock()
        context.register_event_handler(
            EventHandler(matcher=lambda event: isinstance(event, ChangeState), entities=change)
        )

    async def _change_state(self, context: LaunchContext, transition_id: int) -> None:
        request = self._change.srv_type.Request()
        request.transition.id = transition_id
        async with self._reached:
            while not self._is_reached:
                question = self._get_state.srv_type.Request()
                answer = await call_service(context, self._get_state, question, self._logger_of_node, _ASK_AGAIN)
                self._is_reached = answer is not None
                if context.is_shutdown:
                    return
        answer = await call_service(context, self._change, request, self._logger_of_node)
        if answer is not None and not answer.success:
            name = ChangeState.valid_transitions[transition_id]
            self._logger_of_node.error(f"Failed to make transition '{name}' for LifecycleNode '{self.node_name}'")
