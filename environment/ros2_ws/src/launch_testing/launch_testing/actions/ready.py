"""When the tests begin."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator

from launch.action import Action
from launch.launch_context import LaunchContext
from launch.launch_description import LaunchDescription
from launch.launch_description_entity import LaunchDescriptionEntity


class ReadyToTest(Action):
    """Says that the system is ready, so that the tests begin."""

    def __init__(self, **kwargs):
        super().__init__(**kwargs)
        self._callbacks: list[Callable[[], None]] = []

    def _add_callback(self, callback: Callable[[], None]) -> None:
        self._callbacks.append(callback)

    def execute(self, context: LaunchContext) -> None:
        for callback in self._callbacks:
            callback()


def find_ready_actions(description: LaunchDescription) -> list[ReadyToTest]:
    """Return the ReadyToTest actions of a description, in groups and behind events too."""
    return list(_search(description.entities))


def _search(entities: Iterable[LaunchDescriptionEntity]) -> Iterator[ReadyToTest]:
    for entity in entities:
        if isinstance(entity, ReadyToTest):
            yield entity
        yield from _search(entity.describe_sub_entities())
        for _, some in entity.describe_conditional_sub_entities():
            yield from _search(some)
